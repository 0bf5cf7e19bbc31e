// SPDX-License-Identifier: Apache-2.0
#include <Vsine.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "models/exact/drive/sine.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::Sine;

namespace {
constexpr int kLatency = 4;
constexpr double kPi = 3.14159265358979323846;
}  // namespace

TEST_CASE("sine agrees with its twin at every angle, in 4 clocks") {
  test::Rtl<Vsine> rtl;
  test::begin(rtl);
  const Sine twin;
  for (std::uint32_t angle = 0; angle < 1024; ++angle) {
    rtl->angle_i = static_cast<std::uint16_t>(angle);
    REQUIRE(test::run_flow(rtl) == kLatency);
    const Sine::Out out = twin.step({angle});
    CAPTURE(angle);
    REQUIRE(test::word(rtl->sin_o) == out.sin);
    REQUIRE(test::word(rtl->cos_o) == out.cos);
  }
}

TEST_CASE("sine is round(2048 sin) clipped to 2047") {
  for (std::uint32_t angle = 0; angle < 1024; ++angle) {
    const long rounded = std::lround(2048 * std::sin(2 * kPi * angle / 1024));
    CAPTURE(angle);
    REQUIRE(Sine::value(angle) == std::min(rounded, 2047L));
  }
  REQUIRE(Sine::value(0) == 0);
  REQUIRE(Sine::value(128) == 1448);
  REQUIRE(Sine::value(256) == 2047);
  REQUIRE(Sine::value(768) == -2048);
}

TEST_CASE("sine has the flow shape: holds, ignores a second tick, is quiescent between") {
  test::Rtl<Vsine> rtl;
  test::Words words(5);
  const auto drive = [&] { rtl->angle_i = static_cast<std::uint16_t>(words.below(1024)); };
  test::require_flow_shape(rtl, kLatency, {0, 0}, drive, [&] {
    return std::vector<std::int64_t>{rtl->sin_o, rtl->cos_o};
  });
}
