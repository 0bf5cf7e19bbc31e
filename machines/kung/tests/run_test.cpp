// SPDX-License-Identifier: Apache-2.0
//
// What a run of the table leaves behind besides what every run does (tests/testbench), and the
// baselines beside it.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "host/errors.hpp"
#include "lab/build_info.hpp"
#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/baseline.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/tests/by_hand.hpp"
#include "tests/support/files.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;
using test::run_kung;
namespace fs = std::filesystem;

namespace {

struct Scratch : test::Scratch {
  Scratch() : test::Scratch("kung_run_test_out") {}
};

// The table stands still for 40 samples and the run ends as given.
Result standing(EndReason end, const Fault& fault = {}) {
  Result result;
  for (std::uint32_t k = 0; k < 40; ++k) {
    Sample sample;
    sample.tick = k;
    sample.edge = 25000 * static_cast<cosim::Clk>(k);
    result.samples.push_back(sample);
  }
  result.end_tick = 40;
  result.points = 10;
  result.end = end;
  result.fault = fault;
  if (end == EndReason::kMissed) result.missed = "stopped after 10 of 12 points";
  return result;
}

nlohmann::json metrics_of(const fs::path& folder) {
  return nlohmann::json::parse(test::content(folder / "metrics.json"));
}

Options scenario(const std::string& name) {
  Options options;
  lab::apply_file(options, lab::find_scenario(name));
  lab::validate(options);
  return options;
}

}  // namespace

TEST_CASE("a tripped run exits with 5, keeps its record and names the first fault") {
  const Scratch scratch;
  CHECK(run_kung(scratch.path / "a", standing(EndReason::kFault, {FaultCode::kStroke, 1, 17})) ==
        5);
  const auto json = metrics_of(scratch.path / "a");
  CHECK(json["end"] == "tripped");
  CHECK(json["verdict"] == "tripped: stroke exceeded on axis Y at position tick 17 (0.0085 s)");
  CHECK(json["fault"]["cause"] == "stroke exceeded");
  CHECK(json["fault"]["axis"] == "y");
  CHECK(json["fault"]["tick"] == 17);
}

TEST_CASE("how a run ended is reported with the figures that decided it") {
  const Scratch scratch;
  const struct {
    EndReason end;
    const char* verdict;
  } all[] = {{EndReason::kDone,
              "followed 10 points, at most 0.00 mm beside them, 0.00 mm from the last one"},
             {EndReason::kMissed, "missed: stopped after 10 of 12 points"},
             {EndReason::kDiverged, "diverged: error to the model above run.diverged_m = 0.05"},
             {EndReason::kTimeout, "not finished within run.max_s = 60"},
             {EndReason::kStopped, "interrupted: results up to that point"}};
  for (const auto& [end, verdict] : all) {
    CAPTURE(verdict);
    run_kung(scratch.path / "a", standing(end));
    CHECK(metrics_of(scratch.path / "a")["verdict"] == verdict);
  }
}

TEST_CASE("a run keeps its program, and its command repeats it where the user stands") {
  const Scratch scratch;
  const fs::path file = scratch.path / "my part.NGC";
  std::ofstream(file) << "G0 X260\n";
  const std::vector<std::string> set{"path.kind=gcode", "path.gcode_file=" + file.string(),
                                     "name=mine"};
  const fs::path out = scratch.path / "a b";
  CHECK(run_kung(out, standing(EndReason::kDone), set) == 0);
  CHECK(test::content(out / "path.gcode_file.NGC") == "G0 X260\n");
  const fs::path again = fs::proximate(out) / "run.toml";
  CHECK(metrics_of(out)["command"] == "./trammel run '" + again.string() + "'");
  CHECK(metrics_of(out)["options"]["path.gcode_file"] == file.string());
  std::ofstream(file) << "G0 X270\n";  // is another program from now on
  const auto settings = lab::load_scenario(again);
  lab::validate(*settings);
  CHECK(plan_of(static_cast<const Options&>(*settings))->moves().moves.back().to.x == 0.26);
  const auto listed = nlohmann::json::parse(test::content(out / "run.json"));
  CHECK(listed["files"].contains("path.gcode_file.NGC"));
  CHECK(run_kung(out, standing(EndReason::kDone),
                 {"path.kind=gcode", "path.gcode_file=" + (out / "path.gcode_file.NGC").string(),
                  "name=mine"}) == 0);
  CHECK(test::content(out / "path.gcode_file.NGC") == "G0 X260\n");
}

