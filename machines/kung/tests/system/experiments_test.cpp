// SPDX-License-Identifier: Apache-2.0
//
// The paper's eight experiments on the full chip and plant: against specification section 12, and,
// digit by digit, against docs/results.json, which the documentation quotes.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "lab/build_info.hpp"
#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/kung/figures.hpp"
#include "machines/kung/machine.hpp"
#include "machines/kung/paper.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

// A run is the same on every computer: a difference here is a deliberate change (then
// scripts/tool gen-results writes the new figures) or an error.
void check_documented(const std::string& run, const lab::Record& record, const Metrics& metrics) {
  const auto root = std::filesystem::path(lab::kMachineFolder).parent_path();
  std::ifstream in(root / "docs" / "results.json");
  const auto document = nlohmann::json::parse(in).at(run);
  std::size_t compared = 0;
  for (const lab::Figure& figure : record.figures) {
    const bool documented = document.at("figures").contains(figure.id);
    CAPTURE(run, figure.id, figure.value);
    if (figure.expected || figure.printed) CHECK(documented);
    if (!documented) continue;
    const auto& line = document.at("figures").at(figure.id);
    CHECK(line.at("ours").get<double>() ==
          Approx(figure.value).margin(0.0000051).epsilon(0));
    CHECK(line.contains("paper") == figure.printed.has_value());
    if (figure.printed) CHECK(line.at("paper") == *figure.printed);
    ++compared;
  }
  CHECK(compared == document.at("figures").size());
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
  Options options;
  lab::apply_file(options, lab::find_scenario(scenario));
  lab::apply_assignment(options, "controller=" + controller);
  lab::validate(options);
  REQUIRE(is_paper_experiment(options));
  const lab::Record record = lab::run(options);
  REQUIRE(record.result->end == EndReason::kDone);
  const Metrics metrics = evaluate(options, result_of(record));
  REQUIRE(metrics.complete);
  REQUIRE(lab::any_expected(record.figures));
  for (const lab::Figure& figure : record.figures) {
    CAPTURE(scenario, controller, figure.id, figure.unit, figure.value,
            figure.expected.value_or(-1), figure.tolerance);
    CHECK(figure.good());
  }
  check_documented(scenario + '-' + controller, record, metrics);
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
