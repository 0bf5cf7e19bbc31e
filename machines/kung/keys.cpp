// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include "lab/key_table.hpp"
#include "machines/kung/machine.hpp"

namespace trammel::lab {

template <>
std::vector<std::string> enum_names<kung::Controller>() {
  return {"fc", "afc"};
}
template <>
std::vector<std::string> enum_names<kung::PathKind>() {
  return {"circle", "window", "star", "square", "line", "points"};
}

}  // namespace trammel::lab

namespace trammel::kung {
namespace {

constexpr const char* kAxisNames[] = {"x", "y"};

using Table = lab::KeyTable<Options>;

// Adds section.x.key and section.y.key.
struct AxisTable {
  std::vector<lab::Key> by_axis[2];

  template <typename Lens>
  void add(const std::string& section, const std::string& name, double min, double max,
           const std::string& help, Lens lens) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      by_axis[axis].push_back(
          lab::make_key<Options>(fmt::format("{}.{}.{}", section, kAxisNames[axis], name), min, max,
                            help, [lens, axis](auto& o) -> auto& { return lens(o, axis); }));
    }
  }
  void append_to(std::vector<lab::Key>& all) {
    for (auto& keys : by_axis) std::move(keys.begin(), keys.end(), std::back_inserter(all));
  }
};

#define TRAMMEL_AXIS_LENS(group, member) \
  [](auto& o, std::size_t axis_) -> auto& { return o.group[axis_].member; }

void add_run(Table& t) {
  t.names();
  t.text("controller", "fixed rule table (fc) or adaptive (afc)", TRAMMEL_LENS(controller));
  t.platform_and_clocks();
  t.window();
  t.one("run.settle_s", 0, 10, "simulated after the last point, not counted",
        TRAMMEL_LENS(settle_s));
  t.longest_run();
  t.one("run.diverged_m", 1e-4, 1, "tracking error that ends the run as diverged",
        TRAMMEL_LENS(diverged_m));
  t.waves("where the drives start", "see `trammel list signals`");
}

void add_faults(Table& t) {
  t.one("inject.trip_s", 0, 3600, "time at which the trip pin rises; 0 = never",
        TRAMMEL_LENS(inject.trip_s));
  t.one("inject.encoder_s", 0, 3600, "time at which both lines of encoder X jump; 0 = never",
        TRAMMEL_LENS(inject.encoder_s));
  t.one("inject.processor_s", 0, 3600, "time from which the processor does nothing; 0 = never",
        TRAMMEL_LENS(inject.processor_s));
}

void add_path(Table& t) {
  t.text("path.kind", "which generator", TRAMMEL_LENS(path.kind));
  t.one("path.repeats", 1, 1000, "passes of a circle, window, star or points path",
        TRAMMEL_LENS(path.repeats));
  t.one("path.circle_radius_m", 1e-4, 0.3, "of the circle", TRAMMEL_LENS(path.circle_radius_m));
  t.one("path.circle_center_x_m", 0, 0.6, "centre of the circle",
        TRAMMEL_LENS(path.circle_center_x_m));
  t.one("path.circle_center_y_m", 0, 0.6, "centre of the circle",
        TRAMMEL_LENS(path.circle_center_y_m));
  t.one("path.circle_ticks", 16, 1000000, "interrupts per turn", TRAMMEL_LENS(path.circle_ticks));
  t.one("path.window_side_m", 1e-3, 0.6, "of the square", TRAMMEL_LENS(path.window_side_m));
  t.one("path.window_radius_m", 1e-4, 0.29, "of the arcs at the corners",
        TRAMMEL_LENS(path.window_radius_m));
  t.one("path.window_center_x_m", 0, 0.6, "centre of the square",
        TRAMMEL_LENS(path.window_center_x_m));
  t.one("path.window_center_y_m", 0, 0.6, "centre of the square",
        TRAMMEL_LENS(path.window_center_y_m));
  t.one("path.window_step_m", 1e-6, 2.5e-3, "per interrupt, on the straight parts",
        TRAMMEL_LENS(path.window_step_m));
  t.one("path.window_arc_ticks", 4, 100000, "interrupts per arc",
        TRAMMEL_LENS(path.window_arc_ticks));
  t.one("path.star_edge_m", 1e-3, 0.6, "length of a stroke", TRAMMEL_LENS(path.star_edge_m));
  t.one("path.star_start_x_m", 0, 0.6, "left end of the first stroke",
        TRAMMEL_LENS(path.star_start_x_m));
  t.one("path.star_start_y_m", 0, 0.6, "left end of the first stroke",
        TRAMMEL_LENS(path.star_start_y_m));
  t.one("path.star_stroke_ticks", 4, 100000, "interrupts per stroke",
        TRAMMEL_LENS(path.star_stroke_ticks));
  t.one("path.square_low_m", -0.6, 0.6, "where both axes rest", TRAMMEL_LENS(path.square_low_m));
  t.one("path.square_high_m", -0.6, 0.6, "where both axes step to",
        TRAMMEL_LENS(path.square_high_m));
  t.one("path.square_half_samples", 4, 100000, "2 kHz samples per half period",
        TRAMMEL_LENS(path.square_half_samples));
  t.one("path.square_periods", 1, 1000, "of the square wave", TRAMMEL_LENS(path.square_periods));
  t.one("path.line_start_x_m", 0, 0.6, "where the line begins", TRAMMEL_LENS(path.line_start_x_m));
  t.one("path.line_start_y_m", 0, 0.6, "where the line begins", TRAMMEL_LENS(path.line_start_y_m));
  t.one("path.line_end_x_m", 0, 0.6, "where the line ends", TRAMMEL_LENS(path.line_end_x_m));
  t.one("path.line_end_y_m", 0, 0.6, "where the line ends", TRAMMEL_LENS(path.line_end_y_m));
  t.one("path.line_ticks", 1, 1000000, "interrupts from end to end", TRAMMEL_LENS(path.line_ticks));
  t.file("path.points_file",
         "CSV of x_mm,y_mm, one point per interrupt; a relative path starts at the scenario file",
         TRAMMEL_LENS(path.points_file));
}

