// SPDX-License-Identifier: Apache-2.0
#include <Vvector_limit.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "models/exact/drive/vector_limit.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::VectorLimit;

namespace {

constexpr int kLatency = 2;

void check(test::Rtl<Vvector_limit>& rtl, const VectorLimit::In& in) {
  test::set_word(rtl->v_d_i, in.v_d);
  test::set_word(rtl->v_q_i, in.v_q);
  REQUIRE(test::run_flow(rtl) == kLatency);
  const VectorLimit::Out out = VectorLimit().step(in);
  CAPTURE(in.v_d, in.v_q);
  REQUIRE(test::word(rtl->v_d_o) == out.v_d);
  REQUIRE(test::word(rtl->v_q_o) == out.v_q);
  REQUIRE((rtl->limited_o != 0) == out.limited);
}

}  // namespace

TEST_CASE("vector_limit agrees with its twin at every v_d and on random vectors, in 2 clocks") {
  test::Rtl<Vvector_limit> rtl;
  test::begin(rtl);
  test::Words words(1);
  for (std::int32_t v_d = -2048; v_d < 2048; ++v_d) {
    const std::int32_t limit = VectorLimit::limit(std::min(std::abs(v_d), 2047) >> 5);
    check(rtl, {v_d, 2047});
    check(rtl, {v_d, -2048});
    check(rtl, {v_d, limit});
    check(rtl, {v_d, std::max(-limit - 1, -2048)});
  }
  for (int n = 0; n < 20000; ++n) check(rtl, {words(), words()});
}

TEST_CASE("vector_limit uses L(n) = floor(sqrt(2047^2 - min(2047, 32 (n + 1))^2))") {
  for (std::int32_t n = 0; n < 64; ++n) {
    const double side = std::min(2047, 32 * (n + 1));
    REQUIRE(VectorLimit::limit(n) == std::floor(std::sqrt(2047.0 * 2047.0 - side * side)));
  }
  REQUIRE(VectorLimit::limit(0) == 2046);
  REQUIRE(VectorLimit::limit(63) == 0);
}

TEST_CASE("vector_limit keeps every vector inside the hexagon and short ones untouched") {
  const VectorLimit twin;
  test::Words words(2);
  for (int n = 0; n < 100000; ++n) {
    const VectorLimit::In in{words(), words()};
    const VectorLimit::Out out = twin.step(in);
    // the hexagon's inner radius is 2048
    REQUIRE(out.v_d * out.v_d + out.v_q * out.v_q <= 2047 * 2047);
    if (std::hypot(std::abs(in.v_d) + 32, std::abs(in.v_q) + 1) <= 2047) REQUIRE_FALSE(out.limited);
  }
}

TEST_CASE("vector_limit has the flow shape: holds, ignores a second tick, is quiescent between") {
  test::Rtl<Vvector_limit> rtl;
  test::Words words(3);
  const auto drive = [&] {
    test::set_word(rtl->v_d_i, words());
    test::set_word(rtl->v_q_i, words());
  };
  test::require_flow_shape(rtl, kLatency, {0, 0, 0}, drive, [&] {
    return std::vector<std::int64_t>{rtl->v_d_o, rtl->v_q_o, rtl->limited_o};
  });
}
