// SPDX-License-Identifier: Apache-2.0
#include <Vforce_pwm.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/exact/drive/force_pwm.hpp"
#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::ForcePwm;
using trammel::test::Random;

namespace {

constexpr int kPeriod = 6944;  // [clk]

struct Bench {
  trammel::test::Rtl<Vforce_pwm> rtl;
  ForcePwm twin;
  ForcePwm::In force{};

  Bench() {
    rtl->leap_i = 0;
    put();
    rtl.reset();
  }
  void put() {
    rtl->force_1_i = static_cast<std::uint16_t>(force[0] & 0x7FF);
    rtl->force_2_i = static_cast<std::uint16_t>(force[1] & 0x7FF);
    rtl.eval();
  }
  void compare() {
    const auto motors = twin.out();
    REQUIRE(rtl->pwm_o == (motors[0].pwm | motors[1].pwm << 1));
    REQUIRE(rtl->negative_o == (motors[0].negative | motors[1].negative << 1));
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent());
    if (twin.quiescent()) REQUIRE(rtl->next_o == twin.next());
  }
  void tick() {
    put();
    twin.step(force);
    rtl.tick();
    compare();
  }
};

}  // namespace

TEST_CASE("force_pwm is on for its share of a period, in one pulse at the middle of it") {
  Bench bench;
  for (const int force : {0, 1, 88, 300, -300, 512, 1022, 1023, -1023, -1024}) {
    bench.force = {force, -force == 1024 ? 1023 : -force};
    for (int k = 0; k < kPeriod + 1; ++k) bench.tick();  // the next period begins
    while (bench.rtl->quiescent_o) bench.tick();
    const int wanted = static_cast<int>(ForcePwm::on_clk(force));
    std::array<int, 2> on{}, edges{};
    double middle = 0;
    bool was = (bench.rtl->pwm_o & 1) != 0;
    Bench fresh;  // whose period begins with the second clock
    fresh.force = bench.force;
    fresh.tick();
    for (int k = 0; k < kPeriod; ++k) {
      fresh.tick();
      for (unsigned m = 0; m < 2; ++m) on[m] += fresh.rtl->pwm_o >> m & 1;
      const bool now = (fresh.rtl->pwm_o & 1) != 0;
      edges[0] += now != was;
      was = now;
      if (now) middle += k;
    }
    CHECK(on[0] == wanted);
    CHECK(on[1] == wanted);
    if (wanted > 0) CHECK(middle / wanted == Approx((kPeriod - 1) / 2.0).margin(0.01));
    CHECK(std::fabs(wanted - std::fmin(std::abs(force), 1023) * kPeriod / 1023.0) <= 1.5);
    CHECK((fresh.rtl->negative_o & 1) == (force < 0));
    CHECK(fresh.rtl->negative_o >> 1 == (force > 0));
  }
  CHECK(ForcePwm::on_clk(1023) == kPeriod);
  CHECK(ForcePwm::on_clk(0) == 0);
}

TEST_CASE("force_pwm takes force and direction at the begin of a period only") {
  Bench bench;
  bench.tick();
  bench.force = {700, -700};
  for (int k = 0; k < kPeriod / 2; ++k) bench.tick();
  const auto during = bench.rtl->pwm_o;
  CHECK(during == 0);  // of the forces of reset
  bench.force = {-100, 100};
  for (int k = 0; k < kPeriod; ++k) bench.tick();
  CHECK(bench.rtl->negative_o == 1);
  CHECK(bench.rtl->pwm_o == 3);
}

TEST_CASE("force_pwm: each motor alone, clock by clock as its twin") {
  Bench bench;
  for (const ForcePwm::In& force : {ForcePwm::In{1022, 0}, ForcePwm::In{0, 1022},
                                    ForcePwm::In{-650, 3}, ForcePwm::In{3, -650}}) {
    bench.force = force;
    for (int k = 0; k < 2 * kPeriod; ++k) bench.tick();
  }
}

TEST_CASE("force_pwm: 7200 Hz, from one pulse to the next") {
  Bench bench;
  bench.force = {512, 0};
  int last = 0, clock = 0;
  bool was = false;
  for (int pulses = 0; pulses < 4; ++clock) {
    bench.tick();
    const bool now = (bench.rtl->pwm_o & 1) != 0;
    if (now && !was) {
      if (pulses > 1) CHECK(clock - last == kPeriod);
      last = clock;
      ++pulses;
    }
    was = now;
  }
  CHECK(50e6 / kPeriod == Approx(7200).epsilon(1e-3));
}

TEST_CASE("force_pwm agrees with its twin, leaping and not") {
  Bench bench;
  Random random(11);
  for (int i = 0; i < 60'000; ++i) {
    if (random() % 64 == 0) {
      for (auto& force : bench.force) {
        force = random() % 8 == 0 ? static_cast<int>(random() % 3) * 1023 - 1023
                                  : static_cast<int>(random() % 2048) - 1024;
      }
    }
    bench.put();
    trammel::test::leap_or_step(bench.rtl, bench.twin,
                                bench.twin.quiescent() ? bench.twin.next() : 0, random, 2,
                                bench.force);
    bench.compare();
    if (random() % 5000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
  }
}
