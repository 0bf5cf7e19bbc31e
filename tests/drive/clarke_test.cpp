// SPDX-License-Identifier: Apache-2.0
#include <Vclarke.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "models/exact/drive/clarke.hpp"
#include "models/ideal/clarke_park.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::Clarke;

namespace {
constexpr int kLatency = 2;
}

TEST_CASE("clarke agrees with its twin on random and extreme currents, in 2 clocks") {
  test::Rtl<Vclarke> rtl;
  test::begin(rtl);
  const Clarke twin;
  test::Words words(1);
  for (int n = 0; n < 20000; ++n) {
    const Clarke::In in{words(), words()};
    test::set_word(rtl->i_a_i, in.i_a);
    test::set_word(rtl->i_b_i, in.i_b);
    REQUIRE(test::run_flow(rtl) == kLatency);
    const Clarke::Out out = twin.step(in);
    CAPTURE(n, in.i_a, in.i_b);
    REQUIRE(test::word(rtl->i_alpha_o) == out.i_alpha);
    REQUIRE(test::word(rtl->i_beta_o) == out.i_beta);
  }
}

TEST_CASE("clarke saturates exactly where the word ends") {
  test::Rtl<Vclarke> rtl;
  test::begin(rtl);
  // 1182 (i_a + 2 i_b) / 2048 is 2047.5 at a sum of 3547.6 and -2048.5 at -3549.3
  for (std::int32_t sum = 3530; sum < 3570; ++sum) {
    for (const std::int32_t signed_sum : {sum, -sum}) {
      const Clarke::In in{signed_sum % 2, signed_sum / 2};
      test::set_word(rtl->i_a_i, in.i_a);
      test::set_word(rtl->i_b_i, in.i_b);
      REQUIRE(test::run_flow(rtl) == kLatency);
      CAPTURE(signed_sum);
      REQUIRE(test::word(rtl->i_beta_o) == Clarke().step(in).i_beta);
      REQUIRE((test::word(rtl->i_beta_o) == 2047) == (signed_sum > 3545));
      REQUIRE((test::word(rtl->i_beta_o) == -2048) == (signed_sum < -3547));
    }
  }
}

// Kung eq. 7
TEST_CASE("clarke stays within one step of the ideal transform inside the range of a word") {
  const Clarke twin;
  test::Words words(2);
  for (int n = 0; n < 20000; ++n) {
    const Clarke::In in{words(), words()};
    const ideal::AlphaBeta ideal = ideal::clarke(in.i_a, in.i_b);
    const Clarke::Out out = twin.step(in);
    REQUIRE(out.i_alpha == in.i_a);
    // half a step of rounding; 1182 for 2048 / sqrt 3 = 1182.41 is 0.72 at full scale
    REQUIRE(std::abs(out.i_beta - std::clamp(ideal.beta, -2048.0, 2047.0)) < 1.3);
  }
}

TEST_CASE("clarke turns a symmetric three-phase current into a circle of its amplitude") {
  const Clarke twin;
  for (int k = 0; k < 360; ++k) {
    const double angle = k * 3.14159265358979 / 180;
    const auto i_a = static_cast<std::int32_t>(std::lround(1000 * std::cos(angle)));
    const auto i_b =
        static_cast<std::int32_t>(std::lround(1000 * std::cos(angle - 2 * 3.14159265358979 / 3)));
    const Clarke::Out out = twin.step({i_a, i_b});
    REQUIRE(std::hypot(out.i_alpha, out.i_beta) == Approx(1000).margin(2));
  }
}

TEST_CASE("clarke has the flow shape: holds, ignores a second tick, is quiescent between") {
  test::Rtl<Vclarke> rtl;
  test::Words words(3);
  const auto drive = [&] {
    test::set_word(rtl->i_a_i, words());
    test::set_word(rtl->i_b_i, words());
  };
  test::require_flow_shape(rtl, kLatency, {0, 0}, drive, [&] {
    return std::vector<std::int64_t>{rtl->i_alpha_o, rtl->i_beta_o};
  });
}
