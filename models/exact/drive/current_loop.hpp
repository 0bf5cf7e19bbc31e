// SPDX-License-Identifier: Apache-2.0
//
// Vector control of the current of one axis (specification section 7).
// Twin of rtl/drive/current_loop.sv: step() is one sample; start() and run_to() are the same clock
// by clock: each input is read and each word appears at that clock, 0..67, at which it does in the
// RTL.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/drive/clarke.hpp"
#include "models/exact/drive/current_pi.hpp"
#include "models/exact/drive/rotator.hpp"
#include "models/exact/drive/sine.hpp"
#include "models/exact/drive/svpwm.hpp"
#include "models/exact/drive/vector_limit.hpp"

namespace trammel::exact {

class CurrentLoop {
 public:
  static constexpr std::uint32_t kAngleStep = 352047;  // of 12 200 counts a revolution

  struct In {
    bool clear = false;
    std::uint32_t carrier = 0;
    std::int32_t code_a = 2048, code_b = 2048;  // offset binary
    std::int32_t offset_a = 0, offset_b = 0;    // of the sensors
    std::int32_t count = 0;
    std::uint32_t angle_step = kAngleStep;  // of a count [2^-32 revolution]
    std::uint32_t theta_ofs = 0;
    std::int32_t i_q_ref = 0, i_d_ref = 0;
    fixed::Gain kp{}, ki{};
  };
  struct Out {
    std::int32_t cmp_a = 781, cmp_b = 781, cmp_c = 781;
    std::int32_t i_a = 0, i_b = 0, i_d = 0, i_q = 0, v_d = 0, v_q = 0;
    bool limited = false;
  };

  static constexpr int kClocks = 67;         // compare values are ready
  static constexpr int kDone = kClocks + 1;  // no clocks of the sample left

  CurrentLoop() : CurrentLoop(kCarrierClockHz) {}
  explicit CurrentLoop(std::uint32_t clock_hz) : clock_hz_(clock_hz), svpwm_(clock_hz) {
    out_.cmp_a = out_.cmp_b = out_.cmp_c = centre(0);
  }

  void reset() {
    pi_d_.reset();
    pi_q_.reset();
  }

  const Out& step(const In& in) {
    if (in.clear) clear(in.carrier);
    start();
    run_to(kClocks, in);
    return out_;
  }

  void start() {
    stage_ = 0;
    digits_ = 0;
    theta_ = 0;
  }

  // The next clock that does anything.
  int next_clock() const { return stage_ < kAt.size() ? kAt[stage_] : kDone; }

  // Executes the clocks up to `clock`, during which the inputs hold.
  void run_to(int clock, const In& in) {
    multiply(clock, in);
    while (stage_ < kAt.size() && kAt[stage_] <= clock) execute(kAt[stage_++], in);
  }

  // count * step by the Booth digits of the count, digit k at clock 19 - k, up to that of `clock`.
  void multiply(int clock, const In& in) {
    constexpr int kDigits = 19;
    if (digits_ == 0 && clock >= kDigits) {
      theta_ = theta(in.count, 0, in.angle_step);
      digits_ = kDigits;
    }
    for (; digits_ < std::min(clock, kDigits); ++digits_) {
      const auto bits = 2 * std::int64_t{in.count} >> 2 * (kDigits - 1 - digits_) & 7;
      constexpr std::array<std::int8_t, 8> kBooth{0, 1, 1, 2, -2, -1, -1, 0};
      const std::int32_t digit = kBooth[static_cast<std::size_t>(bits)];
      theta_ = 4 * theta_ + static_cast<std::uint32_t>(digit) * in.angle_step;
    }
  }

  // What each clock with in.clear also does; once is enough while it is high.
  void clear(std::uint32_t carrier) {
    reset();
    out_.cmp_a = out_.cmp_b = out_.cmp_c = centre(carrier);
  }

  const Out& out() const { return out_; }

  static std::int32_t current(std::int32_t code, std::int32_t offset) {
    return static_cast<std::int32_t>(fixed::sat(std::int64_t{code} - 2048 - offset, 12));
  }

  // Electrical angle, 2^32 = one revolution.
  static constexpr std::uint32_t theta(std::int32_t count, std::uint32_t offset,
                                       std::uint32_t step = kAngleStep) {
    return static_cast<std::uint32_t>(count) * step + offset;
  }

 private:
  // Compare value of 50 % duty.
  std::int32_t centre(std::uint32_t carrier) const {
    return static_cast<std::int32_t>(cmp_max(carrier, clock_hz_) / 2);
  }

  static constexpr std::array<std::uint8_t, 11> kAt{0,  21, 27, 29, 30, 31,
                                                    32, 33, 34, 36, kClocks};

  void execute(int clock, const In& in) {
    switch (clock) {
      case 0:
        out_.i_a = current(in.code_a, in.offset_a);
        out_.i_b = current(in.code_b, in.offset_b);
        break;
      case 21: angle_ = sine_.step({(theta_ + in.theta_ofs) >> 22}); break;
      case 27: {
        const Clarke::Out i = clarke_.step({out_.i_a, out_.i_b});
        i_dq_ = park_.step({i.i_alpha, i.i_beta, angle_.sin, angle_.cos});
        out_.i_d = i_dq_.x;
        break;
      }
      case 29: out_.i_q = i_dq_.y; break;
      case 36: {
        const VectorLimit::Out v = limit_.step({pi_d_.out().v, pi_q_.out().v});
        out_.v_d = v.v_d;
        out_.v_q = v.v_q;
        out_.limited = v.limited;
        break;
      }
      case kClocks: modulate(in); break;
      default:
        pi_d_.run(clock - 30, {in.clear, in.i_d_ref, out_.i_d, in.kp, in.ki});
        pi_q_.run(clock - 30, {in.clear, in.i_q_ref, out_.i_q, in.kp, in.ki});
        break;
    }
  }

  void modulate(const In& in) {
    const Rotator::Out v = inverse_.step({out_.v_d, out_.v_q, angle_.sin, angle_.cos});
    const Svpwm::Out cmp = svpwm_.step({v.x, v.y, in.carrier});
    out_.cmp_a = in.clear ? centre(in.carrier) : cmp.cmp_a;
    out_.cmp_b = in.clear ? centre(in.carrier) : cmp.cmp_b;
    out_.cmp_c = in.clear ? centre(in.carrier) : cmp.cmp_c;
  }

  std::uint32_t clock_hz_;
  Sine sine_;
  Clarke clarke_;
  Rotator park_{{Rotator::Direction::kPark}};
  CurrentPi pi_d_, pi_q_;
  VectorLimit limit_;
  Rotator inverse_{{Rotator::Direction::kInverse}};
  Svpwm svpwm_;
  Sine::Out angle_;
  Rotator::Out i_dq_;
  Out out_;
  std::size_t stage_ = kAt.size();
  int digits_ = 0;           // multiplied so far
  std::uint32_t theta_ = 0;  // by them
};

}  // namespace trammel::exact
