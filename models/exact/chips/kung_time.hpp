// SPDX-License-Identifier: Apache-2.0
//
// Shared by the parts of the chip's twin: edges, and bits that events set and software clears.
#pragma once

#include <cstdint>
#include <limits>

namespace trammel::exact {

using Clk = std::int64_t;  // index of a clock edge; the first after reset is 0
inline constexpr Clk kNever = std::numeric_limits<Clk>::max();
inline constexpr Clk kLongAgo = 1'000'000;  // [clk] more than any block works after a tick

// A register bit that an event sets and writing 1 clears; at the same edge the event wins.
class Sticky {
 public:
  void set(Clk edge) { set_ = edge; }
  void clear(Clk edge) { cleared_ = edge; }
  bool value() const { return set_ >= cleared_; }

 private:
  Clk set_ = -1, cleared_ = 0;
};

}  // namespace trammel::exact
