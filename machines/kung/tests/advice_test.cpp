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
