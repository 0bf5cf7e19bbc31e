// SPDX-License-Identifier: Apache-2.0
//
// What `trammel doctor` says of programs that are missing: a run needs none of them.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "testbench/run.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/told.hpp"

using namespace trammel;
using Catch::Contains;

TEST_CASE("the doctor names each program that is missing, and exits with 0 without them") {
  const test::Scratch scratch("doctor_test_out");
  const test::NoPrograms none;
  int code = 0;
  const std::string told = test::printed([&] { code = testbench::doctor(true); });
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
  const std::string all = test::printed([&] { code = testbench::doctor(false); });
  CHECK(code == 0);
  for (const auto& [name, where] : tools.items()) {  // however long it is, its use stands behind
    CHECK_THAT(all, Contains((scratch.path / name).string() + ' '));
  }
  for (const auto& [name, where] : tools.items()) {
    INFO("without " << name);
    chmod((scratch.path / name).c_str(), 0644);  // no program
    const std::string text = test::printed([&] { code = testbench::doctor(false); });
    CHECK(code == 0);
    const std::string line = text.substr(text.find("\n" + name) + 1);
    CHECK_THAT(line.substr(0, line.find('\n')), Contains(" missing ") && Contains(" optional: "));
    chmod((scratch.path / name).c_str(), 0755);
  }
  lab::take_data_from((scratch.path / "none").string());  // the last: no scenario is left
  const std::string text = test::printed([&] { code = testbench::doctor(false); });
  CHECK(code == 3);
  CHECK_THAT(text, Contains("\n0 scenarios in " + (scratch.path / "none").string()));
}
