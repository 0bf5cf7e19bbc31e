// SPDX-License-Identifier: Apache-2.0
//
// An axis with a rotary permanent-magnet synchronous motor of p pole pairs on an inverter, and an
// incremental encoder on its shaft (pmsm_axis.hpp says how it moves):
//   T = 3/2 p (lambda_f + (L_d - L_q) i_d) i_q,  theta_e = p theta
//   J dw/dt = T - B w - T_c w/sqrt(w^2 + w_f^2) - T_cog sin(2 p theta) - T_h sin(2 h p theta + 1)
//             - T_load
// The motor model counts places in revolutions, so that theta_e is exact in each of them.
#pragma once

#include <cstdint>

#include "models/plant/axis_parts.hpp"
#include "models/plant/pmsm_axis.hpp"

namespace trammel::plant {

// Defaults of all parts: a servo of some 400 W at 311 V.
struct RotaryMotorPart {
  double resistance_ohm = 2.7;
  double inductance_d_h = 8.5e-3;
  double inductance_q_h = 8.5e-3;
  double flux_wb = 0.07;  // of the magnets in a phase, peak
  int pole_pairs = 4;     // 1 to 50
  double cogging_nm = 0;
  double cogging_harmonic_nm = 0;
  int cogging_harmonic = 2;

  // Per peak of i_q, with i_d = 0 or L_d = L_q [N m/A].
  double torque_constant() const { return 1.5 * pole_pairs * flux_wb; }
};

// The rotor with its load.
struct ShaftPart {
  double inertia_kg_m2 = 60e-6;
  double coulomb_nm = 0.02;
  double viscous_nm_s = 5e-5;
  double friction_speed_rad_s = 0.5;  // width of the Coulomb transition
  double external_torque_nm = 0;      // against positive motion
  double load_nm = 0;                 // more of it, from load_begin_s to load_end_s
  double load_begin_s = 0, load_end_s = 0;  // since the start; 0: it does not end
  bool brake = false;   // holds the shaft until a gate is first on
  bool locked = false;  // holds it all the time
  double start_rev = 0;
};

struct RotaryEncoderPart {
  int encoder_lines = 1024;  // per revolution; each has 4 counts
  double encoder_hysteresis_counts = 0.2;
  double encoder_error_counts = 0;   // sub-divisional, once per line
  double encoder_jitter_counts = 0;  // rms, within the hysteresis
  double index_rev = 0;
};

struct RotaryAxisConfig : RotaryMotorPart,
                          ShaftPart,
                          InverterPart,
                          RotaryEncoderPart,
                          CurrentSensorPart {
  double longest_span_s = 25e-6;  // of one series
};

struct RotaryAxisState {
  double turn = 0;  // [rev]
  double speed_rad_s = 0;
  double i_d_a = 0, i_q_a = 0, i_a_a = 0, i_b_a = 0;
  double torque_nm = 0;  // electromagnetic
  double dc_link_v = 0;
};

PmlsmConfig motor_config(const RotaryAxisConfig& c);

// The same; throws std::invalid_argument that names the first value that no axis can have.
const RotaryAxisConfig& checked(const RotaryAxisConfig& c);

class RotaryAxis : public PmsmAxis {
 public:
  // The seed is that of the encoder's jitter.
  RotaryAxis(const RotaryAxisConfig& config, double period_s, std::uint64_t seed = 0);

  RotaryAxisState state(Clk n) const;
};

}  // namespace trammel::plant
