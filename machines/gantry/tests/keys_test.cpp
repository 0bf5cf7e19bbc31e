// SPDX-License-Identifier: Apache-2.0
//
// What the options of the machine gantry may not be together.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "machines/gantry/machine.hpp"
#include "tests/support/message.hpp"

using namespace trammel;

TEST_CASE("gantry: two controls, or times, that exclude each other are refused") {
  const auto told = [](const std::string& toml) { return test::message_of<gantry::Options>(toml); };
  const std::string cascade = "[control]\ncascade = true\n", sum = "[position]\nsum = \"plain\"\n";
  CHECK(told(cascade + "compensate = true\n") == "");
  CHECK(told(sum) == "");
  CHECK_THAT(told("[position]\nbang_bang = true\n" + cascade),
             Catch::Contains("position.bang_bang: true, and control.cascade is true; permitted: "));
  CHECK_THAT(told(sum + cascade), Catch::Contains("position.sum: a sum, and control.cascade"));
  CHECK_THAT(told(sum + "bang_bang = true\n"),
             Catch::Contains("position.sum: a sum, and position.bang_bang"));
  CHECK_THAT(told("[control]\ncompensate = true\n"),
             Catch::Contains("control.compensate: true, and control.cascade is false; "));
  const auto assigned = [](const std::vector<std::string>& all) {
    return test::refusal_of([&all] {
      gantry::Options options;
      for (const std::string& one : all) lab::apply_assignment(options, one);
      lab::validate(options);
    });
  };
  CHECK(assigned({"run.time_s=1", "run.max_s=1"}) == "");
  CHECK(assigned({"run.max_s=1"}) == "");  // cuts the scenario's time
  CHECK(assigned({"run.time_s=1.5", "run.max_s=1"}) ==
        "run.time_s: 1.5 s is above run.max_s, 1 s; permitted: at most that");
  CHECK_THAT(assigned({"run.time_s=120.5"}), Catch::StartsWith("run.time_s: 120.5 s is above"));
}

TEST_CASE("gantry: forces that exclude each other are refused, each pair by its own keys") {
  const auto told = [](const std::string& toml) { return test::message_of<gantry::Options>(toml); };
  CHECK(told("") == "");
  CHECK(told("[axis]\ncoulomb_count = 90\nstiction_count = 90\n") == "");
  CHECK_THAT(told("[axis]\ncoulomb_count = 90.5\nstiction_count = 90\n"),
             Catch::EndsWith("axis.stiction_count: 90 is below axis.coulomb_count, 90.5; "
                             "permitted: at least that"));
  CHECK(told("[position]\nmin_force = 300\nmax_force = 300\n") == "");
  CHECK_THAT(told("[position]\nmin_force = 301\nmax_force = 300\n"),
             Catch::EndsWith("position.min_force: 301 is above position.max_force, 300; "
                             "permitted: at most that"));
  CHECK(told("[boot]\nhome = true\ncalibrate = true\n") == "");
  CHECK_THAT(told("[boot]\ncalibrate = true\n"),
             Catch::Contains("boot.calibrate: true, and boot.home is false; permitted: with "));
  CHECK_THAT(told("[host]\nsends = \"1:32=1\"\n"), Catch::Contains("host.sends: \"1:32=1\""));
}
