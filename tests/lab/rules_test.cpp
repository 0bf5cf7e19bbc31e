// SPDX-License-Identifier: Apache-2.0
//
// Which settings of every machine are refused before a run: names, and ways to observe a chip that
// exclude each other.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/text.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;

namespace {

constexpr char kAudit[] =
    "run.audit: compares a leaping chip with a plain one; not with --no-leap, --assert or waves";

// The message for these settings of the machine; "" when they can run.
std::string message_of(const Machine& machine, const std::vector<std::string>& assignments) {
  const auto settings = machine.defaults();
  return test::refusal_of([&] {
    for (const std::string& text : assignments) apply_assignment(*settings, text);
    validate(*settings);
  });
}

// A machine like the first one, whose chip declares neither a leap contract nor a twin and whose
// sessions cannot be made.
const Machine& bare();
struct BareSettings final : SettingsOf<BareSettings, bare> {
  BareSettings() { scenario = "bare"; }
};
const Machine& bare() {
  static const Machine description = [] {
    Machine m;
    m.name = "bare";
    m.can = {false, false};
    m.keys = machines().front()->keys;
    m.traces.triggers = machines().front()->traces.triggers;
    m.session = [](const Settings& settings, const cosim::Hooks&,
                   const cosim::Waves&) -> std::unique_ptr<cosim::Session> {
      if (settings.description.empty()) throw std::invalid_argument("plant.mass_kg: too small");
      throw cosim::OptionsError("path: nowhere");
    };
    return m;
  }();
  return description;
}

// One whose chip has what is given.
template <bool kLeap, bool kTwin>
const Machine& with();
template <bool kLeap, bool kTwin>
struct WithSettings final : SettingsOf<WithSettings<kLeap, kTwin>, with<kLeap, kTwin>> {
  WithSettings() { this->scenario = "with"; }
};
template <bool kLeap, bool kTwin>
const Machine& with() {
  static const Machine description = [] {
    Machine m = bare();
    m.name = "with";
    m.can.leap = kLeap;
    m.can.twin = kTwin;
    return m;
  }();
  return description;
}

}  // namespace

TEST_CASE("a chip without a leap contract has no audit, one without a twin no run of it") {
  const struct {
    std::unique_ptr<Settings> settings;
    bool leap, twin;
  } cases[] = {{WithSettings<false, false>().clone(), false, false},
               {WithSettings<true, false>().clone(), true, false},
               {WithSettings<false, true>().clone(), false, true},
               {WithSettings<true, true>().clone(), true, true}};
  for (const auto& one : cases) {
    const auto refusal = [&](bool audit, bool twin) -> std::string {
      const auto settings = one.settings->clone();
      settings->run.audit = audit;
      settings->run.engine = twin ? cosim::Engine::kTwin : cosim::Engine::kRtl;
      return test::refusal_of([&] { validate(*settings); });
    };
    CAPTURE(one.leap, one.twin);
    CHECK(refusal(true, false) ==
          (one.leap ? ""
                    : "run.audit: the machine with declares no leap contract, so that no clock is "
                      "leapt over and there is nothing to compare"));
    CHECK(refusal(false, true) ==
          (one.twin ? ""
                    : "run.engine: the machine with declares no bit-exact twin of its chip"));
  }
}

TEST_CASE("a name that cannot be a folder name is refused by every machine") {
  const std::string bad[] = {"",         "../x",       "/etc",        "a/b",
                             ".",        "..",         ".hidden",     "a/",
                             "a\nb",     "a\tb",       "\x7f",        std::string("a\0b", 3),
                             "\x1b[31m", std::string(201, 'x'), "\xff", "\xC2\x9B"};
  const std::string good[] = {"a", "a.b", "a b", "-", "\xc3\xa9", "it's \"one\"",
                              std::string(200, 'x')};
  for (const Machine* const machine : machines()) {
    for (const std::string& name : bad) {
      CAPTURE(machine->name, name);
      const auto settings = machine->defaults();
      settings->scenario = name;
      CHECK_THROWS_WITH(validate(*settings),
                        fmt::format("name: {} cannot name an output folder: 1 to 200 bytes of "
                                    "UTF-8, no slash or control character, no dot at the start",
                                    host::shown(value_text(name))));
      CHECK_THAT(message_of(*machine, {"name=" + name}), !Catch::Contains("\n"));
    }
    for (const std::string& name : good) {
      CAPTURE(machine->name, name);
      CHECK(message_of(*machine, {"name=" + name}).empty());
    }
  }
}

TEST_CASE("an audit compares a plain chip with a leaping one, and nothing else beside it") {
  for (const Machine* const machine : machines()) {
    if (!machine->can.leap) continue;
    CAPTURE(machine->name);
    CHECK(message_of(*machine, {"run.audit=true"}).empty());
    CHECK(message_of(*machine, {"run.audit=true", "run.platform=direct"}).empty());
    const std::string trigger = std::string("run.wave_trigger=") + machine->traces.triggers().start;
    for (const std::string& beside : {std::string("run.leap=false"),
                                      std::string("run.assertions=true"),
                                      std::string("run.wave=fst"), trigger}) {
      CAPTURE(beside);
      CHECK(message_of(*machine, {"run.audit=true", beside}) == kAudit);
      CHECK(message_of(*machine, {beside}).empty());
    }
  }
}

