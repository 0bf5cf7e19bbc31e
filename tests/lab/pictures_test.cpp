// SPDX-License-Identifier: Apache-2.0
//
// What gnuplot is given for the pictures of a run, and what is said where it fails: a program of
// that name keeps what it is sent.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

struct Scratch : test::Scratch {
  test::Variable path_variable;
  Scratch()
      : test::Scratch("pictures_test_out"),
        path_variable("PATH", (path.string() + ":/usr/bin:/bin").c_str()) {
    for (const Machine* const one : machines()) {  // of its own: others have no pictures
      const fs::path folder = path / "data" / one->name;
      fs::create_directories(folder);
      fs::copy(machine_folder(one->name) / "scenarios", folder / "scenarios");
      fs::create_directory(folder / "pictures");
      std::ofstream(folder / "pictures" / "a.gp") << "the script\n";
    }
    take_data_from((path / "data").string());
  }
  ~Scratch() { take_data_from(before); }

  void gnuplot(const std::string& body) const {
    std::ofstream(path / "gnuplot") << "#!/bin/sh\n" << body << '\n';
    fs::permissions(path / "gnuplot", fs::perms::owner_all);
  }

  const std::string before = machine_folder("").string();
};

}  // namespace

TEST_CASE("gnuplot is given the settings, the title and the samples that are worth drawing") {
  const Scratch scratch;
  scratch.gnuplot("cat > sent.txt; echo '<svg></svg>' > a.svg");
  for (const Machine* const machine : machines()) {
    CAPTURE(machine->name);
    auto arguments = test::arguments_for(test::scenario_of(*machine), scratch.path / "a",
                                         {"name=it's `a` name-1", "run.leap=false"});
    arguments.report = false;
    std::vector<double> first, last;
    Range drawn{};
    const testbench::Simulate simulate = [&](const Settings& settings, const cosim::Hooks&) {
      Record record = test::short_run(settings, cosim::EndReason::kDone);
      drawn = {0, record.result->sample_count()};
      if (machine->files.drawn != nullptr) drawn = machine->files.drawn(record);
      machine->columns().read(settings, *record.result, drawn.first, first);
      if (drawn.last > 0) {
        machine->columns().read(settings, *record.result, drawn.last - 1, last);
      }
      return record;
    };
    std::string told;
    told = test::on_stderr([&] { test::on_stdout([&] { test::run(arguments, simulate); }); });
    if (drawn.last < drawn.first + 2) {
      CHECK_THAT(told, Contains("no pictures: there is nothing to draw"));
      continue;
    }
    CHECK(told == "");
    const std::string sent = test::content(scratch.path / "a" / "sent.txt");
    const auto& columns = machine->columns().columns;
    std::size_t t = 0;
    while (columns[t].name != "t_s") ++t;
    CHECK_THAT(sent, Contains("\ntitle = 'its a name-1"));
    CHECK_THAT(sent, Contains(fmt::format("\nfirst = {}\nlast = {}\nstep = {}\nfrom = {}\nto = "
                                          "{}\n", drawn.first, drawn.last - 1,
                                          (drawn.last - drawn.first) / 6000 + 1, first[t],
                                          last[t])));
    CHECK_THAT(sent, Contains("\nrun_leap = 0\n"));
    CHECK_THAT(sent, Catch::EndsWith("the script\nunset output\n"));
  }
}

TEST_CASE("a gnuplot that fails, or leaves half a picture, is told") {
  const Scratch scratch;
  std::size_t failed = 0;
  for (const Machine* const machine : machines()) {
    CAPTURE(machine->name);
    auto arguments = test::arguments_for(test::scenario_of(*machine), scratch.path / "a");
    arguments.report = false;
    const auto told = [&](const char* body) {
      scratch.gnuplot(body);
      return test::on_stderr([&] {
        test::on_stdout([&] { test::run(arguments, test::ending(cosim::EndReason::kDone)); });
      });
    };
    if (told("cat > /dev/null; exit 1").find("nothing to draw") != std::string::npos) continue;
    CHECK_THAT(told("cat > /dev/null; exit 1"), Contains("no pictures: gnuplot failed"));
    CHECK_THAT(told("cat > /dev/null; kill -9 $$"), Contains("no pictures: gnuplot failed"));
    CHECK(told("cat > /dev/null; printf '<svg></svg> \n\n' > a.svg") == "");
    scratch.gnuplot("cat > /dev/null; printf '<svg></sv' > a.svg");
    CHECK_THAT(test::refusal_of([&] {
                 test::run(arguments, test::ending(cosim::EndReason::kDone));
               }),
               Contains("a.svg: cannot be written: gnuplot left it incomplete"));
    ++failed;
  }
  CHECK(failed > 0);
}
