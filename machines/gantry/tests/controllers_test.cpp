// SPDX-License-Identifier: Apache-2.0
//
// The controllers of the gantry track by their numbers: G-11, G-12, and what the thesis' listing
// and its corrections say of sums and their limits.
#include <catch2/catch.hpp>
#include <cstdint>

#include "sw_nios/apps/gantry/controllers.hpp"

using namespace trammel::sw;

TEST_CASE("G-11 the feed-forward of 0, 10000, 50000 and -170000 is 0, 141, 356 and -1002") {
  CHECK(feed_forward(0) == 0);
  CHECK(feed_forward(10000) == 141);
  CHECK(feed_forward(50000) == 356);
  CHECK(feed_forward(-170000) == -1002);
  CHECK(feed_forward(15000) == 168);
  CHECK(feed_forward(-15000) == -169);  // the shift goes down
  CHECK(feed_forward(-10000) == -142);
}

TEST_CASE("G-12 the motors share a force by error and force as the listing has it, symmetrically") {
  const Compensation c;
  const auto shared = [&](std::int32_t e, std::int32_t u, std::int32_t one, std::int32_t two) {
    const MotorForces f = c.share(e, u);
    CHECK(f.one == one);
    CHECK(f.two == two);
  };
  shared(100, 300, 300, 300);
  shared(16, 300, 300, 80);
  shared(0, 0, 112, -112);
  shared(-16, -300, -80, -300);
  shared(32, -300, -300, -304);
  shared(-32, -300, -272, -300);
  for (std::int32_t e = 1; e <= 40; ++e) {  // the mirror of e and u is that of the motors
    for (std::int32_t u = -1023; u <= 1023; u += 31) {
      // An arithmetic shift of s u + B is of the same number on both sides.
      const MotorForces right = c.share(e, u), left = c.share(-e, -u);
      CHECK(right.one == -left.two);
      CHECK(right.two == -left.one);
    }
  }
}

TEST_CASE("a force of P is lifted to the least one, limited to the most, and 0 stays 0") {
  PositionPi::Config c;
  PositionPi::State s;
  CHECK(PositionPi::step(c, s, 0, 9) == 0);
  CHECK(PositionPi::step(c, s, 1, 9) == 128);
  CHECK(PositionPi::step(c, s, -42, 9) == -128);
  CHECK(PositionPi::step(c, s, -43, 9) == -129);
  CHECK(PositionPi::step(c, s, 1000, 9) == 1023);
  c.most = 0x300;
  CHECK(PositionPi::step(c, s, -1000, 9) == -768);
  c.bang = true;
  CHECK(PositionPi::step(c, s, 1, 9) == 768);
}

TEST_CASE("a sum per tick adds the error that was held; per pass the present one, once") {
  PositionPi::Config c;
  c.sum = PositionPi::Sum::kPlain;
  c.gain = 0;
  c.time = 0;
  c.least = 0;
  PositionPi::State ticks;
  CHECK(PositionPi::step(c, ticks, 10, 9) == 0);
  CHECK(PositionPi::step(c, ticks, 7, 9) == 90);
  CHECK(PositionPi::step(c, ticks, 0, 10) == 160);
  c.per_tick = false;
  PositionPi::State passes;
  CHECK(PositionPi::step(c, passes, 10, 9) == 10);
  CHECK(PositionPi::step(c, passes, 7, 9) == 17);
}

TEST_CASE("a cancelled sum is gone at an error of 0 and where the error crosses it, before use") {
  PositionPi::Config c;
  c.sum = PositionPi::Sum::kCancel;
  c.per_tick = false;
  c.gain = 0;
  c.time = 0;
  c.least = 0;
  PositionPi::State s;
  CHECK(PositionPi::step(c, s, 10, 0) == 10);
  CHECK(PositionPi::step(c, s, 5, 0) == 15);
  CHECK(PositionPi::step(c, s, -1, 0) == 0);
  CHECK(PositionPi::step(c, s, -1, 0) == -1);
  CHECK(PositionPi::step(c, s, 0, 0) == 0);
  CHECK(PositionPi::step(c, s, -3, 0) == -3);
}

TEST_CASE("anti-windup holds the sum while P saturates, and else lets P + I end at the limit") {
  PositionPi::Config c;
  c.sum = PositionPi::Sum::kAntiWindup;
  c.per_tick = false;
  c.gain = 100;
  c.time = 2;
  c.least = 0;
  PositionPi::State s;
  CHECK(PositionPi::step(c, s, 11, 0) == 1023);  // P = 1100
  CHECK(s.sum == 0);
  s.sum = s.last_sum = 4000;                      // I = 1000
  CHECK(PositionPi::step(c, s, 10, 0) == 1023);
  CHECK(s.sum == (1023 - 1000) * 4);
  s.sum = s.last_sum = -4000;
  CHECK(PositionPi::step(c, s, -10, 0) == -1023);
  CHECK(s.sum == (-1023 + 1000) * 4);
}

