// SPDX-License-Identifier: Apache-2.0
//
// What `trammel list` shows is what the program takes, by the same rules for every machine.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "cosim/trigger.hpp"
#include "lab/machine.hpp"
#include "testbench/run.hpp"
#include "tests/support/told.hpp"

using namespace trammel;

TEST_CASE("a trigger takes the range of its signal that is listed, both ends and nothing beyond") {
  for (const lab::Machine* const machine : lab::machines()) {
    const cosim::TriggerForms& forms = machine->triggers();
    const std::string text =
        test::printed([&] { CHECK(testbench::list("signals", machine->name, true) == 0); });
    const auto listed = nlohmann::json::parse(text);
    REQUIRE(listed.size() == forms.signals.size());
    for (const auto& one : listed) {
      const std::string name = one["signal"], range = one["range"];
      CAPTURE(machine->name, name, range);
      const std::int64_t low = std::stoll(range);
      const std::int64_t high = std::stoll(range.substr(range.find("..") + 2));
      for (const std::int64_t value : {low, high}) {
        CHECK(cosim::parse_trigger(fmt::format("{} >= {}", name, value), forms).value == value);
      }
      for (const std::int64_t value : {low - 1, high + 1}) {
        CHECK_THROWS_WITH(cosim::parse_trigger(fmt::format("{} >= {}", name, value), forms),
                          fmt::format("{}: value {} is out of range {}", name, value, range));
      }
    }
  }
}
