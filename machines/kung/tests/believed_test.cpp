// SPDX-License-Identifier: Apache-2.0
//
// The motor that the program believes in, what a run asks of the real one (currents, thrust, losses
// and limits of an axis against a current of known shape), and what is told of it before a run.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "machines/kung/chip/record.hpp"
#include "machines/kung/judge/motor_load.hpp"
#include "machines/kung/plan/believed.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/warnings.hpp"
#include "sw_nios/apps/kung/setup_words.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;

namespace {

struct Value {
  const char* name;
  double value;
};
constexpr std::array<Value, 5> kValues{{{"force_constant_N_A", 66},
                                        {"resistance_ohm", 21},
                                        {"inductance_q_H", 0.017},
                                        {"pole_pitch_m", 0.0271},
                                        {"mass_kg", 4.3}}};

// Its words, by AFC with gains by rule or by the precision controller.
std::array<std::uint32_t, sw::SetupWords::kMembers> words(const std::vector<std::string>& texts) {
  Options options;
  for (const std::string& text : texts) lab::apply_assignment(options, text);
  sw::SetupWords all;
  sw::pack(make_plan(options)->setup, all);
  return all.members;
}

std::string told(const std::vector<std::string>& texts) {
  Options options;
  for (const std::string& text : texts) lab::apply_assignment(options, text);
  const auto lines = warnings(options);
  return std::accumulate(lines.begin(), lines.end(), std::string(),
                         [](const std::string& all, const std::string& s) { return all + s; });
}

}  // namespace

TEST_CASE("the words of a believed motor are those of a plant that has its values") {
  for (const std::string way : {"gains.by_rule=true", "controller=precision"}) {
    const auto plain = words({way});
    for (const std::string axis : {"x", "y"}) {
      for (const Value& one : kValues) {
        const std::string end = axis + "." + one.name + "=" + std::to_string(one.value);
        CAPTURE(way, end);
        const auto believed = words({way, "believed." + end});
        CHECK(believed == words({way, "plant." + end}));
        const bool matters = way == "gains.by_rule=true" ||
                             std::string(one.name) == "pole_pitch_m" ||
                             std::string(one.name) == "force_constant_N_A";
        CHECK((believed != plain) == matters);
        // Another motor than its data sheet changes no word.
        CHECK(words({way, "believed." + end, "plant." + axis + "." + one.name + "=" +
                              std::to_string(1.1 * one.value)}) == believed);
        CHECK((told({way, "believed." + end}).find(" has no effect without gains.by_rule") !=
               std::string::npos) == !matters);
      }
    }
  }
  // A mass that is believed has the payload in it.
  CHECK(words({"gains.by_rule=true", "believed.mass_kg=7", "plant.payload_kg=9"}) ==
        words({"gains.by_rule=true", "plant.mass_kg=7"}));
}

TEST_CASE("a motor that a hot magnet weakens is estimated heavier, by the ratio of the constants") {
  Options options;
  for (const char* text : {"controller=precision", "run.engine=twin", "run.platform=direct",
                           "precision.compare=false", "plant.payload_kg=11",
                           "plant.force_constant_N_A=72", "believed.force_constant_N_A=79.9"}) {
    lab::apply_assignment(options, text);
  }
  lab::validate(options);
  const lab::Record record = lab::run(options);
  REQUIRE(record.result->end == EndReason::kDone);
  CHECK(test::figure(record, "error_um.max") <= 15);
  for (const std::string axis : {"x", "y"}) {
    const double mass = test::figure(record, axis + ".estimate.mass_kg_true") * 79.9 / 72;
    CHECK(test::figure(record, axis + ".estimate.mass_kg") ==
          Approx(mass).margin(0.12 + 0.01 * mass));
  }
}

TEST_CASE("rms, peak and loss are those of a sine of current") {
  AxisLoad load;
  plant::AxisConfig plant;
  for (int n = 0; n < 1000; ++n) {
    AxisSample s;
    s.i_q_true_A = 3 * std::sin(2 * 3.14159265358979 * n / 1000);
    s.i_d_true_A = 0;
    s.force_N = 79.9 * s.i_q_true_A;
    s.x_true_m = 0.1;
    load.add(s, plant);
  }
  CHECK(load.peak_current_A == Approx(3).epsilon(1e-4));
  CHECK(load.rms_current_A() == Approx(1.5).epsilon(1e-3));  // i_q is the peak of a phase
  CHECK(load.rms_force_N() == Approx(79.9 * 3 / std::sqrt(2)).epsilon(1e-3));
  CHECK(load.copper_loss_W(27) == Approx(3 * 27 * 1.5 * 1.5).epsilon(1e-3));
  CHECK(load.limits() == "");
}