TEST_CASE("an anti-windup's limit is within it, on either side and to the last unit") {
  for (const std::int32_t sign : {-1, 1}) {
    for (const std::int32_t beyond : {0, 1}) {
      CAPTURE(sign, beyond);
      PositionPi::Config c;  // TI = 10
      c.sum = PositionPi::Sum::kAntiWindup;
      c.per_tick = false;
      c.gain = 1;
      PositionPi::State s;
      s.sum = s.last_sum = sign * (7 << 10);
      PositionPi::step(c, s, sign * (1023 + beyond), 0);
      CHECK(s.sum == (beyond == 0 ? 0 : sign * (7 << 10)));
      VelocityPi::Config v;
      VelocityPi::State w;
      w.sum = w.last_sum = sign * 1000;
      VelocityPi::step(v, w, 0, sign * (592 + beyond) * 128);
      CHECK(w.sum == (beyond == 0 ? 0 : sign * 1000));  // 592 - P, or as it was
    }
  }
}

TEST_CASE("velocity: u is the feed-forward less both parts; its anti-windup stores 592 - P") {
  VelocityPi::Config c;
  VelocityPi::State s;
  CHECK(VelocityPi::step(c, s, 50000, 50000) == 356);
  CHECK(VelocityPi::step(c, s, 50000, 50000 + 12800) == 356 - 100);  // S = 12800: I = 0
  CHECK(s.sum == 12800);
  s.sum = s.last_sum = 600 << 14;
  CHECK(VelocityPi::step(c, s, 0, 1280) == -10);  // P = 10, I beyond: S = 582, I = 0
  CHECK(s.sum == 582);
  c.aw_shift = true;
  s.sum = s.last_sum = 600 << 14;
  CHECK(VelocityPi::step(c, s, 0, 1280) == -592);
  CHECK(s.sum == 582 << 14);
  CHECK(VelocityPi::step(c, s, 0, 593 << 7) == -1023);  // P beyond: S as it was
  CHECK(s.sum == 582 << 14);
}

// Brochier 2006, appendix C.1: the interrupt of the converter adds the error that the pass left.
TEST_CASE("velocity: a sum per tick adds the error that was held; per pass the present one, once") {
  VelocityPi::Config c;
  c.gain = 30;
  c.time = 0;
  VelocityPi::State passes;
  CHECK(VelocityPi::step(c, passes, 0, 10, 9) == -10);
  CHECK(VelocityPi::step(c, passes, 0, 7, 9) == -17);
  c.per_tick = true;
  VelocityPi::State ticks;
  CHECK(VelocityPi::step(c, ticks, 0, 10, 9) == 0);
  CHECK(VelocityPi::step(c, ticks, 0, 7, 9) == -90);
  CHECK(VelocityPi::step(c, ticks, 0, 0, 10) == -160);
}

TEST_CASE("velocity P: only the error's part, lifted to the least force where it is not 0") {
  VelocityPi::Config c;
  c.sum = c.feed_forward = false;
  c.least = 128;
  VelocityPi::State s;
  for (int k = 0; k < 1000; ++k) VelocityPi::step(c, s, 50000, 0);  // nothing grows
  CHECK(VelocityPi::step(c, s, 50000, 0) == 391);                   // 50000 / 128, up
  CHECK(VelocityPi::step(c, s, 50000, 50000) == 0);
  CHECK(VelocityPi::step(c, s, 1000, 0) == 128);
  CHECK(VelocityPi::step(c, s, 0, 1000) == -128);
  CHECK(VelocityPi::step(c, s, 0, 128 * 200) == -200);
  c.feed_forward = true;
  CHECK(VelocityPi::step(c, s, 50000, 50000) == 356);  // and nothing else
}

TEST_CASE("shifts of a velocity's error go down on either side of 0") {
  const VelocityPi::Config c;
  VelocityPi::State above, below;
  CHECK(VelocityPi::step(c, above, 0, 1) == 0);
  CHECK(VelocityPi::step(c, below, 0, -1) == 2);  // both parts are -1
}

TEST_CASE("the filter moves by 5000 at most from its last mean, and is the mean of four") {
  MeanFilter f;
  CHECK(f.step(100000) == 1250);
  CHECK(f.step(100000) == 2812);
  for (int k = 0; k < 400; ++k) f.step(100000);
  CHECK(f.mean() == 100000);
  CHECK(f.step(99998) == 99999);
}
