// SPDX-License-Identifier: Apache-2.0
#include <Vsvpwm.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "models/exact/drive/svpwm.hpp"
#include "models/ideal/svpwm.hpp"
#include "tests/drive/flow.hpp"

using namespace trammel;
using exact::Svpwm;

namespace {

constexpr int kLatency = 25;

Svpwm::Out run(test::Rtl<Vsvpwm>& rtl, const Svpwm::In& in) {
  test::set_word(rtl->v_alpha_i, in.v_alpha);
  test::set_word(rtl->v_beta_i, in.v_beta);
  rtl->carrier_i = in.carrier & 3;
  REQUIRE(test::run_flow(rtl) == kLatency);
  return {rtl->cmp_a_o, rtl->cmp_b_o, rtl->cmp_c_o, rtl->sector_o};
}

void check_equal(const Svpwm::Out& l, const Svpwm::Out& r) {
  REQUIRE(l.cmp_a == r.cmp_a);
  REQUIRE(l.cmp_b == r.cmp_b);
  REQUIRE(l.cmp_c == r.cmp_c);
  REQUIRE(l.sector == r.sector);
}

// The sector code with exact signs: sqrt 3 a > b is a comparison of squares.
int exact_sector(std::int64_t a, std::int64_t b) {
  const auto root3_exceeds = [](std::int64_t p, std::int64_t q) {  // sqrt 3 p > q
    if (p >= 0) return q < 0 || 3 * p * p > q * q;
    return q < 0 && 3 * p * p < q * q;
  };
  return (b > 0 ? 1 : 0) + (root3_exceeds(a, b) ? 2 : 0) + (root3_exceeds(-a, b) ? 4 : 0);
}

}  // namespace

TEST_CASE("svpwm gives the compare values of the specification") {
  struct Row {
    Svpwm::In in;
    Svpwm::Out out;
  };
  const Row rows[] = {
      {{1024, 0}, {443, 1119, 1119, 2}},    {{1024, 512}, {345, 826, 1217, 3}},
      {{-700, 300}, {1069, 493, 721, 5}},   {{-1024, -600}, {1234, 786, 328, 4}},
      {{500, -1500}, {451, 1353, 209, 6}},  {{1800, 1800}, {0, 419, 1562, 3}},
      {{0, 0}, {781, 781, 781, 0}},
  };
  test::Rtl<Vsvpwm> rtl;
  test::begin(rtl);
  for (const Row& row : rows) {
    CAPTURE(row.in.v_alpha, row.in.v_beta);
    const Svpwm::Out out = run(rtl, row.in);
    REQUIRE(out.cmp_a == row.out.cmp_a);
    REQUIRE(out.cmp_b == row.out.cmp_b);
    REQUIRE(out.cmp_c == row.out.cmp_c);
    REQUIRE(out.sector == row.out.sector);
  }
}

TEST_CASE("svpwm agrees with its twin on random and extreme vectors, in 25 clocks") {
  test::Rtl<Vsvpwm> rtl;
  test::begin(rtl);
  const Svpwm twin;
  test::Words words(1);
  for (int n = 0; n < 20000; ++n) {
    const Svpwm::In in{words(), words(), static_cast<unsigned>(n) % 4};
    CAPTURE(n, in.v_alpha, in.v_beta, in.carrier);
    check_equal(run(rtl, in), twin.step(in));
  }
}

