// SPDX-License-Identifier: Apache-2.0
//
// An axis of Larson's table: pulse buffer, stepper, screw, and a limit switch at each end behind
// which a stop is. Positions in steps of 0.001 inch. Signatures of cosim::Plant, for one axis.
//
// The state advances at the axis' own events and at a change of its drive. Between them the motor
// is integrated in steps of at most 25 us; the next event is at most a span of 1 ms away, unless
// the motor rests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "models/plant/first_clock.hpp"
#include "models/plant/platform.hpp"
#include "models/plant/pulse_buffer.hpp"
#include "models/plant/step_input.hpp"
#include "models/plant/stepper_motor.hpp"

namespace trammel::plant {

struct StepperAxisConfig {
  StepperConfig motor;
  PulseBufferConfig buffer;
  StepInputConfig input;
  PlatformConfig platform;
  double start = 400;             // [step] where the table stands
  double switch_low = -10.5;      // [step] at which a switch opens again,
  double switch_high = 5997.5;
  double switch_hysteresis = 2;   // [step] and so far beyond it is closed
  double overtravel = 60;         // [step] from there to the stop
  std::int64_t clock_ps = 20000;
};

// Steps that were lost at once.
struct StepsLost {
  std::int64_t edge = 0;
  double at = 0;       // [step] of the rotor
  int steps = 0;       // that the rotor is behind by; negative: ahead
  bool at_stop = false;  // within a cycle of a stop, which throws the rotor back
};

// A limit switch that closed or opened.
struct SwitchMoved {
  std::int64_t edge = 0;
  double at = 0;  // [step] of the rotor
  bool high = false, closed = false;
};

// The largest magnitudes of an axis since its start, at every step of its integration.
struct StepperPeaks {
  double angle = 0;   // [step]
  double speed = 0;   // [step/s]
  double torque = 0;  // [N m]
  double power = 0;   // [W] at the shaft, positive
  int waiting = 0;    // pulses
};

class StepperAxis {
 public:
  static constexpr std::int64_t kNever = PulseBuffer::kNever;

  // [step] Where its stops are.
  static double low_stop(const StepperAxisConfig& c) {
    return c.switch_low - c.switch_hysteresis - c.overtravel;
  }
  static double high_stop(const StepperAxisConfig& c) {
    return c.switch_high + c.switch_hysteresis + c.overtravel;
  }

  explicit StepperAxis(const StepperAxisConfig& c)
      : config_(c),
        motor_(c.motor),
        buffer_(buffer_of(c)),
        input_(c.input, c.clock_ps),
        clock_s_(1e-12 * static_cast<double>(c.clock_ps)),
        span_(static_cast<std::int64_t>(1e9 / static_cast<double>(c.clock_ps))),
        step_(std::llround(c.start)) {
    state_.at = static_cast<double>(step_);
    low_ = closed_low(state_.at);
    high_ = closed_high(state_.at);
  }

  bool at_low() const { return low_; }    // the switch is closed
  bool at_high() const { return high_; }
  bool buffer_busy() const { return busy_; }  // pulses wait, as of its Config
  int waiting() const { return buffer_.waiting(); }
  double rate() const { return told(); }  // [step/s] of the translator
  std::int64_t translated() const { return step_; }  // steps of the translator
  const std::vector<StepsLost>& lost() const { return lost_; }
  const std::vector<SwitchMoved>& moved() const { return moved_; }  // its switches
  const std::vector<StepBreach>& breaches() const { return breaches_; }  // pulses without a step
  const std::vector<BufferMove>& moves() const { return buffer_.moves(); }
  int steps_lost() const { return slipped_; }  // in all, with their sign
  const StepperPeaks& peaks() const { return peaks_; }
  bool hit_stop() const { return hit_stop_; }

  // At a clock from the last commit to next().
  StepperMotor::State state(std::int64_t n) const {
    return n == aim_ ? aimed_ : integrated(n);
  }
  double platform(std::int64_t n) const {  // [step]
    return platform_place(config_.platform, state(n).at, side_);
  }
  double torque(std::int64_t n) const { return motor_.torque(state(n), step_, told()); }  // [N m]
  double power(std::int64_t n) const { return motor_.power(state(n), step_, told()); }    // [W]
  double current() const { return motor_.current(step_); }  // [A] of all phases
  // Its mean up to a clock from the last commit on. A sample now and then would see pulses of its
  // own rate always at the same phases.
  double mean_current(std::int64_t n) const {
    return n == 0 ? current() : charge(n) / static_cast<double>(n);
  }
  // [J] into the windings until n, from the last commit on: copper loss and work at the shaft. What
  // the translator itself takes from its supply is not known.
  double supplied(std::int64_t n) const { return copper(n) + state(n).work; }
  // Steps that the rotor is behind the translator, lost ones apart.
  double load_angle(std::int64_t n) const {
    return static_cast<double>(step_ - slipped_) - state(n).at;
  }

