// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/math/timer.sv, and the shape that all timed twins share: step() is one clock edge,
// next() the number of edges that do nothing but count, advance(n) n of them at once.
#pragma once

#include <algorithm>
#include <cstdint>

namespace trammel::exact {

using Gap = std::uint32_t;             // [clk]
inline constexpr Gap kGapMax = 0xFFF;  // no event in sight

class Timer {
 public:
  struct In {
    bool load = false;
    std::uint32_t value = 0;
  };

  void reset() { count_ = 0; }

  std::uint32_t step(const In& in) {
    if (in.load) {
      count_ = in.value;
    } else if (count_ > 0) {
      --count_;
    }
    return count_;
  }

  Gap next(const In& in) const {
    if (in.load) return 0;
    return count_ == 0 ? kGapMax : std::min(count_ - 1, kGapMax - 1);
  }

  // n <= next(): no load among these edges.
  void advance(Gap n) { count_ -= std::min<std::uint32_t>(count_, n); }

  std::uint32_t count() const { return count_; }

 private:
  std::uint32_t count_ = 0;
};

}  // namespace trammel::exact
