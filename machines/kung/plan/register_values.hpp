// SPDX-License-Identifier: Apache-2.0
//
// Physical values to register words of the chip (specification sections 3 to 7).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "cosim/wave_plan.hpp"
#include "models/fixed/fixed.hpp"
#include "models/plant/axis.hpp"

namespace trammel::kung {

// Rates for which the gains are given; at others they are the same in seconds.
inline constexpr double kGainSampleS = 0.5e-3;   // of the position loop [s]
inline constexpr double kGainCarrierHz = 16000;  // of the current loop

// Steps of the measured currents and of i_q* [A], for sensors of that full scale.
constexpr double current_lsb_A(double full_scale_A) { return full_scale_A / 2048; }
constexpr double current_ref_lsb_A(double full_scale_A) { return full_scale_A / 4096; }

// Smallest voltage step [V]: full scale is the largest linear phase voltage.
inline double voltage_lsb_V(double dc_link_V) { return dc_link_V / std::sqrt(3.0) / 2048; }

// Nearest gain word: mantissa 1024..2047 where the exponent allows it; 0 for 0.
inline fixed::Gain gain_word(double value) {
  if (value <= 0) return {};
  int exponent = 0;
  std::frexp(value, &exponent);  // value = f * 2^exponent, f in 0.5..1
  long mantissa = std::lround(std::ldexp(value, 11 - exponent));
  if (mantissa > 2047) {
    ++exponent;
    mantissa = 1024;
  }
  if (exponent < -16) {
    mantissa = std::lround(std::ldexp(value, 11 + 16));
    exponent = -16;
  }
  return {static_cast<std::int32_t>(mantissa), exponent};
}

// ETA = alpha (Kp + Ki) Kv / 32: the constant part of Kung eq. 27 (section 5, step 9).
inline double eta_value(double alpha, double kp, double ki, double kv) {
  return alpha * (kp + ki) * kv / 32;
}

// Current controller gain [V/A] as a ratio of voltage to current command words.
inline double current_gain_value(double gain_V_A, double dc_link_V, double full_scale_A) {
  return gain_V_A * current_ref_lsb_A(full_scale_A) / voltage_lsb_V(dc_link_V);
}

// Gains for a motor: a current loop of 4000 rad/s whose zero cancels the winding's pole,
// a speed loop of 220 rad/s of motor, carried mass and payload.
struct MotorGains {
  double kv_A_s_m = 0, current_kp_V_A = 0, current_ki_V_A = 0;
};

constexpr MotorGains gains_by_rule(const plant::AxisConfig& m) {
  constexpr double kCurrent = 4000, kSpeed = 220;  // [rad/s]
  return {kSpeed * (m.mass_kg + m.payload_kg) / m.force_constant_n_a, kCurrent * m.inductance_q_h,
          kCurrent * m.resistance_ohm / kGainCarrierHz};
}

inline constexpr double kSpeedGain = 3.75;  // gains.kv = 1 in A/(m/s)

// Reference model (Kung eq. 21) by the bilinear transform (Kung eq. 23; section 4):
// A0 = a0 / scale, with the finest scale in which it has 18 bits; B2 = b2 * 2^23.
struct ModelWords {
  std::int32_t a0 = 0;
  std::uint32_t a0_scale = 0;
  std::int32_t b2 = 0;
};

inline ModelWords model_words(double omega_n_rad_s, double zeta, double sample_s) {
  const double k = 2 / sample_s;
  const double w2 = omega_n_rad_s * omega_n_rad_s;
  const double denominator = k * k + 2 * zeta * omega_n_rad_s * k + w2;
  const double b2 = (k * k - 2 * zeta * omega_n_rad_s * k + w2) / denominator;
  constexpr std::array<int, 3> kScaleBits{32, 28, 23};
  std::uint32_t scale = 0;
  while (scale < 2 && std::ldexp(w2 / denominator, kScaleBits[scale]) >= 262143.5) ++scale;
  return {static_cast<std::int32_t>(std::lround(std::ldexp(w2 / denominator, kScaleBits[scale]))),
          scale,
          static_cast<std::int32_t>(std::lround(std::ldexp(b2, 23)))};
}

}  // namespace trammel::kung
