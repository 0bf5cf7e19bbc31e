// SPDX-License-Identifier: Apache-2.0
//
// McAfee's two LM628 behind one port, with the platform's timer, as the loop sees them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "cosim/cosim.hpp"
#include "cosim/mcafee/lines.hpp"

namespace trammel::mcafee {

// What a part holds when the results of a sample are published.
struct Words {
  std::int64_t position = 0;  // desired [2^-16 count]
  std::int32_t speed = 0;     // desired [2^-16 count/sample]
  std::int32_t actual = 0;    // [count]
  std::int32_t error = 0;     // 16 bits [count]
  std::int32_t output = 0;    // 16 bits
};

struct McafeeChip : cosim::Chip {
  virtual Words words(std::size_t axis) const = 0;
  virtual cosim::Clk evaluated() const = 0;
};

// The bit-exact twins of the parts.
std::unique_ptr<McafeeChip> make_twin_chip();

}  // namespace trammel::mcafee
