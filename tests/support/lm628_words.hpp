// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>

#include "parts/lm628/chip.hpp"

namespace trammel::test {

inline void require_same(const lm628::Words& twin, const lm628::Words& chip) {
  REQUIRE(twin.position == chip.position);
  REQUIRE(twin.speed == chip.speed);
  REQUIRE(twin.actual == chip.actual);
  REQUIRE(twin.error == chip.error);
  REQUIRE(twin.proportional == chip.proportional);
  REQUIRE(twin.integral == chip.integral);
  REQUIRE(twin.derivative == chip.derivative);
  REQUIRE(twin.output == chip.output);
  REQUIRE(twin.status == chip.status);
}

}  // namespace trammel::test
