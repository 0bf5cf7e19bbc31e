// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/control/afc.sv: reference model, fuzzy position controller, speed P
// controller and tuning of the four fired rules (Kung et al. 2012); one step() is one 2 kHz sample.
// Specification sections 4 and 5.
#pragma once

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
    int shift_e = 0;            // 0: one unit of the universe is 256 counts
    int shift_de = 2;           // 2: one unit is 64 counts per sample
    std::int32_t a0 = 238008;   // a0 of the reference model, scale 2^-32, 18 bits unsigned
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
    std::int32_t i_q_ref = 0;         // 4.8 A / 2048
    bool saturated = false;           // i_q_ref was clipped
    int i = 0;                        // section of e, 0..5
    int j = 0;                        // section of de, 0..5
    std::array<std::int32_t, 4> d{};  // weights of rules (j,i) (j,i+1) (j+1,i) (j+1,i+1), Q11
  };

  // Bumpless start at rest in x_p; the rules stay.
  void reset(std::int32_t x_p) {
    r_1_ = r_2_ = x_p_prev_ = x_p;
    x_m_ = static_cast<std::int32_t>(fixed::wrap(fixed::shift_left(x_p, 14), 32));
    dx_ = e_prev_ = integral_ = 0;
  }

  void reset_table() { rules_.reset(); }
  std::int32_t rule(int index) const { return rules_.read(index); }
  void set_rule(int index, std::int32_t value) { rules_.write(index, value); }

  Out step(const Config& config, const In& in) {
    using fixed::rs;
    using fixed::sat;
    Out out;
    follow_model(config, in.r);
    out.x_m = x_m_;
    out.dx = dx_;
    out.x_r = word(rs(x_m_, 14));
    out.v = word(sat(16 * (std::int64_t{in.x_p} - x_p_prev_), 12));
    out.e = word(sat(std::int64_t{out.x_r} - in.x_p, 12));  // Kung eq. 15
    out.de = word(sat(std::int64_t{out.e} - e_prev_, 12));  // Kung eq. 16

    const Membership a = fuzzify(out.e, config.shift_e);
    const Membership b = fuzzify(out.de, config.shift_de);
    out.i = a.section;
    out.j = b.section;
    // Kung eq. 20
    out.d = {word(rs(a.low * b.low, 11)), word(rs(a.high * b.low, 11)),
             word(rs(a.low * b.high, 11)), word(rs(a.high * b.high, 11))};
    const std::array<int, 4> fired = RuleStore::fired(out.i, out.j);
    std::int64_t weighted = 0;
    for (std::size_t n = 0; n < 4; ++n) {
      weighted += fixed::floor_shift(rules_.read(fired[n]), 12) * out.d[n];
    }
    out.u = word(sat(rs(weighted, 11), 12));

    const std::int64_t ahead = config.feedforward ? rs(dx_, 10) : 0;
    integral_ = word(sat(integral_ + scaled(config.ki, out.u, -1), 24));
    out.v_star = word(sat(ahead + scaled(config.kp, out.u, 11) + rs(integral_, 12), 12));
    const std::int64_t i_q = scaled(config.kv, sat(out.v_star - out.v, 12), 11);
    out.i_q_ref = word(sat(i_q, 12));
    out.saturated = i_q != out.i_q_ref;

    if (config.adapt) {
      const std::int64_t t = std::int64_t{config.eta.mant} * out.e;
      for (std::size_t n = 0; n < 4; ++n) {
        // Kung eq. 27
        const std::int64_t change = rs(t * out.d[n], 10 - config.eta.exp);
        rules_.write(fired[n], word(sat(rules_.read(fired[n]) + change, 24)));
      }
    }
    e_prev_ = out.e;
    x_p_prev_ = in.x_p;
    return out;
  }

 private:
  struct Membership {
    int section = 0;
    std::int64_t low = 0;   // of the knot below, Q11
    std::int64_t high = 0;  // of the knot above
  };

  static std::int32_t word(std::int64_t x) { return static_cast<std::int32_t>(x); }

  // value of the gain times x, where the product of mantissa and x has `point` bits to drop
  static std::int64_t scaled(const fixed::Gain& gain, std::int64_t x, int point) {
    return fixed::rs(gain.mant * x, point - gain.exp);
  }

  static Membership fuzzify(std::int32_t error, int shift) {
    const std::int64_t from_lowest =
        fixed::clip(fixed::shift_left(error, shift), -1536, 1535) + 1536;
    const std::int64_t section = fixed::floor_shift(from_lowest, 9);  // Kung eq. 17
    // Kung eq. 18
    const std::int64_t high = 4 * (from_lowest - 512 * section);
    return {static_cast<int>(section), 2048 - high, high};
  }

  // Kung eq. 24 in the incremental form (specification section 4)
  void follow_model(const Config& config, std::int32_t r) {
    const std::int64_t commands = std::int64_t{r} + 2 * std::int64_t{r_1_} + r_2_;
    const std::int64_t s =
        fixed::sat(fixed::shift_left(commands, 6) - fixed::floor_shift(x_m_, 6), 24);
    dx_ = word(fixed::sat(
        fixed::rs(std::int64_t{config.b2} * dx_, 23) + fixed::rs(std::int64_t{config.a0} * s, 24),
        24));
    x_m_ = word(fixed::wrap(std::int64_t{x_m_} + dx_, 32));
    r_2_ = r_1_;
    r_1_ = r;
  }

  RuleStore rules_;
  std::int32_t r_1_ = 0, r_2_ = 0;
  std::int32_t x_m_ = 0, dx_ = 0;
  std::int32_t e_prev_ = 0, x_p_prev_ = 0;
  std::int32_t integral_ = 0;
};

}  // namespace trammel::exact
