// SPDX-License-Identifier: Apache-2.0
//
// What motor and supply cannot give is told before a run, and nothing where they can.
#include <catch2/catch.hpp>

#include <fstream>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "machines/kung/machine.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;

namespace {

// The first advice; "" where there is none.
std::string told(const Options& options) {
  const std::vector<std::string> lines = advice(options);
  return lines.empty() ? "" : lines[0];
}

}  // namespace

TEST_CASE("only what is run is judged, so that a path of days is judged at once") {
  Options o;
  o.path.circle_ticks = 1'000'000;
  o.path.repeats = 1000;
  o.chip.irq_period_ticks = 255;
  o.chip.watchdog_ticks = 300;
  o.run.max_s = 1;
  CHECK(told(o) == "");
  o.path = {};
  o.path.kind = PathKind::kPoints;  // rests for longer than the run takes
  o.path.points.assign(20, {0.1, 0.1});
  o.path.points.back() = {0.3, 0.1};
  CHECK(told(o) == "");
  o.run.max_s = 60;
  CHECK_FALSE(advice(o).empty());
}

TEST_CASE("a path that is longer than the run may take is told, unless the run was shortened") {
  Options o;
  o.path.repeats = 100;  // of 628 points
  CHECK(told(o) == "the path takes 125.6 s, longer than run.max_s = 60: the run ends "
                   "ahead of the path, with exit code 5");
  o.settle_s = 4;
  CHECK_THAT(told(o), Contains("takes 129.6 s"));
  o.run.max_s = 129.7;
  CHECK(told(o) == "");
  o.run.max_s = 59;
  CHECK(told(o) == "");
  o.path.repeats = 1;
  o.path.profile = Profile::kFeed;
  CHECK(told(o) == "");
  o.run.max_s = 1;  // 0.63 m at 0.5 m/s, and settled
  REQUIRE(advice(o).size() == 1);
  CHECK_THAT(advice(o)[0], Contains("longer than run.max_s = 1:"));
}

TEST_CASE("the paper's table has nothing to be told, on any of its paths") {
  for (const PathKind kind : {PathKind::kCircle, PathKind::kWindow, PathKind::kStar,
                              PathKind::kSquare, PathKind::kLine}) {
    Options o;
    o.path.kind = kind;
    CHECK(told(o) == "");
  }
}

TEST_CASE("a supply below the back-EMF at the path's speed is told with both voltages") {
  Options o;
  o.path.kind = PathKind::kLine;  // Y at 0.3 m/s, after its start without acceleration
  o.plant.axis[1].dc_link_v = 27;
  o.plant.axis[1].mass_kg = 0.1;
  o.plant.axis[1].viscous_n_s_m = o.plant.axis[1].coulomb_n = 0;
  o.gains[1].kv = 0.1;
  o.chip.dead_time_min_ns = o.chip.axis[1].dead_time_ns = 0;
  const std::vector<std::string> lines = advice(o);
  REQUIRE(lines.size() == 1);
  // 2/3 79.9 N/A 0.3 m/s = 15.98 V; 27 V / sqrt 3 = 15.59 V
  CHECK_THAT(lines[0], Contains("y: back-EMF, drop and dead time of 15.98 V") &&
                           Contains("at 0.3 m/s") && Contains("above the 15.59 V") &&
                           Contains("plant.y.dc_link_V = 27"));
  o.plant.axis[1].dc_link_v = 28;
  CHECK(told(o) == "");
  o.chip.axis[1].dead_time_ns = 4000;  // 28 V 4 us 16 kHz 4 / pi = 2.28 V
  CHECK_THAT(told(o), Contains("dead time of 18.27 V"));
  o.path.kind = PathKind::kSquare;  // its fastest step is that of the model, step omega_n / e
  o.path.square_high_m = 0.1;       // 1.1 m/s
  CHECK_THAT(told(o), Contains("at 1.1 m/s"));
}

