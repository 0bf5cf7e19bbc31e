// SPDX-License-Identifier: Apache-2.0
//
// What a page of the table shows of its record: distances, spectra, gates, the steps of a moment;
// and its pictures.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <sys/stat.h>

#include "host/output_folder.hpp"
#include "lab/report_data.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/page/afc_steps.hpp"
#include "machines/kung/page/page.hpp"
#include "machines/kung/precision/spectrum.hpp"
#include "machines/kung/tests/by_hand.hpp"
#include "models/exact/control/afc.hpp"
#include "tests/support/files.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;
using lab::Json;
using test::run_kung;
using kung::afc_steps;
using kung::AfcSteps;

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

constexpr double kPi = 3.14159265358979323846;

// Of a sine of m + offset/2048 of the rate.
std::vector<double> of_sine(std::size_t n, double m, double amplitude, double mean = 0) {
  return spectrum(n, [=](std::size_t k) {
    return mean + amplitude * std::sin(2 * kPi * m * static_cast<double>(k) / kSegment + 0.3);
  });
}

// Of a path that is counted from sample 10 on.
std::string told(const test::Scratch& scratch, std::uint32_t samples) {
  auto result = std::make_unique<kung::Result>();
  result->points = 1;
  result->first_tick = 10;
  result->end_tick = 10 + samples;
  for (std::uint32_t n = 0; n < 15 + samples; ++n) {
    kung::Sample one;
    one.tick = n;
    one.edge = 25'000 * cosim::Clk{n};
    result->samples.push_back(one);
  }
  lab::Record record;
  record.settings = lab::load_scenario(lab::find_scenario("circle"));
  record.result = std::move(result);
  host::OutputFolder folder(scratch.path / "run");
  const lab::Written written = lab::write_record(record, folder, {}, {}, false);
  CHECK(written.notes.empty());
  return test::content(folder.scratch() / "told");
}

exact::Afc::Config twin_config(const sw::AxisSetup& s) {
  exact::Afc::Config c;
  c.kp = {s.kp.mant, s.kp.exp};
  c.ki = {s.ki.mant, s.ki.exp};
  c.kv = {s.kv.mant, s.kv.exp};
  c.eta = {s.eta.mant, s.eta.exp};
  c.shift_e = s.shift_e;
  c.shift_de = s.shift_de;
  c.a0 = static_cast<std::int32_t>(s.a0);
  c.a0_scale = static_cast<int>(s.a0_scale);
  c.b2 = static_cast<std::int32_t>(fixed::wrap(s.b2, 24));
  c.adapt = s.adapt;
  c.feedforward = s.feedforward;
  return c;
}

// The table follows a command that jumps about, so that every section and both limits are reached.
void check_chase(const sw::AxisSetup& setup, int reach) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> jump(-reach, reach);
  exact::Afc twin;
  twin.reset(0);
  kung::AfcStart start;
  for (std::size_t n = 0; n < 49; ++n) start.rules[n] = twin.rule(static_cast<int>(n));
  for (int k = 0; k < 3000; ++k) {
    start.r = k % 50 == 0 ? start.r_1 + jump(random) : start.r_1;
    start.x_p = start.x_p_prev + jump(random) / 100;
    const exact::Afc::Out expected = twin.step(twin_config(setup), {start.r, start.x_p});
    const AfcSteps steps = afc_steps(setup, start);
    CAPTURE(k);
    REQUIRE(steps[4].result == expected.dx);
    REQUIRE(steps[5].result == expected.x_m);
    REQUIRE(steps[6].result == expected.x_r);
    REQUIRE(steps[7].result == expected.v);
    REQUIRE(steps[8].result == expected.e);
    REQUIRE(steps[9].result == expected.de);
    REQUIRE(steps[22].result == expected.u);
    REQUIRE(steps[25].result == twin.integral());
    REQUIRE(steps[26].result == expected.v_star);
    REQUIRE(steps[29].result == expected.i_q_ref);
    // A later step rounds a product or adds it to what the one before left.
    REQUIRE(steps[3].result == fixed::rs(*steps[0].product, 23));
    for (const std::size_t n : {19u, 20u}) {
      REQUIRE(steps[n + 1].result == *steps[n].result + *steps[n].product);
    }
    const std::int64_t sum = *steps[21].result + *steps[21].product;
    REQUIRE(steps[22].result == fixed::sat(fixed::floor_shift(sum, 11), 12));
    REQUIRE(steps[30].result == steps[29].product);
    for (const std::size_t n : {13u, 14u, 28u}) REQUIRE_FALSE(steps[n].result);
    const auto fired = exact::RuleStore::fired(expected.i, expected.j);
    for (std::size_t n = 0; n < 4; ++n) {
      REQUIRE(steps[15 + n].result == expected.d[n]);
      REQUIRE(steps[15 + n].result == fixed::rs(*steps[14 + n].product, 11));
      REQUIRE(*steps[30 + n].product == *steps[30].result * *steps[15 + n].result);
      REQUIRE(steps[31 + n].result == twin.rule(fired[n]));
      start.rules[static_cast<std::size_t>(fired[n])] = twin.rule(fired[n]);
    }
    start.r_2 = start.r_1;
    start.r_1 = start.r;
    start.x_p_prev = start.x_p;
    start.x_m = expected.x_m;
    start.dx = expected.dx;
    start.e_prev = expected.e;
    start.integral = twin.integral();
  }
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
  result.snapshot.gates = {1000, 7250, cosim::kNever, {{1000, 5}, {1234, 6}}, {}};
  std::array<std::array<std::int32_t, 3>, 2> compare{{{1, 2, 3}, {4, 5, 6}}};
  result.snapshot.gates.compare = {compare, compare};
  Json gates = detail_json(options, result)["gates"];
  CHECK(gates == Json::parse("{\"begin\": 1000, \"end\": 7250, \"edges\": [[1000, 5], [1234, 6]], "
                             "\"compare\": [[[1, 2, 3], [4, 5, 6]], [[1, 2, 3], [4, 5, 6]]]}"));
  result.snapshot.gates.trip = 4125;
  result.snapshot.gates.compare.clear();
  gates = detail_json(options, result)["gates"];
  CHECK(gates["trip"] == 4125);
  CHECK(gates["compare"] == Json::array());
  result.snapshot.rules_first[1][3] = 17;
  result.snapshot.rules_last[0][48] = -9;
  const Json rules = detail_json(options, result)["rules"];
  CHECK(rules["y"]["first"][3] == 17);
  CHECK(rules["x"]["last"][48] == -9);
  CHECK(rules["x"]["first"][3] == 0);
}

