// SPDX-License-Identifier: Apache-2.0

#include <Vpwm.h>

#include <catch2/catch.hpp>

#include "models/exact/drive/carrier.hpp"
#include "models/exact/drive/pwm.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::kGapMax;
using trammel::exact::cmp_max;
using trammel::exact::Pwm;
using trammel::exact::pwm_period;
using trammel::test::Random;
using Rtl = trammel::test::Rtl<Vpwm>;

namespace {

void apply(Rtl& rtl, const Pwm::In& in) {
  rtl->phase_i = in.phase & 0x1FFF;
  rtl->rest_i = (in.period - in.phase) & 0x1FFF;
  rtl->load_i = in.load;
  rtl->enable_i = in.enable;
  rtl->cmp_a_i = in.cmp[0] & 0xFFF;
  rtl->cmp_b_i = in.cmp[1] & 0xFFF;
  rtl->cmp_c_i = in.cmp[2] & 0xFFF;
  rtl.eval();
}

// The input at clock n of a run that starts at phase 0.
Pwm::In at(std::uint32_t n, const std::array<std::uint32_t, 3>& cmp, std::uint32_t carrier = 0) {
  const std::uint32_t period = pwm_period(carrier), phase = n % period;
  return {period, phase, phase == 0, true, cmp};
}

std::uint32_t any_cmp(Random& random, std::uint32_t top) {
  switch (random() % 4) {
    case 0: return random() % 3;
    case 1: return top - random() % 3;
    default: return random() % (top + 1);
  }
}

// Independent values, or three close to one another, so that it is close which comes first.
std::array<std::uint32_t, 3> any_cmps(Random& random, std::uint32_t top) {
  if (random() % 2 == 0) {
    return {any_cmp(random, top), any_cmp(random, top), any_cmp(random, top)};
  }
  const std::uint32_t base = random() % (top - 20);
  return {base + random() % 20, base + random() % 20, base + random() % 20};
}

}  // namespace

TEST_CASE("pwm agrees with its twin over many periods with new compare values at any time") {
  const std::uint32_t carrier = GENERATE(0U, 1U, 2U, 3U);
  CAPTURE(carrier);
  Rtl rtl;
  Pwm twin;
  rtl.reset();
  Random random(9 + carrier);
  std::array<std::uint32_t, 3> cmp{};
  bool enable = true;
  for (std::uint32_t n = 0; n < 40 * pwm_period(carrier); ++n) {
    if (random() % 1000 == 0) cmp = any_cmps(random, cmp_max(carrier));
    if (random() % 5000 == 0) enable = !enable;
    Pwm::In in = at(n, cmp, carrier);
    in.enable = enable;
    apply(rtl, in);
    if (random() % 5000 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(rtl->next_o == twin.next(in));
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    rtl.tick();
    REQUIRE(rtl->on_o == twin.step(in));
  }
}

TEST_CASE("pwm switches on one clock after phase CMP + 1 and off after phase period - CMP") {
  const std::uint32_t carrier = GENERATE(0U, 1U, 2U, 3U);
  constexpr std::uint32_t kPeriods[] = {3125, 6250, 2500, 1250};
  const std::uint32_t period = kPeriods[carrier], top = period / 2;
  CAPTURE(carrier);
  Rtl rtl;
  Random random(10);
  for (int i = 0; i < 30; ++i) {
    rtl.reset();
    const std::uint32_t cmp = i == 0 ? 0 : i == 1 ? top - 1 : i == 2 ? top / 2 : random() % top;
    unsigned before = 0;
    for (std::uint32_t n = 0; n <= period; ++n) {
      apply(rtl, at(n, {cmp, top, cmp}, carrier));
      rtl.tick();
      const unsigned on = rtl->on_o;
      if (on != before) REQUIRE(n == (on == 0 ? period - cmp : cmp + 1));
      REQUIRE((on == 0 || on == 5));
      before = on;
    }
  }
}

TEST_CASE("pwm on-time is period - 1 - 2 CMP clocks: off one clock at 0, never on at the top") {
  const std::uint32_t carrier = GENERATE(0U, 1U, 2U, 3U);
  const std::uint32_t period = pwm_period(carrier), top = period / 2;
  CAPTURE(carrier);
  Rtl rtl;
  for (const std::uint32_t cmp : {0U, 1U, 443U, top / 2, top - 100, top - 1, top}) {
    rtl.reset();
    std::uint32_t on = 0;
    for (std::uint32_t n = 0; n < 3 * period; ++n) {
      apply(rtl, at(n, {cmp, cmp, cmp}, carrier));
      rtl.tick();
      on += rtl->on_o == 7;
    }
    REQUIRE(on == (cmp == top ? 0 : 3 * (period - 1 - 2 * cmp)));
  }
}

TEST_CASE("pwm takes compare values at phase 0 only") {
  Rtl rtl;
  rtl.reset();
  for (std::uint32_t n = 0; n < 2 * 3125; ++n) {
    // The compare values change inside the first period and hold for the second.
    const std::uint32_t cmp = n < 100 ? 1000 : 200;
    apply(rtl, at(n, {cmp, cmp, cmp}));
    rtl.tick();
    const std::uint32_t used = n < 3125 ? 1000 : 200;
    REQUIRE((rtl->on_o == 7) == (Pwm::triangle(3125, n % 3125) > used));
  }
}

TEST_CASE("pwm disabled turns no switch on and announces no event") {
  Rtl rtl;
  rtl.reset();
  Pwm::In in = at(0, {0, 0, 0});
  apply(rtl, in);
  rtl.tick();
  in = at(700, {0, 0, 0});
  apply(rtl, in);
  rtl.tick();
  REQUIRE(rtl->on_o == 7);
  in.enable = false;
  apply(rtl, in);
  REQUIRE_FALSE(rtl->quiescent_o);
  rtl.tick();
  REQUIRE(rtl->on_o == 0);
  REQUIRE(rtl->next_o == kGapMax);
  REQUIRE(rtl->quiescent_o);
}

TEST_CASE("pwm evaluated only at its announced events has the same edges as evaluated plainly") {
  const std::uint32_t carrier = GENERATE(0U, 1U, 2U, 3U);
  const std::uint32_t period = pwm_period(carrier);
  CAPTURE(carrier);
  Rtl plain;
  Rtl leaping;
  plain.reset();
  leaping.reset();
  Random random(11);
  std::array<std::uint32_t, 3> cmp{};
  std::uint32_t n = 0;
  int evaluations = 0;
  while (n < 60 * period) {
    if (n % period == 0) cmp = any_cmps(random, period / 2);
    apply(leaping, at(n, cmp, carrier));
    Gap edges = leaping->quiescent_o ? leaping->next_o : 0;
    edges = std::min<Gap>(std::max<Gap>(edges, 1), period - n % period);
    leaping.tick();
    ++evaluations;
    for (Gap i = 0; i < edges; ++i) {
      apply(plain, at(n++, cmp, carrier));
      plain.tick();
      REQUIRE(plain->on_o == leaping->on_o);
    }
  }
  REQUIRE(evaluations < 60 * 17);  // load, six edges, and the leaps between them
}