void add_chip(Table& t) {
  t.one("chip.dead_time_min_ns", 0, 20000, "lowest dead time the chip accepts",
        TRAMMEL_LENS(chip.dead_time_min_ns));
  t.one("chip.current_limit_A", 0.1, 9.6, "trip level of the measured phase currents",
        TRAMMEL_LENS(chip.current_limit_A));
  t.one("chip.irq_period_ticks", 1, 255, "2 kHz samples per interrupt",
        TRAMMEL_LENS(chip.irq_period_ticks));
  t.one("chip.watchdog_ticks", 0, 65535,
        "longest time between two COMMITs, in 2 kHz samples; 0 = off",
        TRAMMEL_LENS(chip.watchdog_ticks));
  t.processor();
  t.one("plant.seed", 0, 9007199254740992.0, "of the noise", TRAMMEL_LENS(plant.seed));

  AxisTable a;
  a.add("chip", "dead_time_ns", 0, 20000, "between the two gates of a leg",
        TRAMMEL_AXIS_LENS(chip.axis, dead_time_ns));
  a.add("chip", "qep_filter_clk", 1, 15, "equal samples of an encoder edge",
        TRAMMEL_AXIS_LENS(chip.axis, qep_filter_clk));
  a.add("chip", "stroke_check", 0, 0, "leaving the stroke trips",
        TRAMMEL_AXIS_LENS(chip.axis, stroke_check));
  a.add("chip", "stroke_min_m", -40, 40, "where stroke_check trips",
        TRAMMEL_AXIS_LENS(chip.axis, stroke_min_m));
  a.add("chip", "stroke_max_m", -40, 40, "where stroke_check trips",
        TRAMMEL_AXIS_LENS(chip.axis, stroke_max_m));
  a.append_to(t.keys);
}

void add_gains(Table& t) {
  const std::string s = "gains";
  AxisTable a;
  a.add(s, "kp", 0, 32, "proportional gain of the position PI", TRAMMEL_AXIS_LENS(gains, kp));
  a.add(s, "ki", 0, 1, "integral gain of the position PI, per sample",
        TRAMMEL_AXIS_LENS(gains, ki));
  a.add(s, "kv", 0, 64, "proportional gain of the speed loop", TRAMMEL_AXIS_LENS(gains, kv));
  a.add(s, "learning_rate", 0, 10, "alpha of the tuning law",
        TRAMMEL_AXIS_LENS(gains, learning_rate));
  a.add(s, "shift_e", 0, 11, "one fuzzy unit = 256 / 2^shift counts",
        TRAMMEL_AXIS_LENS(gains, shift_e));
  a.add(s, "shift_de", 0, 11, "the same for the error change",
        TRAMMEL_AXIS_LENS(gains, shift_de));
  a.add(s, "omega_n_rad_s", 1, 200, "natural frequency of the reference model",
        TRAMMEL_AXIS_LENS(gains, omega_n_rad_s));
  a.add(s, "zeta", 0.2, 5, "damping ratio of the reference model", TRAMMEL_AXIS_LENS(gains, zeta));
  a.add(s, "current_kp_V_A", 0, 1000, "proportional gain of the current PI",
        TRAMMEL_AXIS_LENS(gains, current_kp_V_A));
  a.add(s, "current_ki_V_A", 0, 1000, "integral gain of the current PI, per 16 kHz sample",
        TRAMMEL_AXIS_LENS(gains, current_ki_V_A));
  a.add(s, "theta_offset_rad", -7, 7, "electrical angle at count 0",
        TRAMMEL_AXIS_LENS(gains, theta_offset_rad));
  a.add(s, "feedforward", 0, 0, "velocity feed-forward from the model",
        TRAMMEL_AXIS_LENS(gains, feedforward));
  a.add(s, "interpolate", 0, 0, "commands linear between interrupts",
        TRAMMEL_AXIS_LENS(gains, interpolate));
  a.append_to(t.keys);
}