TEST_CASE("a sine shows with its amplitude at its frequency, and nowhere else") {
  for (const std::size_t n : {kSegment, kSegment + 1, 3 * kSegment, 10000ul}) {
    CAPTURE(n);
    const auto all = of_sine(n, 100, 2.5, 40);
    REQUIRE(all.size() == kSegment / 2 + 1);
    CHECK(all[100] == Approx(2.5).epsilon(1e-3));
    CHECK(all[101] == Approx(1.25).epsilon(1e-2));  // Hann: half of it beside it
    for (const std::size_t m : {0, 1, 97, 103, 500, 1024}) {
      CAPTURE(m);
      CHECK(all[m] < 1e-3);
    }
  }
}

TEST_CASE("between two frequencies a sine shows at both, at most 15 percent lower") {
  const auto all = of_sine(5000, 300.5, 1);
  CHECK(all[300] == Approx(0.849).epsilon(1e-2));
  CHECK(all[301] == Approx(0.849).epsilon(1e-2));
}

TEST_CASE("a short series is one segment, and of a very short one there is nothing") {
  const auto all = of_sine(512, 200, 3);
  CHECK(all[200] == Approx(3).epsilon(1e-2));
  CHECK(of_sine(15, 200, 1).empty());
}

TEST_CASE("of noise the powers of the segments are averaged") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> values(200 * kSegment);
  for (double& one : values) one = normal(random);
  const auto all = spectrum(values.size(), [&](std::size_t k) { return values[k]; });
  // Variance 1 over the window: amplitude 2 sqrt(sum w^2) / sum w = 2 sqrt(3/2 / n).
  const double expected = 2 * std::sqrt(1.5 / kSegment);
  for (std::size_t m = 4; m < 1020; m += 50) CHECK(all[m] == Approx(expected).epsilon(0.2));
}

TEST_CASE("a picture has at most 6000 points, of the samples that count") {
  const test::Scratch scratch("pictures_test_out");
  const test::NoPrograms none;
  std::ofstream(scratch.path / "gnuplot") << "#!/bin/sh\nexec /bin/cat >> told\n";
  chmod((scratch.path / "gnuplot").c_str(), 0755);
  setenv("PATH", scratch.path.c_str(), 1);
  const struct {
    std::uint32_t samples;
    const char* variables;
  } runs[] = {
      {2, "first = 10\nlast = 11\nstep = 1\nfrom = 0.005\nto = "},
      {5999, "first = 10\nlast = 6008\nstep = 1\nfrom = 0.005\nto = "},
      {6000, "first = 10\nlast = 6009\nstep = 2\nfrom = 0.005\nto = "},
      {12'001, "first = 10\nlast = 12010\nstep = 3\nfrom = 0.005\nto = "},
  };
  for (const auto& [samples, variables] : runs) {
    INFO(samples << " samples");
    CHECK_THAT(told(scratch, samples), Catch::Matchers::Contains(variables));
  }
}

TEST_CASE("the steps of a sample end at the words and rules of the twin") {
  sw::AxisSetup setup;
  check_chase(setup, 2000);
  setup.adapt = true;
  check_chase(setup, 2000);
  check_chase(setup, 60);
  setup.feedforward = true;
  setup.shift_e = 2;
  setup.ki = {1500, -3};
  check_chase(setup, 2000);
  setup.shift_e = -1;
  setup.shift_de = -2;
  check_chase(setup, 2000);
  for (const std::uint32_t scale : {1u, 2u, 3u}) {  // 3 acts as 2
    CAPTURE(scale);
    setup.a0_scale = scale;
    setup.a0 = scale == 1 ? 14876 : 465;
    check_chase(setup, 2000);
  }
}

TEST_CASE("the steps are those of the specification for its check vector") {
  // Section 5: e = 1000, de = 200 with a fresh table.
  kung::AfcStart start;
  const exact::Afc fresh;
  for (std::size_t n = 0; n < 49; ++n) start.rules[n] = fresh.rule(static_cast<int>(n));
  start.r = start.r_1 = start.r_2 = 1000;  // the model rests there
  start.x_m = 1000 << 14;
  start.e_prev = 800;
  const AfcSteps steps = afc_steps({}, start);
  CHECK(steps[8].result == 1000);
  CHECK(steps[9].result == 200);
  CHECK(steps[15].result == 42);
  CHECK(steps[16].result == 854);
  CHECK(steps[17].result == 54);
  CHECK(steps[18].result == 1098);
  CHECK(steps[22].result == 1526);
  CHECK(steps[26].result == 577);
  CHECK(steps[29].result == 1062);
}
