// SPDX-License-Identifier: Apache-2.0
#include "testbench/doctor.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cosim/kung/trigger.hpp"
#include "cosim/mcafee/signals.hpp"
#include "cosim/wave_event.hpp"
#include "testbench/build_info.hpp"
#include "testbench/config.hpp"
#include "testbench/output.hpp"

namespace trammel::testbench {
namespace {

using Json = nlohmann::ordered_json;

template <class Options>
constexpr bool is_of_kung = std::is_same_v<Options, kung::Options>;

template <class Options>
std::string description_of(const std::filesystem::path& file) {
  Options options;
  apply_file(options, file);
  return options.description;
}

int list_scenarios(bool json) {
  Json all = Json::array();
  std::string text;
  for (const auto& file : scenarios()) {
    const std::string machine = machine_of(file);
    const std::string description = machine == "kung"    ? description_of<kung::Options>(file)
                                    : machine == "an693" ? description_of<lm628::Options>(file)
                                                         : description_of<mcafee::Options>(file);
    const std::string name = file.stem().string();
    all.push_back({{"name", name}, {"machine", machine}, {"description", description}});
    text += fmt::format("{:<19}{}\n", name, description);
  }
  fmt::print("{}", json ? all.dump(2) + '\n' : text);
  return 0;
}

template <class Options>
int list_keys(bool json) {
  const Options defaults;
  Json all = Json::array();
  std::string text;
  if (is_of_kung<Options>) text = "Axis keys without .x or .y set both axes.\n\n";
  for (const KeyOf<Options>& key : keys_of<Options>()) {
    const std::string value = value_text(key.get(defaults));
    all.push_back({{"key", key.name}, {"default", value}, {"range", range_text(key)},
                   {"help", key.help}});
    text += fmt::format("{:<35} {:<11} {:<45} {}\n", key.name, value, range_text(key), key.help);
  }
  fmt::print("{}", json ? all.dump(2) + '\n' : text);
  return 0;
}

int list_signals(bool json) {
  Json all = Json::array();
  std::string text =
      "What --wave-trigger may name. With x. or y. before it a signal of that axis; without, of "
      "either.\n";
  const auto add = [&](const char* machine, const char* forms,
                       const std::vector<cosim::Signal>& signals) {
    text += fmt::format("\n{}. Events: {}\n\n", machine, forms);
    for (const cosim::Signal& signal : signals) {
      const std::int64_t span = std::int64_t{1} << signal.bits;
      const std::int64_t low = signal.is_signed ? -span / 2 : 0;
      const std::string range = fmt::format("{}..{}", low, low + span - 1);
      all.push_back({{"machine", machine}, {"signal", signal.name}, {"axis", signal.of_axis},
                     {"range", range}, {"help", signal.help}});
      text += fmt::format("{:<6}{:<22}{:<26}{}\n", signal.of_axis ? "x. y." : "", signal.name,
                          range, signal.help);
    }
  };
  add("kung", kung::kTriggerForms, kung::signals());
  add("an693", cosim::kWaveEvents, lm628::signals());
  add("mcafee", cosim::kWaveEvents, mcafee::signals());
  fmt::print("{}", json ? all.dump(2) + '\n' : text);
  return 0;
}

}  // namespace

int list(const std::string& topic, const std::string& machine, bool json) {
  if (topic == "signals") return list_signals(json);
  if (topic != "keys") return list_scenarios(json);
  if (machine == "kung") return list_keys<kung::Options>(json);
  return machine == "an693" ? list_keys<lm628::Options>(json) : list_keys<mcafee::Options>(json);
}

std::string version_text() {
  return fmt::format("trammel {} commit {}\nverilator {}, systemc {}, {}, {}", kVersion, kCommit,
                     kVerilator, kSystemC, kCompiler, kBuild);
}

int doctor(bool json) {
  struct Tool {
    const char* name;
    const char* use;
  };
  constexpr Tool kTools[] = {{"gnuplot", "path.svg and error.svg"},
                             {"fst2vcd", "--wave vcd"},
                             {"gtkwave", "looking at waves"}};
  Json all = versions_json();
  std::string text = version_text() + '\n';
  int missing = 0;
  for (const Tool& tool : kTools) {
    const std::string where = find_program(tool.name).string();
    all["tools"][tool.name] = where;
    text += fmt::format("{:<10}{:<26}{}\n", tool.name, where.empty() ? "MISSING" : where, tool.use);
    missing += where.empty() ? 1 : 0;
  }
  const std::size_t count = scenarios().size();
  all["scenarios"] = count;
  text += fmt::format("{} scenarios in {}\n", count, kScenarioFolder);
  fmt::print("{}", json ? all.dump(2) + '\n' : text);
  return missing > 0 || count == 0 ? 3 : 0;
}

}  // namespace trammel::testbench
