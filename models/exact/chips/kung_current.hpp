// SPDX-License-Identifier: Apache-2.0
//
// Converter and current loop of one axis of kung_xy, edge by edge: advance(n) brings it to what it
// shows after edge n, with inputs that have held since the last edge it was brought to.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models/exact/chips/kung_time.hpp"
#include "models/exact/drive/current_loop.hpp"

namespace trammel::exact {

class KungCurrent {
 public:
  struct Config {
    std::uint32_t angle_step = CurrentLoop::kAngleStep;
    std::uint32_t theta_ofs = 0;
    fixed::Gain kp{}, ki{};
    std::int32_t offset_a = 0, offset_b = 0;  // of the sensors
    int zeros = 4;                            // leading zeros of a frame
  };

  // The code in a frame of 16 bits: 12 bits behind the leading zeros.
  static constexpr std::int32_t code_of(std::int32_t frame, int zeros) {
    return frame >> (4 - std::min(zeros, 4)) & 0xFFF;
  }

  // Edges after that of the tick.
  static constexpr Clk kCodes = 64;              // the frame has ended
  static constexpr Clk kTaken = 65;              // the loop takes the currents
  static constexpr Clk kLimited = 66 + CurrentLoop::kClocks;  // STATUS shows the limit

  // The tick of the carrier at edge n latches count, i_q* and the shape of a frame; the converters
  // hold `frames` then.
  void tick(Clk n, std::uint32_t carrier, std::int32_t count, std::int32_t i_q_ref,
            const std::array<std::int32_t, 2>& frames, const Config& config) {
    if (carrier != carrier_) {
      carrier_ = carrier;
      if (clear_) clear_at_ = n + 1;  // 50 % duty is another word
    }
    tick_ = n;
    count_ = count;
    i_q_ref_ = i_q_ref;
    held_ = {code_of(frames[0], config.zeros), code_of(frames[1], config.zeros)};
    framed_ = false;
    loop_.start();
    limit_due_ = true;
    schedule();
  }

  // From edge n on the integrators are held at 0, or no more.
  void clear(Clk n, bool level) {
    clear_ = level;
    clear_at_ = level ? n : kNever;
    schedule();
  }

  void advance(Clk n, const Config& config, Sticky& limited) {
    if (n < due_) return;
    if (!framed_ && n >= tick_ + kCodes) {
      codes_ = held_;
      framed_ = true;
    }
    const CurrentLoop::In in = input(config);
    if (clear_at_ <= n) {
      loop_.run_to(clock(clear_at_), in);
      loop_.clear(carrier_);
      clear_at_ = kNever;
    }
    loop_.run_to(clock(n), in);
    if (limit_due_ && n >= tick_ + kLimited) {
      if (loop_.out().limited) limited.set(tick_ + kLimited);
      limit_due_ = false;
    }
    schedule();
  }

  // ANGLE_STEP changes at edge n: up to it the multiplication has gone with the old one.
  void hold_angle(Clk n, const Config& config) {
    if (n >= tick_ + kTaken) loop_.multiply(clock(n), input(config));
  }

  // The edge at which advance() next has something to do.
  Clk due() const { return due_; }

  bool busy(Clk n) const {
    return n >= tick_ + kTaken && n < tick_ + kTaken + CurrentLoop::kClocks;
  }
  bool cleared() const { return clear_; }
  const CurrentLoop::Out& out() const { return loop_.out(); }
  const std::array<std::int32_t, 2>& codes() const { return codes_; }
  std::int32_t count() const { return count_; }
  std::int32_t i_q_ref() const { return i_q_ref_; }

  // Does a phase current reach `limit` [I_fs / 2048]? 0: never. The third is -(a + b).
  static bool reaches(std::int32_t a, std::int32_t b, std::int32_t limit) {
    const auto reached = [limit](std::int32_t i) { return i >= limit || i <= -limit; };
    return limit != 0 && (reached(a) || reached(b) || reached(a + b));
  }
  bool over(std::int32_t limit) const { return reaches(loop_.out().i_a, loop_.out().i_b, limit); }
  bool will_be_over(std::int32_t limit, const Config& config) const {
    return reaches(CurrentLoop::current(held_[0], config.offset_a),
                   CurrentLoop::current(held_[1], config.offset_b), limit);
  }

 private:
  CurrentLoop::In input(const Config& config) const {
    CurrentLoop::In in;
    in.clear = clear_;
    in.carrier = carrier_;
    in.code_a = held_[0];
    in.code_b = held_[1];
    in.offset_a = config.offset_a;
    in.offset_b = config.offset_b;
    in.count = count_;
    in.angle_step = config.angle_step;
    in.theta_ofs = config.theta_ofs;
    in.i_q_ref = i_q_ref_;
    in.kp = config.kp;
    in.ki = config.ki;
    return in;
  }

  void schedule() {
    due_ = clear_at_;
    if (!framed_) due_ = std::min(due_, tick_ + kCodes);
    if (loop_.next_clock() <= CurrentLoop::kClocks) {
      due_ = std::min(due_, tick_ + kTaken + loop_.next_clock());
    }
    if (limit_due_) due_ = std::min(due_, tick_ + kLimited);
  }

  int clock(Clk n) const {
    return static_cast<int>(std::min<Clk>(n - tick_ - kTaken, CurrentLoop::kClocks));
  }

  CurrentLoop loop_;
  Clk tick_ = -kLongAgo;
  std::uint32_t carrier_ = 0;
  std::int32_t count_ = 0, i_q_ref_ = 0;
  std::array<std::int32_t, 2> held_{2048, 2048}, codes_{};
  bool framed_ = true, limit_due_ = false;
  bool clear_ = true;
  Clk clear_at_ = kNever;
  Clk due_ = kNever;
};

}  // namespace trammel::exact
