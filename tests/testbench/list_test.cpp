// SPDX-License-Identifier: Apache-2.0
//
// Lists of the program, its doctor, and its launcher.
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "cosim/trigger.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "lab/settings.hpp"
#include "lab/write.hpp"
#include "testbench/run.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using Catch::Contains;

namespace {

std::string listed(const std::string& topic, const std::string& machine, bool json) {
  return test::on_stdout([&] { CHECK(testbench::list(topic, machine, json) == 0); });
}

}  // namespace

TEST_CASE("each key, column and scenario is listed with what belongs to it") {
  for (const lab::Machine* const machine : lab::machines()) {
    CAPTURE(machine->name);
    const auto defaults = machine->defaults();
    const auto keys = nlohmann::json::parse(listed("keys", machine->name, true));
    const std::string text = listed("keys", machine->name, false);
    REQUIRE(keys.size() == machine->keys().size());
    bool axes = false;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const lab::Key& key = machine->keys()[k];
      axes = axes || key.name.find(".x.") != std::string::npos;
      CHECK(keys[k] == nlohmann::json{{"key", key.name},
                                      {"default", lab::value_text(key.get(*defaults))},
                                      {"range", lab::range_text(key)},
                                      {"help", key.help}});
      CHECK_THAT(text, Contains('\n' + key.name + ' ') || Catch::StartsWith(key.name + ' '));
    }
    CHECK((text.find("without its .x or .y sets both axes.\n\n") != std::string::npos) == axes);
    const auto columns = nlohmann::json::parse(listed("columns", machine->name, true));
    REQUIRE(columns.size() == machine->columns().columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const lab::Column& column = machine->columns().columns[k];
      CHECK(columns[k] == nlohmann::json{{"column", column.name}, {"unit", column.unit},
                                         {"help", column.help}});
    }
  }
  const auto scenarios = nlohmann::json::parse(listed("scenarios", "", true));
  REQUIRE(scenarios.size() == lab::scenarios().size());
  for (const auto& one : scenarios) {
    const std::string name = one["name"];
    CAPTURE(name);
    const auto settings = lab::load_scenario(lab::find_scenario(name));
    CHECK(one["machine"] == settings->machine().name);
    CHECK(one["description"] == settings->description);
  }
  CHECK(listed("columns", "", true) == listed("columns", lab::machines().front()->name, true));
  CHECK(listed("keys", "", true) == listed("keys", lab::machines().front()->name, true));
}

TEST_CASE("what a list tells a program it tells people too, in a line each and in its order") {
  const auto check = [](const std::string& topic, const std::string& machine,
                        const std::vector<std::string>& members, bool two_lines = false) {
    CAPTURE(topic, machine);
    std::istringstream lines(listed(topic, machine, false));
    for (const auto& one : nlohmann::json::parse(listed(topic, machine, true))) {
      std::string line, more;
      REQUIRE(std::getline(lines, line));
      if (two_lines && std::getline(lines, more)) line += ' ' + more;
      std::size_t at = 0;
      for (const std::string& member : members) {
        const std::string text = one[member];
        CAPTURE(line, text);
        CHECK((member != members.front() || line.rfind(text, 0) == 0));
        at = line.find(text, at);
        REQUIRE(at != std::string::npos);
        at += text.size();
      }
    }
    std::string more;
    CHECK_FALSE(std::getline(lines, more));
  };
  check("scenarios", "", {"name", "description"});
  check("machines", "", {"name", "title", "source"}, true);
  for (const lab::Machine* const machine : lab::machines()) {
    check("columns", machine->name, {"column", "unit", "help"});
  }
}

TEST_CASE("signals are those of the machine that is named, or of all") {
  std::size_t all = 0;
  for (const lab::Machine* const machine : lab::machines()) {
    CAPTURE(machine->name);
    const auto own = nlohmann::json::parse(listed("signals", machine->name, true));
    all += own.size();
    for (const auto& one : own) CHECK(one["machine"] == machine->name);
    std::istringstream lines(listed("signals", machine->name, false));
    std::size_t of_axis = 0;
    for (std::string line; std::getline(lines, line);) of_axis += line.rfind("x. y.", 0) == 0;
    std::size_t wanted = 0;
    for (const cosim::Signal& signal : machine->traces.triggers().signals) wanted += signal.of_axis;
    CHECK(of_axis == wanted);
  }
  CHECK(nlohmann::json::parse(listed("signals", "", true)).size() == all);
  const auto machines = nlohmann::json::parse(listed("machines", "", true));
  REQUIRE(machines.size() == lab::machines().size());
  for (std::size_t k = 0; k < machines.size(); ++k) {
    const lab::Machine& machine = *lab::machines()[k];
    CHECK(machines[k] == nlohmann::json{{"name", machine.name}, {"title", machine.title},
                                        {"source", machine.source}, {"leap", machine.can.leap},
                                        {"twin", machine.can.twin}});
  }
}

