// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <map>
#include <string>

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

// Words that have `first` and the numbers after it, in the order of the struct.
inline lm628::Words numbered_words(int first) {
  lm628::Words w;
  w.position = std::int64_t{first} << 16;
  w.speed = (first + 1) << 16;
  w.actual = first + 2;
  w.error = first + 3;
  w.proportional = first + 4;
  w.integral = first + 5;
  w.derivative = first + 6;
  w.output = first + 7;
  w.status = static_cast<std::uint8_t>(first + 8);
  return w;
}

// Their columns of trace.csv.
inline std::map<std::string, double> numbered_columns(const std::string& prefix, int first) {
  std::map<std::string, double> all;
  for (const char* name : {"desired_count", "desired_speed", "real_count", "e", "p", "i", "d",
                           "output", "status"}) {
    all[prefix + name] = first++;
  }
  return all;
}

}  // namespace trammel::test
