// SPDX-License-Identifier: Apache-2.0
//
// Keys of the machine mcafee. Words of a trajectory are those that the LM628 takes.
#include "machines/mcafee/machine.hpp"
#include "parts/lm628/keys.hpp"

namespace trammel::lab {

template <>
std::vector<std::string> enum_names<sw::McafeeStage>() {
  return {"read", "move", "track"};
}
template <>
std::vector<std::string> enum_names<mcafee::PathKind>() {
  return {"square", "circle", "star", "corner", "points"};
}

}  // namespace trammel::lab

namespace trammel::mcafee {

const std::vector<lab::Key>& keys() {
  static const auto all = [] {
    constexpr double kWord = 1073741823;  // 30 bits
    lab::KeyTable<Options> t(machine().name);
    t.names();
    t.text("program", "stage I, II or III", TRAMMEL_LENS(stage));
    t.text("compare", "also track at constant speeds, 254 and the least one",
           TRAMMEL_LENS(compare));
    t.platform_and_clocks();
    t.window();
    t.longest_run();
    t.one("run.diverged_counts", 1, 32767, "position error that ends the run as diverged",
          TRAMMEL_LENS(diverged_counts));
    t.waves("the first drive", "see docs/waves.md");
    t.text("path.kind", "shape", TRAMMEL_LENS(path.kind));
    t.one("path.side_mm", 1, 600, "of the square, an edge of the star, a leg of the corner",
          TRAMMEL_LENS(path.side_mm));
    t.one("path.radius_mm", 0.01, 300, "of corners and tips, or of the circle",
          TRAMMEL_LENS(path.radius_mm));
    t.file("path.points_file", "CSV of x_mm,y_mm; the table starts at the first",
           TRAMMEL_LENS(path.points_file));
    t.one("path.row_mm", 1e-3, 10, "length of a row; made to fit the path a whole number of times",
          TRAMMEL_LENS(path.row_mm));
    t.one("path.kappa_max_1_mm", 1e-4, 1000, "curvature that is C = 255",
          TRAMMEL_LENS(path.kappa_max_1_mm));
    t.one("path.preview_rows", 0, 10000, "ahead of a row, for CC", TRAMMEL_LENS(path.preview_rows));
    lm628::add_filter(t);
    t.one("track.speed", 0, 255, "constant; 0 = self-paced by the feed rate", TRAMMEL_LENS(speed));
    t.one("track.least_speed", 1, 255, "floor of the speed", TRAMMEL_LENS(least_speed));
    t.one("track.velocity_shift", 0, 8, "left, of the LM628 velocity",
          TRAMMEL_LENS(velocity_shift));
    t.one("trajectory.acceleration", 1, kWord, "2^-16 count/sample^2", TRAMMEL_LENS(acceleration));
    t.one("trajectory.velocity", 1, kWord, "2^-16 count/sample, of Stage II",
          TRAMMEL_LENS(velocity));
    t.one("trajectory.position_counts", -kWord - 1, kWord, "target of Stage II",
          TRAMMEL_LENS(position));
    t.one("trajectory.readings", 1, 1e6, "of Stage I", TRAMMEL_LENS(readings));
    t.one("trajectory.wait_s", 1e-5, 60, "between readings, and at the end", TRAMMEL_LENS(wait_s));
    t.processor();
    lm628::add_motor(t, TRAMMEL_LENS(stage_axis.motor));
    t.one("motor.current_limit_A", 0.01, 1000, "of the amplifier; assumed",
          TRAMMEL_LENS(stage_axis.motor.current_limit));
    t.one("stage.pitch_m", 1e-4, 0.1, "travel of the table per turn",
          TRAMMEL_LENS(stage_axis.pitch));
    t.one("stage.switch_low_m", -10, -1e-3, "limit switch, from the start",
          TRAMMEL_LENS(stage_axis.switch_low));
    t.one("stage.switch_high_m", 1e-3, 10, "limit switch, from the start",
          TRAMMEL_LENS(stage_axis.switch_high));
    t.one("stage.switch_hysteresis_m", 0, 1e-3, "of both switches",
          TRAMMEL_LENS(stage_axis.switch_hysteresis));
    t.one("stage.overtravel_m", 0, 0.1, "from a switch to the stop behind it",
          TRAMMEL_LENS(stage_axis.overtravel));
    t.one("encoder.lines", 1, 25000, "lines per turn; four counts each",
          TRAMMEL_LENS(stage_axis.encoder.lines));
    t.one("encoder.hysteresis_V", 0, 0.5, "of its comparators, full width",
          TRAMMEL_LENS(stage_axis.encoder.hysteresis));
    t.one("encoder.cosine_offset_V", -0.2, 0.2, "error of a channel",
          TRAMMEL_LENS(stage_axis.encoder.cosine_offset));
    t.one("encoder.sine_offset_V", -0.2, 0.2, "error of a channel",
          TRAMMEL_LENS(stage_axis.encoder.sine_offset));
    t.text("encoder.swapped", "sine and cosine exchanged: it counts the wrong way",
           TRAMMEL_LENS(stage_axis.encoder.swapped));
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::mcafee
