// SPDX-License-Identifier: Apache-2.0
//
// What `trammel run` leaves behind and how it exits, by the same rules for every machine.
#include "testbench/run.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/text.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "tests/support/files.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/short_run.hpp"
#include "tests/support/variable.hpp"

using namespace trammel;
using namespace trammel::testbench;
using Catch::Contains;
using cosim::EndReason;
using test::arguments_for;
using test::ending;
using test::entries;
namespace fs = std::filesystem;

namespace {

struct Scratch : test::Scratch {
  test::NoPrograms no_pictures;
  Scratch() : test::Scratch("run_test_out") {}
};

nlohmann::json metrics_of(const fs::path& folder) {
  return nlohmann::json::parse(test::content(folder / "metrics.json"));
}

int run_to(const fs::path& out, const lab::Machine& machine, EndReason end,
           std::vector<std::string> set = {}) {
  return test::run(arguments_for(test::scenario_of(machine), out, std::move(set)), ending(end));
}

// A simulation that must not start.
lab::Record never(const lab::Settings&, const cosim::Hooks&) {
  FAIL("a run that is refused was begun");
  return {};
}

template <class Check>
void each_machine(Check check) {
  for (const lab::Machine* const machine : lab::machines()) {
    CAPTURE(machine->name);
    const Scratch scratch;
    check(*machine, scratch.path);
  }
}

}  // namespace

TEST_CASE("a run leaves one folder with its record and nothing beside it") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    CHECK(run_to(base / "a", machine, EndReason::kDone) == 0);
    for (const char* file : {"metrics.json", "trace.csv", "run.toml", "report.html"}) {
      CAPTURE(file);
      CHECK(fs::file_size(base / "a" / file) > 0);
    }
    CHECK(entries(base) == 1);
    const auto json = metrics_of(base / "a");
    CHECK(json["machine"] == machine.name);
    CHECK(json["scenario"] == test::scenario_of(machine));
    CHECK(json["end"] == "done");
    CHECK(json["run"]["samples"] > 10);
    const std::string page = test::content(base / "a" / "report.html");
    for (const lab::Key& key : machine.keys()) {
      CAPTURE(key.name);
      CHECK(json["options"].contains(key.name));
      CHECK(page.find('"' + key.name + "\":{\"default\":") != std::string::npos);
    }
  });
}

TEST_CASE("without a report a run leaves no page") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    auto arguments = arguments_for(test::scenario_of(machine), base / "a");
    arguments.report = false;
    CHECK(test::run(arguments, ending(EndReason::kDone)) == 0);
    CHECK(fs::exists(base / "a" / "metrics.json"));
    CHECK_FALSE(fs::exists(base / "a" / "report.html"));
  });
}

TEST_CASE("how a run ended is its exit code, and its record is kept") {
  const struct {
    EndReason end;
    int code;
    const char* text;
  } ends[] = {{EndReason::kDone, 0, "done"},         {EndReason::kFault, 5, "tripped"},
              {EndReason::kDiverged, 5, "diverged"}, {EndReason::kTimeout, 5, "timeout"},
              {EndReason::kStopped, 130, "interrupted"},
              {EndReason::kAssertion, 4, "assertion failed"}};
  each_machine([&](const lab::Machine& machine, const fs::path& base) {
    for (const auto& [end, code, text] : ends) {
      CAPTURE(text);
      CHECK(run_to(base / text, machine, end) == code);
      CHECK(metrics_of(base / text)["end"] == text);
      CHECK(fs::file_size(base / text / "trace.csv") > 0);
    }
  });
}

TEST_CASE("a failed assertion is named in the record") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    CHECK(run_to(base / "a", machine, EndReason::kAssertion) == 4);
    const auto json = metrics_of(base / "a");
    CHECK(json["promise"]["name"] == "no_shoot_through");
    CHECK(json["promise"]["instance"] == "chip.u_leg");
    CHECK(json["promise"]["place"] == "drive/gate_leg_props.sv:7");
    CHECK(json["promise"]["clock"] == 617283);
    const std::string verdict = json["verdict"];
    CHECK_THAT(verdict, Contains("assertion failed: no_shoot_through of chip.u_leg at "
                                 "0.01234566 s, clock 617283 (drive/gate_leg_props.sv:7)",
                                 Catch::CaseSensitive::No));
  });
}

