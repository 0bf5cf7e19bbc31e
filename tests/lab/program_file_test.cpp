// SPDX-License-Identifier: Apache-2.0
//
// Files that machines run in place of a scenario, by the same rules for every machine.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/files.hpp"
#include "lab/inputs.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::lab;
namespace fs = std::filesystem;

TEST_CASE("a program is run by the machine that knows its extension, named as its file") {
  std::set<std::string> seen;
  for (const Machine* const machine : machines()) {
    for (const std::string& extension : machine->program.extensions) {
      CAPTURE(machine->name, extension);
      CHECK(extension.front() == '.');
      CHECK(seen.insert(extension).second);  // one machine alone
      const std::string name = "some/my part=1" + extension;
      CHECK(find_scenario(name) == name);
      CHECK(machine_of_program(name) == machine);
      CHECK(&machine_of(name) == machine);
      const auto settings = load_scenario(name);
      CHECK(&settings->machine() == machine);
      CHECK(settings->scenario == "my part=1");
      const auto keys = find_keys(machine->keys(), machine->program.key);
      REQUIRE(keys.size() == 1);
      CHECK(keys.front()->kind == Kind::kFile);
      CHECK(std::get<std::string>(keys.front()->get(*settings)) == fs::absolute(name).string());
      for (const std::string& text : machine->program.assignments) {
        const auto set = machine->defaults();
        apply_assignment(*set, text);
        const Key* const key = find_keys(machine->keys(), text.substr(0, text.find('='))).front();
        CHECK(key->get(*settings) == key->get(*set));
      }
    }
  }
  CHECK(seen.size() == program_extensions().size());
}

TEST_CASE("what is kept of a program is what it was before the run, not what became of it") {
  for (const Machine* const machine : machines()) {
    for (const std::string& extension : machine->program.extensions) {
      CAPTURE(machine->name, extension);
      const test::Scratch scratch("program_file_test_copies");
      const std::string program = (scratch.path / ("part" + extension)).string();
      const auto settings = load_scenario(program);
      const fs::path folder = scratch.path / "run";
      fs::create_directory(folder);
      host::write_text(program, "before");
      copy_inputs(*settings, folder);
      host::write_text(program, "during the run");
      copy_inputs(*settings, folder);
      const std::string kept = (folder / (machine->program.key + extension)).string();
      CHECK(host::read_text(kept) == "before");
      fs::remove(kept);
      copy_inputs(*settings, folder);
      CHECK(host::read_text(kept) == "during the run");
    }
  }
}

TEST_CASE("a program that is named is run, or what keeps it from that is refused") {
  for (const Machine* const machine : machines()) {
    if (machine->program.extensions.empty()) continue;
    CAPTURE(machine->name);
    const std::string name = "part" + machine->program.extensions.front();
    const std::string file = fs::absolute(name).string();
    std::vector<std::string> changed{machine->program.key + "=other"};
    for (const std::string& text : machine->program.assignments) {
      const std::string key = text.substr(0, text.find('='));
      const Key& own = *find_keys(machine->keys(), key).front();
      for (const std::string& word : own.choices) {
        if (key + '=' + word != text) changed.push_back(key + '=' + word);
      }
    }
    CHECK(changed.size() > machine->program.assignments.size());
    for (const std::string& text : changed) {
      CAPTURE(text);
      const auto settings = load_scenario(name);
      apply_assignment(*settings, text);
      const auto copy = settings->clone();
      const std::string key = text.substr(0, text.find('='));
      const Key& own = *find_keys(machine->keys(), key).front();
      const std::string wanted = value_text(own.get(*load_scenario(name)));
      CHECK_THROWS_WITH(validate(*copy),
                        fmt::format("{}: {}: value {} must be {}: else this program is not run",
                                    file, key, value_text(own.get(*settings)), wanted));
    }
  }
}

TEST_CASE("without a folder of its run a program repeats by its name") {
  for (const Machine* const machine : machines()) {
    if (machine->program.extensions.empty()) continue;
    const std::string name = "no such part" + machine->program.extensions.front();
    const auto settings = load_scenario(name);
    const std::string command = "./trammel run '" + fs::absolute(name).string() + "'";
    CHECK(repeat_command(*settings) == command);
    apply_assignment(*settings, "run.max_s=7");
    CHECK(repeat_command(*settings) == command + " -s run.max_s=7.0");
    CHECK(repeat_command(*settings, "some/folder") == "./trammel run some/folder/run.toml");
    CHECK(repeat_command(*settings, fs::absolute("a folder")) ==
          "./trammel run 'a folder/run.toml'");
  }
}

TEST_CASE("a copy has the name of its key and the extension of its file, if that is a plain one") {
  for (const Machine* const machine : machines()) {
    if (machine->program.extensions.empty()) continue;
    const test::Scratch scratch("program_file_test_names");
    const Key& key = *find_keys(machine->keys(), machine->program.key).front();
    for (const auto& [file, extension] :
         {std::pair<std::string, std::string>{"a.b.nc", ".nc"}, {"a.seven67", ".seven67"},
          {"a.longer78", ""}, {"a.n-c", ""}, {"a", ""}, {"a.\xC3\xA9", ""}}) {
      CAPTURE(machine->name, file);
      const fs::path folder = scratch.path / ("run of " + file);
      fs::create_directory(folder);
      const std::string path = (scratch.path / file).string();
      const auto settings = machine->defaults();
      key.set(*settings, path);
      CHECK(std::get<std::string>(key.get(*with_copies(*settings, folder))) == path);
      copy_inputs(*settings, folder);  // there is no such file: nothing to copy
      CHECK(test::entries(folder) == 0);
      host::write_text(path, "it");
      copy_inputs(*settings, folder);
      CHECK(host::read_text(folder / (key.name + extension)) == "it");
      const auto copies = with_copies(*settings, folder);
      CHECK(std::get<std::string>(key.get(*copies)) == key.name + extension);
      CHECK(std::get<std::string>(key.get(*settings)) == path);
    }
  }
}

TEST_CASE("scenarios are in the order of their names, and a path is one that nobody looks for") {
  std::vector<std::string> names;
  for (const fs::path& file : scenarios()) names.push_back(file.filename().string());
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(find_scenario("no/such") == "no/such");
  CHECK(find_scenario("none.toml") == "none.toml");
  CHECK_THROWS_AS(find_scenario("none.tml"), host::ConfigError);
  for (const Machine* const machine : machines()) {
    for (const Experiment& experiment : machine->experiments.list) {  // of run --all
      const auto settings = load_scenario(find_scenario(experiment.scenario));
      settings->scenario = experiment.name;
      CHECK(repeat_command(*settings) == "./trammel run " + experiment.scenario);
    }
  }
}

TEST_CASE("the extension of a program may be in capitals, another one is that of a scenario") {
  for (std::string extension : program_extensions()) {
    std::transform(extension.begin(), extension.end(), extension.begin(), ::toupper);
    INFO("a program A" << extension << " is known");
    CHECK(machine_of_program("A" + extension) != nullptr);
  }
  CHECK(machine_of_program("circle") == nullptr);
  CHECK(machine_of_program("a.toml") == nullptr);
  CHECK(machine_of_program("") == nullptr);
  CHECK_THROWS_AS(find_scenario("none"), host::ConfigError);
}
