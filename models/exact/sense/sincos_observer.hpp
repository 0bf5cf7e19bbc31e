// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/sense/sincos_observer.sv: what a code does is computed at once, when the
// RTL is done with it. Words of 16 bits wrap, shifts are arithmetic, as on the thesis' processor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

// Calibration data: words as in Brochier 2006, C.15.
struct Calibration {
  static constexpr std::size_t kWords = 62;  // and their checksum
  std::array<std::uint16_t, kWords + 1> words{};

  std::int32_t at(std::size_t k) const { return static_cast<std::int16_t>(words[k]); }
  std::int32_t origin(std::size_t encoder) const { return at(4 + encoder); }
  std::int32_t limit(std::size_t k) const { return at(6 + k); }
  std::int32_t ymid(std::size_t region) const { return at(10 + region); }
  std::int32_t poly(std::size_t region, std::size_t k) const { return at(14 + 4 * region + k); }
  bool invert() const { return (words[30] & 1) != 0; }
  std::int32_t dot_offset(std::size_t encoder) const { return at(31 + encoder); }
  std::int32_t dot_min(std::size_t encoder) const { return at(33 + encoder); }
  std::int32_t dot_max(std::size_t encoder) const { return at(35 + encoder); }
  std::int32_t phasemid(std::size_t region) const { return at(37 + region); }
  std::int32_t dot_poly(std::size_t region, std::size_t k) const { return at(41 + 5 * region + k); }
  std::int32_t exponent() const { return at(61); }
};

class SincosObserver {
 public:
  struct In {
    bool tick = false;
    bool restart = false, active = false, velocity = false, ask = false;
    bool sample = false;
    std::uint32_t channel = 0, code = 0;
  };
  struct Out {
    std::int32_t position = 0, velocity = 0;  // 2^-14 of a period; 2^-9 of that a tick
    std::uint16_t phase = 0;
    std::uint8_t region = 0;
    bool known = false;
  };

  static constexpr std::int32_t kPhases = 1 << 14;  // of a period

  void reset() { *this = SincosObserver(); }

  const Out& out() const { return out_; }
  bool busy() const { return left_ > 0; }

  // The channel that is asked for in the present clock.
  std::optional<std::uint32_t> asked(const In& in) const {
    if (left_ > 0) {
      if (work_ != Work::kAsk || left_ != 1) return std::nullopt;
      return 2 * encoder_of(region_);
    }
    if (!in.ask || in.sample || (out_.known && !dot_next_)) return std::nullopt;
    if (!out_.known) return seen_[0] ? 2 : 0;
    return 2 * encoder_of(region_) + 1;
  }

  void step(const In& in, const Calibration& calib) {
    if (in.restart) {
      reset();
      return;
    }
    const std::uint32_t since = since_;
    if (in.tick && since_ < kLong) ++since_;
    if (left_ == 0) {
      begin(in, calib);
    } else if (--left_ == 0) {
      end(in, calib, since);
    }
  }

  bool quiescent(const In& in) const {
    return left_ == 0 && !in.ask && !in.sample && !in.tick && !in.restart;
  }

  // The arithmetic alone.
  static std::int32_t word(std::int64_t value) { return static_cast<std::int16_t>(value); }
  static std::size_t region(std::int32_t phase, const Calibration& c) {
    if (phase < c.limit(2)) return phase > c.limit(1) ? 2 : phase > c.limit(0) ? 1 : 0;
    return phase < c.limit(3) ? 3 : 0;
  }
  static std::int32_t phase(std::uint32_t code, std::size_t region, const Calibration& c) {
    const std::int32_t x = word((static_cast<std::int32_t>(code) - 512) * 64 - c.ymid(region));
    std::int32_t p = c.poly(region, 0);
    for (std::size_t k = 1; k < 4; ++k) p = word((p * x >> 14) + c.poly(region, k));
    return p & (kPhases - 1);
  }

 private:
  enum class Work { kStart, kAsk, kEncoder, kDot };
  static constexpr std::uint32_t kLong = 31;  // ticks

  static std::uint32_t encoder_of(std::size_t region) { return region % 2 == 0 ? 1 : 0; }
  static std::int32_t short_way(std::int32_t phase) {
    return ((phase + kPhases / 2) & (kPhases - 1)) - kPhases / 2;
  }
  // 23 bits.
  static std::int32_t narrow(std::int64_t value) {
    const std::int64_t bits = value & 0x7FFFFF;
    return static_cast<std::int32_t>(bits >= 0x400000 ? bits - 0x800000 : bits);
  }

