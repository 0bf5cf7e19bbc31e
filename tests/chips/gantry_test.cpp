// SPDX-License-Identifier: Apache-2.0
//
// The chip gantry alone, each case beside its twin: sequence of a tick, acceptance tests G-01 to
// G-03 by the RTL, calibration data by commands, and random traffic.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "tests/chips/gantry_bench.hpp"
#include "tests/support/random.hpp"
#include "tests/support/stripe_sensor.hpp"
#include "tests/support/traffic.hpp"

using trammel::test::GantryBench;
using trammel::test::Random;
using trammel::test::StripeSensor;
using trammel::test::ideal_calibration;
using trammel::test::kUnit_mm;
namespace exact = trammel::exact;
using namespace trammel::gantry_regs;

namespace {

constexpr double kClock_s = 20e-9;

}  // namespace

TEST_CASE("gantry reads its calibration after reset, then observes when asked to") {
  const exact::Calibration calib = ideal_calibration();
  GantryBench bench(&calib);
  CHECK(bench.get(kId) == kIdValue);
  CHECK(bench.get(kCalibration) == kCalibrationValid);
  CHECK(bench.get(kStatus) == 0);
  const StripeSensor sensor;
  bench.code = [&](int channel, std::int64_t) { return sensor.code(channel, 1.7, 0); };
  bench.put(kObserver, 0x11);
  bench.clocks(6 * 10842);
  CHECK((bench.get(kAngle) & kAngleKnown) != 0);
  const double x = static_cast<std::int32_t>(bench.get(kPosition)) * kUnit_mm;
  CHECK(x == Approx(1.7).margin(0.0026));
  CHECK(bench.get(kVelocity) == 0);
  CHECK(bench.get(kTicks) == 6);
}
