// SPDX-License-Identifier: Apache-2.0
//
// Keys of the machine mcafee. Words of a trajectory are those that the LM628 takes.
#include "machines/mcafee/machine_members.hpp"
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
    lm628::add_run(t);
    t.one("run.reached_counts", 0, 32767,
          "largest error, and movement, of a table at its target, and distance beside its path; "
          "0 = 50, or a quarter of a short travel; beside the path a twentieth of its diagonal, if "
          "more",
          TRAMMEL_LENS(reached_counts));
    t.faults(fault_pins({}));
    using P = PathOptions;
    const auto path = lm628::keys_of(t, "path.", TRAMMEL_LENS(path));
    path("kind", 0, 0, "shape", &P::kind);
    path("side_mm", 1, 600, "of the square, an edge of the star, a leg of the corner", &P::side_mm);
    path("radius_mm", 0.01, 300, "of corners and tips, or of the circle", &P::radius_mm);
    t.file("path.points_file", "CSV of x_mm,y_mm; the table starts at the first",
           TRAMMEL_LENS(path.points_file));
    path("row_mm", 1e-3, 10, "length of a row; made to fit the path a whole number of times",
         &P::row_mm);
    path("kappa_max_1_mm", 1e-4, 1000, "curvature that is C = 255", &P::kappa_max_1_mm);
    path("preview_rows", 0, 10000, "ahead of a row, for CC", &P::preview_rows);
    lm628::add_clock(t, TRAMMEL_LENS(clock_MHz));
    lm628::add_monitors(t);
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
    using S = plant::LeadscrewConfig;
    const auto stage = lm628::keys_of(t, "stage.", TRAMMEL_LENS(stage_axis));
    stage("pitch_m", 1e-4, 0.1, "travel of the table per revolution of the screw", &S::pitch);
    stage("switch_low_m", -10, -1e-3, "limit switch, from the start", &S::switch_low);
    stage("switch_high_m", 1e-3, 10, "limit switch, from the start", &S::switch_high);
    stage("switch_hysteresis_m", 0, 1e-3, "of both switches", &S::switch_hysteresis);
    stage("overtravel_m", 0, 0.1, "from a switch to the stop behind it", &S::overtravel);
    using E = plant::SineEncoderConfig;
    const auto encoder = lm628::keys_of(t, "encoder.", TRAMMEL_LENS(stage_axis.encoder));
    encoder("lines", 1, 25000, "lines per revolution; four counts each", &E::lines);
    encoder("hysteresis_V", 0, 0.5, "of its comparators, full width", &E::hysteresis);
    encoder("cosine_offset_V", -0.2, 0.2, "error of a channel", &E::cosine_offset);
    encoder("sine_offset_V", -0.2, 0.2, "error of a channel", &E::sine_offset);
    encoder("swapped", 0, 0, "sine and cosine exchanged: it counts the wrong way", &E::swapped);
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::mcafee
