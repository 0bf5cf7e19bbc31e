// SPDX-License-Identifier: Apache-2.0
//
// Axis of a leadscrew stage (McAfee 1994, ch. IV): 8-bit converter, amplifier of the LM675 class
// that limits its current, DC motor, screw, encoder on the shaft, optical limit switches at both
// ends of the travel and stops behind them. Past an open switch only a diode carries the motor's
// current: at once none flows toward the switch, while the amplifier can still drive away from it
// and the moving motor brakes. Signatures of cosim::Plant, for one axis.
#pragma once

#include <cstdint>

#include "models/plant/sensed_motor.hpp"
#include "models/plant/sine_encoder.hpp"

namespace trammel::plant {

// Electrical data of the Aerotech 1075 and the friction are assumed; the inertia is that of rotor,
// screw and carriage together.
inline DcMotorConfig leadscrew_motor() {
  DcMotorConfig c;
  c.resistance = 1.1;
  c.inductance = 2e-3;
  c.constant = 0.080;
  c.inertia = 2e-4;
  c.coulomb = 0.03;
  c.supply = 22;
  c.current_limit = 3;
  return c;
}

struct LeadscrewConfig {
  DcMotorConfig motor = leadscrew_motor();
  SineEncoderConfig encoder;
  double pitch = 4.0132e-3;           // [m] per revolution, 0.158 in
  double switch_low = -0.3048;        // [m] from where the axis starts; 24 in of travel
  double switch_high = 0.3048;        // [m]
  double switch_hysteresis = 20e-6;   // [m]
  double overtravel = 5e-3;           // [m] from a switch to the stop behind it
  std::int64_t clock_ps = 20000;
};

class LeadscrewSensor {
 public:
  explicit LeadscrewSensor(const LeadscrewConfig& c)
      : encoder_(c.encoder),
        radians_per_m_(2 * kPi / c.pitch),
        hysteresis_(c.switch_hysteresis * radians_per_m_),
        overtravel_(c.overtravel * radians_per_m_),
        low_at_(c.switch_low * radians_per_m_),
        high_at_(c.switch_high * radians_per_m_) {
    follow(0);
  }

  const SineEncoder& encoder() const { return encoder_; }
  bool at_low() const { return at_low_; }  // the switch is open
  bool at_high() const { return at_high_; }
  double radians_per_m() const { return radians_per_m_; }

  bool leaves(double theta) const {
    return encoder_.leaves(theta) || low(theta) != at_low_ || high(theta) != at_high_;
  }

  void follow(double theta) {
    encoder_.follow(theta);
    at_low_ = low(theta);
    at_high_ = high(theta);
  }

  DcMotorBounds bounds() const {
    DcMotorBounds b;
    if (at_low_) b.i_low = 0;
    if (at_high_) b.i_high = 0;
    b.theta_low = low_at_ - overtravel_;
    b.theta_high = high_at_ + overtravel_;
    return b;
  }

 private:
  bool low(double theta) const { return theta <= low_at_ + (at_low_ ? hysteresis_ : 0); }
  bool high(double theta) const { return theta >= high_at_ - (at_high_ ? hysteresis_ : 0); }

  SineEncoder encoder_;
  double radians_per_m_;
  double hysteresis_, overtravel_, low_at_, high_at_;  // [rad]
  bool at_low_ = false, at_high_ = false;
};

class LeadscrewAxis : public SensedMotor<LeadscrewSensor> {
 public:
  static constexpr unsigned kZeroCode = 0x80;  // of the converter; FFh is full clockwise

  explicit LeadscrewAxis(const LeadscrewConfig& c)
      : SensedMotor(c.motor, LeadscrewSensor(c), c.clock_ps) {}

  // Only an event of the axis or a new code advances the state.
  void drive(std::int64_t n, unsigned code) {
    if (code == code_ && n < next()) return;
    code_ = code;
    commit(n, (static_cast<double>(code) - kZeroCode) / kZeroCode);
  }

  // [m] from where the axis starts.
  double position(std::int64_t n) const { return state(n).theta / sensor().radians_per_m(); }

 private:
  unsigned code_ = kZeroCode;
};

}  // namespace trammel::plant