void add_plant(Table& t) {
  const std::string s = "plant";
  AxisTable a;
#define TRAMMEL_PLANT(name, member, min, max, help) \
  a.add(s, name, min, max, help, TRAMMEL_AXIS_LENS(plant.axis, member))
  TRAMMEL_PLANT("resistance_ohm", resistance_ohm, 0.01, 1000, "of a phase");
  TRAMMEL_PLANT("inductance_d_H", inductance_d_h, 1e-4, 1, "direct axis");
  TRAMMEL_PLANT("inductance_q_H", inductance_q_h, 1e-4, 1, "quadrature axis");
  TRAMMEL_PLANT("force_constant_N_A", force_constant_n_a, 1, 1000, "at the peak of i_q");
  TRAMMEL_PLANT("pole_pitch_m", pole_pitch_m, 1e-3, 1, "half an electrical turn");
  TRAMMEL_PLANT("mass_kg", mass_kg, 0.1, 500, "moving mass");
  TRAMMEL_PLANT("payload_kg", payload_kg, 0, 500, "on top of the moving mass");
  TRAMMEL_PLANT("coulomb_N", coulomb_n, 0, 500, "Coulomb friction");
  TRAMMEL_PLANT("viscous_N_s_m", viscous_n_s_m, 0, 10000, "viscous friction");
  TRAMMEL_PLANT("cogging_N", cogging_n, 0, 500, "amplitude, period one pole pitch");
  TRAMMEL_PLANT("friction_speed_m_s", friction_speed_m_s, 1e-5, 1, "where friction smooths out");
  TRAMMEL_PLANT("external_force_N", external_force_n, -1000, 1000, "against positive motion");
  TRAMMEL_PLANT("stroke_min_m", stroke_min_m, -40, 40, "hard stop");
  TRAMMEL_PLANT("stroke_max_m", stroke_max_m, -40, 40, "hard stop");
  TRAMMEL_PLANT("hard_stops", hard_stops, 0, 0, "the carriage stops at both ends");
  TRAMMEL_PLANT("dc_link_V", dc_link_v, 1, 1000, "of the inverter");
  TRAMMEL_PLANT("switch_drop_V", switch_drop_v, 0, 10, "of a closed switch");
  TRAMMEL_PLANT("diode_drop_V", diode_drop_v, 0, 10, "of a conducting diode");
  TRAMMEL_PLANT("encoder_count_m", encoder_count_m, 1e-7, 1e-3, "after x4 decoding");
  TRAMMEL_PLANT("encoder_hysteresis_counts", encoder_hysteresis_counts, 0, 0.9,
                "keeps ripple from chattering at a count");
  TRAMMEL_PLANT("index_m", index_m, -40, 40, "where the index pulse is");
  TRAMMEL_PLANT("current_full_scale_A", current_full_scale_a, 0.1, 1000, "of the sensors");
  TRAMMEL_PLANT("current_noise_A", current_noise_a, 0, 10, "rms");
  TRAMMEL_PLANT("adc_bits", adc_bits, 6, 12, "of the converters");
#undef TRAMMEL_PLANT
  a.append_to(t.keys);
}

#undef TRAMMEL_AXIS_LENS

}  // namespace

const std::vector<lab::Key>& keys() {
  static const std::vector<lab::Key> all = [] {
    Table t(machine().name);
    add_run(t);
    add_faults(t);
    add_path(t);
    add_gains(t);
    add_chip(t);
    add_plant(t);
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::kung