TEST_CASE("what limits an axis is told with its share of the samples") {
  AxisLoad load;
  plant::AxisConfig plant;
  for (int n = 0; n < 100; ++n) {
    AxisSample s;
    s.x_true_m = n < 50 ? plant.stroke_max_m : n < 70 ? plant.stroke_min_m : 0.1;
    s.force_N = 1;  // away from the lower stop
    s.i_q_ref = n < 10 ? -2047 : 0;
    s.v_d = n < 4 ? -1300 : 0;
    s.v_q = n < 4 ? 1500 : 0;
    load.add(s, plant);
  }
  CHECK(load.limits() == "i_q* at its limit 10 %, voltage at the supply's 4 %, carriage at a hard "
                         "stop 50 % of the samples");
  CHECK(AxisLoad{}.limits() == "");
  AxisLoad without;
  plant.hard_stops = false;
  AxisSample s;
  s.x_true_m = plant.stroke_max_m;
  s.force_N = 1;
  without.add(s, plant);
  CHECK(without.at_stop == 0);
}

TEST_CASE("a run above the rating of a motor says so; 0 is no rating") {
  Options options;
  Result result;
  AxisSample s;
  s.i_q_true_A = 4;
  s.x_true_m = 0.1;
  for (int n = 0; n < 10; ++n) result.load[1].add(s, options.plant.axis[1]);
  const auto lines = overloads(options, result);
  REQUIRE(lines.size() == 1);
  CHECK_THAT(lines[0], Contains("rms phase current of Y is 2.828 A, above "
                                "plant.y.continuous_current_A = 1.6"));
  options.plant.axis[1].peak_current_a = 3.9985;
  CHECK(overloads(options, result).size() == 1);  // 4 A are 0.04 % above it
  options.plant.axis[1].peak_current_a = 3.98;
  CHECK_THAT(overloads(options, result).at(1),
             Contains("largest vector of i_d and i_q in a sample of Y is 4 A, above "
                      "plant.y.peak_current_A = 3.98"));
  options.plant.axis[1].peak_current_a = options.plant.axis[1].continuous_current_a = 0;
  CHECK(overloads(options, result).empty());
}

TEST_CASE("only what is run is judged, so that a path of days is judged at once") {
  Options o;
  o.path.circle_ticks = 1'000'000;
  o.path.repeats = 1000;
  o.chip.irq_period_ticks = 255;
  o.chip.watchdog_ticks = 300;
  o.run.max_s = 1;
  CHECK(warnings(o).empty());
  o.path = {};
  o.path.kind = PathKind::kPoints;  // rests for longer than the run takes
  PathFile file;
  file.points.assign(20, {0.1, 0.1});
  file.points.back() = {0.3, 0.1};
  o.prepared = make_plan(o, file);
  CHECK(warnings(o).empty());
  o.run.max_s = 60;
  o.prepared = make_plan(o, file);
  CHECK_FALSE(warnings(o).empty());
}

TEST_CASE("a start on a hard stop is told of every kind of path, axis and end of the stroke") {
  const test::Scratch scratch("kung_start_on_stop");
  const std::string program = (scratch.path / "a.ngc").string();
  const std::string rows = (scratch.path / "a.csv").string();
  std::ofstream(program) << "G21 G90 G61\nG1 F6000 X300 Y300\nM30\n";
  std::ofstream(rows) << "0,600\n100,500\n";
  const std::string gcode = "kind = 'gcode'\ngcode_file = '" + program + "'\n";
  const std::string points = "kind = 'points'\npoints_file = '" + rows + "'\npoints_mode = ";
  const struct {
    std::string path;
    std::vector<std::string> stops;
  } cases[] = {
      {"circle_center_y_m = 0.5\n", {"y.stroke_max_m"}},  // of the circle, from its upper end
      {"kind = 'window'\nwindow_center_x_m = 0.1\n", {"x.stroke_min_m"}},
      {"kind = 'star'\nstar_start_x_m = 0\n", {"x.stroke_min_m"}},
      {"kind = 'line'\nline_start_x_m = 0.6\nline_start_y_m = 0\n",
       {"x.stroke_max_m", "y.stroke_min_m"}},
      {gcode, {}},
      {gcode + "start_x_m = 0\nstart_y_m = 0.6\n", {"x.stroke_min_m", "y.stroke_max_m"}},
      {gcode + "start_x_m = 0.6\n", {"x.stroke_max_m"}},
      {gcode + "start_y_m = 0\n", {"y.stroke_min_m"}},
      {points + "'timed'\n", {"x.stroke_min_m", "y.stroke_max_m"}},
      {points + "'path'\n", {"x.stroke_min_m", "y.stroke_max_m"}}};
  for (const auto& one : cases) {
    Options o;
    lab::apply_text(o, "controller = 'precision'\n[path]\n" + one.path, "some.toml", ".");
    lab::validate(o);
    std::vector<std::string> stops;
    for (const std::string& line : warnings(o)) {
      const std::string begin = ": the path begins on the hard stop plant.";
      if (line.find(begin) != 1) continue;
      stops.push_back(line.substr(1 + begin.size(), std::string("x.stroke_min_m").size()));
    }
    CAPTURE(one.path);
    CHECK(stops == one.stops);
  }
}
