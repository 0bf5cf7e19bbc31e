// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>

#include "parts/lm628/chip.hpp"

namespace trammel::test {

inline void require_same(const lm628::Words& a, const lm628::Words& b) {
  REQUIRE(a.position == b.position);
  REQUIRE(a.speed == b.speed);
  REQUIRE(a.actual == b.actual);
  REQUIRE(a.error == b.error);
  REQUIRE(a.proportional == b.proportional);
  REQUIRE(a.integral == b.integral);
  REQUIRE(a.derivative == b.derivative);
  REQUIRE(a.output == b.output);
  REQUIRE(static_cast<int>(a.status) == static_cast<int>(b.status));
}

}  // namespace trammel::test
