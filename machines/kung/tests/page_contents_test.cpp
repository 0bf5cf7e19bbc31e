// SPDX-License-Identifier: Apache-2.0
//
// What a page takes from a run: its title, the distance to the path, the spectra of its errors, and
// the gates around a trip.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "lab/files.hpp"
#include "lab/report_data.hpp"
#include "machines/kung/spectrum.hpp"
#include "machines/kung/tests/by_hand.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;
using lab::Json;
using test::run_kung;

namespace {

struct Scratch : test::Scratch {
  Scratch() : test::Scratch("kung_page_contents_out") {}
};

// A command that goes 0.05 mm along X at each of `n` samples; the table is there `late` samples
// later, and `beside_m` beside.
Result late_table(std::uint32_t n, std::uint32_t late, double beside_m) {
  Result result;
  for (std::uint32_t k = 0; k < n; ++k) {
    Sample sample;
    sample.tick = k + 1;
    sample.edge = 25'000 * static_cast<cosim::Clk>(k);
    sample.axis[0].r = static_cast<std::int32_t>(20'000 + 10 * k);
    sample.axis[0].x_true_m = 5e-6 * (20'000 + 10 * (k > late ? k - late : 0));
    sample.axis[1].x_true_m = beside_m;
    result.samples.push_back(sample);
  }
  result.first_tick = 1;
  result.end_tick = n + 1;
  result.points = 10;
  return result;
}

}  // namespace

TEST_CASE("the title of a page names scenario and controller") {
  const auto title = [](const char* controller) {
    return page().title({{"scenario", "mine"}, {"options", {{"controller", controller}}}});
  };
  CHECK(title("fc") == "mine, FC");
  CHECK(title("afc") == "mine, AFC");
  CHECK(title("precision") == "mine, precision");
}

TEST_CASE("the distance to the path is searched as far back as the model of either axis lags") {
  const Scratch scratch;
  // Of 10 rad/s and 1.2: a lag of 0.24 s, and three of them are 1440 samples.
  for (const std::string axis : {"x", "y"}) {
    const std::vector<std::string> slow{"gains." + axis + ".omega_n_rad_s=10",
                                        "gains." + axis + ".zeta=1.2"};
    run_kung(scratch.path / axis, late_table(1600, 1300, 1e-3), slow);
    const lab::RunFolder run = lab::read_run(scratch.path / axis);
    const lab::Series& contour = run.columns.at("contour_m");
    CAPTURE(axis);
    for (const std::size_t k : {100u, 1000u, 1400u, 1599u}) CHECK(contour[k] == Approx(1e-3));
  }
  // 0.25 s at least: the table is 800 samples and 1 mm away from what was asked 500 samples ago.
  run_kung(scratch.path / "quick", late_table(1600, 1300, 1e-3));
  const lab::RunFolder run = lab::read_run(scratch.path / "quick");
  CHECK(run.columns.at("contour_m")[1599] == Approx(std::hypot(800 * 5e-5, 1e-3)).epsilon(0.01));
}

TEST_CASE("a path has a distance to it, unless it is a square wave or a sweep") {
  const Scratch scratch;
  for (const std::string kind : {"circle", "square", "sweep"}) {
    run_kung(scratch.path / kind, late_table(40, 2, 0), {"path.kind=" + kind});
    CAPTURE(kind);
    CHECK(lab::read_run(scratch.path / kind).columns.count("contour_m") == (kind == "circle"));
  }
}

TEST_CASE("spectra are of the errors of the samples that count, in each axis") {
  const Scratch scratch;
  Result result = late_table(900, 7, 2e-3);
  result.first_tick = 201;
  result.end_tick = 701;  // 500 samples
  run_kung(scratch.path / "a", std::move(result), {"controller=precision"});
  const lab::RunFolder run = lab::read_run(scratch.path / "a");
  const lab::Series& counted = run.columns.at("counted");
  std::size_t first = 0, last = counted.size();
  while (counted[first] == 0) ++first;
  while (counted[last - 1] == 0) --last;
  REQUIRE(first >= 200);
  REQUIRE(last <= 700);
  REQUIRE(last > first + 100);
  for (const std::string axis : {"x", "y"}) {
    const lab::Series& error = run.columns.at(axis + "_error_um");
    const auto expected = spectrum(last - first, [&](std::size_t k) { return error[first + k]; });
    const Json& shown = run.detail["spectrum"][axis];
    REQUIRE(shown.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      REQUIRE(shown[k].get<double>() == Approx(expected[k]).epsilon(1e-3).margin(1e-12));
    }
  }
}

TEST_CASE("gates of a page are those of their window, around a trip with its edge") {
  Options options;
  Result result;
  CHECK(detail_json(options, result)["gates"].is_null());
  result.detail.gates = {1000, 7250, cosim::kNever, {{1000, 5}, {1234, 6}}, {}};
  std::array<std::array<std::int32_t, 3>, 2> compare{{{1, 2, 3}, {4, 5, 6}}};
  result.detail.gates.compare = {compare, compare};
  Json gates = detail_json(options, result)["gates"];
  CHECK(gates == Json::parse("{\"begin\": 1000, \"end\": 7250, \"edges\": [[1000, 5], [1234, 6]], "
                             "\"compare\": [[[1, 2, 3], [4, 5, 6]], [[1, 2, 3], [4, 5, 6]]]}"));
  result.detail.gates.trip = 4125;
  result.detail.gates.compare.clear();
  gates = detail_json(options, result)["gates"];
  CHECK(gates["trip"] == 4125);
  CHECK(gates["compare"] == Json::array());
  result.detail.rules_first[1][3] = 17;
  result.detail.rules_last[0][48] = -9;
  const Json rules = detail_json(options, result)["rules"];
  CHECK(rules["y"]["first"][3] == 17);
  CHECK(rules["x"]["last"][48] == -9);
  CHECK(rules["x"]["first"][3] == 0);
}
