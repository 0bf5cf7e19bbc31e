// SPDX-License-Identifier: Apache-2.0
//
// Park and inverse Park transform. Twin of rtl/drive/rotator.sv.
#pragma once

#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Rotator {
 public:
  enum class Direction { kPark, kInverse };
  struct Config {
    Direction direction = Direction::kPark;
  };
  struct In {
    std::int32_t x = 0, y = 0, sin = 0, cos = 0;
  };
  struct Out {
    std::int32_t x = 0, y = 0;
  };

  Rotator() = default;
  explicit Rotator(const Config& config) : config_(config) {}

  void reset() {}

  Out step(const In& in) const {
    const std::int64_t x = in.x, y = in.y, c = in.cos;
    const std::int64_t s = config_.direction == Direction::kPark ? in.sin : -in.sin;
    return {word(x * c + y * s), word(y * c - x * s)};  // Kung eq. 9, 10
  }

 private:
  static std::int32_t word(std::int64_t sum) {
    return static_cast<std::int32_t>(fixed::sat(fixed::rs(sum, 11), 12));
  }

  Config config_;
};

}  // namespace trammel::exact
