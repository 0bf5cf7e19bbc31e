// SPDX-License-Identifier: Apache-2.0
//
// Position loop of the LM628 (data sheet SNVS781C, "PID compensation filter"):
//   u = kp e + min(|ki S / 256|, il) sign + kd (e - e'), S the sum of e in 24 bits
// The derivative is taken every (n + 1) samples and held. The chip keeps 16 bits of every product
// and of the sum; what it does on overflow is not published: they saturate, or wrap on request.
#pragma once

#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Lm628Pid {
 public:
  struct Config {
    std::int64_t kp = 0, ki = 0, kd = 0, il = 0;  // 0..32767
    std::int64_t interval = 0;                    // n, 0..255 [samples]
    bool wrap = false;
  };

  void reset() { *this = Lm628Pid(); }

  // New coefficients: the next sample takes a derivative.
  void renew(const Config& c) {
    wait_ = 0;
    if (c.ki == 0) sum_ = 0;
  }

  std::int64_t step(const Config& c, std::int64_t e) {
    sum_ = fixed::clip(sum_ + e, -kSumLimit, kSumLimit);
    if (wait_ > 0) {
      --wait_;
    } else {
      derivative_ = word(c, c.kd * (e - last_e_));
      last_e_ = e;
      wait_ = c.interval;
    }
    return word(c, word(c, c.kp * e) + integral(c) + derivative_);
  }

  std::int64_t sum() const { return fixed::floor_shift(sum_, 8); }  // what RDSUM returns
  std::int64_t integral(const Config& c) const { return fixed::clip(c.ki * sum(), -c.il, c.il); }
  std::int64_t derivative() const { return derivative_; }  // the one that is held

 private:
  static constexpr std::int64_t kSumLimit = (1 << 23) - 1;

  static std::int64_t word(const Config& c, std::int64_t x) {
    return c.wrap ? fixed::wrap(x, 16) : fixed::clip(x, -32767, 32767);
  }

  std::int64_t sum_ = 0;  // 24 bits
  std::int64_t last_e_ = 0;
  std::int64_t derivative_ = 0;
  std::int64_t wait_ = 0;  // [samples] until the next derivative
};

}  // namespace trammel::exact
