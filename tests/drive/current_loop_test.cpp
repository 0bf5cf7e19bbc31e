// SPDX-License-Identifier: Apache-2.0
#include <Vcurrent_loop.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "models/exact/drive/current_loop.hpp"
#include "models/ideal/clarke_park.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::CurrentLoop;
using fixed::Gain;

namespace {

constexpr int kLatency = 68;  // the specification allows 96
constexpr Gain kKp{1275, 2};
constexpr Gain kKi{1478, -2};

using Dut = test::Rtl<Vcurrent_loop>;

void drive(Dut& rtl, const CurrentLoop::In& in) {
  rtl->clear_i = in.clear;
  rtl->carrier_i = in.carrier & 3;
  rtl->code_a_i = static_cast<std::uint16_t>(in.code_a);
  rtl->code_b_i = static_cast<std::uint16_t>(in.code_b);
  test::set_word(rtl->offset_a_i, in.offset_a);
  test::set_word(rtl->offset_b_i, in.offset_b);
  rtl->count_i = test::as_bits(in.count, 24);
  rtl->angle_step_i = in.angle_step;
  rtl->theta_ofs_i = in.theta_ofs;
  test::set_word(rtl->i_q_ref_i, in.i_q_ref);
  test::set_word(rtl->i_d_ref_i, in.i_d_ref);
  rtl->kp_i = test::gain_bits(in.kp);
  rtl->ki_i = test::gain_bits(in.ki);
}

void check(Dut& rtl, const CurrentLoop::Out& out) {
  REQUIRE(rtl->cmp_a_o == static_cast<std::uint32_t>(out.cmp_a));
  REQUIRE(rtl->cmp_b_o == static_cast<std::uint32_t>(out.cmp_b));
  REQUIRE(rtl->cmp_c_o == static_cast<std::uint32_t>(out.cmp_c));
  REQUIRE(test::word(rtl->i_a_o) == out.i_a);
  REQUIRE(test::word(rtl->i_b_o) == out.i_b);
  REQUIRE(test::word(rtl->i_d_o) == out.i_d);
  REQUIRE(test::word(rtl->i_q_o) == out.i_q);
  REQUIRE(test::word(rtl->v_d_o) == out.v_d);
  REQUIRE(test::word(rtl->v_q_o) == out.v_q);
  REQUIRE((rtl->limited_o != 0) == out.limited);
}

}  // namespace

TEST_CASE("current_loop agrees with its twin on 20 000 samples, in 68 clocks") {
  Dut rtl;
  test::begin(rtl);
  CurrentLoop twin;
  test::Words words(1);
  CurrentLoop::In in;
  for (int n = 0; n < 20000; ++n) {
    if (n % 16 == 0) {
      in.kp = words.below(2) ? kKp : Gain{int(words.below(2048)), int(words.below(32)) - 16};
      in.ki = words.below(2) ? kKi : Gain{int(words.below(2048)), int(words.below(32)) - 16};
      in.theta_ofs = words.below(0xFFFFFFFF);
      in.angle_step = words.below(2) ? CurrentLoop::kAngleStep : words.below(0xFFFFFFFF);
      in.clear = words.below(8) == 0;
      in.carrier = words.below(4);
      in.offset_a = words.below(2) ? 0 : words();
      in.offset_b = words.below(2) ? 0 : words() / 16;
      in.i_q_ref = words();
      in.i_d_ref = words.below(2) ? 0 : words();
    }
    const int span = words.below(2) ? 1 : 8;
    in.code_a = 2048 + words() / span;
    in.code_b = 2048 + words() / span;
    in.count = static_cast<std::int32_t>(words.below(1u << 24)) - (1 << 23);
    drive(rtl, in);
    REQUIRE(test::run_flow(rtl) == kLatency);
    CAPTURE(in.offset_a, in.offset_b);
    CAPTURE(n, in.code_a, in.code_b, in.count, in.angle_step, in.theta_ofs, in.i_q_ref, in.clear,
            in.carrier);
    check(rtl, twin.step(in));
  }
}

