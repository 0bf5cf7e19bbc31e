// SPDX-License-Identifier: Apache-2.0
//
// What no axis can have is refused by its name, ahead of searches that would not end with it.
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "models/plant/axis.hpp"
#include "models/plant/trig.hpp"

namespace trammel::plant {
namespace {

using C = AxisConfig;

enum class Is { kFinite, kNotNegative, kPositive };

struct Value {
  const char* name;
  double C::* member;
  Is is;
};

constexpr Value kValues[] = {
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
    {"dc_link_v", &C::dc_link_v, Is::kNotNegative},
    {"supply_ohm", &C::supply_ohm, Is::kNotNegative},
    {"dc_link_f", &C::dc_link_f, Is::kPositive},
    {"chopper_v", &C::chopper_v, Is::kNotNegative},
    {"switch_drop_v", &C::switch_drop_v, Is::kNotNegative},
    {"diode_drop_v", &C::diode_drop_v, Is::kNotNegative},
    {"encoder_count_m", &C::encoder_count_m, Is::kPositive},
    {"encoder_hysteresis_counts", &C::encoder_hysteresis_counts, Is::kNotNegative},
    {"encoder_error_m", &C::encoder_error_m, Is::kNotNegative},
    {"encoder_period_m", &C::encoder_period_m, Is::kPositive},
    {"encoder_jitter_m", &C::encoder_jitter_m, Is::kNotNegative},
    {"index_m", &C::index_m, Is::kFinite},
    {"current_full_scale_a", &C::current_full_scale_a, Is::kPositive},
    {"current_noise_a", &C::current_noise_a, Is::kNotNegative},
    {"current_offset_a_a", &C::current_offset_a_a, Is::kFinite},
    {"current_offset_b_a", &C::current_offset_b_a, Is::kFinite},
    {"current_gain_a", &C::current_gain_a, Is::kFinite},
    {"current_gain_b", &C::current_gain_b, Is::kFinite},
    {"start_m", &C::start_m, Is::kFinite},
    {"longest_span_s", &C::longest_span_s, Is::kPositive}};

void require(bool good, const char* name, double value, const std::string& permitted) {
  if (good) return;
  std::ostringstream text;
  text << "axis: " << name << ": value " << value << " must be " << permitted;
  throw std::invalid_argument(text.str());
}

std::string than(const char* words, double value) {
  std::ostringstream text;
  text << words << ' ' << value;
  return text.str();
}

}  // namespace

const AxisConfig& checked(const AxisConfig& c) {
  for (const Value& one : kValues) {
    const double value = c.*one.member;
    require(std::isfinite(value), one.name, value, "finite");
    require(one.is != Is::kPositive || value > 0, one.name, value, "above 0");
    require(one.is != Is::kNotNegative || value >= 0, one.name, value, "0 or above");
  }
  require(c.mode_mass_ratio < 1, "mode_mass_ratio", c.mode_mass_ratio, "below 1");
  require(c.cogging_harmonic >= 1, "cogging_harmonic", c.cogging_harmonic, "1 or above");
  require(!c.hard_stops || c.stroke_min_m < c.stroke_max_m, "stroke_min_m", c.stroke_min_m,
          than("below stroke_max_m =", c.stroke_max_m));
  require(c.load_end_s == 0 || c.load_end_s > c.load_begin_s, "load_end_s", c.load_end_s,
          than("0 or above load_begin_s =", c.load_begin_s));
  require(c.encoder_hysteresis_counts < 1, "encoder_hysteresis_counts",
          c.encoder_hysteresis_counts, "below 1");
  // Or the counts would not rise with the position.
  require(c.encoder_error_m < c.encoder_period_m / (2 * kPi), "encoder_error_m", c.encoder_error_m,
          than("below encoder_period_m / (2 pi) =", c.encoder_period_m / (2 * kPi)));
  require(c.adc_bits >= 6 && c.adc_bits <= 16, "adc_bits", c.adc_bits, "6 to 16");
  return c;
}

}  // namespace trammel::plant