TEST_CASE("a second run replaces what the first wrote and leaves other files alone") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    const fs::path folder = base / "a";
    CHECK(run_to(folder, machine, EndReason::kDone) == 0);
    std::ofstream(folder / "notes.txt") << "mine";
    std::ofstream(folder / "report.html") << "of the first";
    CHECK(run_to(folder, machine, EndReason::kDone) == 0);
    CHECK(test::content(folder / "notes.txt") == "mine");
    CHECK(test::content(folder / "report.html") != "of the first");
    CHECK(fs::exists(folder / "metrics.json"));
    CHECK(entries(base) == 1);
  });
}

TEST_CASE("a name that cannot be a folder name is refused before anything is written") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    const test::WorkingFolder here(base);  // without -o a run goes to out/NAME
    for (const std::string& name : {std::string("../x"), std::string(), std::string("."),
                                    std::string(".hidden"), std::string("a/b"),
                                    std::string("a\nb"), std::string(201, 'x')}) {
      for (const char* out : {"", "a"}) {
        CAPTURE(name, out);
        const auto arguments =
            arguments_for(test::scenario_of(machine), out, {"name=" + name});
        CHECK_THROWS_AS(test::run(arguments, never), host::ConfigError);
        CHECK_THROWS_WITH(test::run(arguments, never),
                          Contains("name: " + host::shown(lab::value_text(name)) +
                                   " cannot name an output folder"));
      }
    }
    CHECK(entries(base) == 0);
  });
}

TEST_CASE("a run goes to out/NAME unless -o names another folder") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    const test::WorkingFolder here(base);
    CHECK(run_to("", machine, EndReason::kDone, {"name=a b"}) == 0);
    CHECK(fs::exists(base / "out" / "a b" / "metrics.json"));
    CHECK(run_to("", machine, EndReason::kDone) == 0);
    CHECK(fs::exists(base / "out" / test::scenario_of(machine) / "metrics.json"));
    CHECK(entries(base) == 1);
  });
}

TEST_CASE("a refused or failed run leaves nothing half written") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    const auto refused = [&](std::vector<std::string> set) {
      const auto arguments = arguments_for(test::scenario_of(machine), base / "a", std::move(set));
      CHECK_THROWS_AS(test::run(arguments, never), host::ConfigError);
    };
    refused({"run.max_s=-1"});
    refused({"no.such.key=1"});
    refused({"run.engine=twin", "run.audit=true"});
    const Simulate broken = [](const lab::Settings&, const cosim::Hooks&) -> lab::Record {
      throw std::runtime_error("broken");
    };
    CHECK_THROWS_WITH(test::run(arguments_for(test::scenario_of(machine), base / "a"), broken),
                      "broken");
    CHECK(entries(base) == 0);
  });
}

TEST_CASE("an impossible output folder is refused before the run") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    std::ofstream(base / "file") << "a file";
    for (const fs::path& out : {base / "file", base / "file" / "below"}) {
      CHECK_THROWS_AS(test::run(arguments_for(test::scenario_of(machine), out), never),
                      host::ConfigError);
      CHECK_THROWS_WITH(test::run(arguments_for(test::scenario_of(machine), out), never),
                        Contains("--out: "));
    }
    CHECK(entries(base) == 1);
  });
}

TEST_CASE("run.toml repeats the run") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    auto arguments =
        arguments_for(test::scenario_of(machine), base / "a", {"run.max_s=7.5", "name=other"});
    std::ofstream(base / "more.toml") << "description = 'quotes \" and \\'\nrun.max_s = 3\n";
    arguments.files = {(base / "more.toml").string()};
    arguments.keys = {{"--platform", "run.platform=direct"}};
    std::unique_ptr<lab::Settings> ran;
    const Simulate simulate = [&ran](const lab::Settings& settings, const cosim::Hooks&) {
      ran = settings.clone();
      return test::short_run(settings, EndReason::kDone);
    };
    REQUIRE(test::run(arguments, simulate) == 0);
    const auto again = lab::load_scenario(base / "a" / "run.toml");
    CHECK(&again->machine() == &machine);
    CHECK(again->scenario == "other");
    CHECK(again->description == "quotes \" and \\");
    CHECK(again->run.max_s == 7.5);
    CHECK(again->run.platform == cosim::Platform::kDirect);
    for (const lab::Key& key : machine.keys()) {
      CAPTURE(key.name);
      CHECK(key.get(*again) == key.get(*ran));
    }
  });
}

