// SPDX-License-Identifier: Apache-2.0
//
// The paper's eight experiments on the full chip and plant: against specification section 12, and,
// digit by digit, against docs/results.json, which the documentation quotes.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "systemc/machines/kung.hpp"
#include "testbench/build_info.hpp"
#include "testbench/config.hpp"
#include "testbench/metrics.hpp"
#include "testbench/paper.hpp"

using namespace trammel;
using namespace trammel::testbench;

namespace {

// A run is the same on every machine: what differs here was changed by somebody (then
// scripts/gen_results.py writes the new figures) or is a mistake.
void check_documented(const std::string& run, const std::vector<Comparison>& lines,
                      const Metrics& metrics) {
  const auto root = std::filesystem::path(kScenarioFolder).parent_path().parent_path();
  std::ifstream in(root / "docs" / "results.json");
  const auto document = nlohmann::json::parse(in).at(run);
  for (const Comparison& line : lines) {
    CAPTURE(run, line.what, line.ours);
    const double printed = document.at("figures").at(line.what).at("ours");
    CHECK(printed == Approx(line.ours).margin(0.0000051).epsilon(0));
  }
  for (std::size_t a = 0; a < 2; ++a) {
    const auto& periods = metrics.axis[a].periods;
    for (std::size_t n = 0; n < periods.size(); ++n) {
      CAPTURE(run, a, n);
      const double printed = document.at(a == 0 ? "overshoot_percent_x" : "overshoot_percent_y")[n];
      CHECK(printed == Approx(periods[n].overshoot_percent).margin(0.0051).epsilon(0));
    }
  }
}

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
  check_documented(scenario + '-' + controller, lines, metrics);
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
