// SPDX-License-Identifier: Apache-2.0
//
// The interface in fabrics whose clocks are no round multiple of 240 kHz: RTL and twin alike, and
// the rates of Table I (Larson 1974) without an error that adds up.
#include <Vstep_table_100MHz.h>
#include <Vstep_table_1MHz.h>
#include <Vstep_table_33333kHz.h>
#include <Vstep_table_third.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "models/exact/motion/step_table.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::StepTable;
using trammel::test::Random;

namespace {

constexpr std::uint32_t kBusy = 010000, kForward = 020000;

template <class Model, std::uint32_t kInc, std::uint32_t kMod>
struct Fabric {
  static double hertz() { return 240e3 * kMod / kInc; }

  trammel::test::Rtl<Model> rtl;
  StepTable twin{kInc, kMod};
  StepTable::In in;
  std::int64_t now = 0;

  Fabric() {
    rtl->leap_i = 0;
    apply();
    rtl.reset();
    for (int i = 0; i < 4; ++i) tick();
    rtl.reset();
    twin.reset();
    now = 0;
  }

  void apply() {
    rtl->limit_low_i = (in.pins[0].low ? 1 : 0) | (in.pins[1].low ? 2 : 0);
    rtl->limit_high_i = 0;
    rtl->buf_busy_i = 0;
    rtl->write_i = in.write;
    rtl->y_i = in.y;
    rtl->bytes_i = 15;
    rtl->data_i = in.data;
    rtl->grant_i = 0;
    rtl.eval();
  }
  void tick() {
    apply();
    rtl.tick();
    twin.step(in);
    ++now;
  }
  void leap(Gap n) {
    rtl->leap_i = (n - 1) & 0xFFF;
    rtl.tick();
    rtl->leap_i = 0;
    twin.advance(n);
    now += n;
  }
  // `steps` of one axis, forward.
  void start(bool y, std::uint32_t code, std::uint32_t steps) {
    in.write = true;
    in.y = y;
    in.bytes = 15;
    in.data = (kBusy | kForward | code) << 16 | (0xFFFF - steps);
    tick();
    in.write = false;
    in.bytes = 0;
  }
  bool same() {
    apply();
    bool equal = rtl->x_o == twin.words(0) && rtl->y_o == twin.words(1) &&
                 rtl->next_o == twin.next() && bool(rtl->quiescent_o) == twin.quiescent(in);
    for (std::size_t k = 0; k < 2; ++k) {
      equal = equal && (rtl->step_o >> k & 1) == twin.axis(k).step;
    }
    return equal;
  }
};

using Slow = Fabric<Vstep_table_1MHz, 6, 25>;             // four clocks a period
using Odd = Fabric<Vstep_table_33333kHz, 80, 11111>;      // 33,333,000 Hz
using Third = Fabric<Vstep_table_third, 80000, 11111111>; // 33,333,333 Hz
using Fast = Fabric<Vstep_table_100MHz, 3, 1250>;

}  // namespace

TEMPLATE_TEST_CASE("step_table in another fabric agrees with its twin, leaping and not", "", Slow,
                   Odd, Third, Fast) {
  TestType bench;
  Random random(3);
  int steps = 0;
  for (int n = 0; n < 30'000; ++n) {
    if (random() % 500 == 0) {
      const auto below = static_cast<std::uint32_t>(random() % 40);
      bench.start(random() % 2 == 0, 07777 - below, 1 + random() % 30);
    }
    REQUIRE(bench.same());
    const bool was = bench.twin.axis(0).step;
    const Gap next = bench.twin.next();
    if (bench.twin.quiescent(bench.in) && next > 0 && random() % 3 != 0) {
      bench.leap(1 + static_cast<Gap>(random() % next));
    } else {
      bench.tick();
    }
    steps += bench.twin.axis(0).step && !was ? 1 : 0;
  }
  CHECK(steps > 100);
}

TEMPLATE_TEST_CASE("M-01 rates of Table I hold in another fabric, over 1000 steps to a clock", "",
                   Slow, Odd, Third, Fast) {
  for (const std::uint32_t code : {01000u, 05000u, 07400u, 07550u, 07704u}) {
    TestType bench;
    bench.start(false, code, 1001);
    std::vector<std::int64_t> at;
    bool was = false;
    while (at.size() < 1001) {
      const Gap next = bench.twin.quiescent(bench.in) ? bench.twin.next() : 0;
      if (next > 0) bench.leap(next);
      bench.tick();
      bench.apply();
      const bool is = (bench.rtl->step_o & 1) != 0;
      if (is && !was) at.push_back(bench.now);
      was = is;
    }
    const double clocks = 1000.0 * (4096 - code) / 240e3 * TestType::hertz();
    CAPTURE(code, TestType::hertz());
    CHECK(std::fabs(static_cast<double>(at.back() - at.front()) - clocks) <= 1);
    CHECK(bench.same());
  }
}
