// SPDX-License-Identifier: Apache-2.0
//
// A DC motor whose shaft moves a sensor with lines, behind a converter and a linear amplifier. The
// first clock at which a line changes is predicted under the present voltage, with the same steps
// that a commit takes. A Sensor says whether its lines change at an angle (`leaves`), takes the
// angle (`follow`), and gives the limits of current and angle (`bounds`).
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/plant/dc_motor.hpp"

namespace trammel::plant {

template <class Sensor>
class SensedMotor {
 public:
  static constexpr double kTurn = 6.283185307179586;  // [rad]

  SensedMotor(const DcMotorConfig& motor, const Sensor& sensor, std::int64_t clock_ps)
      : motor_(motor), period_(static_cast<double>(clock_ps) * 1e-12), sensor_(sensor) {
    bounds_ = motor_.within(sensor_.bounds());
    predict();
  }

  const Sensor& sensor() const { return sensor_; }
  double voltage() const { return volt_; }  // [V] commanded from the amplifier

  std::int64_t next() const { return next_; }

  // `command` acts from clock n on; 1 is full scale.
  void commit(std::int64_t n, double command) {
    state_ = state(n);
    since_ = n;
    sensor_.follow(state_.theta);
    bounds_ = motor_.within(sensor_.bounds());
    if (open_) bounds_.i_low = bounds_.i_high = 0;
    command_ = command;
    state_.i = std::clamp(state_.i, bounds_.i_low, bounds_.i_high);
    volt_ = supply_ * motor_.voltage(command);
    predict();
  }

  // From clock n on: the winding carries no current; the amplifier has that share of its supply.
  void open(std::int64_t n, bool open) {
    open_ = open;
    commit(n, command_);
  }
  void supply(std::int64_t n, double share) {
    supply_ = share;
    commit(n, command_);
  }

  // From clock n on: the torque [N m] against positive motion.
  void load(std::int64_t n, double torque) {
    commit(n, command_);
    motor_.load(torque);
    predict();
  }

  DcMotorState state(std::int64_t n) const {
    DcMotorState s = state_;
    std::int64_t left = n - since_;
    for (; left > kStep; left -= kStep) s = after(s, kStep);
    return after(s, left);
  }

 private:
  static constexpr std::int64_t kStep = 800;      // [clk], one step of the motor's integration
  static constexpr std::int64_t kAhead = 100000;  // [clk], how far ahead an edge is searched for

  DcMotorState after(const DcMotorState& s, std::int64_t clocks) const {
    return clocks == 0 ? s
                       : motor_.after(s, static_cast<double>(clocks) * period_, volt_, bounds_);
  }

  // The first clock after `since_` at which a line changes; where there is none within kAhead, the
  // motor is committed there and the search goes on.
  void predict() {
    DcMotorState s = state_;
    for (std::int64_t begin = 0; begin < kAhead; begin += kStep) {
      const DcMotorState end = after(s, kStep);
      if (sensor_.leaves(end.theta)) {
        std::int64_t low = 0, high = kStep;  // inside at low, outside at high
        while (high - low > 1) {
          const std::int64_t middle = (low + high) / 2;
          (sensor_.leaves(after(s, middle).theta) ? high : low) = middle;
        }
        next_ = since_ + begin + high;
        return;
      }
      s = end;
    }
    next_ = since_ + kAhead;
  }

  DcMotor motor_;
  double period_;  // [s]
  Sensor sensor_;
  DcMotorBounds bounds_;
  DcMotorState state_;
  double volt_ = 0, command_ = 0;
  double supply_ = 1;  // share that is left
  bool open_ = false;
  std::int64_t since_ = 0, next_ = 0;
};

}  // namespace trammel::plant