TEST_CASE("a twin has no signals, assertions or clocks to look at") {
  for (const Machine* const machine : machines()) {
    if (!machine->can.twin) continue;
    CAPTURE(machine->name);
    const std::string twin = "run.engine=twin";
    CHECK(message_of(*machine, {twin}).empty());
    const std::string trigger = std::string("run.wave_trigger=") + machine->traces.triggers().start;
    for (const std::string& waves : {std::string("run.wave=fst"), trigger}) {
      CHECK(message_of(*machine, {twin, waves}) ==
            "run.engine: the twin has no signals to trace; waves and triggers need the RTL "
            "(--engine rtl)");
    }
    CHECK(message_of(*machine, {twin, "run.assertions=true"}) ==
          "run.engine: the twin has no assertions; --assert needs the RTL (--engine rtl)");
    CHECK(message_of(*machine, {twin, "run.domains=false"}) ==
          "run.domains: the twin has no clock domains; the RTL has (--engine rtl)");
    for (const char* clocks : {"run.leap=false", "run.audit=true"}) {
      CHECK(message_of(*machine, {twin, clocks}) ==
            "run.engine: the twin has no clocks to evaluate; --no-leap and --audit need the RTL "
            "(--engine rtl)");
    }
    CHECK(message_of(*machine, {twin, "run.audit=true", "run.leap=false"}) == kAudit);
  }
}

TEST_CASE("what only plant or firmware can refuse is still the user's mistake") {
  BareSettings settings;
  CHECK_THROWS_AS(run(settings), host::ConfigError);
  CHECK_THROWS_WITH(run(settings), "plant.mass_kg: too small");
  settings.description = "with a path";
  CHECK_THROWS_AS(run(settings), host::ConfigError);
  CHECK_THROWS_WITH(run(settings), "path: nowhere");
}

TEST_CASE("a file names its machine; one that does not is for the first") {
  const std::filesystem::path file = "rules_test.toml";
  const auto written = [&file](const std::string& text) {
    std::ofstream(file) << text;
    return &machine_of(file);
  };
  CHECK(written("[path]\nkind = 'circle'\n") == machines().front());
  CHECK(written("machine = [\n") == machines().front());  // who reads it tells what is wrong
  for (const Machine* const machine : machines()) {
    CHECK(written("machine = '" + machine->name + "'\n") == machine);
    const std::string wrong = machine->name + 'x';
    CHECK_THROWS_WITH(written("\nmachine = '" + wrong + "'\n"),
                      Contains("rules_test.toml:2: machine: value \"" + wrong + '"') &&
                          Contains("did you mean " + machine->name + '?'));
  }
  std::filesystem::remove(file);
}

TEST_CASE("every built-in scenario loads, can run, names its machine and repeats by its name") {
  for (const Machine* const machine : machines()) {
    std::size_t of_this = 0;
    for (const auto& file : scenarios()) {
      if (&machine_of(file) != machine) continue;
      ++of_this;
      CAPTURE(file);
      const auto settings = load_scenario(file);
      CHECK(&settings->machine() == machine);
      CHECK(settings->scenario == file.stem());
      CHECK_FALSE(settings->description.empty());
      CHECK_NOTHROW(validate(*settings));
      CHECK(find_scenario(settings->scenario) == file);
      const std::string command = "./trammel run " + settings->scenario;
      CHECK(repeat_command(*settings) == command);
      apply_assignment(*settings, "run.max_s=0.5");
      CHECK(repeat_command(*settings) == command + " -s run.max_s=0.5");
      apply_assignment(*settings, "run.wave_trigger=x > 1 after 2ms");  // a shell takes it apart
      CHECK(repeat_command(*settings) == command + " -s run.max_s=0.5 -s "
                                                   "'run.wave_trigger=x > 1 after 2ms'");
      settings->scenario = "mine";
      CHECK(repeat_command(*settings) == "./trammel run run.toml");
    }
    CAPTURE(machine->name);
    CHECK(of_this > 0);
  }
  CHECK_THROWS_WITH(find_scenario("circel"), Contains("did you mean circle?"));
}

TEST_CASE("a run that sets up to eight keys repeats by these, one with more by its record") {
  const auto settings = load_scenario(find_scenario("circle"));
  int set = 0;
  for (const std::string axis : {"x", "y"}) {
    for (const std::string key : {"payload_kg", "coulomb_N", "viscous_N_s_m", "cogging_N",
                                  "pole_pitch_m"}) {
      const std::string text = "plant." + axis + '.' + key + "=0.125";
      apply_assignment(*settings, text);
      CAPTURE(text);
      ++set;
      const std::string repeated = repeat_command(*settings);
      if (set > 8) {
        CHECK(repeated == "./trammel run run.toml");
      } else {
        CHECK_THAT(repeated, Catch::StartsWith("./trammel run circle -s "));
        CHECK_THAT(repeated, Contains(" -s " + text));
      }
      CHECK(std::count(repeated.begin(), repeated.end(), '=') == (set > 8 ? 0 : set));
      settings->scenario = "circle-fc";  // as run --all names it
      CHECK(repeat_command(*settings) == repeated);
      settings->scenario = "circle";
    }
  }
}
