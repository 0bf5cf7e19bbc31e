// SPDX-License-Identifier: Apache-2.0
#include "models/plant/axis.hpp"

namespace trammel::plant {
namespace {

using C = AxisConfig;

// What no axis can have is refused ahead of searches that would not end with it.
constexpr PartValue<C> kMotorAndCarriage[] = {
    {"resistance_ohm", &C::resistance_ohm, Is::kPositive},
    {"inductance_d_h", &C::inductance_d_h, Is::kPositive},
    {"inductance_q_h", &C::inductance_q_h, Is::kPositive},
    {"force_constant_n_a", &C::force_constant_n_a, Is::kNotNegative},
    {"pole_pitch_m", &C::pole_pitch_m, Is::kPositive},
    {"mass_kg", &C::mass_kg, Is::kPositive},
    {"payload_kg", &C::payload_kg, Is::kNotNegative},
    {"coulomb_n", &C::coulomb_n, Is::kNotNegative},
    {"viscous_n_s_m", &C::viscous_n_s_m, Is::kNotNegative},
    {"cogging_n", &C::cogging_n, Is::kFinite},
    {"friction_speed_m_s", &C::friction_speed_m_s, Is::kPositive},
    {"external_force_n", &C::external_force_n, Is::kFinite},
    {"stribeck_n", &C::stribeck_n, Is::kNotNegative},
    {"stribeck_speed_m_s", &C::stribeck_speed_m_s, Is::kPositive},
    {"cogging_harmonic_n", &C::cogging_harmonic_n, Is::kFinite},
    {"cable_n_m", &C::cable_n_m, Is::kNotNegative},
    {"cable_rest_m", &C::cable_rest_m, Is::kFinite},
    {"mode_hz", &C::mode_hz, Is::kNotNegative},
    {"mode_damping", &C::mode_damping, Is::kNotNegative},
    {"mode_mass_ratio", &C::mode_mass_ratio, Is::kPositive},
    {"load_n", &C::load_n, Is::kFinite},
    {"load_begin_s", &C::load_begin_s, Is::kNotNegative},
    {"load_end_s", &C::load_end_s, Is::kNotNegative},
    {"stroke_min_m", &C::stroke_min_m, Is::kFinite},
    {"stroke_max_m", &C::stroke_max_m, Is::kFinite},
    {"start_m", &C::start_m, Is::kFinite},
    {"longest_span_s", &C::longest_span_s, Is::kPositive}};

constexpr PartValue<C> kEncoder[] = {
    {"encoder_count_m", &C::encoder_count_m, Is::kPositive},
    {"encoder_hysteresis_counts", &C::encoder_hysteresis_counts, Is::kNotNegative},
    {"encoder_error_m", &C::encoder_error_m, Is::kNotNegative},
    {"encoder_period_m", &C::encoder_period_m, Is::kPositive},
    {"encoder_jitter_m", &C::encoder_jitter_m, Is::kNotNegative},
    {"index_m", &C::index_m, Is::kFinite}};

PmsmAxisConfig parts(const AxisConfig& c, std::uint64_t seed) {
  PmsmAxisConfig p;
  p.link = link_config(c);
  p.inverter = inverter_config(c);
  p.motor = motor_config(c);
  p.mount = {c.start_m, c.stroke_min_m, c.stroke_max_m, c.hard_stops, c.brake,
             c.locked,  c.load_n,       c.load_begin_s, c.load_end_s};
  p.encoder = {c.encoder_count_m,  c.encoder_hysteresis_counts, c.index_m, c.encoder_error_m,
               c.encoder_period_m, c.encoder_jitter_m,          seed,      0};
  p.sensors = sensor_configs(c);
  p.longest_span = c.longest_span_s;
  return p;
}

}  // namespace

PmlsmConfig motor_config(const AxisConfig& c) {
  PmlsmConfig m;
  m.resistance = c.resistance_ohm;
  m.inductance_d = c.inductance_d_h;
  m.inductance_q = c.inductance_q_h;
  m.force_constant = c.force_constant_n_a;
  m.pole_pitch = c.pole_pitch_m;
  m.mass = c.mass_kg + c.payload_kg;
  m.coulomb = c.coulomb_n;
  m.viscous = c.viscous_n_s_m;
  m.cogging = c.cogging_n;
  m.friction_speed = c.friction_speed_m_s;
  m.external_force = c.external_force_n;
  m.stribeck = c.stribeck_n;
  m.stribeck_speed = c.stribeck_speed_m_s;
  m.harmonic_force = c.cogging_harmonic_n;
  m.harmonic = c.cogging_harmonic;
  m.cable = c.cable_n_m;
  m.cable_rest = c.cable_rest_m;
  if (c.mode_hz != 0) m.add_mode(c.mode_hz, c.mode_damping, c.mode_mass_ratio);
  return m;
}

const AxisConfig& checked(const AxisConfig& c) {
  check_values(c, kMotorAndCarriage);
  check_part(static_cast<const InverterPart&>(c));
  check_values(c, kEncoder);
  check_part(static_cast<const CurrentSensorPart&>(c));
  require_value(c.mode_mass_ratio < 1, "mode_mass_ratio", c.mode_mass_ratio, "below 1");
  require_value(c.cogging_harmonic >= 1, "cogging_harmonic", c.cogging_harmonic, "1 or above");
  require_value(!c.hard_stops || c.stroke_min_m < c.stroke_max_m, "stroke_min_m", c.stroke_min_m,
                limit("below stroke_max_m =", c.stroke_max_m));
  require_value(c.load_end_s == 0 || c.load_end_s > c.load_begin_s, "load_end_s", c.load_end_s,
                limit("0 or above load_begin_s =", c.load_begin_s));
  require_value(c.encoder_hysteresis_counts < 1, "encoder_hysteresis_counts",
                c.encoder_hysteresis_counts, "below 1");
  // Or the counts would not rise with the position.
  const double steepest = c.encoder_period_m / (2 * kPi);
  require_value(c.encoder_error_m < steepest, "encoder_error_m", c.encoder_error_m,
                limit("below encoder_period_m / (2 pi) =", steepest));
  return c;
}

Axis::Axis(const AxisConfig& config, double period_s, std::uint64_t seed)
    : PmsmAxis(parts(checked(config), seed), period_s) {}

AxisState Axis::state(Clk n) const {
  const PmsmState s = motion(n);
  return {s.motor.x, s.motor.v, s.motor.i_d, s.motor.i_q, s.i_a,
          s.i_b,     s.force,   s.dc_link,   s.motor.y};
}

}  // namespace trammel::plant