TEST_CASE("a check where nothing is expected exits 2, and the record is kept") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    // No source tells of a processor this slow.
    auto arguments =
        arguments_for(test::scenario_of(machine), base / "a", {"processor.access_clk=9"});
    arguments.check = true;
    CHECK(test::run(arguments, ending(EndReason::kDone)) == 2);
    CHECK(fs::exists(base / "a" / "metrics.json"));
    CHECK(test::run(arguments, ending(EndReason::kDiverged)) == 5);
    arguments.check = false;
    CHECK(test::run(arguments, ending(EndReason::kDone)) == 0);
  });
}

TEST_CASE("a check exits 1 where a figure lies outside its tolerance") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    auto arguments = arguments_for(test::scenario_of(machine), base / "a");
    for (const double off : {0.0, 0.4, 0.6}) {
      const Simulate simulate = [off](const lab::Settings& settings, const cosim::Hooks&) {
        lab::Record record = test::short_run(settings, EndReason::kDone);
        for (lab::Figure& figure : record.figures) figure.expected.reset();
        lab::Figure& figure = record.figures.back();
        figure.expected = figure.value + off;
        figure.tolerance = 0.5;
        return record;
      };
      CAPTURE(off);
      arguments.check = true;
      CHECK(test::run(arguments, simulate) == (off > 0.5 ? 1 : 0));
      const auto figure = metrics_of(base / "a")["figures"].back();
      CHECK(figure["within"] == (off < 0.5));
      CHECK(figure["tolerance"] == 0.5);
      arguments.check = false;
      CHECK(test::run(arguments, simulate) == 0);
    }
  });
}

TEST_CASE("a comparison run that did not end well sets the exit code") {
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    for (const auto& [end, code] : {std::pair{EndReason::kDone, 0}, {EndReason::kAssertion, 4}}) {
      const Simulate simulate = [end = end](const lab::Settings& settings, const cosim::Hooks&) {
        lab::Record record = test::short_run(settings, EndReason::kDone);
        record.companions.push_back(test::short_run(settings, end));
        record.companions.back().name = "other";
        return record;
      };
      CHECK(test::run(arguments_for(test::scenario_of(machine), base / "a"), simulate) == code);
      CHECK(metrics_of(base / "a")["compared"]["other"]["end"] == lab::end_text(end));
    }
  });
}

TEST_CASE("a run names one scenario, or asks for all experiments") {
  const Scratch scratch;
  Arguments arguments = arguments_for("", scratch.path / "a");
  CHECK_THROWS_WITH(test::run(arguments, never), Contains("run: name a scenario"));
  arguments.all = true;
  arguments.scenario = "circle";
  CHECK_THROWS_WITH(test::run(arguments, never),
                    "run: --all runs the experiments of the source and takes no scenario");
  CHECK(entries(scratch.path) == 0);
}

TEST_CASE("experiments that are stopped before they ended count as interrupted") {
  const Scratch scratch;
  std::atomic<bool> stop{false};
  Arguments arguments = arguments_for("", scratch.path);
  arguments.all = true;
  const Simulate stopped_behind = [&stop](const lab::Settings& settings, const cosim::Hooks&) {
    stop = true;
    return test::short_run(settings, EndReason::kDone);
  };
  CHECK(run(arguments, stop, stopped_behind) == 130);
  CHECK(entries(scratch.path) == 1);
}

