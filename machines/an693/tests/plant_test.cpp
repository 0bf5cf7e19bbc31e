// SPDX-License-Identifier: Apache-2.0
//
// The motor of the machine an693 behind its pins: what an open winding and a supply that is not
// whole make of it, and the mean voltage that pulses give it, by hand.
#include <catch2/catch.hpp>

#include "machines/an693/session.hpp"

using namespace trammel;
using an693::MotorPlant;

namespace {

constexpr cosim::Clk kMs = 50'000;

void go(MotorPlant& plant, cosim::Clk end, cosim::Lines drive) {
  while (plant.next() < end) plant.commit(plant.next(), drive);
  plant.commit(end, drive);
}

MotorPlant of(lm628::Variant variant) {
  lm628::PartOptions part;
  part.variant = variant;
  return {plant::MotorAxisConfig(), part};
}

}  // namespace

TEST_CASE("an693: an open winding carries no current, and does so again once it is closed") {
  for (const cosim::Lines code : {cosim::Lines{0xC00}, cosim::Lines{0x400}}) {
    const double sense = code > lm628::kZeroCode ? 1 : -1;
    MotorPlant plant = of(lm628::Variant::kLm628);
    go(plant, 1, code);
    go(plant, 5 * kMs, code);
    CAPTURE(code);
    CHECK(sense * plant.axis().state(5 * kMs).i > 0.5);
    plant.open_phase(5 * kMs, 0, 0, true);
    const double speed = plant.axis().state(5 * kMs).omega;
    CHECK(sense * speed > 1);
    go(plant, 10 * kMs, code);
    CHECK(plant.axis().state(10 * kMs).i == 0);
    CHECK(plant.axis().state(10 * kMs).omega == Approx(speed).epsilon(0.01));  // nothing drives it
    plant.open_phase(10 * kMs, 0, 0, false);
    go(plant, 15 * kMs, code);
    CHECK(sense * plant.axis().state(15 * kMs).i > 0.5);
  }
}

TEST_CASE("an693: a supply that is not whole gives its motor that share of the voltage") {
  MotorPlant plant = of(lm628::Variant::kLm628);
  go(plant, 1, 0xC00);  // half of 24 V
  CHECK(plant.voltage(1) == 12);
  plant.supply(kMs, 0.25);
  CHECK(plant.voltage(kMs) == 3);
  go(plant, 2 * kMs, 0x400);
  CHECK(plant.voltage(2 * kMs) == -3);
  plant.supply(3 * kMs, 1);
  CHECK(plant.voltage(3 * kMs) == -12);
}

TEST_CASE("an693: the voltage of pulses is the mean since it was asked for, through dips and all") {
  constexpr cosim::Lines kForward = 1 << lm628::kMagnitude;
  constexpr cosim::Lines kBackward = kForward | 1 << lm628::kSign;
  MotorPlant plant = of(lm628::Variant::kLm629);
  plant.commit(0, kForward);
  CHECK(plant.voltage(0) == 24);  // of no time: as it is
  plant.supply(1000, 0.5);
  CHECK(plant.voltage(2000) == Approx((24.0 + 12) / 2));
  CHECK(plant.voltage(3000) == Approx(12));
  plant.commit(3250, 0);
  CHECK(plant.voltage(4000) == Approx(12.0 / 4));
  plant.supply(4000, 1);
  plant.commit(4500, kBackward);
  CHECK(plant.voltage(5000) == Approx(-24.0 / 2));
  plant.commit(5600, cosim::Lines{1} << lm628::kSign);
  CHECK(plant.voltage(6000) == Approx(-24 * 0.6));
}
