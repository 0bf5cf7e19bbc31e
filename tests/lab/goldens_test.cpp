// SPDX-License-Identifier: Apache-2.0
//
// Goldens of all machines: the description of each, its columns and its keys. A key and the member
// that it sets stand at the same rank, so keys that are swapped change the golden.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "tests/support/files.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/message.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using lab::Kind;

namespace {

using Lines = std::vector<std::string>;

// "  name: one, two", as many lines as it takes.
std::string paragraph(const std::string& name, const Lines& words) {
  if (words.empty()) return "";
  std::string text, line = "  " + name + ':';
  for (const std::string& word : words) {
    if (line.size() + word.size() > 98) {
      text += line + '\n';
      line = "     ";
    }
    line += ' ' + word + (&word == &words.back() ? "" : ",");
  }
  return text + line + '\n';
}

// How trace.csv prints it, and its resolution on the page: "t_s .8 1e-08", of a whole number
// "call 1"; * is compared on a page of several runs, # are flags.
std::string column_text(const lab::Column& column) {
  const int digits = column.format.digits;
  std::string text = column.name;
  if (column.format.kind == lab::Format::Kind::kFixed) text += fmt::format(" .{}", digits);
  if (column.format.kind == lab::Format::Kind::kGeneral) text += fmt::format(" g{}", digits);
  return text + fmt::format(" {:g}{}{}", column.resolution, column.compared ? " *" : "",
                            column.bits ? " #" : "");
}

lab::Value other_value(const lab::Key& key, const lab::Value& was) {
  switch (key.kind) {
    case Kind::kFlag: return !std::get<bool>(was);
    case Kind::kInteger: {
      const auto least = static_cast<std::int64_t>(key.min);
      return std::get<std::int64_t>(was) == least ? static_cast<std::int64_t>(key.max) : least;
    }
    case Kind::kReal: return std::get<double>(was) == key.min ? key.max : key.min;
    case Kind::kChoice:
      return std::get<std::string>(was) == key.choices[0] ? key.choices.back() : key.choices[0];
    default: return std::get<std::string>(was) + "1";
  }
}

// The bytes of an object, without those that it points to.
std::vector<unsigned char> bytes_of(const lab::Settings& settings) {
  const void* const whole = dynamic_cast<const void*>(&settings);
  const auto* const begin = static_cast<const unsigned char*>(whole);
  return {begin, begin + malloc_usable_size(const_cast<void*>(whole))};
}

// Sets a key, which must change nothing that another key reads. Where its member begins.
std::size_t place_of(const lab::Machine& machine, const lab::Key& key) {
  const std::unique_ptr<lab::Settings> settings = machine.defaults();
  const auto defaults = machine.defaults();
  const auto before = bytes_of(*settings);
  const lab::Value value = other_value(key, key.get(*settings));
  INFO("key " << key.name);
  key.set(*settings, value);
  CHECK(key.get(*settings) == value);
  for (const lab::Key& other : machine.keys()) {
    if (&other == &key || other.get(*settings) == other.get(*defaults)) continue;
    FAIL_CHECK("it also sets " << other.name);
  }
  const auto after = bytes_of(*settings);
  const auto changed = std::mismatch(before.begin(), before.end(), after.begin()).first;
  return static_cast<std::size_t>(changed - before.begin());
}

// Keys in the order of their members in memory, by sections.
std::string keys_text(const lab::Machine& machine) {
  std::vector<std::pair<std::size_t, std::string>> places;
  for (const lab::Key& key : machine.keys()) places.emplace_back(place_of(machine, key), key.name);
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text = "  keys in the order of their members:\n", section;
  Lines names;
  for (const auto& [place, name] : places) {
    const std::size_t dot = name.rfind('.');
    const std::string own = dot == std::string::npos ? "-" : name.substr(0, dot);
    if (own != section) text += paragraph("  " + section, std::exchange(names, {}));
    section = own;
    names.push_back(dot == std::string::npos ? name : name.substr(dot + 1));
  }
  return text + paragraph("  " + section, names);
}

// What is said of each end of a run, here of its first 20 ms.
std::string ends_text(const lab::Machine& machine) {
  using End = cosim::EndReason;
  const auto settings = lab::load_scenario(lab::find_scenario(test::scenario_of(machine)));
  const auto result = test::short_result(*settings, End::kAssertion);
  std::string text = "  ends of a run:\n";
  CHECK(machine.verdict(*settings, *result) ==
        "assertion failed: " + lab::assertion_text(*result->assertion, result->clock_ps));
  for (const End end : {End::kDone, End::kMissed, End::kFault, End::kDiverged, End::kTimeout,
                        End::kStopped}) {
    result->end = end;
    text += fmt::format("    {}: {}\n", lab::end_text(end), machine.verdict(*settings, *result));
  }
  return text;
}

// What a trigger may name of an axis or of the whole, with its bits: "e s12", "irq 1".
Lines signals_of(const lab::Machine& machine, bool axis) {
  Lines all;
  for (const cosim::Signal& one : machine.traces.triggers().signals) {
    if (one.of_axis != axis) continue;
    all.push_back(fmt::format("{} {}{}", one.name, one.is_signed ? "s" : "", one.bits));
  }
  return all;
}

std::string machine_text(const lab::Machine& m) {
  std::string text = fmt::format("\n{}: {}\n", m.name, m.title);
  text += paragraph("source", {m.source, fmt::format("order {}", m.order)});
  text += paragraph("can", {m.can.leap ? "leap" : "not leap", m.can.twin ? "twin" : "no twin"});
  text += paragraph("traces in bytes/s", {fmt::format("VCD {:g}", m.traces.vcd_bytes_s),
                                          fmt::format("FST {:g}", m.traces.fst_bytes_s)});
  const std::string& described = m.described.by;
  text += paragraph("description of", described.empty() ? Lines{} : Lines{described});
  text += paragraph("program files", m.program.extensions) +
          paragraph("their key", m.program.key.empty() ? Lines{} : Lines{m.program.key}) +
          paragraph("their settings", m.program.assignments);
  Lines gives;
  const auto give = [&gives](const char* what, bool given) {
    if (given) gives.emplace_back(what);
  };
  give("alters", m.described.alters != nullptr);
  give("validate", m.validate != nullptr);
  give("warnings", m.texts.warnings != nullptr);
  give("remarks", m.texts.remarks != nullptr);
  give("companions", m.compared.companions != nullptr);
  give("run_name", m.compared.run_name != nullptr);
  give("metrics", m.files.metrics != nullptr);
  give("detail", m.files.detail != nullptr);
  give("files", m.files.write != nullptr);
  give("drawn", m.files.drawn != nullptr);
  give("experiments_text", m.experiments.text != nullptr);
  text += paragraph("gives", gives) + paragraph("live", m.live);
  text += paragraph("texts", m.page.texts) + paragraph("counts", m.page.counts) +
          paragraph("numbers", m.page.numbers) + paragraph("objects", m.page.objects) +
          paragraph("arrays", m.page.arrays);
  for (const lab::Experiment& one : m.experiments.list) {
    Lines words{one.scenario};
    words.insert(words.end(), one.assignments.begin(), one.assignments.end());
    words.push_back(one.page);
    text += paragraph("experiment " + one.name, words);
  }
  text += ends_text(m) + paragraph("waves begin at", {m.traces.triggers().start}) +
          paragraph("signals of x and of y", signals_of(m, true)) +
          paragraph("signals", signals_of(m, false));
  Lines columns, derived;
  for (const lab::Column& column : m.columns().columns) columns.push_back(column_text(column));
  for (const lab::Column& column : m.page.derived) derived.push_back(column_text(column));
  return text + paragraph("columns", columns) + paragraph("derived", derived) + keys_text(m);
}

std::string said_of(const lab::Machine& machine, const std::string& assignments) {
  const auto settings = machine.defaults();
  const std::string said = test::refusal_of([&] {
    std::istringstream words(assignments);
    for (std::string word; words >> word;) lab::apply_assignment(*settings, word);
    lab::validate(*settings);
  });
  if (!said.empty()) return "  " + said + '\n';
  std::string text = "  can run\n";
  if (machine.texts.warnings == nullptr) return text;
  for (const std::string& line : machine.texts.warnings(*settings)) text += "  " + line + '\n';
  return text;
}

}  // namespace

TEST_CASE("each machine describes itself as in its golden, and each key sets its own member") {
  std::string text = "Machines, described by themselves; scripts/tool gen-manual writes this.\n";
  for (const lab::Machine* const machine : lab::machines()) text += machine_text(*machine);
  test::check_golden("machines.txt", text);
}

TEST_CASE("what is said of settings before they run is their golden") {
  const lab::Machine* machine = nullptr;
  std::istringstream before(test::content(test::golden_file("settings.txt")));
  std::string text;
  for (std::string line; std::getline(before, line);) {
    if (line.rfind("  ", 0) == 0) continue;  // what was said
    text += line + '\n';
    if (const lab::Machine* const named = lab::find_machine(line)) machine = named;
    if (line[0] == '#' || line.find('=') == std::string::npos) continue;
    REQUIRE(machine != nullptr);
    text += said_of(*machine, line);
  }
  test::check_golden("settings.txt", text);
}
