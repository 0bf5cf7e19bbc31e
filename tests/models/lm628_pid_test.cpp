// SPDX-License-Identifier: Apache-2.0
//
// The filter of the LM628 with numbers computed by hand; the RTL is compared with this twin.

#include "models/exact/control/lm628_pid.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

using trammel::exact::Lm628Pid;

namespace {

Lm628Pid::Config gains(std::int64_t kp, std::int64_t ki, std::int64_t kd, std::int64_t il) {
  Lm628Pid::Config c;
  c.kp = kp;
  c.ki = ki;
  c.kd = kd;
  c.il = il;
  return c;
}

}  // namespace

TEST_CASE("lm628_pid saturates each product and the sum at 32 767, or wraps them at 16 bits") {
  Lm628Pid::Config c = gains(300, 0, 0, 0);
  CHECK(Lm628Pid().step(c, 110) == 32767);  // 33 000
  CHECK(Lm628Pid().step(c, -110) == -32767);
  c.wrap = true;
  CHECK(Lm628Pid().step(c, 110) == 33000 - 65536);
  CHECK(Lm628Pid().step(c, -110) == 65536 - 33000);
  CHECK(Lm628Pid().step(c, 300) == 90000 - 65536);

  c = gains(200, 0, 200, 0);  // 20 000 and 20 000
  CHECK(Lm628Pid().step(c, 100) == 32767);
  c.wrap = true;
  CHECK(Lm628Pid().step(c, 100) == 40000 - 65536);
}

TEST_CASE("lm628_pid saturates its products before it adds them") {
  Lm628Pid pid;
  Lm628Pid::Config c = gains(300, 0, 32767, 0);
  pid.step(c, 200);                        // 60 000 and 6 553 400: 65 534, so 32 767
  CHECK(pid.step(c, 199) == 32767 - 32767);  // 59 700 and -32 767: not 26 933
  c.wrap = true;
  CHECK(pid.step(c, 199) == 59700 - 65536);
}

TEST_CASE("lm628_pid limits the integral by its full product, and the sum to 24 bits") {
  Lm628Pid pid;
  const Lm628Pid::Config c = gains(0, 3, 0, 20000);
  CHECK(pid.step(c, 32767) == 3 * 127);  // 32 767 / 256, rounded down
  for (int n = 0; n < 1000; ++n) pid.step(c, 32767);
  CHECK(pid.sum() == 32767);             // (2^23 - 1) / 256
  CHECK(pid.step(c, 0) == 20000);        // of 98 301
  CHECK(pid.step(c, -32767) == 20000);
  for (int n = 0; n < 1000; ++n) pid.step(c, -32767);
  CHECK(pid.sum() == -32768);            // -(2^23 - 1) / 256, rounded down
  CHECK(pid.step(c, 0) == -20000);

  Lm628Pid wrapping;
  Lm628Pid::Config full = gains(0, 3, 0, 32767);
  full.wrap = true;
  for (int n = 0; n < 1000; ++n) wrapping.step(full, 32767);
  CHECK(wrapping.step(full, 0) == 32767);  // limited before it could wrap
}

TEST_CASE("lm628_pid forgets its sum where new coefficients have no integral") {
  Lm628Pid pid;
  pid.step(gains(0, 1, 0, 100), 2560);
  REQUIRE(pid.sum() == 10);
  pid.renew(gains(0, 1, 0, 100));
  CHECK(pid.sum() == 10);
  pid.renew(gains(1, 0, 0, 100));
  CHECK(pid.sum() == 0);
}