TEST_CASE("current_loop: ends of the count and of the angle of a count, and one that changes") {
  Dut rtl;
  test::begin(rtl);
  CurrentLoop twin;
  CurrentLoop::In in;
  in.kp = kKp;
  in.ki = kKi;
  in.code_a = 2900;
  in.code_b = 1700;
  constexpr int kMost = (1 << 23) - 1;
  for (const int count : {0, 1, -1, 2, -2, 3, kMost, -kMost, -kMost - 1, 0x555555, 12200}) {
    for (const std::uint32_t step : {0u, 1u, 352047u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
      in.count = count;
      in.angle_step = step;
      drive(rtl, in);
      REQUIRE(test::run_flow(rtl) == kLatency);
      CAPTURE(count, step);
      check(rtl, twin.step(in));
    }
  }
  // Written while the angle is computed: digits before it are those of the old one.
  for (int change = 0; change <= 24; ++change) {
    in.count = -54321;
    in.angle_step = 352047;
    drive(rtl, in);
    rtl->tick_i = 1;
    rtl.tick();
    rtl->tick_i = 0;
    twin.start();
    for (int clock = 1; clock <= CurrentLoop::kClocks; ++clock) {
      if (clock == change) {
        twin.run_to(clock - 1, in);
        in.angle_step = 12345678;
        drive(rtl, in);
      }
      rtl.tick();
    }
    twin.run_to(CurrentLoop::kClocks, in);
    CAPTURE(change);
    check(rtl, twin.out());
  }
}

TEST_CASE("current_loop answers a step of 427 with v_q = 1063, 1140, 1217, 1294") {
  Dut rtl;
  test::begin(rtl);
  CurrentLoop::In in;
  in.i_q_ref = 427;
  in.kp = kKp;
  in.ki = kKi;
  drive(rtl, in);
  for (const int v : {1063, 1140, 1217, 1294}) {
    REQUIRE(test::run_flow(rtl) == kLatency);
    REQUIRE(test::word(rtl->v_q_o) == v);
    REQUIRE(test::word(rtl->v_d_o) == 0);
  }
}

TEST_CASE("current_loop completes an electrical period in 12 200 counts") {
  REQUIRE(CurrentLoop::theta(0, 5) == 5);
  REQUIRE(CurrentLoop::theta(12200, 0) == 6104);  // 12 200 * 352047 - 2^32: 1.4e-6 of a period
  REQUIRE(CurrentLoop::theta(-3050, 0) >> 22 == 767);
  REQUIRE(CurrentLoop::theta(3050, 0) >> 22 == 256);
}

TEST_CASE("current_loop measures the d and q currents of a rotating field") {
  constexpr double kPi = 3.14159265358979323846;
  Dut rtl;
  test::begin(rtl);
  CurrentLoop::In in;
  in.clear = true;
  for (std::int32_t count = -24400; count < 24400; count += 61) {
    const double theta = 2 * kPi * count / 12200;
    const ideal::Phases i = ideal::inverse_clarke(ideal::inverse_park({200, 700}, theta));
    in.code_a = 2048 + static_cast<std::int32_t>(std::lround(i.a));
    in.code_b = 2048 + static_cast<std::int32_t>(std::lround(i.b));
    in.count = count;
    drive(rtl, in);
    REQUIRE(test::run_flow(rtl) == kLatency);
    // rounding of the inputs, and up to one table step (0.35 degrees, 4.5 of 728) of the angle
    REQUIRE(test::word(rtl->i_d_o) == Approx(200).margin(7));
    REQUIRE(test::word(rtl->i_q_o) == Approx(700).margin(7));
    REQUIRE(rtl->cmp_a_o == 781);
  }
}

TEST_CASE("current_loop goes to 50 % one clock after clear, and is quiescent then") {
  Dut rtl;
  CurrentLoop::In in;
  drive(rtl, in);
  test::begin(rtl);
  REQUIRE(rtl->quiescent_o);
  in.i_q_ref = 427;
  in.kp = kKp;
  in.ki = kKi;
  drive(rtl, in);
  REQUIRE(test::run_flow(rtl) == kLatency);
  REQUIRE_FALSE(rtl->busy_o);
  REQUIRE_FALSE(rtl->quiescent_o);
  rtl.tick();
  REQUIRE(rtl->quiescent_o);
  REQUIRE(rtl->cmp_b_o != 781);  // at angle 0 phase a stays at 50 %
  rtl->clear_i = 1;
  rtl.eval();
  REQUIRE_FALSE(rtl->quiescent_o);
  rtl.tick();
  REQUIRE(rtl->quiescent_o);
  REQUIRE(rtl->cmp_a_o == 781);
  REQUIRE(rtl->cmp_b_o == 781);
  REQUIRE(rtl->cmp_c_o == 781);
}

TEST_CASE("current_loop takes the upper ten bits of the angle and turns exactly at their borders") {
  Dut rtl;
  test::begin(rtl);
  CurrentLoop twin;
  test::Words words(3);
  CurrentLoop::In in;
  in.clear = true;
  for (int n = 0; n < 3000; ++n) {
    in.code_a = 2048 + words();
    in.code_b = 2048 + words();
    in.count = static_cast<std::int32_t>(words.below(1u << 24)) - (1 << 23);
    const std::uint32_t border = words.below(1024) << 22;
    in.theta_ofs = border - words.below(2) - CurrentLoop::theta(in.count, 0);
    drive(rtl, in);
    REQUIRE(test::run_flow(rtl) == kLatency);
    CAPTURE(n, in.code_a, in.code_b, in.count, in.theta_ofs);
    check(rtl, twin.step(in));
  }
}

TEST_CASE("current_loop needs a second clear for values that it computes after the first") {
  Dut rtl;
  test::begin(rtl);
  test::Words words(5);
  int late = 0, c_alone_at_rest = 0;
  for (int n = 0; n < 2000; ++n) {
    CurrentLoop::In in;
    const bool small = n % 2 == 0;  // few counts around 50 %
    in.kp = small ? Gain{1024, 1} : kKp;
    in.i_q_ref = small ? words() / 256 : words();
    in.i_d_ref = small ? words() / 256 : words();
    in.theta_ofs = words.below(1024) << 22;
    drive(rtl, in);
    const int cleared_at = static_cast<int>(words.below(kLatency));
    rtl->tick_i = 1;
    for (int edge = 0; edge < kLatency; ++edge) {
      rtl->clear_i = edge == cleared_at;
      rtl.tick();
      rtl->tick_i = 0;
    }
    rtl->clear_i = 0;
    REQUIRE(rtl->valid_o);
    rtl.tick();
    REQUIRE(rtl->quiescent_o);
    const bool off_a = rtl->cmp_a_o != 781, off_b = rtl->cmp_b_o != 781,
               off_c = rtl->cmp_c_o != 781;
    late += (off_a || off_b || off_c) && cleared_at > 34;
    c_alone_at_rest += off_a && off_b && !off_c;
    rtl->clear_i = 1;
    rtl.eval();
    CAPTURE(n, cleared_at);
    if (off_a || off_b || off_c) REQUIRE_FALSE(rtl->quiescent_o);
    rtl.tick();
    REQUIRE(rtl->quiescent_o);
    REQUIRE(rtl->cmp_a_o == 781);
    REQUIRE(rtl->cmp_b_o == 781);
    REQUIRE(rtl->cmp_c_o == 781);
  }
  REQUIRE(late > 500);
  REQUIRE(c_alone_at_rest > 20);
}

TEST_CASE("current_loop has an error to clear, of d or of q, even without a voltage") {
  Dut rtl;
  test::begin(rtl);
  for (const bool of_d : {false, true}) {
    CurrentLoop::In in;  // both gains are 0
    (of_d ? in.i_d_ref : in.i_q_ref) = 5;
    drive(rtl, in);
    REQUIRE(test::run_flow(rtl) == kLatency);
    rtl.tick();
    REQUIRE(rtl->quiescent_o);
    REQUIRE(rtl->cmp_b_o == 781);
    rtl->clear_i = 1;
    rtl.eval();
    REQUIRE_FALSE(rtl->quiescent_o);
    rtl.tick();
    REQUIRE(rtl->quiescent_o);
  }
}

TEST_CASE("current_loop has the flow shape, and is busy from the tick to the result") {
  Dut rtl;
  test::Words words(2);
  const auto set = [&] {
    CurrentLoop::In in;
    in.code_a = 2048 + words();
    in.code_b = 2048 + words();
    in.count = words();
    in.theta_ofs = words.below(0xFFFFFFFF);
    in.i_q_ref = words();
    in.i_d_ref = words();
    in.kp = kKp;
    in.ki = kKi;
    drive(rtl, in);
  };
  test::require_flow_shape(rtl, kLatency, {781, 781, 781, 0, 0, 0, 0, 0, 0, 0}, set, [&] {
    REQUIRE_FALSE(rtl->busy_o);
    return std::vector<std::int64_t>{rtl->cmp_a_o, rtl->cmp_b_o, rtl->cmp_c_o, rtl->i_a_o,
                                     rtl->i_b_o,   rtl->i_d_o,   rtl->i_q_o,   rtl->v_d_o,
                                     rtl->v_q_o,   rtl->limited_o};
  });
  rtl->tick_i = 1;
  for (int edge = 0; edge < kLatency; ++edge) {
    rtl.tick();
    rtl->tick_i = 0;
    REQUIRE(bool(rtl->busy_o) == (edge < kLatency - 1));
  }
}
