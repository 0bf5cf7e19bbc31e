// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/control/afc.sv: reference model, fuzzy position controller, speed P
// controller and tuning of the four fired rules (Kung et al. 2012); one step() is one 2 kHz sample.
// Specification sections 4 and 5.
//
// start() and run_to() are the same sample clock by clock: each input is read and each word appears
// at that clock, 1..70 after the start, at which it does in the RTL.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models/exact/control/rule_store.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Afc {
 public:
  struct Config {
    fixed::Gain kp{768, 0};
    fixed::Gain ki{839, -7};
    fixed::Gain kv{1884, 1};
    fixed::Gain eta{1140, -8};
    int shift_e = 0;            // 0: one unit of the universe is 256 counts; from -2
    int shift_de = 2;           // 2: one unit is 64 counts per sample
    std::int32_t a0 = 238008;   // a0 of the reference model, 18 bits unsigned
    int a0_scale = 0;           // its scale: 0 2^-32, 1 2^-28, 2 and 3 2^-23
    std::int32_t b2 = 8140683;  // b2 of the reference model, scale 2^-23, 24 bits signed
    bool adapt = true;
    bool feedforward = false;  // v* += dx (extension, specification section 15)
  };

  struct In {
    std::int32_t r = 0;    // command [counts]
    std::int32_t x_p = 0;  // position latched at the tick [counts]
  };

  struct Out {
    std::int32_t x_m = 0;             // model position, Q14 of a count
    std::int32_t x_r = 0;             // model position [counts]
    std::int32_t dx = 0;              // model increment, Q14 of a count per sample
    std::int32_t e = 0;               // [counts]
    std::int32_t de = 0;              // [counts per sample]
    std::int32_t u = 0;               // 1/256 unit
    std::int32_t v_star = 0;          // 1/16 count per sample
    std::int32_t v = 0;               // 1/16 count per sample
    std::int32_t i_q_ref = 0;         // I_fs / 4096
    bool saturated = false;           // i_q_ref was clipped
    int i = 0;                        // section of e, 0..5
    int j = 0;                        // section of de, 0..5
    std::array<std::int32_t, 4> d{};  // weights of rules (j,i) (j,i+1) (j+1,i) (j+1,i+1), Q11
  };

  // What a sample begins with, beside its rules.
  struct State {
    std::int32_t r_1 = 0, r_2 = 0;  // commands of the two samples before [counts]
    std::int32_t x_p_prev = 0, e_prev = 0;
    std::int32_t x_m = 0, dx = 0;   // as in Out
    std::int32_t integral = 0;      // 1/4096 of a v_star LSB
  };

  // Is given what multiplier and adder leave in a step of the RTL (specification section 6).
  struct NoSteps {
    void product(std::size_t, std::int64_t) const {}
    void result(std::size_t, std::int64_t) const {}
  };

  // Bits by which the product A0 s is shifted to the scale of dx.
  static constexpr int driven_shift(int a0_scale) {
    return a0_scale == 0 ? 24 : a0_scale == 1 ? 20 : 15;
  }

  // Bumpless start at rest at x_p; the rules are kept.
  void reset(std::int32_t x_p) {
    r_1_ = r_2_ = x_p_prev_ = x_p;
    out_.x_m = static_cast<std::int32_t>(fixed::wrap(fixed::shift_left(x_p, 14), 32));
    out_.dx = e_prev_ = integral_ = 0;
  }

  void load(const State& state) {
    r_1_ = state.r_1;
    r_2_ = state.r_2;
    x_p_prev_ = state.x_p_prev;
    e_prev_ = state.e_prev;
    out_.x_m = state.x_m;
    out_.dx = state.dx;
    integral_ = state.integral;
  }

  void reset_table() { rules_.reset(); }
  std::int32_t rule(int index) const { return rules_.read(index); }
  void set_rule(int index, std::int32_t value) { rules_.write(index, value); }

  template <class Steps = const NoSteps>
  const Out& step(const Config& config, const In& in, Steps&& steps = {}) {
    start(false);
    run_to(kClocks, config, in, steps);
    return out_;
  }

  static constexpr int kClocks = 70;         // of a sample
  static constexpr int kPublished = 60;      // i_q_ref and saturated
  static constexpr int kDone = kClocks + 1;  // no clocks of the sample left

  // resetting: the sample begins with a reset() to x_p.
  void start(bool resetting) {
    resetting_ = resetting;
    stage_ = 0;
  }

  // The next clock that does anything.
  int next_clock() const { return stage_ < kAt.size() ? kAt[stage_] : kDone; }

  // Executes the clocks up to `clock`, during which the inputs hold.
  template <class Steps = const NoSteps>
  void run_to(int clock, const Config& config, const In& in, Steps&& steps = {}) {
    while (stage_ < kAt.size() && kAt[stage_] <= clock) execute(kAt[stage_++], config, in, steps);
  }

  const Out& out() const { return out_; }
  std::int32_t r() const { return r_; }                // of the sample
  std::int32_t x_p() const { return x_p_; }            // of the sample
  std::int32_t integral() const { return integral_; }  // 1/4096 of a v_star LSB

 private:
  struct Membership {
    int section = 0;
    std::int64_t low = 0;   // of the knot below, Q11
    std::int64_t high = 0;  // of the knot above
  };

  static constexpr std::array<std::uint8_t, 30> kAt{1,  2,  7,  10, 12, 14, 16, 18, 20, 24,
                                                    46, 47, 48, 49, 50, 52, 54, 57, 58, 59,
                                                    60, 61, 62, 63, 64, 65, 66, 67, 68, 70};

  static std::int32_t word(std::int64_t x) { return static_cast<std::int32_t>(x); }

  static Membership fuzzify(std::int32_t error, int shift) {
    // In 1/1024 unit, as the memberships: a shift of -2 loses no bit.
    const std::int64_t from_lowest =
        fixed::clip(fixed::shift_left(error, std::max(shift, -2) + 2), -4 * 1536, 4 * 1535) +
        4 * 1536;
    const std::int64_t section = fixed::floor_shift(from_lowest, 11);  // Kung eq. 17
    const std::int64_t high = from_lowest - 2048 * section;  // Kung eq. 18
    return {static_cast<int>(section), 2048 - high, high};
  }

  template <class Steps>
  void execute(int clock, const Config& config, const In& in, Steps& steps) {
    if (clock <= 24) {
      follow(clock, config, in, steps);
    } else if (clock == 46) {
      infer(steps);
    } else if (clock <= 60) {
      drive(clock, config, steps);
    }
    if (clock > 60) tune(clock, config, steps);
  }

  // Reference model, errors and their weights.
  template <class Steps>
  void follow(int clock, const Config& config, const In& in, Steps& steps) {
    using fixed::rs;
    using fixed::sat;
    switch (clock) {
      case 1:
        if (resetting_) reset(in.x_p);
        sum_ = std::int64_t{resetting_ ? in.x_p : in.r} + r_2_;
        steps.product(0, std::int64_t{config.b2} * out_.dx);
        steps.result(0, sum_);
        term_ = rs(std::int64_t{config.b2} * out_.dx, 23);
        break;
      case 2:
        r_ = resetting_ ? in.x_p : in.r;
        x_p_ = in.x_p;
        break;
      case 7: {  // Kung eq. 24 in the incremental form (specification section 4)
        const std::int64_t commands = sum_ + 2 * std::int64_t{r_1_};
        const std::int64_t s =
            sat(fixed::shift_left(commands, 6) - fixed::floor_shift(out_.x_m, 6), 24);
        steps.result(1, commands);
        steps.result(2, s);
        steps.product(3, std::int64_t{config.a0} * s);
        steps.result(3, term_);
        term_ = sat(term_ + rs(std::int64_t{config.a0} * s, driven_shift(config.a0_scale)), 24);
        break;
      }
      case 10:
        out_.dx = word(term_);
        steps.result(4, out_.dx);
        break;
      case 12:
        out_.x_m = word(fixed::wrap(std::int64_t{out_.x_m} + out_.dx, 32));
        steps.result(5, out_.x_m);
        break;
      case 14:
        out_.x_r = word(rs(out_.x_m, 14));
        steps.result(6, out_.x_r);
        r_2_ = r_1_;
        r_1_ = r_;
        break;
      case 16:
        out_.v = resetting_ ? 0 : word(sat(16 * (std::int64_t{x_p_} - x_p_prev_), 12));
        steps.result(7, out_.v);
        break;
      case 18:
        out_.e = word(sat(std::int64_t{out_.x_r} - x_p_, 12));  // Kung eq. 15
        steps.result(8, out_.e);
        break;
      case 20:
        out_.de = word(sat(std::int64_t{out_.e} - e_prev_, 12));  // Kung eq. 16
        a_ = fuzzify(out_.e, config.shift_e);
        steps.result(9, out_.de);
        steps.result(10, a_.low);
        break;
      default: weigh(fuzzify(out_.de, config.shift_de), steps); break;
    }
  }

  // Kung eq. 20
  template <class Steps>
  void weigh(const Membership& b, Steps& steps) {
    out_.i = a_.section;
    out_.j = b.section;
    steps.result(11, b.high + 2048 * b.section - 4 * 1536);
    steps.result(12, b.low);
    const std::array<std::int64_t, 4> products{a_.low * b.low, a_.high * b.low, a_.low * b.high,
                                               a_.high * b.high};
    for (std::size_t n = 0; n < 4; ++n) {
      out_.d[n] = word(fixed::rs(products[n], 11));
      steps.product(14 + n, products[n]);
      steps.result(15 + n, out_.d[n]);
    }
  }

  template <class Steps>
  void infer(Steps& steps) {
    const std::array<int, 4> fired = RuleStore::fired(out_.i, out_.j);
    std::int64_t weighted = 0;
    for (std::size_t n = 0; n < 4; ++n) {
      const std::int64_t one = fixed::floor_shift(rules_.read(fired[n]), 12) * out_.d[n];
      weighted += one;
      steps.product(18 + n, one);
      if (n < 3) steps.result(19 + n, weighted + 1024);  // which rounds u
    }
    out_.u = word(fixed::sat(fixed::rs(weighted, 11), 12));
    steps.result(22, out_.u);
  }

  // A product with a gain takes two clocks: the first reads the mantissa and the three low bits of
  // the shift, the second the others. At exponent 0 `point` bits of it are dropped.
  void multiply(const fixed::Gain& gain, std::int64_t x, int point) {
    product_ = gain.mant * x;
    low_ = (point - gain.exp) & 7;
  }
  std::int64_t scaled(const fixed::Gain& gain, int point) const {
    return fixed::rs(product_, ((point - gain.exp) & ~7) | low_);
  }

  // v* and i_q*.
  template <class Steps>
  void drive(int clock, const Config& config, Steps& steps) {
    using fixed::sat;
    switch (clock) {
      case 47:
        sum_ = config.feedforward ? fixed::rs(out_.dx, 10) : 0;
        multiply(config.kp, out_.u, 11);
        steps.product(23, product_);
        steps.result(23, sum_);
        break;
      case 48:
        sum_ += scaled(config.kp, 11);
        steps.result(24, sum_);
        break;
      case 49:
        multiply(config.ki, out_.u, -1);
        steps.product(24, product_);
        break;
      case 50: term_ = scaled(config.ki, -1); break;
      case 52:
        integral_ = word(sat(integral_ + term_, 24));
        steps.result(25, integral_);
        break;
      case 54:
        out_.v_star = word(sat(sum_ + fixed::rs(integral_, 12), 12));
        steps.result(26, out_.v_star);
        break;
      case 57: {
        const std::int64_t behind = sat(out_.v_star - out_.v, 12);
        multiply(config.kv, behind, 11);
        steps.result(27, behind);
        steps.product(28, product_);
        break;
      }
      case 58: term_ = scaled(config.kv, 11); break;
      case 59:
        rate_ = std::int64_t{config.eta.mant} * out_.e;
        steps.product(29, rate_);
        steps.result(30, rate_);
        break;
      default:
        out_.i_q_ref = word(sat(term_, 12));
        steps.result(29, out_.i_q_ref);
        out_.saturated = term_ != out_.i_q_ref;
        break;
    }
  }

  // Kung eq. 27: rule n is multiplied at clocks 61 + 2 n and 62 + 2 n and written at 64 + 2 n.
  template <class Steps>
  void tune(int clock, const Config& config, Steps& steps) {
    const auto n = static_cast<std::size_t>(clock - 61) / 2;
    if (clock % 2 != 0) {
      multiply({1, config.eta.exp}, rate_ * out_.d[n], 10);
      steps.product(30 + n, product_);
      return;
    }
    if (n > 0) {
      const int rule = RuleStore::fired(out_.i, out_.j)[n - 1];
      if (config.adapt) rules_.write(rule, word(fixed::sat(rules_.read(rule) + term_, 24)));
      steps.result(30 + n, rules_.read(rule));
    }
    if (n < 4) term_ = scaled(config.eta, 10);
    if (clock != kClocks) return;
    e_prev_ = out_.e;
    x_p_prev_ = x_p_;
  }

  RuleStore rules_;
  Out out_;
  std::int32_t r_ = 0, x_p_ = 0;
  std::int32_t r_1_ = 0, r_2_ = 0;
  std::int32_t e_prev_ = 0, x_p_prev_ = 0;
  std::int32_t integral_ = 0;
  bool resetting_ = false;
  std::size_t stage_ = kAt.size();
  Membership a_;
  std::int64_t sum_ = 0, term_ = 0, product_ = 0;
  std::int64_t rate_ = 0;  // learning gain times e
  int low_ = 0;
};

}  // namespace trammel::exact
