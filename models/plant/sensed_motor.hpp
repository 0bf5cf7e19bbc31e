// SPDX-License-Identifier: Apache-2.0
//
// A DC motor whose shaft moves a sensor with lines, behind a converter and a linear amplifier. The
// first clock at which a line changes is predicted under the present voltage, with the same steps
// that a commit takes, and no further than a commit may be: next() is no later than that clock, and
// a commit there that changes nothing goes on with the search. A Sensor says whether its lines
// change at an angle (`leaves`), takes the angle (`follow`), and gives the limits of current and
// angle (`bounds`).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/plant/dc_motor.hpp"
#include "models/plant/first_clock.hpp"

namespace trammel::plant {

// Where the motor's current comes from. A linear amplifier takes it from its positive or negative
// supply, whatever its sign, and burns the rest of the voltage; a bridge lets it flow back.
enum class Amplifier { kLinear, kBridge };

template <class Sensor>
class SensedMotor {
 public:
  static constexpr double kTurn = 6.283185307179586;  // [rad]

  SensedMotor(const DcMotorConfig& motor, const Sensor& sensor, std::int64_t clock_ps,
              Amplifier amplifier = Amplifier::kLinear)
      : motor_(motor),
        period_(static_cast<double>(clock_ps) * 1e-12),
        sensor_(sensor),
        amplifier_(amplifier) {
    bounds_ = motor_.within(sensor_.bounds());
    rail_ = motor_.config().supply;
    begin();
  }

  const Sensor& sensor() const { return sensor_; }
  double voltage() const { return volt_; }  // [V] commanded from the amplifier

  std::int64_t next() const { return next_; }

  // `command` acts from clock n on; 1 is full scale.
  void commit(std::int64_t n, double command) {
    if (early_ && n >= next_) {
      while (early_ && n >= next_) predict();
      if (n < next_ && command == command_) return;
    }
    advance(n, command);
  }

  // From clock n on: the winding carries no current; the amplifier has that share of its supply.
  void open(std::int64_t n, bool open) {
    open_ = open;
    advance(n, command_);
  }
  void supply(std::int64_t n, double share) {
    supply_ = share;
    advance(n, command_);
  }

  // From clock n on: the torque [N m] against positive motion.
  void load(std::int64_t n, double torque) {
    advance(n, command_);
    motor_.load(torque);
    begin();
  }

  // [J] from the supply until n, from the last commit on; of a bridge less what flowed back.
  double supplied(std::int64_t n) const { return supplied_ + drawn(state(n)); }

  DcMotorState state(std::int64_t n) const {
    std::size_t k = 0;
    std::int64_t left = n - since_;
    for (; left > kStep && k + 1 < steps_.size(); left -= kStep) ++k;
    DcMotorState s = steps_[k];
    for (; left > kStep; left -= kStep) s = after(s, kStep);
    return after(s, left);
  }

 private:
  static constexpr std::int64_t kStep = 800;      // [clk], one step of the motor's integration
  static constexpr std::int64_t kLook = 12800;    // [clk], how far an edge is searched for at once
  static constexpr std::int64_t kAhead = 100000;  // [clk], after which the motor is committed

  void advance(std::int64_t n, double command) {
    const DcMotorState now = state(n);
    supplied_ += drawn(now);
    state_ = now;
    since_ = n;
    sensor_.follow(state_.theta);
    bounds_ = motor_.within(sensor_.bounds());
    if (open_) bounds_.i_low = bounds_.i_high = 0;
    command_ = command;
    state_.i = std::clamp(state_.i, bounds_.i_low, bounds_.i_high);
    volt_ = supply_ * motor_.voltage(command);
    rail_ = supply_ * motor_.config().supply;
    begin();
  }

  double drawn(const DcMotorState& now) const {  // [J] since the last commit
    return amplifier_ == Amplifier::kBridge ? volt_ * (now.charge - state_.charge)
                                            : rail_ * (now.magnitude - state_.magnitude);
  }

  void begin() {
    steps_.assign(1, state_);
    predict();
  }

  DcMotorState after(const DcMotorState& s, std::int64_t clocks) const {
    return clocks == 0 ? s
                       : motor_.after(s, static_cast<double>(clocks) * period_, volt_, bounds_);
  }

  // The first clock after `since_` at which a line changes, if it is within kLook from where the
  // search stands.
  void predict() {
    const auto at = [this] { return static_cast<std::int64_t>(steps_.size() - 1) * kStep; };
    early_ = false;
    for (const std::int64_t end = at() + kLook; at() < kAhead;) {
      if (at() >= end) {
        early_ = true;
        break;
      }
      const DcMotorState s = steps_.back();
      steps_.push_back(after(s, kStep));
      if (!sensor_.leaves(steps_.back().theta)) continue;
      next_ = since_ + at() - kStep + first_outside(s, steps_.back());
      return;
    }
    next_ = since_ + at();
  }

  // The first clock of a step from `s` to `e` at which a line has changed. The shaft moves almost
  // evenly for so short a time, so the search begins where the chord leaves.
  std::int64_t first_outside(const DcMotorState& s, const DcMotorState& e) const {
    const double a_clock = (e.theta - s.theta) / kStep;
    const auto on_chord = [&](std::int64_t clock) {
      return sensor_.leaves(s.theta + static_cast<double>(clock) * a_clock);
    };
    const auto outside = [&](std::int64_t clock) { return sensor_.leaves(after(s, clock).theta); };
    std::int64_t low = 0, high = kStep;  // inside at low, outside at high
    std::int64_t clock = first_clock(low, high, on_chord);
    for (std::int64_t reach = 1; low < clock && clock < high; reach *= 4) {
      const bool is_outside = outside(clock);
      (is_outside ? high : low) = clock;
      clock += is_outside ? -reach : reach;
    }
    return first_clock(low, high, outside);
  }

  DcMotor motor_;
  double period_;  // [s]
  Sensor sensor_;
  Amplifier amplifier_;
  DcMotorBounds bounds_;
  DcMotorState state_;
  double volt_ = 0, command_ = 0;
  double supply_ = 1;    // share that is left
  double rail_ = 0;      // [V] of the supply
  double supplied_ = 0;  // [J] up to the last commit
  bool open_ = false;
  std::int64_t since_ = 0, next_ = 0;
  bool early_ = false;  // the line changes at next_ or later
  std::vector<DcMotorState> steps_;  // since the last commit, as far as the search went
};

}  // namespace trammel::plant
