// SPDX-License-Identifier: Apache-2.0
//
// An axis with a linear motor, in metres and newtons (pmsm_axis.hpp says how it moves).
#pragma once

#include <cstdint>

#include "models/plant/axis_parts.hpp"
#include "models/plant/pmsm_axis.hpp"

namespace trammel::plant {

// Defaults of all parts: the X axis of the table of Kung et al. 2012.
struct LinearMotorPart {
  double resistance_ohm = 27;
  double inductance_d_h = 23.3e-3;
  double inductance_q_h = 23.3e-3;
  double force_constant_n_a = 79.9;
  double pole_pitch_m = 30.5e-3;
  double cogging_n = 0;
  double cogging_harmonic_n = 0;
  int cogging_harmonic = 2;
  double continuous_current_a = 1.6, peak_current_a = 4.8;  // rating: rms, largest of a phase
};

// The carriage, its guide, and what pushes it.
struct CarriagePart {
  double mass_kg = 2.5;
  double payload_kg = 0;
  double coulomb_n = 3.0;
  double viscous_n_s_m = 20;
  double friction_speed_m_s = 0.5e-3;
  double external_force_n = 0;
  double stribeck_n = 0, stribeck_speed_m_s = 5e-3;  // friction at rest above coulomb_n
  double cable_n_m = 0, cable_rest_m = 0.3;  // a cable that pulls toward its place of rest
  double mode_hz = 0;  // resonance of an elastic mode; 0: none
  double mode_damping = 0.02, mode_mass_ratio = 0.2;  // of critical; share of the mass
  double load_n = 0;                       // more of it, from load_begin_s to load_end_s
  double load_begin_s = 0, load_end_s = 0;  // since the start; 0: it does not end
  double stroke_min_m = 0;
  double stroke_max_m = 0.6;
  bool hard_stops = true;
  bool brake = true;  // holds the carriage until a gate is first on
  bool locked = false;  // holds it all the time
  double start_m = 0;
};

struct LinearEncoderPart {
  double encoder_count_m = 5e-6;
  double encoder_hysteresis_counts = 0.2;
  double encoder_error_m = 0, encoder_period_m = 20e-6;  // sub-divisional; period of the scale
  double encoder_jitter_m = 0;                           // rms, within the hysteresis
  double index_m = 0.25;
};

struct AxisConfig : LinearMotorPart,
                    CarriagePart,
                    InverterPart,
                    LinearEncoderPart,
                    CurrentSensorPart {
  double longest_span_s = 25e-6;  // of one series
};

struct AxisState {
  double x_m = 0, v_m_s = 0;
  double i_d_a = 0, i_q_a = 0, i_a_a = 0, i_b_a = 0;
  double force_n = 0;  // electromagnetic
  double dc_link_v = 0;
  double mode_m = 0;  // by which the mass on the spring is ahead
};

PmlsmConfig motor_config(const AxisConfig& c);

// The same; throws std::invalid_argument that names the first value that no axis can have.
const AxisConfig& checked(const AxisConfig& c);

class Axis : public PmsmAxis {
 public:
  // The seed is that of the encoder's jitter.
  Axis(const AxisConfig& config, double period_s, std::uint64_t seed = 0);

  AxisState state(Clk n) const;
};

}  // namespace trammel::plant