  std::int64_t next() const { return std::min(next_, buffer_.next()); }

  // Pins at clock n, of next() or earlier: a pulse is a rising edge of step.
  void drive(std::int64_t n, bool step, bool forward, bool flush) {
    const StepInput::Seen seen = input_.at(n, step, forward);
    const bool flushed = flush && !flushing_;
    flushing_ = flush;
    if (seen.breach.kind != StepBreach::Kind::kNone && !flush) breaches_.push_back(seen.breach);
    const bool own = n >= next();
    if (!own && seen.pulse == 0 && seen.taken == 0 && !flushed) return;
    pass(n);
    if (own) show(n);
    if (seen.taken != 0 && !flush) take_back(n, seen.taken);
    if (flushed) buffer_.flush();
    if (seen.pulse != 0 && !flush) take(n, seen.pulse);
    foresee();
  }

  // [share of its torque] from clock n on.
  void weaken(std::int64_t n, double share) {
    pass(n);
    StepperConfig weak = config_.motor;
    weak.torque_share *= share;
    weak.phase_A *= share;
    motor_ = StepperMotor(weak);
    resting_ = false;
    foresee();
  }

 private:
  static constexpr double kStep = 25e-6;  // [s]

  static PulseBufferConfig buffer_of(const StepperAxisConfig& c) {
    PulseBufferConfig b = c.buffer;
    b.clock_ps = c.clock_ps;
    return b;
  }

  bool closed_low(double at) const {
    return at <= config_.switch_low - (low_ ? 0 : config_.switch_hysteresis);
  }
  bool closed_high(double at) const {
    return at >= config_.switch_high + (high_ ? 0 : config_.switch_hysteresis);
  }
  bool leaves(double at) const { return closed_low(at) != low_ || closed_high(at) != high_; }

  double told() const {
    if (config_.buffer.fitted) return buffer_.rate();
    return bypass_until_ == kNever ? 0 : bypass_rate_;
  }

  // A pulse of the interface.
  void take(std::int64_t n, int direction) {
    if (config_.buffer.fitted) {
      buffer_.enter(n, direction);
      peaks_.waiting = std::max(peaks_.waiting, waiting());
      return;
    }
    // Without the buffer: the translator's rate is that of the pulses, until one is missing.
    const std::int64_t gap = bypass_last_ == kNever ? 0 : n - bypass_last_;
    bypass_last_ = n;
    if (gap > 0 && gap < 20 * span_) {
      bypass_rate_ = direction / (static_cast<double>(gap) * clock_s_);
      bypass_until_ = n + gap + gap / 2;
    }
    advance(direction);
  }

  // The last pulse was none: it waits in the buffer, or was made a step by now.
  void take_back(std::int64_t n, int direction) {
    if (config_.buffer.fitted && buffer_.take_back(n)) return;
    advance(-direction);
  }

  void advance(int direction) {
    step_ += direction;
    side_ = direction;
    resting_ = false;
  }

  // [A clk] from the start to clock n.
  double charge(std::int64_t n) const {
    return charge_ + current() * static_cast<double>(n - from_);
  }

  double copper(std::int64_t n) const {  // [J] from the start to clock n
    return copper_ + motor_.copper_loss(step_) * static_cast<double>(n - from_) * clock_s_;
  }

  void note(StepperPeaks& peaks, const StepperMotor::State& s) const {
    const double torque = motor_.torque(s, step_, told());
    peaks.angle = std::max(peaks.angle, std::fabs(static_cast<double>(step_ - slipped_) - s.at));
    peaks.speed = std::max(peaks.speed, std::fabs(s.speed));
    peaks.torque = std::max(peaks.torque, std::fabs(torque));
    peaks.power = std::max(peaks.power, motor_.power(torque, s));
  }

  void pass(std::int64_t n) {
    if (n == aim_) {
      state_ = aimed_;
      peaks_ = aimed_peaks_;
    } else {
      state_ = integrated(n, &peaks_);
    }
    charge_ = charge(n);
    copper_ = copper(n);
    from_ = n;
    stop_at_ends();
    count_losses(n);
    if (n == bypass_until_) {
      bypass_until_ = bypass_last_ = kNever;
      resting_ = false;
    }
    if (n == buffer_.next()) {
      const int direction = buffer_.pass(n);
      if (direction != 0) advance(direction);
    }
    if (!resting_ && told() == 0 && std::fabs(state_.speed) < kStill &&
        std::fabs(motor_.acceleration(state_, step_, 0)) < kStillForce) {
      resting_ = true;
      state_.speed = 0;
    }
  }

