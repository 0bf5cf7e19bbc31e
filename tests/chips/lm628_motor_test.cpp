// SPDX-License-Identifier: Apache-2.0
//
// The LM628 with a motor: AN-693, "Tuning the filter", on the reference motor of dc_motor.hpp.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/plant/dc_motor.hpp"
#include "tests/chips/lm628_bench.hpp"

using trammel::exact::Opcode;
using trammel::plant::DcMotor;
using trammel::plant::DcMotorState;
using trammel::test::Lm628Twin;
using MotorBench = trammel::test::Lm628Bench<Lm628Twin>;

namespace {

constexpr double kTick = 0.125e-6;           // [s]
constexpr double kCounts = 4000;             // per revolution: 1000 lines
constexpr double kTurn = 6.283185307179586;  // [rad]
constexpr double kSample = 2048 * kTick;

struct Response {
  double overshoot = 0;  // of the step
  double settled = 0;    // [s] after which it stays in the band
};

// From tick 400 of a sample on the output is known; it reaches the converter 24 ticks later, and
// the encoder is read at tick 0 of the next.
Response step_response(unsigned kp, int counts) {
  MotorBench bench;
  bench.start();
  bench.command(Opcode::kPort12);
  bench.command(Opcode::kLfil, {0x030A, kp, 1000});  // derivative every 4 samples
  bench.command(Opcode::kUdf);
  bench.trajectory(0x2A, {(1 << 30) - 1, (1 << 30) - 1, counts});
  bench.command(Opcode::kStt);

  const DcMotor motor({});
  DcMotorState s;
  double volt = 0;
  double peak = 0;
  Response response;
  for (int n = 1; n <= 1500; ++n) {
    bench.sample();
    s = motor.after(s, 24 * kTick, volt);
    volt = motor.voltage(static_cast<double>(bench.engine().output() >> 4) / 2048);
    s = motor.after(s, (2048 - 424) * kTick, volt);
    bench.move_to(static_cast<std::int64_t>(std::floor(s.theta / kTurn * kCounts + 0.5)));
    s = motor.after(s, 400 * kTick, volt);
    const double position = s.theta / kTurn * kCounts;
    peak = std::max(peak, position);
    if (std::fabs(position - counts) > 2.5) response.settled = n * kSample;
  }
  response.overshoot = std::max(0.0, peak - counts) / counts;
  return response;
}

}  // namespace

TEST_CASE("L-16 lm628 tunes the reference motor from over- to under-damped as kp rises") {
  struct Row {
    unsigned kp;
    double overshoot;  // [%], within 3 points
  };
  for (const Row& row : {Row{5, 0}, Row{35, 0.3}, Row{50, 2.0}, Row{100, 14.3}, Row{200, 33.7}}) {
    const Response response = step_response(row.kp, 50);
    CAPTURE(row.kp, response.settled);
    CHECK(std::fabs(100 * response.overshoot - row.overshoot) <= 3);
    if (row.kp == 50) CHECK(response.settled < 0.060);
  }
}