  void begin(const In& in, const Calibration& calib) {
    if (in.sample) {
      code_ = in.code;
      encoder_ = in.channel / 2 % 2;
      if (!in.active || in.channel > 3) return;
      const bool dot = in.channel % 2 == 1;
      if (!out_.known) {
        if (dot) return;
        start_code_[encoder_] = in.code;
        seen_[encoder_] = true;
        if (seen_[0] && seen_[1]) start(Work::kStart, 2);
      } else if (encoder_ == encoder_of(region_)) {
        start(dot ? Work::kDot : Work::kEncoder, dot ? dot_clocks(calib) : 6);
      }
      return;
    }
    if (!in.ask || !out_.known) return;
    if (dot_next_) {
      dot_next_ = false;
      return;
    }
    const std::int32_t p = out_.phase;
    region_ = region(p, calib);
    start(Work::kAsk, p < calib.limit(2) && p <= calib.limit(1) ? 4 : 3);
  }

  void start(Work work, int clocks) {
    work_ = work;
    left_ = clocks;
  }

  bool saturated(const Calibration& c) const {
    const std::int32_t code = static_cast<std::int32_t>(code_);
    return code < c.dot_min(encoder_) || code > c.dot_max(encoder_);
  }
  bool same() const { return used_ && out_.region == region_; }
  int dot_clocks(const Calibration& c) const { return !saturated(c) ? 11 : same() ? 4 : 2; }

  void end(const In& in, const Calibration& calib, std::uint32_t since) {
    switch (work_) {
      case Work::kStart: find_quarter(calib); break;
      case Work::kAsk: dot_next_ = in.velocity; break;
      case Work::kDot: derive(calib); break;
      case Work::kEncoder:
        follow(calib);
        ticks_ = since;
        since_ = in.tick ? 1 : 0;
        break;
    }
  }

  void find_quarter(const Calibration& c) {
    const std::int32_t a = word(static_cast<std::int32_t>(start_code_[0]) - c.origin(0));
    const std::int32_t b = word(static_cast<std::int32_t>(start_code_[1]) - c.origin(1));
    const std::int32_t size_a = word(a < 0 ? -a : a), size_b = word(b < 0 ? -b : b);
    const int quarter = size_a >= size_b ? (a > 0 ? 0 : 2) : b > 0 ? 1 : 3;
    out_.phase = static_cast<std::uint16_t>(quarter << 12);
    out_.known = true;
  }

  void follow(const Calibration& c) {
    last_phase_ = out_.phase;
    const std::int32_t found = phase(code_, region_, c);
    out_.phase = static_cast<std::uint16_t>(found);
    invert_ = c.invert();
    const std::int32_t target = invert_ ? -found : found;
    const auto position = static_cast<std::uint32_t>(out_.position);
    const std::int32_t way = short_way((target - out_.position) & (kPhases - 1));
    out_.position = static_cast<std::int32_t>(position + static_cast<std::uint32_t>(way));
    used_ = true;
    out_.region = static_cast<std::uint8_t>(region_);
  }

  void derive(const Calibration& c) {
    std::int64_t velocity = 0;
    if (saturated(c)) {
      if (same()) velocity = numeric() * 512 | 1;
    } else {
      const std::int32_t t = word(8 * (out_.phase - c.phasemid(region_)));
      std::int32_t p = c.dot_poly(region_, 0);
      for (std::size_t k = 1; k < 5; ++k) p = word((p * t >> 15) + c.dot_poly(region_, k));
      const std::int32_t d =
          word(32 * word(static_cast<std::int32_t>(code_) - c.dot_offset(encoder_)));
      velocity = shifted(word(p * d >> 15), static_cast<std::int8_t>(18 - c.exponent())) & ~1;
    }
    out_.velocity = narrow(invert_ ? -velocity : velocity);
  }

  // The difference of phase a tick.
  std::int64_t numeric() const {
    if (ticks_ < 1 || ticks_ > 16) return 0;
    const std::int64_t table = (2 * 32768 + ticks_) / (2 * ticks_);  // rounded half up
    return short_way(out_.phase - last_phase_) * table >> 15;
  }

  static std::int64_t shifted(std::int64_t value, int left) {
    if (left > 22) return 0;
    return left > 0 ? value * (std::int64_t{1} << left) : value >> (left < -15 ? 15 : -left);
  }

  Out out_;
  std::size_t region_ = 0;  // of the next sample
  std::array<bool, 2> seen_{};
  std::array<std::uint32_t, 2> start_code_{};
  bool dot_next_ = false, used_ = false, invert_ = false;
  std::uint32_t since_ = kLong, ticks_ = 0, code_ = 0;
  std::size_t encoder_ = 0;
  std::int32_t last_phase_ = 0;
  Work work_ = Work::kStart;
  int left_ = 0;  // [clk]
};

}  // namespace trammel::exact
