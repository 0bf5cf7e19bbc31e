// SPDX-License-Identifier: Apache-2.0
//
// The pulse buffer against Larson's table of multiple step times (1974, section III), and what no
// ramp may do.
#include "models/plant/pulse_buffer.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

using trammel::plant::PulseBuffer;
using trammel::plant::PulseBufferConfig;

namespace {

constexpr double kClockS = 20e-9;

// Clocks at which n pulses leave that come every `gap` clocks from clock 0 on.
std::vector<std::int64_t> leaving(int n, std::int64_t gap) {
  PulseBuffer buffer((PulseBufferConfig()));
  std::vector<std::int64_t> all;
  for (int entered = 0; static_cast<int>(all.size()) < n;) {
    const std::int64_t comes = entered < n ? entered * gap : PulseBuffer::kNever;
    if (comes <= buffer.next()) {
      buffer.enter(comes, 1);
      ++entered;
    } else {
      const std::int64_t leaves = buffer.next();
      if (buffer.pass(leaves) != 0) all.push_back(leaves);
    }
  }
  return all;
}

double seconds(std::int64_t clocks) { return static_cast<double>(clocks) * kClockS; }

}  // namespace

TEST_CASE("M-09 moves of 1 to 127 steps at 4000 PPS take Larson's seven times within 5 %") {
  const std::pair<int, double> rows[] = {{1, 2.6e-3}, {3, 6.5e-3},  {7, 15e-3},   {15, 30e-3},
                                         {31, 60e-3}, {63, 100e-3}, {127, 180e-3}};
  for (const auto& [steps, time] : rows) {
    CAPTURE(steps);
    CHECK(seconds(leaving(steps, 12'500).back()) == Approx(time).epsilon(0.05));
  }
}

TEST_CASE("pulse_buffer: 2000 steps take 1.26 s and 6000 take 2.49 s, as computed independently") {
  CHECK(seconds(leaving(2000, 12'500).back()) == Approx(1.26).epsilon(5e-3));
  CHECK(seconds(leaving(6000, 12'500).back()) == Approx(2.49).epsilon(5e-3));
}

TEST_CASE("pulse_buffer: a rate rises by 2760/s each second at most, and brakes before the end") {
  const std::vector<std::int64_t> at = leaving(1000, 12'500);
  const auto rate = [&at](std::size_t k) { return 1 / seconds(at[k] - at[k - 1]); };
  for (std::size_t k = 21; k < at.size(); ++k) {  // over 20 pulses: a clock is 4e-5 of an interval
    const double between = (seconds(at[k] + at[k - 1]) - seconds(at[k - 20] + at[k - 21])) / 2;
    CHECK((rate(k) - rate(k - 20)) / between < 2760 * 1.02);
  }
  CHECK(rate(at.size() - 1) < 1100);  // the motor stops from there
}

TEST_CASE("pulse_buffer: pulses never leave faster than they came, and none is lost or made") {
  for (const std::int64_t gap : {125'000, 25'000, 12'500}) {
    const std::vector<std::int64_t> at = leaving(3000, gap);
    CHECK(at.size() == 3000);
    for (std::size_t k = 0; k < at.size(); ++k) {
      REQUIRE(at[k] > static_cast<std::int64_t>(k) * gap);
      if (k > 4) REQUIRE(at[k] - at[k - 4] > 4 * gap * 98 / 100);
    }
  }
}

TEST_CASE("pulse_buffer is busy while a pulse waits, or more than so many") {
  for (const int above : {0, 2}) {
    PulseBufferConfig config;
    config.busy_above = above;
    PulseBuffer buffer(config);
    for (int k = 0; k < 5; ++k) {
      buffer.enter(k * 1000, 1);
      CHECK(buffer.waiting() == k + 1);
      CHECK(buffer.busy() == (k + 1 > above));
    }
    while (buffer.waiting() > 0) {
      CHECK(buffer.pass(buffer.next()) == 1);
      CHECK(buffer.busy() == (buffer.waiting() > above));
    }
  }
}

TEST_CASE("pulse_buffer tells a rate from the first pulse that leaves, as long as others wait") {
  PulseBuffer buffer((PulseBufferConfig()));
  for (int k = 0; k < 3; ++k) buffer.enter(k * 12'500, -1);
  CHECK(buffer.rate() == 0);
  const std::int64_t before = buffer.next();
  CHECK(buffer.pass(before) == -1);
  CHECK(buffer.rate() == Approx(-464 - 2760 * (seconds(before) - 0.4e-3)).epsilon(1e-4));
  CHECK(buffer.pass(buffer.next()) == -1);
  CHECK(buffer.rate() < -464);
  CHECK(buffer.pass(buffer.next()) == -1);
  CHECK(buffer.rate() == 0);
}

TEST_CASE("pulse_buffer: after a pause it goes on, after 20 ms of it with a new ramp") {
  for (const auto& [pause, first_s] : {std::pair{500'000, 2.2e-3}, {1'500'000, 2.54e-3}}) {
    PulseBuffer buffer((PulseBufferConfig()));
    buffer.enter(0, 1);
    const std::int64_t left = buffer.next();
    CHECK(buffer.pass(left) == 1);
    CHECK(buffer.next() == left + 1'000'000);  // it comes to stand
    if (pause > 1'000'000) CHECK(buffer.pass(buffer.next()) == 0);
    const std::int64_t again = left + pause;
    for (int k = 0; k < 4; ++k) buffer.enter(again + k * 12'500, -1);
    CHECK(seconds(buffer.next() - again) < first_s * 1.15);
    CHECK(buffer.pass(buffer.next()) == -1);
    CHECK(buffer.busy());
    CHECK(buffer.rate() < 0);
    buffer.flush();
    CHECK_FALSE(buffer.busy());
    CHECK(buffer.waiting() == 0);
    CHECK(buffer.next() == PulseBuffer::kNever);
  }
}
