// SPDX-License-Identifier: Apache-2.0
#include "models/plant/rotary_axis.hpp"

namespace trammel::plant {
namespace {

using Rotary = RotaryAxisConfig;

constexpr double kRevolution = 2 * kPi;     // [rad/rev]
constexpr double kSpeedRoom = 10;     // [rev/s] a motor gains less in the look-ahead of an axis
constexpr int kMostPolePairs = 50;
constexpr int kMostLines = 1'000'000;  // their counts stay exact over 1e6 revolutions

constexpr PartValue<Rotary> kMotorAndShaft[] = {
    {"resistance_ohm", &Rotary::resistance_ohm, Is::kPositive},
    {"inductance_d_h", &Rotary::inductance_d_h, Is::kPositive},
    {"inductance_q_h", &Rotary::inductance_q_h, Is::kPositive},
    {"flux_wb", &Rotary::flux_wb, Is::kNotNegative},
    {"cogging_nm", &Rotary::cogging_nm, Is::kFinite},
    {"cogging_harmonic_nm", &Rotary::cogging_harmonic_nm, Is::kFinite},
    {"inertia_kg_m2", &Rotary::inertia_kg_m2, Is::kPositive},
    {"coulomb_nm", &Rotary::coulomb_nm, Is::kNotNegative},
    {"viscous_nm_s", &Rotary::viscous_nm_s, Is::kNotNegative},
    {"friction_speed_rad_s", &Rotary::friction_speed_rad_s, Is::kPositive},
    {"external_torque_nm", &Rotary::external_torque_nm, Is::kFinite},
    {"load_nm", &Rotary::load_nm, Is::kFinite},
    {"load_begin_s", &Rotary::load_begin_s, Is::kNotNegative},
    {"load_end_s", &Rotary::load_end_s, Is::kNotNegative},
    {"start_rev", &Rotary::start_rev, Is::kFinite},
    {"longest_span_s", &Rotary::longest_span_s, Is::kPositive}};

constexpr PartValue<Rotary> kRotaryEncoder[] = {
    {"encoder_hysteresis_counts", &Rotary::encoder_hysteresis_counts, Is::kNotNegative},
    {"encoder_error_counts", &Rotary::encoder_error_counts, Is::kNotNegative},
    {"encoder_jitter_counts", &Rotary::encoder_jitter_counts, Is::kNotNegative},
    {"index_rev", &Rotary::index_rev, Is::kFinite}};

EncoderConfig encoder_config(const Rotary& c, std::uint64_t seed) {
  const int counts = 4 * c.encoder_lines;
  EncoderConfig e;
  e.count = 1.0 / counts;
  e.hysteresis = c.encoder_hysteresis_counts;
  e.index = c.index_rev;
  e.error = c.encoder_error_counts * e.count;
  e.period = 1.0 / c.encoder_lines;
  e.jitter = c.encoder_jitter_counts * e.count;
  e.seed = seed;
  e.turn = counts;
  return e;
}

PmsmAxisConfig parts(const Rotary& c, std::uint64_t seed) {
  PmsmAxisConfig p;
  p.link = link_config(c);
  p.inverter = inverter_config(c);
  p.motor = motor_config(c);
  p.mount.start = c.start_rev;
  p.mount.brake = c.brake;
  p.mount.locked = c.locked;
  p.mount.load = kRevolution * c.load_nm;
  p.mount.load_begin = c.load_begin_s;
  p.mount.load_end = c.load_end_s;
  p.encoder = encoder_config(c, seed);
  p.sensors = sensor_configs(c);
  p.longest_span = c.longest_span_s;
  return p;
}

}  // namespace

PmlsmConfig motor_config(const RotaryAxisConfig& c) {
  PmlsmConfig m;
  m.resistance = c.resistance_ohm;
  m.inductance_d = c.inductance_d_h;
  m.inductance_q = c.inductance_q_h;
  m.force_constant = kRevolution * c.torque_constant();
  m.pole_pitch = 0.5 / c.pole_pairs;
  m.pole_pairs = c.pole_pairs;
  m.mass = kRevolution * kRevolution * c.inertia_kg_m2;
  m.coulomb = kRevolution * c.coulomb_nm;
  m.viscous = kRevolution * kRevolution * c.viscous_nm_s;
  m.cogging = kRevolution * c.cogging_nm;
  m.friction_speed = c.friction_speed_rad_s / kRevolution;
  m.external_force = kRevolution * c.external_torque_nm;
  m.harmonic_force = kRevolution * c.cogging_harmonic_nm;
  m.harmonic = c.cogging_harmonic;
  m.speed_room = kSpeedRoom;
  return m;
}

const RotaryAxisConfig& checked(const RotaryAxisConfig& c) {
  require_value(c.pole_pairs >= 1 && c.pole_pairs <= kMostPolePairs, "pole_pairs", c.pole_pairs,
                "1 to 50");
  check_values(c, kMotorAndShaft);
  check_part(static_cast<const InverterPart&>(c));
  check_values(c, kRotaryEncoder);
  check_part(static_cast<const CurrentSensorPart&>(c));
  require_value(c.cogging_harmonic >= 1, "cogging_harmonic", c.cogging_harmonic, "1 or above");
  require_value(c.load_end_s == 0 || c.load_end_s > c.load_begin_s, "load_end_s", c.load_end_s,
                limit("0 or above load_begin_s =", c.load_begin_s));
  require_value(c.encoder_lines >= 1 && c.encoder_lines <= kMostLines, "encoder_lines",
                c.encoder_lines, "1 to 1000000");
  require_value(c.encoder_hysteresis_counts < 1, "encoder_hysteresis_counts",
                c.encoder_hysteresis_counts, "below 1");
  // Or the counts would not rise with the angle.
  require_value(c.encoder_error_counts < 2 / kPi, "encoder_error_counts", c.encoder_error_counts,
                limit("below 2 / pi =", 2 / kPi));
  return c;
}

RotaryAxis::RotaryAxis(const RotaryAxisConfig& config, double period_s, std::uint64_t seed)
    : PmsmAxis(parts(checked(config), seed), period_s) {}

RotaryAxisState RotaryAxis::state(Clk n) const {
  const PmsmState s = motion(n);
  return {s.motor.x, kRevolution * s.motor.v, s.motor.i_d,     s.motor.i_q,
          s.i_a,     s.i_b,             s.force / kRevolution, s.dc_link};
}

}  // namespace trammel::plant
