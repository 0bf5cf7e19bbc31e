// SPDX-License-Identifier: Apache-2.0
//
// The paper's eight experiments on the full chip and plant against specification section 12.
#include <catch2/catch.hpp>
#include <string>

#include "systemc/machines/kung.hpp"
#include "testbench/config.hpp"
#include "testbench/metrics.hpp"
#include "testbench/paper.hpp"

using namespace trammel;
using namespace trammel::testbench;

namespace {

void check_experiment(const std::string& scenario, const std::string& controller) {
  kung::Options options;
  apply_file(options, find_scenario(scenario));
  apply_assignment(options, "controller=" + controller);
  finish(options);
  REQUIRE(is_paper_experiment(options));
  const kung::Result result = kung::simulate(options, {});
  REQUIRE(result.end == kung::EndReason::kDone);
  const Metrics metrics = evaluate(options, result);
  REQUIRE(metrics.complete);
  const auto lines = compare(options, metrics);
  REQUIRE_FALSE(lines.empty());
  for (const Comparison& line : lines) {
    CAPTURE(scenario, controller, line.what, line.unit, line.ours, line.expected.value_or(-1),
            line.tolerance);
    CHECK(line.good());
  }
  if (scenario == "step" && controller == "afc") {  // acceptance item k
    for (const AxisMetrics& axis : metrics.axis) {
      REQUIRE(axis.periods.size() == 8);
      for (std::size_t n = 1; n < 4; ++n) {
        CHECK(axis.periods[n].overshoot_percent < axis.periods[n - 1].overshoot_percent);
      }
    }
  }
}

}  // namespace

// One case each, so that they run side by side.
TEST_CASE("circle fc") { check_experiment("circle", "fc"); }
TEST_CASE("circle afc") { check_experiment("circle", "afc"); }
TEST_CASE("window fc") { check_experiment("window", "fc"); }
TEST_CASE("window afc") { check_experiment("window", "afc"); }
TEST_CASE("star fc") { check_experiment("star", "fc"); }
TEST_CASE("star afc") { check_experiment("star", "afc"); }
TEST_CASE("step fc") { check_experiment("step", "fc"); }
TEST_CASE("step afc") { check_experiment("step", "afc"); }
