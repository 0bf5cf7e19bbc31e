// SPDX-License-Identifier: Apache-2.0
#include <Vcurrent_pi.h>

#include <catch2/catch.hpp>

#include "models/exact/drive/current_pi.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::CurrentPi;
using fixed::Gain;

namespace {

constexpr int kLatency = 5;
constexpr Gain kKp{1275, 2};   // specification section 7
constexpr Gain kKi{1478, -2};

void drive(test::Rtl<Vcurrent_pi>& rtl, const CurrentPi::In& in) {
  rtl->clear_i = in.clear;
  test::set_word(rtl->ref_i, in.ref);
  test::set_word(rtl->meas_i, in.meas);
  rtl->kp_i = test::gain_bits(in.kp);
  rtl->ki_i = test::gain_bits(in.ki);
}

}  // namespace

// Kung eq. 11 to 14
TEST_CASE("current_pi gives 1063, 1140, 1217, 1294 for a step of 427") {
  test::Rtl<Vcurrent_pi> rtl;
  test::begin(rtl);
  CurrentPi twin;
  const CurrentPi::In in{false, 427, 0, kKp, kKi};
  for (const int v : {1063, 1140, 1217, 1294}) {
    drive(rtl, in);
    REQUIRE(test::run_flow(rtl) == kLatency);
    REQUIRE(test::word(rtl->v_o) == v);
    REQUIRE(twin.step(in).v == v);
  }
}

TEST_CASE("current_pi agrees with its twin for every exponent and many errors, in 5 clocks") {
  test::Rtl<Vcurrent_pi> rtl;
  test::begin(rtl);
  CurrentPi twin;
  test::Words words(1);
  CurrentPi::In in;
  for (int n = 0; n < 40000; ++n) {
    if (n % 8 == 0) {
      const auto gain = [&] {
        return Gain{static_cast<std::int32_t>(words.below(8) ? words.below(2048) : 2047),
                    static_cast<std::int32_t>(words.below(32)) - 16};
      };
      in.kp = gain();
      in.ki = gain();
      in.clear = words.below(16) == 0;
    }
    in.ref = words.below(4) ? words() / 16 : words();  // small errors reach the small shifts
    in.meas = words.below(4) ? words() / 32 : words();
    drive(rtl, in);
    REQUIRE(test::run_flow(rtl) == kLatency);
    CAPTURE(n, in.ref, in.meas, in.kp.mant, in.kp.exp, in.ki.mant, in.ki.exp, in.clear);
    REQUIRE(test::word(rtl->v_o) == twin.step(in).v);
  }
}

TEST_CASE("current_pi integrator stops at the voltage range and returns at once") {
  CurrentPi twin;
  for (int k = 0; k < 1000; ++k) twin.step({false, 2047, 0, {0, 0}, kKi});
  REQUIRE(twin.state().integral == 2047 * 4096);
  REQUIRE(twin.step({false, -2048, 0, {0, 0}, kKi}).v == 2047);  // the error acts a sample later
  REQUIRE(twin.step({false, -2048, 0, {0, 0}, kKi}).v < 2047);
  for (int k = 0; k < 1000; ++k) twin.step({false, -2048, 0, {0, 0}, kKi});
  REQUIRE(twin.state().integral == -2048 * 4096);
}

TEST_CASE("current_pi is cleared within one clock and then quiescent") {
  test::Rtl<Vcurrent_pi> rtl;
  test::begin(rtl);
  drive(rtl, {false, 427, 0, kKp, kKi});
  for (int k = 0; k < 3; ++k) test::run_flow(rtl);
  rtl.tick();
  REQUIRE(rtl->quiescent_o);
  rtl->clear_i = 1;
  rtl.eval();
  REQUIRE_FALSE(rtl->quiescent_o);
  rtl.tick();
  REQUIRE(rtl->quiescent_o);
  REQUIRE(rtl->v_o == 0);
  rtl->clear_i = 0;
  test::run_flow(rtl);
  REQUIRE(test::word(rtl->v_o) == 1063);
}

TEST_CASE("current_pi has the flow shape: holds, ignores a second tick, is quiescent between") {
  test::Rtl<Vcurrent_pi> rtl;
  test::Words words(2);
  const auto gain = [&] {
    return Gain{static_cast<std::int32_t>(words.below(2048)),
                static_cast<std::int32_t>(words.below(32)) - 16};
  };
  const auto set = [&] { drive(rtl, {false, words() / 16, words() / 32, gain(), gain()}); };
  test::require_flow_shape(rtl, kLatency, {0}, set,
                           [&] { return std::vector<std::int64_t>{rtl->v_o}; });
}