TEST_CASE("each example of a trigger that a machine's list of signals has is a trigger of it") {
  const std::regex form(R"((?:at \d+ms)|(rise\|fall\|change [\w.]+)|(?:[\w.]+ (?:>|==) \d+))");
  for (const lab::Machine* const machine : lab::machines()) {
    const cosim::TriggerForms& forms = machine->traces.triggers();
    const std::string help = forms.help;
    int examples = 0;
    for (std::sregex_iterator at(help.begin(), help.end(), form), none; at != none; ++at) {
      const std::string text = (*at)[1].matched ? at->str().substr(10) : at->str();
      CAPTURE(machine->name, text);
      CHECK_NOTHROW(cosim::parse_trigger(text, forms, 20'000));
      ++examples;
    }
    CHECK(examples == 3);
  }
}

TEST_CASE("a trigger takes the range of its signal that is listed, both ends and nothing beyond") {
  for (const lab::Machine* const machine : lab::machines()) {
    const cosim::TriggerForms& forms = machine->traces.triggers();
    const std::string text =
        test::on_stdout([&] { CHECK(testbench::list("signals", machine->name, true) == 0); });
    const auto listed = nlohmann::json::parse(text);
    REQUIRE(listed.size() == forms.signals.size());
    for (const auto& one : listed) {
      const std::string name = one["signal"], range = one["range"];
      CAPTURE(machine->name, name, range);
      const std::int64_t low = std::stoll(range);
      const std::int64_t high = std::stoll(range.substr(range.find("..") + 2));
      for (const std::int64_t value : {low, high}) {
        const std::string asked = fmt::format("{} >= {}", name, value);
        CHECK(cosim::parse_trigger(asked, forms, 20'000).value == value);
      }
      for (const std::int64_t value : {low - 1, high + 1}) {
        const std::string asked = fmt::format("{} >= {}", name, value);
        CHECK_THROWS_WITH(cosim::parse_trigger(asked, forms, 20'000),
                          fmt::format("{}: value {} is out of range {}", name, value, range));
      }
    }
  }
}

TEST_CASE("the doctor names each program that is missing, and exits with 0 without them") {
  const test::Scratch scratch("doctor_test_out");
  const test::NoPrograms none;
  int code = 0;
  const std::string told = test::on_stdout([&] { code = testbench::doctor(true); });
  CHECK(code == 0);
  const auto tools = nlohmann::json::parse(told)["tools"];
  REQUIRE(tools.size() >= 3);
  CHECK(nlohmann::json::parse(told)["scenarios"] == lab::scenarios().size());
  const auto versions = lab::versions_json();
  for (const auto& [name, version] : versions.items()) {
    CHECK(nlohmann::json::parse(told)[name] == version.get<std::string>());
  }
  for (const auto& [name, where] : tools.items()) CHECK(where == "");

  setenv("PATH", scratch.path.c_str(), 1);
  for (const auto& [name, where] : tools.items()) {
    std::ofstream(scratch.path / name) << "#!/bin/sh\n";
    chmod((scratch.path / name).c_str(), 0755);
  }
  const std::string all = test::on_stdout([&] { code = testbench::doctor(false); });
  CHECK(code == 0);
  for (const auto& [name, where] : tools.items()) {  // however long it is, its use stands behind
    CHECK_THAT(all, Contains((scratch.path / name).string() + ' '));
  }
  for (const auto& [name, where] : tools.items()) {
    INFO("without " << name);
    chmod((scratch.path / name).c_str(), 0644);  // no program
    const std::string text = test::on_stdout([&] { code = testbench::doctor(false); });
    CHECK(code == 0);
    const std::string line = text.substr(text.find("\n" + name) + 1);
    CHECK_THAT(line.substr(0, line.find('\n')), Contains(" missing ") && Contains(" optional: "));
    chmod((scratch.path / name).c_str(), 0755);
  }
  lab::take_data_from((scratch.path / "none").string());  // the last: no scenario is left
  const std::string text = test::on_stdout([&] { code = testbench::doctor(false); });
  CHECK(code == 3);
  CHECK_THAT(text, Contains("\n0 scenarios in " + (scratch.path / "none").string()));
}

TEST_CASE("what a program lacks is left to its launcher, which learns the name of the next one") {
  std::string words[] = {"trammel", "-c", "[ \"$TRAMMEL_PROGRAM\" = trammel_x ] && exit 7"};
  char* line[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("TRAMMEL_LAUNCHER");
    testbench::hand_over("trammel_y", line);
    setenv("TRAMMEL_LAUNCHER", "/bin/sh", 1);
    testbench::hand_over("trammel_x", line);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 7);
}