TEST_CASE("a stop without a fault of the chip is distinguished from a trip") {
  CHECK(cause_text({FaultCode::kStroke, 1, 17}) == "stroke exceeded on axis Y");
  CHECK_THAT(cause_text({}), Contains("processor"));
  const Scratch scratch;
  const Fault fault{FaultCode::kNone, 0, 0, "a busy bit did not clear"};
  CHECK(run_kung(scratch.path / "a", standing(EndReason::kFault, fault)) == 5);
  CHECK(metrics_of(scratch.path / "a")["verdict"] ==
        "tripped: the processor's check: a busy bit did not clear");
}

// docs/deviations.md prints these; gen-results writes them anew. A thousandth is for compilers that
// order the double precision's operations otherwise; a gain or friction that is 1 % off shows.
TEST_CASE("the documented baselines are those of the program") {
  const auto root = std::filesystem::path(lab::kMachineFolder).parent_path();
  std::ifstream in(root / "docs" / "results.json");
  const auto document = nlohmann::json::parse(in).at("baseline");
  for (const std::string name : {"circle", "window", "star"}) {
    std::vector<lab::Figure> list;
    add_baselines(scenario(name), list);
    REQUIRE(list.size() == 6);
    for (const lab::Figure& figure : list) {
      CAPTURE(name, figure.id);
      CHECK(document.at(name).at(figure.id).get<double>() ==
            Approx(figure.value).epsilon(1e-3).margin(0.0000051));
    }
  }
}

TEST_CASE("whoever follows the model cuts the circle by what the model does") {
  // A second order model with zeta = 1 shows a harmonic motion at w with 1/(1 + (w/w_n)^2) of it.
  Options options = scenario("circle");
  options.path.repeats = 3;
  const double w = 0.5 / 0.1;
  const double radius_mm = 100 / (1 + std::pow(w / 30, 2));
  for (const Law law : {Law::kCascade, Law::kPid}) {
    const Tracks tracks = baseline_tracks(*make_plan(options), law);
    REQUIRE(tracks.table.size() == 4 * (3 * 628 + 1));
    const PointM center{0.25, 0.25};
    for (std::size_t k = 2 * 4 * 628; k < tracks.table.size(); ++k) {
      CHECK(tracking_error(tracks.model[k], center) * kMm == Approx(radius_mm).margin(0.02));
      // Friction that turns over at an axis' reversal moves it by a few tenths.
      CHECK(tracking_error(tracks.table[k], center) * kMm == Approx(radius_mm).margin(0.5));
    }
  }
}

// Half the range of the sensors is the range of i_q*.
TEST_CASE("a baseline pushes with the current that the controllers have, and no more") {
  Options options = scenario("step");
  options.path.square_periods = 1;
  options.chip.current_limit_A = 0.9;
  for (plant::AxisConfig& axis : options.plant.axis) {
    axis.current_full_scale_a = 1;
    axis.coulomb_n = axis.viscous_n_s_m = 0;
  }
  const double h = options.chip.sample_s();
  for (const Law law : {Law::kCascade, Law::kPid}) {
    const Points table = baseline_tracks(*make_plan(options), law).table;
    const plant::AxisConfig& axis = options.plant.axis[0];
    double most = 0;  // [m/s2]
    std::size_t at = 0;
    for (std::size_t k = 1; k + 1 < table.size(); ++k) {
      const double second = table[k + 1].x_m - 2 * table[k].x_m + table[k - 1].x_m;
      if (std::abs(second) / (h * h) > most) most = std::abs(second) / (h * h), at = k;
    }
    INFO((law == Law::kPid ? "PID" : "P-PI") << " of X, largest acceleration, in sample " << at);
    // The source's current is right to 1e-4 A of 0.5 A.
    CHECK(most == Approx(axis.force_constant_n_a * 0.5 / (axis.mass_kg + axis.payload_kg))
                      .epsilon(1e-3));
  }
}

TEST_CASE("a baseline stands beside the paper's paths alone") {
  std::vector<lab::Figure> list;
  add_baselines(scenario("step"), list);
  CHECK(list.empty());
  Options other = scenario("circle");
  other.path.circle_radius_m = 0.09;
  add_baselines(other, list);
  CHECK(list.empty());
}
