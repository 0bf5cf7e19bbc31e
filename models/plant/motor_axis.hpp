// SPDX-License-Identifier: Apache-2.0
//
// A DC motor with an incremental encoder on its shaft, behind a converter and a linear amplifier:
// signatures of cosim::Plant (models/ may not see cosim/, which wraps it). The encoder's next edge
// is found ahead under the voltage that holds, with the same steps that a commit takes.
#pragma once

#include <cstdint>

#include "models/plant/dc_motor.hpp"
#include "models/plant/encoder.hpp"

namespace trammel::plant {

struct MotorAxisConfig {
  DcMotorConfig motor;
  int counts = 4000;        // a turn, after quadrupling
  double hysteresis = 0.2;  // [counts], full width
  std::int64_t clock_ps = 20000;
};

class MotorAxis {
 public:
  static constexpr double kTurn = 6.283185307179586;  // [rad]

  explicit MotorAxis(const MotorAxisConfig& c)
      : motor_(c.motor),
        period_(static_cast<double>(c.clock_ps) * 1e-12),
        counts_(c.counts),
        encoder_({kTurn / c.counts, c.hysteresis, 0}, 0) {
    predict();
  }

  std::int64_t count() const { return encoder_.count(); }
  bool a() const { return encoder_.a(); }
  bool b() const { return encoder_.b(); }
  bool index() const { return encoder_.count() % counts_ == 0; }
  double voltage() const { return volt_; }  // [V] at the motor

  std::int64_t next() const { return next_; }

  // `command`: 1 is full scale, from clock n on.
  void commit(std::int64_t n, double command) {
    state_ = state(n);
    since_ = n;
    encoder_.follow(state_.theta);
    volt_ = motor_.voltage(command);
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
  static constexpr std::int64_t kAhead = 100000;  // [clk], as far as an edge is looked for

  DcMotorState after(const DcMotorState& s, std::int64_t clocks) const {
    return clocks == 0 ? s : motor_.after(s, static_cast<double>(clocks) * period_, volt_);
  }

  // The first clock after `since_` at which the encoder leaves its count; where there is none
  // within kAhead, the axis is committed there and looks on.
  void predict() {
    DcMotorState s = state_;
    for (std::int64_t begin = 0; begin < kAhead; begin += kStep) {
      const DcMotorState end = after(s, kStep);
      if (encoder_.leaves(end.theta)) {
        std::int64_t low = 0, high = kStep;  // inside at low, outside at high
        while (high - low > 1) {
          const std::int64_t middle = (low + high) / 2;
          (encoder_.leaves(after(s, middle).theta) ? high : low) = middle;
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
  int counts_;
  Encoder encoder_;
  DcMotorState state_;
  double volt_ = 0;
  std::int64_t since_ = 0, next_ = 0;
};

}  // namespace trammel::plant
