// SPDX-License-Identifier: Apache-2.0
//
// The stage of the machine mcafee behind its pins: the marker of each axis once a turn, an open
// winding and a supply that is not whole; and what its converters have before the parts write.
#include <catch2/catch.hpp>
#include <array>

#include "machines/mcafee/board.hpp"
#include "machines/mcafee/machine.hpp"
#include "machines/mcafee/session.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

constexpr cosim::Clk kMs = 50'000;

cosim::Lines codes(cosim::Lines x, cosim::Lines y) { return x << converter(0) | y << converter(1); }

template <class After>
void go(StagePlant& plant, cosim::Clk end, cosim::Lines drive, After after) {
  while (plant.next() < end) {
    plant.commit(plant.next(), drive);
    after();
  }
  plant.commit(end, drive);
}
void go(StagePlant& plant, cosim::Clk end, cosim::Lines drive) {
  go(plant, end, drive, [] {});
}

}  // namespace

TEST_CASE("mcafee: converters give nothing before the parts have written to them") {
  CHECK(Board().codes == codes(0x80, 0x80));
  for (const int axis : {0, 1}) CHECK(code(Board().codes, axis) == kZeroCode);
}

TEST_CASE("mcafee: the line of each marker is high about the place of a turn, and low elsewhere") {
  const plant::LeadscrewConfig config;
  for (const int axis : {0, 1}) {
    StagePlant plant({config, config});
    int markers = 0, others = 0;
    bool was = true;  // it starts at one
    CHECK((plant.sense() >> marker(0) & plant.sense() >> marker(1) & 1) == 1);
    go(plant, 600 * kMs, axis == 0 ? codes(0xA0, 0x80) : codes(0x80, 0xA0), [&] {
      const cosim::Lines lines = plant.sense();
      const bool is = (lines >> marker(axis) & 1) != 0;
      if (is && !was) {
        ++markers;
        const auto& encoder = plant.stage().axis(static_cast<std::size_t>(axis)).sensor().encoder();
        const std::int64_t off = encoder.count() % encoder.counts();
        CHECK((off <= 3 || off >= encoder.counts() - 3));
      }
      was = is;
      others += (lines >> marker(1 - axis) & 1) == 0 ? 1 : 0;
    });
    const double turns = plant.stage().axis(static_cast<std::size_t>(axis)).position(600 * kMs) /
                         config.pitch;
    CAPTURE(axis, turns);
    REQUIRE(turns > 2.2);
    CHECK(markers == static_cast<int>(turns + 0.01));
    CHECK(others == 0);  // the other one stands at its own
  }
}

TEST_CASE("mcafee: an open winding carries no current, that of the other axis does") {
  for (const std::size_t dead : {std::size_t{0}, std::size_t{1}}) {
    const plant::LeadscrewConfig config;
    StagePlant plant({config, config});
    const auto current = [&](std::size_t k, cosim::Clk n) {
      return plant.stage().axis(k).state(n).i;
    };
    go(plant, 1, codes(0xC0, 0xC0));
    plant.open_phase(1, static_cast<int>(dead), 0, true);
    go(plant, 2 * kMs, codes(0xC0, 0xC0));
    CAPTURE(dead);
    CHECK(current(dead, 2 * kMs) == 0);
    CHECK(current(1 - dead, 2 * kMs) > 0.1);
    plant.open_phase(2 * kMs, static_cast<int>(dead), 0, false);
    go(plant, 4 * kMs, codes(0xC0, 0xC0));
    CHECK(current(dead, 4 * kMs) > 0.1);
  }
}

TEST_CASE("mcafee: a supply that is not whole gives both motors that share of the voltage") {
  const plant::LeadscrewConfig config;
  StagePlant plant({config, config});
  const auto volts = [&] {
    return std::array<double, 2>{plant.stage().axis(0).voltage(), plant.stage().axis(1).voltage()};
  };
  const double whole = config.motor.supply;
  go(plant, 1, codes(0xC0, 0x60));  // a half forward, a quarter backward
  CHECK(volts() == std::array<double, 2>{0.5 * whole, -0.25 * whole});
  plant.supply(kMs, 0.5);
  CHECK(volts() == std::array<double, 2>{0.25 * whole, -0.125 * whole});
  go(plant, 2 * kMs, codes(0x40, 0x80));
  CHECK(volts() == std::array<double, 2>{-0.25 * whole, 0});
  plant.supply(3 * kMs, 1);
  CHECK(volts() == std::array<double, 2>{-0.5 * whole, 0});
}

TEST_CASE("mcafee: a count is a quarter of a line, the travel is from switch to switch") {
  Options options;
  options.stage_axis.pitch = 4e-3;
  options.stage_axis.encoder.lines = 250;
  options.stage_axis.switch_low = -0.1;
  options.stage_axis.switch_high = 0.2;
  CHECK(options.count_mm() == Approx(4e-3));
  const TravelMm travel = options.travel_mm();
  CHECK(travel.low == Approx(-100));
  CHECK(travel.high == Approx(200));
}