// Kung eq. 8
TEST_CASE("svpwm stays within one count of the ideal, over-modulated or not") {
  const Svpwm twin;
  test::Words words(2);
  int over = 0;
  for (int n = 0; n < 400000; ++n) {
    const Svpwm::In in{words(), words(), static_cast<unsigned>(n) % 4};
    constexpr int kTops[] = {1562, 3125, 1250, 625};
    const int top = kTops[in.carrier];
    const ideal::AlphaBeta v{in.v_alpha / 2048.0, in.v_beta / 2048.0};
    const Svpwm::Out out = twin.step(in);
    const ideal::OffTimes off = ideal::svpwm(v);
    CAPTURE(in.v_alpha, in.v_beta, in.carrier);
    REQUIRE(std::abs(out.cmp_a - off.a * top) < 1.0);
    REQUIRE(std::abs(out.cmp_b - off.b * top) < 1.0);
    REQUIRE(std::abs(out.cmp_c - off.c * top) < 1.0);
    const double shortest = std::min({off.a, off.b, off.c});
    if (shortest < 1e-12) {
      ++over;
      continue;
    }
    const ideal::Phases duty = ideal::min_max_duty(v);
    REQUIRE(std::abs(1 - off.a - duty.a) < 1e-14);
    REQUIRE(std::abs(1 - off.b - duty.b) < 1e-14);
    REQUIRE(std::abs(1 - off.c - duty.c) < 1e-14);
    REQUIRE(std::abs(out.cmp_a - std::round((1 - duty.a) * top)) <= 1);
    REQUIRE(std::abs(out.cmp_b - std::round((1 - duty.b) * top)) <= 1);
    REQUIRE(std::abs(out.cmp_c - std::round((1 - duty.c) * top)) <= 1);
  }
  REQUIRE(over > 10000);
}

TEST_CASE("svpwm has half the period of the carrier as its top, whatever the clock") {
  test::Words words(4);
  for (const std::uint32_t clock_hz : {8'000'000u, 48'000'000u, 55'360'000u}) {
    const Svpwm twin(clock_hz);
    for (int n = 0; n < 20000; ++n) {
      const Svpwm::In in{words(), words(), static_cast<unsigned>(n) % 4};
      constexpr double kHz[] = {16e3, 8e3, 20e3, 40e3};
      const double top = std::floor(clock_hz / kHz[in.carrier] / 2);
      const ideal::OffTimes off = ideal::svpwm({in.v_alpha / 2048.0, in.v_beta / 2048.0});
      const Svpwm::Out out = twin.step(in);
      CAPTURE(clock_hz, in.v_alpha, in.v_beta, in.carrier);
      REQUIRE(std::abs(out.cmp_a - off.a * top) < 1.0);
      REQUIRE(std::abs(out.cmp_b - off.b * top) < 1.0);
      REQUIRE(std::abs(out.cmp_c - off.c * top) < 1.0);
    }
  }
}

TEST_CASE("svpwm refuses a clock that cannot make its carriers") {
  for (const std::uint32_t clock_hz : {0u, 7'920'000u, 25'000'000u, 55'440'000u}) {
    REQUIRE_THROWS_WITH(Svpwm(clock_hz), "carrier: clock of " + std::to_string(clock_hz) +
                                             " Hz: must be a multiple of 80000 from 8000000 to "
                                             "55360000");
  }
}

TEST_CASE("svpwm errs in the sector only within a tenth of a step of its border") {
  const Svpwm twin;
  int wrong = 0;
  for (std::int32_t a = -2048; a < 2048; a += 3) {
    for (std::int32_t b = -2048; b < 2048; ++b) {
      if (twin.step({a, b}).sector == exact_sector(a, b)) continue;
      ++wrong;
      CAPTURE(a, b);
      REQUIRE(std::abs(std::abs(b) - std::sqrt(3.0) * std::abs(a)) < 0.1);
    }
  }
  REQUIRE(wrong < 100);  // of 5.6 million; the duty is continuous there
}

TEST_CASE("svpwm has the flow shape: holds, ignores a second tick, is quiescent between") {
  test::Rtl<Vsvpwm> rtl;
  test::Words words(3);
  const auto drive = [&] {
    test::set_word(rtl->v_alpha_i, words());
    test::set_word(rtl->v_beta_i, words());
  };
  test::require_flow_shape(rtl, kLatency, {781, 781, 781, 0}, drive, [&] {
    return std::vector<std::int64_t>{rtl->cmp_a_o, rtl->cmp_b_o, rtl->cmp_c_o, rtl->sector_o};
  });
}