  // The lines as they now are; at events of the axis only, where they are looked at.
  void show(std::int64_t n) {
    const bool low = closed_low(state_.at), high = closed_high(state_.at);
    if (low != low_) moved_.push_back({n, state_.at, false, low});
    if (high != high_) moved_.push_back({n, state_.at, true, high});
    low_ = low;
    high_ = high;
    busy_ = busy_now();
  }
  bool busy_now() const { return config_.buffer.fitted && buffer_.busy(); }

  // The stop takes all speed.
  void stop_at_ends() {
    const double low = low_stop(config_), high = high_stop(config_);
    if (state_.at > low && state_.at < high) return;
    hit_stop_ = true;
    state_.speed = state_.at <= low ? std::fmax(0.0, state_.speed) : std::fmin(0.0, state_.speed);
    state_.at = std::fmax(low, std::fmin(high, state_.at));
  }

  void count_losses(std::int64_t n) {
    const double behind = static_cast<double>(step_) - state_.at;
    const int slipped =
        static_cast<int>(StepperMotor::kCycle * std::floor(behind / StepperMotor::kCycle + 0.5));
    if (slipped == slipped_) return;
    // As long as it slips back and forth at the edge nothing is lost for good: 0.5 step apart.
    const double beyond = std::fabs(behind - slipped_) - StepperMotor::kCycle / 2;
    if (beyond < 0.5) return;
    const bool at_stop = state_.at < low_stop(config_) + StepperMotor::kCycle ||
                         state_.at > high_stop(config_) - StepperMotor::kCycle;
    lost_.push_back({n, state_.at, slipped - slipped_, at_stop});
    slipped_ = slipped;
  }

  StepperMotor::State integrated(std::int64_t n, StepperPeaks* peaks = nullptr) const {
    StepperMotor::State s = state_;
    const double t = static_cast<double>(n - from_) * clock_s_;
    if (resting_ || t <= 0) return s;
    const int steps = std::max(1, static_cast<int>(std::ceil(t / kStep)));
    for (int k = 0; k < steps; ++k) {
      s = motor_.after(s, t / steps, step_, told());
      if (peaks != nullptr) note(*peaks, s);
    }
    return s;
  }

  // Up to where the state holds its course: a switch, a missing pulse, the end of the span.
  void foresee() {
    aim_ = kNever;
    next_ = kNever;
    if (leaves(state_.at) || busy_now() != busy_) {
      next_ = from_ + 1;
      return;
    }
    if (resting_) return;
    const std::int64_t end = std::min({from_ + span_, buffer_.next(), bypass_until_});
    note(peaks_, state_);  // a step that was made just now pulls at once
    StepperMotor::State s = state_;
    aimed_peaks_ = peaks_;
    const double whole = static_cast<double>(end - from_) * clock_s_;
    const int steps = std::max(1, static_cast<int>(std::ceil(whole / kStep)));
    for (int k = 0; k < steps; ++k) {
      const StepperMotor::State before = s;
      s = motor_.after(s, whole / steps, step_, told());
      note(aimed_peaks_, s);
      if (!leaves(s.at)) continue;
      const std::int64_t a = from_ + (end - from_) * k / steps;
      next_ = crossing(before, a, from_ + (end - from_) * (k + 1) / steps);
      return;
    }
    aim_ = next_ = end;
    aimed_ = s;
  }

  // The first clock after `a` at which a switch has changed, on a straight line through the step.
  std::int64_t crossing(const StepperMotor::State& before, std::int64_t a, std::int64_t b) const {
    const auto changed = [&](std::int64_t clock) {
      const double h = static_cast<double>(clock - a) * clock_s_;
      return leaves(motor_.after(before, h, step_, told()).at);
    };
    return std::max(first_clock(a, std::max(a + 1, b), changed), from_ + 1);
  }

  // A swing of 1e-4 step is rest.
  static constexpr double kStill = 0.05;     // [step/s]
  static constexpr double kStillForce = 30;  // [step/s^2]

  StepperAxisConfig config_;
  StepperMotor motor_;
  PulseBuffer buffer_;
  StepInput input_;
  double clock_s_;
  std::int64_t span_;                  // [clk]
  StepperMotor::State state_, aimed_;  // at from_; at aim_
  std::int64_t from_ = 0, aim_ = kNever, next_ = kNever;
  std::int64_t step_;                  // of the translator
  int side_ = 0;                       // its last step
  double charge_ = 0;                  // [A clk] up to from_
  double copper_ = 0;                  // [J] up to from_
  StepperPeaks peaks_, aimed_peaks_;   // up to from_; up to aim_
  bool resting_ = true;
  bool low_ = false, high_ = false, busy_ = false;  // as they are shown
  bool flushing_ = false;
  double bypass_rate_ = 0;
  std::int64_t bypass_last_ = kNever, bypass_until_ = kNever;
  int slipped_ = 0;
  bool hit_stop_ = false;
  std::vector<StepsLost> lost_;
  std::vector<SwitchMoved> moved_;
  std::vector<StepBreach> breaches_;
};

}  // namespace trammel::plant
