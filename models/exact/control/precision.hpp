// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/control/precision.sv: the law of one axis (docs/precision.md, sections 3
// and 4). step() is one tick of 16 kHz; PrecisionKnots says which ticks are knots. Positions Q8 of
// a count, e1 Q12, e2 2^-20 count per tick, accelerations 2^-26 count per tick^2, currents Q8 of an
// i_q* LSB.
#pragma once

#include <cstdint>

#include "models/exact/control/precision_knots.hpp"
#include "models/exact/control/precision_store.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Precision {
 public:
  static constexpr std::int64_t kTickClocks = 3125;  // 50 MHz / 16 kHz
  static constexpr std::int64_t kClocks = 229;      // from the start to the new i_q*
  static constexpr std::int64_t kKnotClocks = 277;  // the same at a knot or in reset

  using Knot = PrecisionKnots::Knot;

  struct In {
    std::int32_t count = 0;  // 24 bits
    int ticks = 15;          // since the encoder's last edge, 15 = 15 or more
    std::int32_t age = 0;    // [clk] from that edge at the pin to the tick
    bool up = false;         // its way
    Knot knot = Knot::kNone;
    bool reset = false;
  };

  struct Out {
    std::int32_t i_q_ref = 0;  // 12 bits
    bool saturated = false;
    bool clipped = false;  // the error
  };

  struct State {
    std::int64_t c1 = 0, c2 = 0, c3 = 0;           // control points
    std::int64_t p = 0, v = 0, a = 0, j = 0;       // spline
    std::int64_t iacc = 0, istep = 0, iff = 0;     // ramp of the current, 1/32 of IFF
    std::int64_t e1 = 0, e2 = 0, d = 0;            // observer: error, its rate, disturbance
    std::int64_t u1 = 0, u2 = 0, um = 0;           // feedback: 1 and 2 ticks ago, with its lag
    fixed::Gain km, kmi, kb;                       // in effect
    std::int64_t fc = 0;
    std::int64_t y = 0, e = 0, acc = 0, vff = 0;   // of the last tick
    std::int64_t aff = 0, i8 = 0, used = 0;
    std::int64_t err_sum = 0, iq_sum = 0;          // since the last knot
    std::int64_t err_latched = 0, iq_latched = 0;  // at the last knot
    std::int64_t dist = 0, knots = 0;
  };

  // Reads the window; a knot with new words clears RATIO in it.
  Out step(const In& in, PrecisionStore& window, int axis) {
    using Word = PrecisionStore::Word;
    const auto word = [&](Word w) { return window.word(axis, w); };
    if (in.reset) {
      if (in.knot == Knot::kCommit) window.put(axis, Word::kRatio, 0);
      s_ = State();
      s_.c1 = s_.c2 = s_.c3 = 256 * std::int64_t{in.count};
      s_.p = fixed::shift_left(in.count, 23);
      return {};
    }
    const Misc misc(word(Word::kMisc));
    if (in.knot != Knot::kNone) take(in.knot, word);
    advance();
    const std::int64_t v24 = sat24(fixed::rs(s_.v, 9)), a24 = sat24(s_.a);
    s_.y = 256 * std::int64_t{in.count} + between(in, misc, v24);
    // (p - y) >> 15, which wraps like p
    s_.e = fixed::rs(fixed::sat(fixed::wrap(s_.p - fixed::shift_left(s_.y, 15), 48), 35), 15);
    Out out;
    out.clipped = s_.e != fixed::sat(s_.e, 20);
    s_.e = fixed::sat(s_.e, 20);
    s_.aff = sat24(8 * (a24 + misc.lead * fixed::sat(s_.j, 18)));
    s_.vff = sat24(v24 + fixed::rs(misc.lead * a24, 9));
    if (in.knot == Knot::kCommit) {
      const std::int64_t ratio = fixed::wrap(word(Word::kRatio), 16);
      s_.d = sat24(s_.d + fixed::rs(ratio * sat24(s_.aff + s_.d), 15));
      window.put(axis, Word::kRatio, 0);
    }
    correct(misc.rest && v24 == 0 && a24 == 0, word);
    s_.acc = sat24(mul(gain(word(Word::kK1)), s_.e1, -3) +
                   mul(gain(word(Word::kK2)), s_.e2, 5) + s_.d);
    drive(misc, out);
    predict();
    s_.err_sum += s_.e;
    s_.iq_sum += out.i_q_ref;
    return out;
  }

  const State& state() const { return s_; }
  State& state() { return s_; }

  // What the bus reads at the words above those that it writes.
  std::int32_t read(int word) const {
    switch (static_cast<PrecisionStore::Word>(word)) {
      case PrecisionStore::Word::kE1: return low(s_.e1);
      case PrecisionStore::Word::kE2: return low(s_.e2);
      case PrecisionStore::Word::kD: return low(s_.d);
      case PrecisionStore::Word::kAcc: return low(s_.acc);
      case PrecisionStore::Word::kVff: return low(s_.vff);
      case PrecisionStore::Word::kP: return low(s_.y + s_.e);  // p >> 15 unless e is clipped
      case PrecisionStore::Word::kY: return low(s_.y);
      case PrecisionStore::Word::kV24: return low(sat24(fixed::rs(s_.v, 9)));
      case PrecisionStore::Word::kErr: return low(s_.e);
      case PrecisionStore::Word::kErrSum: return low(s_.err_latched);
      case PrecisionStore::Word::kIqSum: return low(s_.iq_latched);
      case PrecisionStore::Word::kDist: return low(s_.dist);
      case PrecisionStore::Word::kKnots: return low(s_.knots);
      default: return 0;
    }
  }

  static constexpr fixed::Gain gain(std::int32_t word) {
    const std::int64_t exp = fixed::wrap(fixed::floor_shift(word, 16), 5);
    return {word & 0x7FF, static_cast<std::int32_t>(exp)};
  }

  // rs(mant x, shift - exp); a shift to the left counts modulo 16, which matters above exponent 12
  // of L3 and K1 only.
  static constexpr std::int64_t mul(const fixed::Gain& g, std::int64_t x, int shift) {
    const int right = shift - g.exp;
    return fixed::rs(g.mant * x, right < -15 ? right + 16 : right);
  }

 private:
  struct Misc {
    explicit Misc(std::int32_t word)
        : lead(word & 15),
          knee((word >> 4) & 15),
          sub_ticks((word >> 8) & 15),
          hysteresis((word >> 12) & 255),
          rest(((word >> 20) & 1) != 0) {}
    std::int64_t lead;
    int knee, sub_ticks;
    std::int64_t hysteresis;
    bool rest;
  };

  static constexpr std::int64_t sat24(std::int64_t x) { return fixed::sat(x, 24); }
  static constexpr std::int32_t low(std::int64_t x) {
    return static_cast<std::int32_t>(fixed::wrap(x, 32));
  }

  // Item 1: the control point, the ramp of the current and the words of the knot.
  template <class Word>
  void take(Knot knot, const Word& word) {
    using W = PrecisionStore::Word;
    const bool commit = knot == Knot::kCommit;
    // A factor takes 35 bits: points beyond, which coasting alone can reach, wrap there.
    const auto x = [](std::int64_t point) { return fixed::wrap(point, 35); };
    const std::int64_t c = commit                ? word(W::kC)
                           : knot == Knot::kCoast ? 2 * x(s_.c1) - x(s_.c2)
                                                  : s_.c1;
    s_.j = x(c) - 3 * x(s_.c1) + 3 * x(s_.c2) - x(s_.c3);
    s_.c3 = s_.c2;
    s_.c2 = s_.c1;
    s_.c1 = c;
    const std::int64_t iff = commit ? fixed::sat(word(W::kIff), 20) : s_.iff;
    s_.iacc = 32 * s_.iff;
    s_.istep = iff - s_.iff;
    s_.iff = iff;
    s_.err_latched = s_.err_sum;
    s_.iq_latched = s_.iq_sum;
    s_.err_sum = s_.iq_sum = 0;
    s_.dist = s_.d;
    ++s_.knots;
    if (!commit) return;
    s_.km = gain(word(W::kKm));
    s_.kmi = gain(word(W::kKmi));
    s_.kb = gain(word(W::kKb));
    s_.fc = word(W::kFc) < 0 ? 0 : word(W::kFc);
  }

  // Item 2.
  void advance() {
    s_.a = fixed::wrap(s_.a + s_.j, 48);
    s_.v = fixed::wrap(s_.v + s_.a, 48);
    s_.p = fixed::wrap(s_.p + s_.v, 48);
    s_.iacc += s_.istep;
  }

  // Item 3: how far from the count, by the time of the last edge.
  static std::int64_t between(const In& in, const Misc& misc, std::int64_t v24) {
    const bool fresh = in.ticks < misc.sub_ticks;
    if (!fresh || (in.up ? v24 <= 0 : v24 >= 0)) return 0;
    const std::int64_t t = fixed::rs(5369 * std::int64_t{in.age}, 12);  // 2^-12 tick
    const std::int64_t m = fixed::sat(fixed::rs(v24 * t, 18), 12);
    const std::int64_t inside = 128 - misc.hysteresis, most = 128 + misc.hysteresis;
    return fixed::clip((in.up ? -inside : inside) + m, -most, most);
  }

  // Items 7 and 8.
  template <class Word>
  void correct(bool rest, const Word& word) {
    using W = PrecisionStore::Word;
    const std::int64_t e = rest ? s_.e - fixed::clip(s_.e, -128, 128) : s_.e;
    const std::int64_t n = sat24(16 * e - s_.e1);
    s_.e1 = sat24(s_.e1 + mul(gain(word(W::kL1)), n, 11));
    s_.e2 = sat24(s_.e2 + mul(gain(word(W::kL2)), n, 3));
    s_.d = sat24(s_.d + mul(gain(word(W::kL3)), n, -3));
  }

  // Items 10 and 11.
  void drive(const Misc& misc, Out& out) {
    const std::int64_t friction =
        fixed::clip(sat24(fixed::shift_left(s_.vff, misc.knee)), -s_.fc, s_.fc);
    s_.i8 = sat24(mul(s_.km, sat24(s_.acc + s_.aff), 11) + mul(s_.kb, s_.vff, 11) + friction +
                  fixed::rs(s_.iacc, 5));
    const std::int64_t wanted = fixed::rs(s_.i8, 8);
    const std::int64_t i_q = fixed::sat(wanted, 12);
    out.i_q_ref = static_cast<std::int32_t>(i_q);
    out.saturated = i_q != wanted;
    s_.used = out.saturated ? sat24(s_.acc - mul(s_.kmi, s_.i8 - 256 * i_q, 11)) : s_.acc;
  }

  // Item 12.
  void predict() {
    s_.um += fixed::rs(s_.u2 - s_.um, 2);
    s_.u2 = s_.u1;
    s_.u1 = s_.used;
    s_.e2 = sat24(s_.e2 + fixed::rs(s_.d - s_.um, 6));
    s_.e1 = sat24(s_.e1 + fixed::rs(s_.e2, 8));
  }

  State s_;
};

}  // namespace trammel::exact