TEST_CASE("the exit code of all experiments is the worst of theirs, whichever it is of") {
  const std::size_t count = lab::machines().front()->experiments.list.size();
  REQUIRE(count > 2);
  for (const std::size_t bad : {std::size_t{0}, count / 2, count - 1, count}) {
    for (const auto& [end, code] :
         {std::pair{EndReason::kDiverged, 5}, {EndReason::kAssertion, 4}}) {
      const Scratch scratch;
      Arguments arguments = arguments_for("", scratch.path);
      arguments.all = true;
      arguments.report = false;
      std::size_t run_so_far = 0;
      const Simulate simulate = [&, end = end](const lab::Settings& settings, const cosim::Hooks&) {
        return test::short_run(settings, run_so_far++ == bad ? end : EndReason::kDone);
      };
      CAPTURE(bad, code);
      CHECK(test::run(arguments, simulate) == (bad == count ? 0 : code));
      CHECK(run_so_far == count);
    }
  }
}

TEST_CASE("a key that the experiments set is refused with --all, wherever it comes from") {
  const Scratch scratch;
  Arguments arguments = arguments_for("", scratch.path / "a");
  arguments.all = true;
  arguments.report = false;
  arguments.assignments = {"controller=fc"};
  CHECK_THROWS_WITH(test::run(arguments, never),
                    "run: --all sets controller itself; do not set it as well");
  std::ofstream(scratch.path / "afc.toml") << "controller = 'afc'\n";
  arguments.assignments = {"plant.payload_kg=1"};
  CHECK(test::run(arguments, ending(EndReason::kDone)) == 0);
  CHECK(entries(scratch.path / "a") == lab::machines().front()->experiments.list.size());
  arguments.files = {(scratch.path / "afc.toml").string()};
  CHECK_THROWS_AS(test::run(arguments, never), host::ConfigError);
}

TEST_CASE("a key has the value of the layer that was asked for last") {
  const test::Variable variable("TRAMMEL_RUN_MAX_S", "3");
  each_machine([](const lab::Machine& machine, const fs::path& base) {
    const fs::path scenario = lab::find_scenario(test::scenario_of(machine));
    std::ofstream(base / "a.toml") << "run.max_s = 1\n";
    std::ofstream(base / "b.toml") << "run.max_s = 2\n";
    const auto asked = [&](const Arguments& arguments) {
      return layered(scenario, arguments)->run.max_s;
    };
    Arguments arguments;
    CHECK(asked(arguments) == 3);
    arguments.files = {(base / "a.toml").string(), (base / "b.toml").string()};
    CHECK(asked(arguments) == 3);
    {
      const test::Variable unset("TRAMMEL_RUN_MAX_S", nullptr);
      CHECK(asked(arguments) == 2);
    }
    arguments.assignments = {"run.max_s=4", "run.max_s=5"};
    CHECK(asked(arguments) == 5);
    arguments.keys = {{"--max", "run.max_s=6"}};
    CHECK(asked(arguments) == 6);
  });
}

TEST_CASE("a page is beside its run, that of the latest where none is named; of several in out/") {
  const Scratch scratch;
  const test::WorkingFolder inside(scratch.path);
  const std::string scenario = test::scenario_of(*lab::machines().front());
  for (const char* folder : {"out/a", "out/b"}) {
    Arguments arguments = arguments_for(scenario, folder);
    arguments.report = false;
    REQUIRE(test::run(arguments, ending(EndReason::kDone)) == 0);
  }
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time("out/b/metrics.json", now - std::chrono::hours(1));
  const struct {
    std::vector<std::string> folders;
    std::string out, page;
  } cases[] = {{{}, "", "out/a/report.html"},
               {{"out/b"}, "", "out/b/report.html"},
               {{"out/a", "out/b"}, "", "out/compare.html"},
               {{}, "own.html", "own.html"},
               {{"out/a", "out/b"}, "both.html", "both.html"}};
  for (const auto& one : cases) {
    CAPTURE(one.page);
    CHECK_FALSE(fs::exists(one.page));
    Arguments arguments;
    arguments.folders = one.folders;
    arguments.out = one.out;
    CHECK(test::on_stdout([&] { CHECK(report(arguments) == 0); }) == one.page + '\n');
    CHECK(fs::exists(one.page));
  }
}
