// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "lab/key_table.hpp"
#include "machines/kung/options.hpp"

namespace trammel::lab {

template <>
std::vector<std::string> enum_names<kung::Cpu>() {
  return {"native", "rtl"};
}
template <>
std::vector<std::string> enum_names<kung::Controller>() {
  return {"fc", "afc", "precision"};
}
template <>
std::vector<std::string> enum_names<kung::SweepOf>() {
  return {"position", "current"};
}
template <>
std::vector<std::string> enum_names<kung::Profile>() {
  return {"auto", "constant", "feed"};
}
template <>
std::vector<std::string> enum_names<kung::Corner>() {
  return {"auto", "stop", "pass"};
}
template <>
std::vector<std::string> enum_names<kung::PointsMode>() {
  return {"timed", "path"};
}
template <>
std::vector<std::string> enum_names<kung::PathKind>() {
  return {"circle", "window", "star", "square", "line", "points", "sweep", "gcode"};
}

}  // namespace trammel::lab

namespace trammel::kung {
namespace {

using Table = lab::KeyTable<Options>;

// A function that adds the key PREFIX + name of a member of what `select` finds in the options.
template <class Select>
auto keys_of(Table& t, const std::string& prefix, Select select) {
  return [=, &t](const char* name, double min, double max, const char* help, auto member) {
    t.one(prefix + name, min, max, help, [=](auto& o) -> auto& { return select(o).*member; });
  };
}

std::string axis_prefix(const char* section, std::size_t axis) {
  return fmt::format("{}.{}.", section, axis == 0 ? 'x' : 'y');
}

void add_run(Table& t) {
  t.names();
  t.text("controller", "fixed rule table (fc), adaptive (afc), or docs/precision.md",
         TRAMMEL_LENS(controller));
  t.platform_and_clocks();
  t.text("run.cpu",
         "firmware compiled for this computer, or the RTL of kung_soc's processor with its binary, "
         "without SystemC",
         TRAMMEL_LENS(cpu));
  t.text("run.uart",
         "what is on the serial port of run.cpu = \"rtl\": a file of commands, - (the terminal) or "
         "pty",
         TRAMMEL_LENS(uart));
  t.window();
  t.one("run.settle_s", 0, 10, "simulated after the last point, not counted",
        TRAMMEL_LENS(settle_s));
  t.one("run.settled_m", 1e-9, 1, "band of the settling time after the last point",
        TRAMMEL_LENS(settled_m));
  t.longest_run();
  t.one("run.diverged_m", 1e-4, 1,
        "distance from the model, or from the path asked, that ends the run as diverged",
        TRAMMEL_LENS(diverged_m));
  t.one("run.reached_m", 0, 1,
        "largest error of a table that followed, beside the path, in its extent, and from its last "
        "point at the end, with controller = \"precision\" to the command; 0 = by the path's "
        "diagonal and the model's lag, with precision 15 um or 3 counts",
        TRAMMEL_LENS(reached_m));
  t.waves("where the drives start", "see `trammel list signals`");
}

void add_faults(Table& t) {
  t.faults(fault_pins({}));
}

void add_path(Table& t) {
  const auto add = keys_of(t, "path.", [](auto& o) -> auto& { return o.path; });
  add("kind", 0, 0, "which generator", &PathOptions::kind);
  add("repeats", 1, 1000, "passes of a circle, window, star, points or program path",
      &PathOptions::repeats);
  add("circle_radius_m", 1e-4, 0.3, "of the circle", &PathOptions::circle_radius_m);
  add("circle_center_x_m", 0, 0.6, "centre of the circle", &PathOptions::circle_center_x_m);
  add("circle_center_y_m", 0, 0.6, "centre of the circle", &PathOptions::circle_center_y_m);
  add("circle_ticks", 16, 1000000, "interrupts per revolution", &PathOptions::circle_ticks);
  add("window_side_m", 1e-3, 0.6, "of the square", &PathOptions::window_side_m);
  add("window_radius_m", 1e-4, 0.29, "of the arcs at the corners", &PathOptions::window_radius_m);
  add("window_center_x_m", 0, 0.6, "centre of the square", &PathOptions::window_center_x_m);
  add("window_center_y_m", 0, 0.6, "centre of the square", &PathOptions::window_center_y_m);
  add("window_step_m", 1e-6, 2.5e-3, "per interrupt, on the straight parts",
      &PathOptions::window_step_m);
  add("window_arc_ticks", 4, 100000, "interrupts per arc", &PathOptions::window_arc_ticks);
  add("star_edge_m", 1e-3, 0.6, "length of a stroke", &PathOptions::star_edge_m);
  add("star_start_x_m", 0, 0.6, "left end of the first stroke", &PathOptions::star_start_x_m);
  add("star_start_y_m", 0, 0.6, "left end of the first stroke", &PathOptions::star_start_y_m);
  add("star_stroke_ticks", 4, 100000, "interrupts per stroke", &PathOptions::star_stroke_ticks);
  add("square_low_m", -0.6, 0.6, "where both axes rest", &PathOptions::square_low_m);
  add("square_high_m", -0.6, 0.6, "where both axes step to", &PathOptions::square_high_m);
  add("square_half_samples", 4, 100000, "position samples per half period",
      &PathOptions::square_half_samples);
  add("square_periods", 1, 1000, "of the square wave", &PathOptions::square_periods);
  add("line_start_x_m", 0, 0.6, "where the line begins", &PathOptions::line_start_x_m);
  add("line_start_y_m", 0, 0.6, "where the line begins", &PathOptions::line_start_y_m);
  add("line_end_x_m", 0, 0.6, "where the line ends", &PathOptions::line_end_x_m);
  add("line_end_y_m", 0, 0.6, "where the line ends", &PathOptions::line_end_y_m);
  add("line_ticks", 1, 1000000, "interrupts from end to end", &PathOptions::line_ticks);
  add("sweep_of", 0, 0, "what the sine commands: with current the position loops are open",
      &PathOptions::sweep_of);
  add("sweep_center_m", 0, 0.6, "where both axes rest", &PathOptions::sweep_center_m);
  add("sweep_amplitude_m", 1e-6, 0.1, "of a sweep of position",
      &PathOptions::sweep_amplitude_m);
  add("sweep_amplitude_A", 1e-3, 1000, "of a sweep of current",
      &PathOptions::sweep_amplitude_A);
  add("sweep_first_ticks", 4, 100000, "position samples in a period of the first, lowest tone",
      &PathOptions::sweep_first_ticks);
  add("sweep_last_ticks", 4, 100000, "the same of the last, highest tone",
      &PathOptions::sweep_last_ticks);
  add("sweep_tones", 1, 200, "frequencies, in equal ratios", &PathOptions::sweep_tones);
  add("sweep_dwell_ticks", 1, 100000,
      "position samples, at least, for which a tone settles, and is then measured",
      &PathOptions::sweep_dwell_ticks);
  add("profile", 0, 0,
      "constant speed along the path, or a feed profile that keeps the acceleration of each axis; "
      "auto = feed with controller = \"precision\" and for programs and lines, else constant",
      &PathOptions::profile);
  add("feed_m_s", 0, 1.2,
      "feed profile: of a shape, at least 0.0001; 0 = circle 0.5, window 0.35, star 0.275, else "
      "0.3",
      &PathOptions::feed_m_s);
  add("rapid_m_s", 1e-4, 1.2, "feed profile: of G0", &PathOptions::rapid_m_s);
  add("feed_max_m_s", 1e-4, 1.2, "feed profile: above it F is lowered", &PathOptions::feed_max_m_s);
  add("mean_points", 1, 64, "feed profile: points over which the path length is averaged",
      &PathOptions::mean_points);
  add("corner", 0, 0,
      "feed profile: stop at the corners of a path, or pass them slowly; auto = stop in a shape, "
      "pass in a file",
      &PathOptions::corner);
  t.file("path.points_file",
         "CSV of x_mm,y_mm; a relative path starts at the scenario file",
         TRAMMEL_LENS(path.points_file));
  add("points_mode", 0, 0,
      "one point per interrupt, or lines from point to point under the feed profile",
      &PathOptions::points_mode);
  t.file("path.gcode_file",
         "program in G-code, see docs/gcode.md; a relative path starts at the scenario file",
         TRAMMEL_LENS(path.gcode_file));
  add("start_x_m", 0, 0.6, "where the table rests before a program", &PathOptions::start_x_m);
  add("start_y_m", 0, 0.6, "where the table rests before a program", &PathOptions::start_y_m);
  add("home_x_m", 0, 0.6, "where G28 of a program goes", &PathOptions::home_x_m);
  add("home_y_m", 0, 0.6, "where G28 of a program goes", &PathOptions::home_y_m);
  // Behind all of [path]: a table of TOML is written once.
  for (const std::size_t axis : {0u, 1u}) {
    t.one(axis_prefix("path", axis) + "accel_m_s2", 0.1, 40,
          "feed profile: largest acceleration of the axis",
          [axis](auto& o) -> auto& { return o.path.axis[axis].accel_m_s2; });
  }
}

void add_gains(Table& t, std::size_t axis) {
  const auto add = keys_of(t, axis_prefix("gains", axis),
                           [axis](auto& o) -> auto& { return o.gains[axis]; });
  add("kp", 0, 32, "proportional gain of the position PI", &AxisGains::kp);
  add("ki", 0, 1, "integral gain of the position PI, per 0.5 ms", &AxisGains::ki);
  add("kv", 0, 64, "proportional gain of the speed loop: 1 = 3.75 A/(m/s)", &AxisGains::kv);
  add("learning_rate", 0, 10, "alpha of the tuning law", &AxisGains::learning_rate);
  add("shift_e", kLeastShift, kMostShift, "fuzzy unit: 256 / 2^shift counts", &AxisGains::shift_e);
  add("shift_de", kLeastShift, kMostShift, "the same for the error change", &AxisGains::shift_de);
  add("omega_n_rad_s", 1, 200, "natural frequency of the reference model",
      &AxisGains::omega_n_rad_s);
  add("zeta", 0.2, 5, "damping ratio of the reference model", &AxisGains::zeta);
  add("current_kp_V_A", 0, 1000, "proportional gain of the current PI", &AxisGains::current_kp_V_A);
  add("current_ki_V_A", 0, 1000, "integral gain of the current PI, per 62.5 us",
      &AxisGains::current_ki_V_A);
  add("theta_offset_rad", -7, 7, "electrical angle at count 0", &AxisGains::theta_offset_rad);
  add("feedforward", 0, 0, "velocity feed-forward from the model", &AxisGains::feedforward);
  add("interpolate", 0, 0,
      "commands linear over the four position samples of chip.irq_period_ticks = 4",
      &AxisGains::interpolate);
}

void add_precision(Table& t) {
  const auto add = keys_of(t, "precision.", [](auto& o) -> auto& { return o.precision; });
  add("identify", 0, 0, "a small move of both axes before the path tells mass and friction",
      &PrecisionOptions::identify);
  add("adapt", 0, 0, "mass, friction, cogging and force are estimated on the path too",
      &PrecisionOptions::adapt);
  add("subcount", 0, 0, "positions between two counts, by the time of the encoder's last edge",
      &PrecisionOptions::subcount);
  add("learn", 0, 0, "corrections from lap to lap, with path.repeats above 1",
      &PrecisionOptions::learn);
  add("learn_gain", 0, 1, "share of an error that a lap corrects", &PrecisionOptions::learn_gain);
  add("compare", 0, 0, "also run fc and afc on the same feed profile, with the twin engine",
      &PrecisionOptions::compare);
  for (const std::size_t axis : {0u, 1u}) {
    const auto own = keys_of(t, axis_prefix("precision", axis),
                             [axis](auto& o) -> auto& { return o.precision.axis[axis]; });
    own("w1_rad_s", 20, 1500, "pole of the feedback", &AxisPrecision::w1_rad_s);
    own("zeta", 0.3, 3, "its damping ratio", &AxisPrecision::zeta);
    own("w2_rad_s", 100, 8000, "double pole of the observer, above w1_rad_s",
        &AxisPrecision::w2_rad_s);
    own("w3_rad_s", 0, 2000, "pole of its disturbance; 0 = none is observed",
        &AxisPrecision::w3_rad_s);
    own("mass_kg", 0.1, 500, "moving mass to start with, payload included",
        &AxisPrecision::mass_kg);
    own("viscous_N_s_m", 0, 10000, "viscous friction to start with", &AxisPrecision::viscous_n_s_m);
    own("coulomb_N", 0, 500, "Coulomb friction to start with", &AxisPrecision::coulomb_n);
    own("lead_ticks", 0, 15, "carrier periods by which the feed-forward is ahead",
        &AxisPrecision::lead_ticks);
    own("hysteresis_counts", 0, 0.9, "of the encoder's edges", &AxisPrecision::hysteresis_counts);
  }
}

void add_chip(Table& t) {
  const auto add = keys_of(t, "chip.", [](auto& o) -> auto& { return o.chip; });
  add("carrier_Hz", 8000, 40000, "of the PWM and its current loops: 8000, 16000, 20000, 40000",
      &ChipOptions::carrier_Hz);
  add("position_Hz", 1000, 4000, "rate of the position loops: 1000, 2000, 4000",
      &ChipOptions::position_Hz);
  add("dead_time_min_ns", 0, 20000, "lowest dead time the chip accepts",
      &ChipOptions::dead_time_min_ns);
  add("current_limit_A", 1e-3, 1000, "trip level of the measured phase currents",
      &ChipOptions::current_limit_A);
  add("following_error_m", 0, 1,
      "distance from the reference model at which the firmware turns the drives off; 0 = never",
      &ChipOptions::following_error_m);
  add("d_current_A", 0, 1000,
      "measured d current at which the firmware turns the drives off: its loop holds 0; 0 = never",
      &ChipOptions::d_current_A);
  add("offset_samples", 0, 255,
      "interrupts before the drives start that average the offsets of the current sensors",
      &ChipOptions::offset_samples);
  add("irq_period_ticks", 1, 255, "position samples per interrupt", &ChipOptions::irq_period_ticks);
  add("watchdog_ticks", 0, 65535, "longest time between two COMMITs, in position samples; 0 = off",
      &ChipOptions::watchdog_ticks);
  t.processor();
  t.one("processor.point_clk", 0, 90000,
        "clocks in which the firmware computes a point, before it writes the command",
        TRAMMEL_LENS(point_clk));
  t.one("plant.seed", 0, 9007199254740992.0, "of the noise", TRAMMEL_LENS(plant.seed));
}

void add_axis_chip(Table& t, std::size_t axis) {
  const auto add = keys_of(t, axis_prefix("chip", axis),
                           [axis](auto& o) -> auto& { return o.chip.axis[axis]; });
  add("dead_time_ns", 0, 20000, "between the two gates of a leg", &AxisChip::dead_time_ns);
  add("qep_filter_clk", 1, 15, "equal samples of an encoder edge", &AxisChip::qep_filter_clk);
  add("stroke_check", 0, 0, "leaving the stroke trips", &AxisChip::stroke_check);
  add("stroke_min_m", -40, 40, "where stroke_check trips", &AxisChip::stroke_min_m);
  add("stroke_max_m", -40, 40, "where stroke_check trips", &AxisChip::stroke_max_m);
}

void add_believed(Table& t, std::size_t axis) {
  const auto add = keys_of(t, axis_prefix("believed", axis),
                           [axis](auto& o) -> auto& { return o.believed[axis]; });
  add("force_constant_N_A", 0, 10000, "for gains.by_rule and the precision controller; 0 = plant's",
      &BelievedMotor::force_constant_n_a);
  add("resistance_ohm", 0, 1000, "of a phase, for gains.by_rule; 0 = the plant's",
      &BelievedMotor::resistance_ohm);
  add("inductance_q_H", 0, 1, "quadrature axis, for gains.by_rule; 0 = the plant's",
      &BelievedMotor::inductance_q_h);
  add("pole_pitch_m", 0, 1, "for electrical angle and estimated cogging; 0 = the plant's",
      &BelievedMotor::pole_pitch_m);
  add("mass_kg", 0, 1000, "moving mass with payload, for gains.by_rule; 0 = the plant's",
      &BelievedMotor::mass_kg);
}

void add_plant(Table& t, std::size_t axis) {
  const auto add = keys_of(t, axis_prefix("plant", axis),
                           [axis](auto& o) -> auto& { return o.plant.axis[axis]; });
  add("resistance_ohm", 0.01, 1000, "of a phase", &plant::AxisConfig::resistance_ohm);
  add("inductance_d_H", 1e-5, 1, "direct axis", &plant::AxisConfig::inductance_d_h);
  add("inductance_q_H", 1e-5, 1, "quadrature axis", &plant::AxisConfig::inductance_q_h);
  add("force_constant_N_A", 1, 10000, "at the peak of i_q", &plant::AxisConfig::force_constant_n_a);
  add("pole_pitch_m", 1e-4, 1, "half an electrical turn, at least 8 counts",
      &plant::AxisConfig::pole_pitch_m);
  add("mass_kg", 0.1, 500, "moving mass", &plant::AxisConfig::mass_kg);
  add("payload_kg", 0, 500, "on top of the moving mass", &plant::AxisConfig::payload_kg);
  add("coulomb_N", 0, 500, "Coulomb friction", &plant::AxisConfig::coulomb_n);
  add("viscous_N_s_m", 0, 10000, "viscous friction", &plant::AxisConfig::viscous_n_s_m);
  add("cogging_N", 0, 500, "amplitude, period one pole pitch", &plant::AxisConfig::cogging_n);
  add("stribeck_N", 0, 500, "of the friction at rest above coulomb_N",
      &plant::AxisConfig::stribeck_n);
  add("stribeck_speed_m_s", 1e-4, 1, "where 1/e of stribeck_N is left",
      &plant::AxisConfig::stribeck_speed_m_s);
  add("cogging_harmonic_N", 0, 500, "amplitude of a harmonic of the cogging",
      &plant::AxisConfig::cogging_harmonic_n);
  add("cogging_harmonic", 2, 12, "its number", &plant::AxisConfig::cogging_harmonic);
  add("cable_N_m", 0, 10000, "pull of a cable, per metre from cable_rest_m",
      &plant::AxisConfig::cable_n_m);
  add("cable_rest_m", -40, 40, "where the cable does not pull", &plant::AxisConfig::cable_rest_m);
  add("mode_Hz", 0, 1000,
      "resonance of an elastic mode: a share of the mass on a spring beside the encoder; 0 = none",
      &plant::AxisConfig::mode_hz);
  add("mode_damping", 0, 1, "its damping, of the critical one", &plant::AxisConfig::mode_damping);
  add("mode_mass_ratio", 0.01, 0.9, "share of the mass that is on the spring",
      &plant::AxisConfig::mode_mass_ratio);
  add("friction_speed_m_s", 1e-5, 1, "where friction smooths out",
      &plant::AxisConfig::friction_speed_m_s);
  add("external_force_N", -1000, 1000, "against positive motion",
      &plant::AxisConfig::external_force_n);
  add("load_N", -1000, 1000, "a force on top of it from load_begin_s to load_end_s",
      &plant::AxisConfig::load_n);
  add("load_begin_s", 0, 3600, "since the start of the run", &plant::AxisConfig::load_begin_s);
  add("load_end_s", 0, 3600, "since the start of the run; 0 = it does not end",
      &plant::AxisConfig::load_end_s);
  add("stroke_min_m", -40, 40, "hard stop", &plant::AxisConfig::stroke_min_m);
  add("stroke_max_m", -40, 40, "hard stop", &plant::AxisConfig::stroke_max_m);
  add("hard_stops", 0, 0, "the carriage stops at both ends", &plant::AxisConfig::hard_stops);
  add("brake", 0, 0, "holds the carriage until the drive is on", &plant::AxisConfig::brake);
  add("locked", 0, 0, "holds the carriage all the time", &plant::AxisConfig::locked);
  add("dc_link_V", 1, 1000, "of the inverter", &plant::AxisConfig::dc_link_v);
  add("supply_ohm", 0, 1000, "of the rectifier that charges the DC link; 0 = a stiff supply",
      &plant::AxisConfig::supply_ohm);
  add("dc_link_F", 1e-6, 1, "capacitor of a DC link that is not stiff",
      &plant::AxisConfig::dc_link_f);
  add("chopper_V", 0, 2000, "at which its brake chopper burns what comes back; 0 = none",
      &plant::AxisConfig::chopper_v);
  add("switch_drop_V", 0, 10, "of a closed switch", &plant::AxisConfig::switch_drop_v);
  add("diode_drop_V", 0, 10, "of a conducting diode", &plant::AxisConfig::diode_drop_v);
  add("continuous_current_A", 0, 1000, "rating of the motor, rms of a phase; 0 = none",
      &plant::AxisConfig::continuous_current_a);
  add("peak_current_A", 0, 1000, "rating of the motor, largest of a phase; 0 = none",
      &plant::AxisConfig::peak_current_a);
  add("encoder_count_m", 1e-7, 1e-3, "after x4 decoding; equal on both axes",
      &plant::AxisConfig::encoder_count_m);
  add("encoder_error_m", 0, 1e-4, "amplitude of a sine in the encoder's scale",
      &plant::AxisConfig::encoder_error_m);
  add("encoder_period_m", 1e-7, 1e-2, "period of that sine, of the scale's lines",
      &plant::AxisConfig::encoder_period_m);
  add("encoder_jitter_m", 0, 1e-5, "rms of a count's boundary, kept within the hysteresis",
      &plant::AxisConfig::encoder_jitter_m);
  add("encoder_hysteresis_counts", 0, 0.9, "keeps ripple from chattering at a count",
      &plant::AxisConfig::encoder_hysteresis_counts);
  add("index_m", -40, 40, "where the index pulse is", &plant::AxisConfig::index_m);
  add("current_full_scale_A", 0.1, 1000, "of the sensors",
      &plant::AxisConfig::current_full_scale_a);
  add("current_noise_A", 0, 10, "rms", &plant::AxisConfig::current_noise_a);
  add("current_offset_a_A", -1000, 1000, "what the sensor of phase a shows at no current",
      &plant::AxisConfig::current_offset_a_a);
  add("current_offset_b_A", -1000, 1000, "what the sensor of phase b shows at no current",
      &plant::AxisConfig::current_offset_b_a);
  add("current_gain_a", 0, 10, "what the sensor of phase a shows of the current",
      &plant::AxisConfig::current_gain_a);
  add("current_gain_b", 0, 10, "what the sensor of phase b shows of the current",
      &plant::AxisConfig::current_gain_b);
  add("adc_bits", 6, 16, "of the converters; the chip takes the highest 12",
      &plant::AxisConfig::adc_bits);
}

}  // namespace

const std::vector<lab::Key>& keys() {
  static const std::vector<lab::Key> all = [] {
    Table t(machine().name);
    add_run(t);
    add_faults(t);
    add_path(t);
    t.one("gains.by_rule", 0, 0,
          "kv and the gains of the current loop from the motor's data, not from their keys",
          TRAMMEL_LENS(gains_by_rule));
    for (const std::size_t axis : {0u, 1u}) add_gains(t, axis);
    add_precision(t);
    add_chip(t);
    for (const std::size_t axis : {0u, 1u}) add_axis_chip(t, axis);
    for (const std::size_t axis : {0u, 1u}) add_plant(t, axis);
    for (const std::size_t axis : {0u, 1u}) add_believed(t, axis);
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::kung
