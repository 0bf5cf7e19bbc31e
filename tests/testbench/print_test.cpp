// SPDX-License-Identifier: Apache-2.0
//
// What `trammel run` and `trammel report` print, and which of several exit codes is the run's.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/files.hpp"
#include "host/text.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "tests/support/files.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using namespace trammel::testbench;
using Catch::Contains;
using cosim::EndReason;
using nlohmann::json;
using test::arguments_for;
using test::ending;
namespace fs = std::filesystem;

namespace {

struct Scratch : test::Scratch {
  test::NoPrograms no_pictures;
  Scratch() : test::Scratch("print_test_out") {}
};

const lab::Machine& first() { return *lab::machines().front(); }

}  // namespace

TEST_CASE("a run prints its report, or one document, and the clock domains where asked to") {
  const Scratch scratch;
  auto arguments = arguments_for(test::scenario_of(first()), scratch.path / "a");
  arguments.report = false;
  const auto printed = [&](EndReason end) {
    return test::on_stdout([&] { test::run(arguments, ending(end)); });
  };
  const std::string text = printed(EndReason::kDone);
  CHECK_THAT(text, Catch::StartsWith(arguments.scenario) && Contains("results in ") &&
                       !Contains("clock domains") && !Contains("report: "));
  const auto settings = lab::load_scenario(lab::find_scenario(arguments.scenario));
  CHECK_THAT(text, Contains("\n  " + settings->description + '\n'));
  arguments.activity = true;
  CHECK_THAT(printed(EndReason::kDone), Contains("clock domains: only the leaping RTL"));
  arguments.json = true;
  for (const EndReason end : {EndReason::kDone, EndReason::kFault, EndReason::kStopped}) {
    const json document = json::parse(printed(end));  // one, and nothing else
    CHECK(document["end"] == lab::end_text(end));
    CHECK(document == json::parse(test::content(scratch.path / "a" / "metrics.json")));
  }
}

TEST_CASE("the run's own end is told before that of what it is compared with") {
  const Scratch scratch;
  auto arguments = arguments_for(test::scenario_of(first()), scratch.path / "a");
  arguments.report = false;
  for (const auto& [own, beside, code] :
       {std::tuple{EndReason::kDone, EndReason::kAssertion, 4},
        {EndReason::kFault, EndReason::kDone, 5}, {EndReason::kFault, EndReason::kAssertion, 5},
        {EndReason::kAssertion, EndReason::kFault, 4}, {EndReason::kDone, EndReason::kDone, 0}}) {
    const Simulate simulate = [own = own, beside = beside](const lab::Settings& settings,
                                                           const cosim::Hooks&) {
      lab::Record record = test::short_run(settings, own);
      record.companions.push_back(test::short_run(settings, beside));
      record.companions.back().name = "other";
      return record;
    };
    CAPTURE(lab::end_text(own), lab::end_text(beside));
    int got = -1;
    const std::string told =
        test::on_stderr([&] { test::on_stdout([&] { got = test::run(arguments, simulate); }); });
    CHECK(got == code);
    const std::string name = "trammel: " + arguments.scenario;
    CHECK((told.find(fmt::format("{}: {}", name, lab::end_text(own))) != std::string::npos) ==
          (own != EndReason::kDone));
    CHECK((told.find(fmt::format("{}, other: {}", name, lab::end_text(beside))) !=
           std::string::npos) == (beside != EndReason::kDone));
  }
}

TEST_CASE("an interrupt behind the run is told, and no check of figures follows it") {
  const Scratch scratch;
  auto arguments = arguments_for(test::scenario_of(first()), scratch.path / "a");
  arguments.report = false;
  std::atomic<bool> stop{false};
  const Simulate simulate = [&stop](const lab::Settings& settings, const cosim::Hooks&) {
    stop = true;
    return test::short_run(settings, EndReason::kDone);
  };
  int code = 0;
  const std::string told =
      test::on_stderr([&] { test::on_stdout([&] { code = run(arguments, stop, simulate); }); });
  CHECK(code == 130);
  CHECK_THAT(told, Contains(arguments.scenario + ": interrupted after the run; record kept in "));
  CHECK_THAT(told, Contains("no pictures: gnuplot is missing"));
}

TEST_CASE("experiments print a document each, under their own names, or their table") {
  const Scratch scratch;
  const auto& experiments = first().experiments.list;
  REQUIRE(experiments.size() > 2);
  Arguments arguments = arguments_for("", scratch.path);
  arguments.all = true;
  arguments.report = false;
  arguments.json = true;
  const auto printed = [&] {
    return test::on_stdout([&] { CHECK(test::run(arguments, ending(EndReason::kDone)) == 0); });
  };
  std::string told;
  json documents;
  told = test::on_stderr([&] { documents = json::parse(printed()); });
  REQUIRE(documents.size() == experiments.size());
  for (std::size_t k = 0; k < experiments.size(); ++k) {
    const std::string& name = experiments[k].name;
    CAPTURE(name);
    CHECK(documents[k]["scenario"] == name);
    CHECK(documents[k] == json::parse(test::content(scratch.path / name / "metrics.json")));
    CHECK_THAT(told, Contains("trammel: " + name + ": "));
  }
  CHECK_FALSE(fs::exists(scratch.path / "index.html"));
  arguments.json = false;
  std::string text;
  test::on_stderr([&] { text = printed(); });
  CHECK(text.find("report: ") == std::string::npos);
}

