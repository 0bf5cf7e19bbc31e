// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "lab/build_info.hpp"
#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "machines/kung/baseline.hpp"
#include "machines/kung/machine.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

Options scenario(const std::string& name) {
  Options options;
  lab::apply_file(options, lab::find_scenario(name));
  lab::validate(options);
  return options;
}

}  // namespace

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
    const Tracks tracks = baseline_tracks(options, law);
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
    const Points table = baseline_tracks(options, law).table;
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
