// SPDX-License-Identifier: Apache-2.0
//
// A leadscrew axis of other values than McAfee's: limits in metres, and when each of its own events
// and of its drive's changes acts.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/plant/leadscrew_axis.hpp"
#include "models/plant/xy_stage.hpp"

using namespace trammel::plant;

namespace {

// Few lines, so that the switches' edges are events of their own.
LeadscrewConfig own() {
  LeadscrewConfig c;
  c.pitch = 2e-3;
  c.encoder.lines = 2;
  c.switch_low = -0.7e-3;
  c.switch_high = 1.1e-3;
  c.switch_hysteresis = 80e-6;
  c.overtravel = 0.3e-3;
  return c;
}

}  // namespace

TEST_CASE("leadscrew_axis: each switch opens and closes at its place, at the first clock of it") {
  for (const bool high : {false, true}) {
    const LeadscrewConfig c = own();
    LeadscrewAxis axis(c);
    const double out = high ? c.switch_high : c.switch_low;
    const double back = out + (high ? -80e-6 : 80e-6);
    const auto open = [&] { return high ? axis.sensor().at_high() : axis.sensor().at_low(); };
    std::int64_t n = 0;
    const auto until = [&](bool wanted, unsigned code) {
      axis.drive(n, code);
      while (open() != wanted) {
        REQUIRE(n < 50'000'000);
        n = axis.next();
        axis.drive(n, code);
      }
    };
    const auto within_a_clock_of = [&](double place, std::int64_t edge) {
      const double speed = std::fabs(axis.state(edge).omega) / axis.sensor().radians_per_m();
      CAPTURE(high, place, edge, axis.position(edge));
      CHECK(std::fabs(axis.position(edge) - place) <= speed * 20e-9 + 1e-12);
    };
    until(true, high ? 0xB0 : 0x50);
    within_a_clock_of(out, n);
    until(false, high ? 0x50 : 0xB0);
    within_a_clock_of(back, n);
  }
}

TEST_CASE("leadscrew_axis: the stop is its overtravel behind each switch") {
  for (const bool high : {false, true}) {
    LeadscrewAxis axis(own());
    const unsigned code = high ? 0xC0 : 0x40;
    axis.drive(0, code);
    while (axis.next() < 20'000'000) axis.drive(axis.next(), code);
    CAPTURE(high);
    CHECK(axis.position(20'000'000) == Approx(high ? 1.4e-3 : -1.0e-3));
    CHECK(axis.state(20'000'000).omega == 0);
  }
}

TEST_CASE("leadscrew_axis: a code acts from its clock on, whenever its next event is") {
  LeadscrewAxis axis(own());
  const double full = own().motor.supply;
  for (const unsigned code : {0x00u, 0x01u, 0x7Fu, 0x81u, 0xFFu}) {
    const std::int64_t n = axis.next() - 1;  // ahead of its event
    axis.drive(n, code);
    CAPTURE(code, n);
    CHECK(axis.voltage() == Approx(full * (static_cast<int>(code) - 128) / 128.0));
    CHECK(axis.next() > n);
  }
}

TEST_CASE("the stage opens a winding of one axis, and weakens the supply of both") {
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    XyStageConfig config{own(), own()};
    config[1].motor.supply = 10;
    XyStage stage(config);
    stage.commit(0, {0xC0, 0xC0});
    CAPTURE(k);
    CHECK(stage.axis(0).voltage() == Approx(11));
    CHECK(stage.axis(1).voltage() == Approx(5));
    while (stage.next() < 10'000) stage.commit(stage.next(), {0xC0, 0xC0});
    stage.open(10'000, k, true);
    CHECK(stage.axis(k).state(10'100).i == 0);
    CHECK(stage.axis(1 - k).state(10'100).i > 0);
    stage.supply(10'200, 0.5);
    CHECK(stage.axis(0).voltage() == Approx(5.5));
    CHECK(stage.axis(1).voltage() == Approx(2.5));
    // Committed no later than the first event of either.
    CHECK(stage.next() == std::min(stage.axis(0).next(), stage.axis(1).next()));
  }
}