TEST_CASE("inertia and load above the thrust of the largest i_q* are told") {
  Options o;
  o.plant.axis[0].external_force_n = -500;
  CHECK_THAT(told(o), Contains("x: inertia, friction, cogging and load of 5") &&
                      Contains("plant.x.current_full_scale_A = 9.6 allows an i_q* of "
                               "4.8 A"));
  o = {};
  o.path.kind = PathKind::kSquare;  // of 10 mm: 40 kg 10 mm (30 rad/s)^2 = 360 N at its start
  o.plant.axis[0].mass_kg = 40;
  o.gains_by_rule = true;
  CHECK(told(o) == "");
  o.plant.axis[0].mass_kg = 50;  // 450 N, 5.6 A
  REQUIRE(advice(o).size() == 1);
  CHECK_THAT(advice(o)[0],
             Contains("x: inertia, friction, cogging and load of 4") && Contains(" take 5."));
}

TEST_CASE("cogging, cable, Stribeck friction and a load that comes later are part of the demand") {
  const auto told = [](auto change) {
    Options o;
    change(o.plant.axis[0]);
    const std::vector<std::string> lines = advice(o);
    return lines.empty() ? "" : lines[0];
  };
  const auto thrust = Contains("x: inertia, friction, cogging and load of ");
  CHECK(told([](auto& p) { p.cogging_n = 360; }) == "");  // of 383.5 N
  CHECK_THAT(told([](auto& p) { p.cogging_n = 380; }), thrust);
  CHECK_THAT(told([](auto& p) { p.cogging_harmonic_n = 380; }), thrust);
  CHECK_THAT(told([](auto& p) { p.stribeck_n = 450; }), thrust);
  CHECK_THAT(told([](auto& p) { p.cable_n_m = 10000; }), thrust);
  CHECK_THAT(told([](auto& p) { p.load_n = 400, p.load_begin_s = 0.5; }), thrust);
  CHECK(told([](auto& p) { p.load_n = 400, p.load_begin_s = 5; }) == "");  // behind the end
  CHECK_THAT(told([](auto& p) { p.load_n = 400, p.load_end_s = 0.1; }), thrust);
}

TEST_CASE("a force that moves the carriage before the start is told") {
  Options o;
  o.plant.axis[1].external_force_n = -30;
  CHECK(told(o) == "");
  o.plant.axis[1].brake = false;
  CHECK_THAT(told(o), Contains("y: 30 N are above the friction of 4.8 N: they move the "
                               "carriage before its drive is on, as plant.y.brake = "
                               "false"));
  o.plant.axis[1].stribeck_n = 26;
  CHECK(told(o) == "");
}

TEST_CASE("a sweep, which the table need not follow, has nothing to be told") {
  Options o;
  o.path.kind = PathKind::kSweep;
  o.path.sweep_amplitude_m = 0.01;
  o.path.sweep_last_ticks = 8;
  CHECK(told(o) == "");
}

TEST_CASE("a speed loop that is too slow or too fast for its load is told") {
  Options o;
  o.plant.axis[0].payload_kg = 11;  // the paper's: 41 rad/s
  CHECK(told(o) == "");
  o.plant.axis[0].mass_kg = 50;
  CHECK_THAT(told(o), Contains("x: gains.x.kv = 1.84 makes of 61 kg a speed loop of 9.04 "
                               "rad/s, too slow for gains.x.omega_n_rad_s = 30; "
                               "gains.by_rule makes 220 rad/s"));
  o.plant.axis[0] = {};
  o.plant.axis[0].mass_kg = 0.15;
  CHECK_THAT(told(o), Contains("3.68e+03 rad/s, too fast for chip.position_Hz = 2000"));
  o.gains_by_rule = true;
  CHECK(told(o) == "");
}

TEST_CASE("dead time above twenty times what the resistance drops is told, with both voltages") {
  Options o;
  o.path.kind = PathKind::kSquare;  // of 10 mm
  o.gains_by_rule = true;
  for (plant::AxisConfig& axis : o.plant.axis) axis.dc_link_v = 560;
  o.plant.axis[0].resistance_ohm = 1;
  o.plant.axis[0].force_constant_n_a = 40;  // 2.5 kg 10 mm (30 rad/s)^2 = 22 N at least: 0.6 A
  CHECK_THAT(told(o), Contains("x: dead time takes 17.9 V of a phase whose resistance drops 0.6"));
  CHECK_THAT(told(o), Contains("a lower chip.x.dead_time_ns, chip.carrier_Hz or "
                               "plant.x.dc_link_V makes it less"));
  CHECK(advice(o).size() == 1);
  o.plant.axis[0].resistance_ohm = 1.6;
  CHECK(told(o) == "");
  o.plant.axis[0].resistance_ohm = 1;
  o.chip.axis[0].dead_time_ns = 1200;
  CHECK(told(o) == "");
  // An axis that rests has nothing to be late with.
  o.chip.axis[0].dead_time_ns = 2000;
  o.path.kind = PathKind::kLine;
  o.path.line_end_x_m = o.path.line_start_x_m;
  CHECK(told(o) == "");
}

