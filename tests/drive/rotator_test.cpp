// SPDX-License-Identifier: Apache-2.0
#include <Vrotator.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "models/exact/drive/rotator.hpp"
#include "models/exact/drive/sine.hpp"
#include "models/ideal/clarke_park.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::Rotator;
using exact::Sine;

namespace {
constexpr int kLatency = 5;
constexpr double kPi = 3.14159265358979323846;
}  // namespace

TEST_CASE("rotator agrees with its twin on random and extreme vectors, in 5 clocks") {
  test::Rtl<Vrotator> rtl;  // the Park transform; the inverse is covered in current_loop
  test::begin(rtl);
  const Rotator twin;
  test::Words words(1);
  for (int n = 0; n < 20000; ++n) {
    const Rotator::In in{words(), words(), words(), words()};
    test::set_word(rtl->x_i, in.x);
    test::set_word(rtl->y_i, in.y);
    test::set_word(rtl->sin_i, in.sin);
    test::set_word(rtl->cos_i, in.cos);
    REQUIRE(test::run_flow(rtl) == kLatency);
    const Rotator::Out out = twin.step(in);
    CAPTURE(n, in.x, in.y, in.sin, in.cos);
    REQUIRE(test::word(rtl->x_o) == out.x);
    REQUIRE(test::word(rtl->y_o) == out.y);
  }
}

// Kung eq. 9, 10
TEST_CASE("rotator stays within two steps of the ideal rotation both ways") {
  const Rotator park({Rotator::Direction::kPark});
  const Rotator inverse({Rotator::Direction::kInverse});
  test::Words words(3);
  for (int n = 0; n < 20000; ++n) {
    const std::uint32_t angle = words.below(1024);
    const double theta = 2 * kPi * angle / 1024;
    const std::int32_t s = Sine::value(angle), c = Sine::value(angle + 256);
    const std::int32_t x = words() / 2, y = words() / 2;
    // half a step of rounding and half a step of each table value, the crest a whole one
    const ideal::DirectQuadrature dq = ideal::park({double(x), double(y)}, theta);
    const Rotator::Out forward = park.step({x, y, s, c});
    REQUIRE(std::abs(forward.x - dq.d) < 1.5);
    REQUIRE(std::abs(forward.y - dq.q) < 1.5);
    const ideal::AlphaBeta ab = ideal::inverse_park({double(x), double(y)}, theta);
    const Rotator::Out backward = inverse.step({x, y, s, c});
    REQUIRE(std::abs(backward.x - ab.alpha) < 1.5);
    REQUIRE(std::abs(backward.y - ab.beta) < 1.5);
  }
}

TEST_CASE("rotator by a quarter turn exchanges the axes") {
  const Rotator park({Rotator::Direction::kPark});
  const Rotator::Out out = park.step({500, 300, 2047, 0});
  REQUIRE(out.x == 300);
  REQUIRE(out.y == -500);
}

TEST_CASE("rotator has the flow shape: holds, ignores a second tick, is quiescent between") {
  test::Rtl<Vrotator> rtl;
  test::Words words(4);
  const auto drive = [&] {
    test::set_word(rtl->x_i, words());
    test::set_word(rtl->y_i, words());
    test::set_word(rtl->sin_i, words());
    test::set_word(rtl->cos_i, words());
  };
  test::require_flow_shape(rtl, kLatency, {0, 0}, drive, [&] {
    return std::vector<std::int64_t>{rtl->x_o, rtl->y_o};
  });
}
