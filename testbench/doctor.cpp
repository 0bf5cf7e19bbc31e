// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "lab/build_info.hpp"
#include "lab/machines.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "testbench/run.hpp"

namespace trammel::testbench {
namespace {

using Json = nlohmann::ordered_json;

struct List {
  Json json = Json::array();
  std::string text;
};

List machines() {
  List all;
  for (const lab::Machine* machine : lab::machines()) {
    all.json.push_back({{"name", machine->name}, {"title", machine->title},
                        {"source", machine->source},
                        {"leap", machine->can.leap},
                        {"twin", machine->can.twin}});
    all.text += fmt::format("{:<10}{}\n{:<10}{}\n", machine->name, machine->title, "",
                            machine->source);
  }
  return all;
}

List scenarios() {
  List all;
  for (const auto& file : lab::scenarios()) {
    const auto settings = lab::load_scenario(file);
    const std::string name = file.stem().string();
    all.json.push_back({{"name", name}, {"machine", settings->machine().name},
                        {"description", settings->description}});
    all.text += fmt::format("{:<19}{}\n", name, settings->description);
  }
  return all;
}

List keys(const lab::Machine& machine) {
  const auto defaults = machine.defaults();
  List all;
  bool two_axes = false;
  for (const lab::Key& key : machine.keys()) {
    const std::string value = lab::value_text(key.get(*defaults));
    const std::string range = lab::range_text(key);
    two_axes = two_axes || lab::short_form(key.name) != key.name;
    all.json.push_back(
        {{"key", key.name}, {"default", value}, {"range", range}, {"help", key.help}});
    all.text += fmt::format("{:<35} {:<11} {:<45} {}\n", key.name, value, range, key.help);
  }
  if (two_axes) all.text = "A key of an axis without its .x or .y sets both axes.\n\n" + all.text;
  return all;
}

List columns(const lab::Machine& machine) {
  List all;
  for (const lab::Column& column : machine.columns().columns) {
    all.json.push_back({{"column", column.name}, {"unit", column.unit}, {"help", column.help}});
    all.text += fmt::format("{:<18}{:<24}{}\n", column.name, column.unit, column.help);
  }
  return all;
}

List signals(const std::string& only) {
  List all;
  all.text =
      "Signals for --wave-trigger: x.NAME or y.NAME is that of one axis, NAME alone that of "
      "either.\n";
  for (const lab::Machine* machine : lab::machines()) {
    if (!only.empty() && machine->name != only) continue;
    const cosim::TriggerForms& forms = machine->traces.triggers();
    all.text += fmt::format("\n{}. Events: {}\n\n", machine->name, forms.help);
    for (const cosim::Signal& signal : forms.signals) {
      const std::int64_t span = std::int64_t{1} << signal.bits;
      const std::int64_t low = signal.is_signed ? -span / 2 : 0;
      const std::string range = fmt::format("{}..{}", low, low + span - 1);
      all.json.push_back({{"machine", machine->name}, {"signal", signal.name},
                          {"axis", signal.of_axis}, {"range", range}, {"unit", signal.unit},
                          {"help", signal.help}});
      all.text += fmt::format("{:<6}{:<22}{:<26}{}\n", signal.of_axis ? "x. y." : "", signal.name,
                              range, cosim::described(signal));
    }
  }
  return all;
}

int show(const List& all, bool json) {
  json ? print_json(all.json) : print(all.text);
  return 0;
}

}  // namespace

int list(const std::string& topic, const std::string& machine, bool json) {
  if (machine.empty() && topic != "keys" && topic != "columns") lab::need_all_machines();
  const lab::Machine& asked =
      machine.empty() ? lab::first_machine() : *lab::find_machine(machine);
  if (topic == "signals") return show(signals(machine), json);
  if (topic == "machines") return show(machines(), json);
  if (topic == "keys") return show(keys(asked), json);
  return show(topic == "columns" ? columns(asked) : scenarios(), json);
}

std::string version_text() {
  return fmt::format("trammel {} commit {}\nverilator {}, systemc {}, {}, {}", lab::kVersion,
                     lab::kCommit, lab::kVerilator, lab::kSystemC, lab::kCompiler, lab::kBuild);
}

int doctor(bool json) {
  struct Tool {
    const char* name;
    const char* use;
  };
  // A run needs none of them.
  constexpr Tool kTools[] = {{"gnuplot", "optional: pictures of a run as svg files"},
                             {"fst2vcd", "optional: --wave vcd"},
                             {"gtkwave", "optional: waves on the screen"}};
  Json all = lab::versions_json();
  std::string text = version_text() + '\n';
  for (const Tool& tool : kTools) {
    const std::string where = host::find_program(tool.name).string();
    all["tools"][tool.name] = where;
    text += fmt::format("{:<10}{:<25} {}\n", tool.name, where.empty() ? "missing" : where,
                        tool.use);
  }
  const std::size_t count = lab::scenarios().size();
  all["scenarios"] = count;
  text += fmt::format("{} scenarios in {}\n", count, lab::machine_folder("").string());
  json ? print_json(all) : print(text);
  return count == 0 ? 3 : 0;
}

}  // namespace trammel::testbench
