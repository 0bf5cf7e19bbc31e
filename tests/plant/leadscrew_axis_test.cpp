// SPDX-License-Identifier: Apache-2.0
//
// An axis with a leadscrew: by default, and of other values than the default ones.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/plant/leadscrew_axis.hpp"
#include "models/plant/xy_stage.hpp"

using namespace trammel::plant;

namespace {

constexpr std::int64_t kSample = 17'067;  // [clk] of an LM628 at 6 MHz

// Drives with one code until clock `end`, with the plant's own events in between.
void run(LeadscrewAxis& axis, std::int64_t from, std::int64_t end, unsigned code) {
  axis.drive(from, code);
  while (axis.next() < end) axis.drive(axis.next(), code);
}

LeadscrewConfig short_travel() {
  LeadscrewConfig config;
  config.switch_low = -1e-3;
  config.switch_high = 1e-3;
  config.overtravel = 0.5e-3;
  return config;
}

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

TEST_CASE("leadscrew_axis counts up where the converter's code is above 80h") {
  LeadscrewAxis axis({});
  run(axis, 0, 5'000'000, 0xC0);
  CHECK(axis.sensor().encoder().count() > 100);
  CHECK(axis.position(5'000'000) > 0);
  // 800 counts of 5.0165 um per revolution.
  CHECK(axis.position(5'000'000) / 5.0165e-6 ==
        Approx(static_cast<double>(axis.sensor().encoder().count())).margin(0.6));
}

TEST_CASE("leadscrew_axis has an amplifier that gives at most 3 A") {
  LeadscrewAxis axis({});
  axis.drive(0, 0xFF);
  double most = 0, before = 0;
  for (std::int64_t n = 1000; n <= 500'000; n += 1000) {
    while (axis.next() < n) axis.drive(axis.next(), 0xFF);
    most = std::fmax(most, axis.state(n).i);
    if (n == 400'000) before = axis.state(n).omega;
  }
  CHECK(most == 3);
  // k i - T_c over J: 1050 rad/s^2, once the current is there and the shaft moves.
  const double rise = axis.state(500'000).omega - before;
  CHECK(rise / 2e-3 == Approx((0.080 * 3 - 0.03) / 2e-4).epsilon(1e-3));
}

TEST_CASE("leadscrew_axis finds each change of a line at its first clock") {
  LeadscrewAxis axis(short_travel());
  axis.drive(0, 0xA0);
  int changes = 0;
  while (changes < 200) {
    const std::int64_t n = axis.next();
    if (axis.sensor().leaves(axis.state(n).theta)) {
      REQUIRE_FALSE(axis.sensor().leaves(axis.state(n - 1).theta));
      ++changes;
    }
    axis.drive(n, 0xA0);
  }
}

TEST_CASE("F-11 a limit switch cuts the motor's power within one sample, and says so") {
  LeadscrewAxis axis(short_travel());
  axis.drive(0, 0xFF);
  while (!axis.sensor().at_high()) axis.drive(axis.next(), 0xFF);
  const std::int64_t hit = axis.next() - 1;
  CHECK(axis.position(hit) == Approx(1e-3).margin(20e-6));
  // From then on no current flows toward the switch, though the code asks for all there is.
  for (std::int64_t n = hit; n < hit + 100 * kSample; n += kSample / 10) {
    while (axis.next() < n) axis.drive(axis.next(), 0xFF);
    REQUIRE(axis.state(n).i <= 0);
  }
  CHECK(axis.sensor().at_high());
  CHECK_FALSE(axis.sensor().at_low());
}

TEST_CASE("leadscrew_axis comes to rest at its stop, and can be driven back off the switch") {
  LeadscrewConfig config = short_travel();
  config.overtravel = 0.1e-3;
  LeadscrewAxis axis(config);
  run(axis, 0, 5'000'000, 0x00);
  CHECK(axis.sensor().at_low());
  CHECK(axis.position(5'000'000) == Approx(-1.1e-3));
  CHECK(axis.state(5'000'000).omega == 0);
  CHECK(axis.state(5'000'000).i == 0);
  run(axis, 5'000'000, 12'000'000, 0xC0);
  CHECK_FALSE(axis.sensor().at_low());
  CHECK(axis.position(12'000'000) > -1e-3);
}

TEST_CASE("an axis of the stage is independent of the other") {
  XyStage stage({}), alone({});
  stage.commit(0, {0x90, 0x30});
  alone.commit(0, {0x90, 0x80});
  const std::int64_t end = 3'000'000;
  while (stage.next() < end) stage.commit(stage.next(), {0x90, 0x30});
  while (alone.next() < end) alone.commit(alone.next(), {0x90, 0x80});
  CHECK(stage.axis(0).position(end) == alone.axis(0).position(end));
  CHECK(stage.axis(1).position(end) < 0);
}

TEST_CASE("leadscrew_axis: an open switch closes again behind its hysteresis, at either end") {
  for (const bool high : {false, true}) {
    CAPTURE(high);
    LeadscrewConfig config = short_travel();
    config.switch_hysteresis = 100e-6;
    LeadscrewSensor sensor(config);
    const double sign = high ? 1 : -1;
    const auto open_at = [&](double metres) {
      sensor.follow(sign * metres * sensor.radians_per_m());
      return high ? sensor.at_high() : sensor.at_low();
    };
    CHECK_FALSE(open_at(0.95e-3));  // within the hysteresis, on the way out
    CHECK(open_at(1.001e-3));
    CHECK(open_at(0.95e-3));  // and on the way back
    CHECK_FALSE(open_at(0.85e-3));
    CHECK_FALSE((sensor.at_low() || sensor.at_high()));
  }
}

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