TEST_CASE("a start of the precision controller on a hard stop is told, one count inside is not") {
  Options o;
  o.controller = Controller::kPrecision;
  o.path.kind = PathKind::kLine;
  o.path.line_start_x_m = 0;
  o.path.line_end_y_m = 0.59;
  CHECK(told(o) == "x: the path begins on the hard stop plant.x.stroke_min_m = 0: in its first 10 "
                   "ms a light table is up to 30 um from the command; a start 5 um farther inside "
                   "avoids it");
  o.plant.axis[0].hard_stops = false;
  CHECK(told(o) == "");
  o.plant.axis[0].hard_stops = true;
  o.path.line_start_x_m = 5e-6;
  CHECK(told(o) == "");
  o.path.line_start_y_m = 0.6;
  CHECK_THAT(told(o), Contains("y: the path begins on the hard stop plant.y.stroke_max_m = 0.6:"));
  o.path.line_start_y_m = 0.599995;
  CHECK(told(o) == "");
  o.path.line_start_y_m = 0.6;
  o.controller = Controller::kAfc;
  CHECK(told(o) == "");
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
    for (const std::string& line : advice(o)) {
      const std::string begin = ": the path begins on the hard stop plant.";
      if (line.find(begin) != 1) continue;
      stops.push_back(line.substr(1 + begin.size(), std::string("x.stroke_min_m").size()));
    }
    CAPTURE(one.path);
    CHECK(stops == one.stops);
  }
}

TEST_CASE("poles that pass faster than the current loop follows are told") {
  Options o;
  o.path.kind = PathKind::kLine;  // at 0.3 m/s
  o.plant.axis[1].pole_pitch_m = 0.17e-3;
  CHECK(told(o) == "");  // 882 of 1/(10/16 kHz + 2/(4000 1/s)) = 889
  o.plant.axis[1].pole_pitch_m = 0.16e-3;
  CHECK_THAT(told(o), Contains("y: 0.3 m/s are 937.6 electrical turns a second with "
                               "plant.y.pole_pitch_m = 0.00016, above the 888.8 that a "
                               "current loop of 3999 rad/s follows with "
                               "chip.carrier_Hz = 16000"));
  o.chip.carrier_Hz = 40'000;
  CHECK(told(o) == "");
  o.gains[1].current_kp_V_A = 40;
  CHECK_THAT(told(o), Contains("above the 706") && Contains("loop of 1717 rad/s"));
  o.gains_by_rule = true;
  CHECK(told(o) == "");
}

TEST_CASE("times of the native processor that the core's RTL does not have are told") {
  Options o;
  o.processor.access_clk = 100;
  CHECK(told(o) == "");
  o.cpu = Cpu::kRtl;
  CHECK_THAT(told(o), Contains("processor.access_clk, interrupt_latency_clk and "
                               "point_clk have no effect with run.cpu = \"rtl\""));
  o.processor = Options().processor;
  CHECK(told(o) == "");
}

TEST_CASE("an offset of a sensor that is not measured is told") {
  Options o;
  o.plant.axis[0].current_offset_b_a = -0.05;
  CHECK_THAT(told(o), Contains("x: an offset of 0.05 A of a current sensor is not "
                               "measured: chip.offset_samples = 0"));
  o.chip.offset_samples = 8;
  CHECK(told(o) == "");
}

TEST_CASE("a load that ends before it begins and a stroke the wrong way round are refused") {
  Options o;
  o.plant.axis[1].load_begin_s = 0.2;
  o.plant.axis[1].load_end_s = 0.1;
  CHECK_THROWS_WITH(advice(o), Contains("plant.y.load_end_s: value 0.1 must be 0 or above "
                                        "plant.y.load_begin_s = 0.2"));
  o = {};
  o.chip.axis[0].stroke_max_m = -0.1;
  CHECK_THROWS_WITH(advice(o), Contains("chip.x.stroke_min_m: value 0 must be below "
                                        "chip.x.stroke_max_m = -0.1"));
}
