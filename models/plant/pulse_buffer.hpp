// SPDX-License-Identifier: Apache-2.0
//
// The pulse buffer between a stepper interface and its motor (Larson 1974, section III: Icon
// 601-TR). It keeps pulses and lets them go with a ramp that the motor can follow. The model is
// fitted to Larson's table of multiple step times:
//
//   from the first pulse into a buffer that stands, a dead time; then the phase grows with
//   r(t) = start + rise t, at most the rate of the pulses that come in, at most
//   sqrt(brake^2 + 2 rise q) for q pulses that wait; where it reaches 1 a pulse leaves.
//
// While nothing waits the phase holds; after a while of that the buffer stands. Times are in clocks
// of the chip; between its events the state is a closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

namespace trammel::plant {

struct PulseBufferConfig {
  bool fitted = true;        // false: pulses pass at once
  double dead_s = 0.4e-3;
  double start = 464;        // [pulse/s]
  double rise = 2760;        // [pulse/s^2]
  double brake = 1000;       // [pulse/s] that the motor may stop from
  double idle_s = 20e-3;     // without a pulse, until it stands
  int busy_above = 0;        // pulses that may wait when it is not busy
  std::int64_t clock_ps = 20000;
};

// From the first pulse into a buffer that stands until it stands again.
struct BufferMove {
  std::int64_t began = 0, entered = 0, left = 0;  // the first pulse and the last one, in and out
  int pulses = 0, gone = 0;                        // that came, that left
};

class PulseBuffer {
 public:
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

  explicit PulseBuffer(const PulseBufferConfig& c)
      : config_(c), clock_s_(1e-12 * static_cast<double>(c.clock_ps)) {}

  int waiting() const { return static_cast<int>(pulses_.size()); }
  bool busy() const { return waiting() > config_.busy_above; }

  // [pulse/s] with the sign of the next pulse, from the first that left on: what the motor is told.
  double rate() const {
    return pulses_.empty() || !moving_ ? 0 : pulses_.front() * std::min(rate_, incoming_);
  }

  const std::vector<BufferMove>& moves() const { return moves_; }

  // A pulse comes at clock n, its direction +1 or -1.
  void enter(std::int64_t n, int direction) {
    settle(n);
    if (last_ != kNever) incoming_ = 1 / (static_cast<double>(n - last_) * clock_s_);
    last_ = n;
    if (pulses_.empty() && standing_) {
      standing_ = moving_ = false;
      phase_ = 0;
      rate_ = config_.start;
      from_ = n + std::llround(config_.dead_s / clock_s_);
      moves_.push_back({n});
    }
    moves_.back().entered = n;
    ++moves_.back().pulses;
    pulses_.push_back(direction);
    idle_ = kNever;
    foresee();
  }

  // The clock of the next pulse that leaves, or at which it comes to stand.
  std::int64_t next() const { return std::min(leaves_, idle_); }

  // At clock n, of next(): the direction of a pulse that leaves, or 0.
  int pass(std::int64_t n) {
    if (n == idle_) {
      idle_ = kNever;
      standing_ = true;
      incoming_ = std::numeric_limits<double>::infinity();
      last_ = kNever;
      return 0;
    }
    if (n != leaves_) return 0;
    settle(n);
    const int direction = pulses_.front();
    pulses_.pop_front();
    phase_ = 0;
    moving_ = true;
    moves_.back().left = n;
    ++moves_.back().gone;
    if (pulses_.empty()) idle_ = n + std::llround(config_.idle_s / clock_s_);
    foresee();
    return direction;
  }

  // The pulse that came last is void; false: it has left.
  bool take_back(std::int64_t n) {
    if (pulses_.empty()) return false;
    settle(n);
    pulses_.pop_back();
    if (!pulses_.empty()) {
      foresee();
    } else if (moving_) {
      leaves_ = kNever;
      idle_ = n + std::llround(config_.idle_s / clock_s_);
    } else {
      flush();
    }
    return true;
  }

  // What waits is void.
  void flush() {
    pulses_.clear();
    standing_ = true;
    leaves_ = idle_ = last_ = kNever;
    incoming_ = std::numeric_limits<double>::infinity();
  }

 private:
  // How the rate goes on from `first`: it rises for `rising` seconds, or it is `steady`.
  struct Ramp {
    double first, rising, steady;
  };
  Ramp ramp() const {
    const double brake =
        std::sqrt(config_.brake * config_.brake + 2 * config_.rise * waiting());
    const double first = std::min(rate_, brake), most = std::min(incoming_, brake);
    if (first >= most) return {first, 0, most};
    return {first, (most - first) / config_.rise, most};
  }

  // Phase and rate at clock n; nothing entered or left since `from_`.
  void settle(std::int64_t n) {
    if (standing_ || n <= from_) return;
    const double t = static_cast<double>(n - from_) * clock_s_;
    from_ = n;
    if (pulses_.empty()) return;
    const Ramp r = ramp();
    const double rising = std::min(t, r.rising);
    phase_ += r.first * rising + config_.rise * rising * rising / 2 + r.steady * (t - rising);
    rate_ = r.first + config_.rise * rising;
  }

  // When the phase reaches 1.
  void foresee() {
    leaves_ = kNever;
    if (pulses_.empty()) return;
    const Ramp r = ramp();
    const double need = std::max(0.0, 1 - phase_);
    const double risen = r.first * r.rising + config_.rise * r.rising * r.rising / 2;
    double t = 0;
    if (need <= risen) {
      t = 2 * need / (r.first + std::sqrt(r.first * r.first + 2 * config_.rise * need));
    } else {
      t = r.rising + (need - risen) / r.steady;
    }
    leaves_ = from_ + std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(t / clock_s_)));
  }

  PulseBufferConfig config_;
  double clock_s_;
  std::deque<int> pulses_;  // directions
  std::vector<BufferMove> moves_;
  bool standing_ = true;
  double phase_ = 0;        // of the pulse to come, 0..1
  double rate_ = 0;         // [pulse/s]
  double incoming_ = std::numeric_limits<double>::infinity();  // rate of the pulses that come
  bool moving_ = false;     // a pulse has left since it stood
  std::int64_t from_ = 0;   // phase and rate are those of this clock
  std::int64_t last_ = kNever;  // a pulse came
  std::int64_t leaves_ = kNever, idle_ = kNever;
};

}  // namespace trammel::plant