TEST_CASE("a page of experiments that cannot be made is told, and makes the exit code 2") {
  for (const EndReason end : {EndReason::kDone, EndReason::kAssertion}) {
    const Scratch scratch;
    Arguments arguments = arguments_for("", scratch.path);
    arguments.all = true;
    const auto run = ending(end);
    const Simulate simulate = [&](const lab::Settings& settings, const cosim::Hooks& hooks) {
      for (const lab::Experiment& one : first().experiments.list) {  // which were not there before
        fs::create_directories(scratch.path / one.page);
      }
      return run(settings, hooks);
    };
    int code = 0;
    std::string printed;
    const std::string told = test::on_stderr([&] {
      printed = test::on_stdout([&] { code = test::run(arguments, simulate); });
    });
    CHECK(code == (end == EndReason::kDone ? 2 : 4));
    CHECK_THAT(told, Contains("no report: ") && Contains("; the results are kept"));
    for (const auto& one : first().experiments.list) CHECK_THAT(told, Contains(one.page));
    CHECK(printed.find("report: ") == std::string::npos);
    CHECK(fs::exists(scratch.path / first().experiments.list.back().name / "report.html"));
  }
}

TEST_CASE("experiments are not put among files that are none of theirs") {
  const Scratch scratch;
  Arguments arguments = arguments_for("", scratch.path);
  arguments.all = true;
  const auto refused = [&](const char* why) {
    CHECK_THROWS_WITH(test::run(arguments, ending(EndReason::kDone)), Contains(why));
  };
  host::write_text(scratch.path / "index.html", "mine");
  refused("holds no runs of --all");
  fs::create_directories(scratch.path / first().experiments.list.front().name);
  refused("index.html there is no page of runs");
  arguments.out = (scratch.path / "index.html").string();
  refused("is not a folder");
}

TEST_CASE("experiments that are interrupted before the next one exit with 130 and begin none") {
  const Scratch scratch;
  Arguments arguments = arguments_for("", scratch.path);
  arguments.all = true;
  arguments.report = false;
  for (const std::size_t most : {0u, 2u}) {
    std::size_t runs = 0;
    std::atomic<bool> stop{most == 0};
    const Simulate simulate = [&](const lab::Settings& settings, const cosim::Hooks&) {
      if (++runs == most) stop = true;
      return test::short_run(settings, EndReason::kDone);
    };
    int code = 0;
    test::on_stderr([&] { test::on_stdout([&] { code = run(arguments, stop, simulate); }); });
    CHECK(code == 130);
    CHECK(runs == most);
    CHECK(test::entries(scratch.path) == most);
  }
}

TEST_CASE("a port for another program is offered by machines that have one, below other keys") {
  const Scratch scratch;
  std::size_t with_port = 0;
  std::vector<std::string> names;  // of machines with a line that others can speak on
  for (const lab::Machine* const machine : lab::machines()) {
    const auto keys = lab::find_keys(machine->keys(), "host.serial");
    if (!keys.empty()) names.push_back(machine->name);
  }
  for (const lab::Machine* const machine : lab::machines()) {
    CAPTURE(machine->name);
    const fs::path scenario = lab::find_scenario(test::scenario_of(*machine));
    Arguments arguments;
    arguments.live = true;
    if (machine->live.empty()) {
      CHECK_THROWS_WITH(layered(scenario, arguments),
                        "--serial: the machine " + machine->name + " has no port for another "
                        "program; permitted: scenarios of " + fmt::format("{}", fmt::join(names,
                                                                                          ", ")));
      continue;
    }
    ++with_port;
    CHECK(layered(scenario, arguments)->run.max_s == 3600);
    arguments.assignments = {"run.max_s=3000"};
    CHECK(layered(scenario, arguments)->run.max_s == 3000);
    std::ofstream(scratch.path / "a.toml") << "run.max_s = 2000\n";
    arguments.assignments.clear();
    arguments.files = {(scratch.path / "a.toml").string()};
    CHECK(layered(scenario, arguments)->run.max_s == 2000);
  }
  CHECK(with_port > 0);
}

TEST_CASE("a page is told with its size") {
  const Scratch scratch;
  auto arguments = arguments_for(test::scenario_of(first()), scratch.path / "a");
  arguments.report = false;
  test::on_stdout([&] { REQUIRE(test::run(arguments, ending(EndReason::kDone)) == 0); });
  Arguments asked;
  asked.folders = {(scratch.path / "a").string()};
  asked.json = true;
  const json told = json::parse(test::on_stdout([&] { CHECK(report(asked) == 0); }));
  const fs::path page = scratch.path / "a" / "report.html";
  CHECK(told == json{{"page", page.string()}, {"bytes", fs::file_size(page)}});
}
