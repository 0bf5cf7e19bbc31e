// SPDX-License-Identifier: Apache-2.0
//
// The pulse buffer against Larson's table of multiple step times (1974, section III), what no ramp
// may do, and buffers of other values in closed form.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "models/plant/pulse_buffer.hpp"

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

constexpr std::int64_t kClockPs = 50'000;
constexpr double kOwnClockS = 50e-9;

PulseBufferConfig own() {
  PulseBufferConfig c;
  c.dead_s = 1e-3;
  c.start = 200;
  c.rise = 5000;
  c.brake = 300;
  c.idle_s = 40e-3;
  c.clock_ps = kClockPs;
  return c;
}

std::int64_t clocks(double seconds) { return std::llround(seconds / kOwnClockS); }

// [s] a phase takes to grow by 1 that begins at `rate`, rises by `rise`, and stays at `most`.
double next_pulse(double& rate, double rise, double most) {
  double phase = 0, t = 0;
  const double h = 1e-6;
  rate = std::min(rate, most);
  while (phase < 1) {
    phase += rate * h;
    rate = std::min(rate + rise * h, most);
    t += h;
  }
  return t;
}

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

TEST_CASE("pulse_buffer: dead time, first rate, rise and brake are its own") {
  const PulseBufferConfig c = own();
  PulseBuffer buffer(c);
  for (int k = 0; k < 30; ++k) buffer.enter(1000 + k, 1);  // all at once
  double rate = c.start, t = 1000 * kOwnClockS + c.dead_s;
  for (int waiting = 30; waiting > 0; --waiting) {
    const double brake = std::sqrt(c.brake * c.brake + 2 * c.rise * waiting);
    t += next_pulse(rate, c.rise, brake);
    const std::int64_t n = buffer.next();
    CAPTURE(waiting, n, clocks(t));
    // A clock of each pulse, and 1 us of this integration.
    REQUIRE(std::fabs(static_cast<double>(n) * kOwnClockS - t) < 1.1e-6 * (31 - waiting));
    REQUIRE(buffer.pass(n) == 1);
    REQUIRE(buffer.waiting() == waiting - 1);
    REQUIRE(buffer.busy() == (waiting > 1));
  }
}

TEST_CASE("pulse_buffer: a pulse leaves at the first clock at which its phase has reached 1") {
  PulseBufferConfig c = own();
  c.rise = 1e-3;  // as good as none
  c.start = c.brake = 300;
  PulseBuffer buffer(c);
  buffer.enter(7, 1);
  const auto whole = static_cast<std::int64_t>(std::ceil(1 / (300 * kOwnClockS)));
  CHECK(buffer.next() == 7 + clocks(1e-3) + whole);
}

TEST_CASE("pulse_buffer: a pulse that comes in between neither hastens nor delays the next") {
  PulseBufferConfig c = own();
  c.brake = 5000;
  PulseBuffer alone(c), fed(c);
  for (PulseBuffer* buffer : {&alone, &fed}) {
    for (int k = 0; k < 3; ++k) buffer->enter(k, 1);
  }
  // 2500/s: faster than the buffer's own rate by now.
  const std::int64_t leaves = alone.next();
  for (std::int64_t n = clocks(0.4e-3); n < leaves; n += clocks(0.4e-3)) {
    fed.enter(n, 1);
    CAPTURE(n);
    CHECK(std::llabs(fed.next() - leaves) <= 1);
  }
  CHECK(fed.waiting() > 10);
}

TEST_CASE("pulse_buffer: a rate that rises to that of its pulses within one pulse stays there") {
  // 200/s from 5 ms on, 250/s after 1 ms of 50 000/s^2, as the first two pulses are 4 ms apart.
  const struct {
    double third_ms, leaves_ms;  // 0 = none comes
  } cases[] = {{0, 6 + 1e3 * (1 - 0.225) / 250},
               {5.5, 5.5 + (std::sqrt(225 * 225 + 1e5 * (1 - 0.10625)) - 225) / 50},
               {7, 7 + 5.0 / 3 + 1e3 * (0.525 - 0.4861111) * 3 / 1000}};
  for (const auto& one : cases) {
    PulseBufferConfig c = own();
    c.dead_s = 5e-3;
    c.rise = 50'000;
    PulseBuffer buffer(c);
    buffer.enter(0, 1);
    buffer.enter(clocks(4e-3), 1);
    if (one.third_ms > 0) buffer.enter(clocks(1e-3 * one.third_ms), 1);
    CAPTURE(one.third_ms);
    CHECK(static_cast<double>(buffer.next()) * kOwnClockS * 1e3 ==
          Approx(one.leaves_ms).margin(2e3 * kOwnClockS));
    if (one.third_ms > 0) continue;
    buffer.pass(buffer.next());
    CHECK(static_cast<double>(buffer.next()) * kOwnClockS * 1e3 ==
          Approx(one.leaves_ms + 4).margin(2e3 * kOwnClockS));
  }
}

TEST_CASE("pulse_buffer: it stands after its own pause, and not before, nor with pulses in it") {
  const PulseBufferConfig c = own();
  for (const double pause : {0.9, 1.1}) {
    PulseBuffer buffer(c);
    buffer.enter(0, 1);
    const std::int64_t left = buffer.next();
    buffer.pass(left);
    CHECK(buffer.next() == left + clocks(c.idle_s));
    const std::int64_t again = left + clocks(pause * c.idle_s);
    while (buffer.next() < again) CHECK(buffer.pass(buffer.next()) == 0);
    buffer.enter(again, -1);
    const std::int64_t n = buffer.next();
    CAPTURE(pause, n - again);
    // Anew with its dead time; else without it, by the rate of pulses so far apart.
    const double gap = static_cast<double>(again) * kOwnClockS;
    const double wanted = pause > 1 ? c.dead_s + (std::sqrt(200.0 * 200 + 2 * 5000) - 200) / 5000
                                    : gap;
    CHECK(static_cast<double>(n - again) * kOwnClockS == Approx(wanted).epsilon(0.01));
    CHECK(buffer.pass(n) == -1);
  }
}

TEST_CASE("pulse_buffer: how slow pulses were is forgotten behind a pause") {
  const PulseBufferConfig c = own();
  PulseBuffer buffer(c);
  for (const double at : {0.0, 30e-3}) {  // 33/s
    buffer.enter(clocks(at), 1);
    CHECK(buffer.pass(buffer.next()) == 1);
  }
  const std::int64_t stands = buffer.next();
  CHECK(buffer.pass(stands) == 0);
  buffer.enter(stands + 10, -1);
  double rate = c.start;
  const double t = next_pulse(rate, c.rise, std::sqrt(c.brake * c.brake + 2 * c.rise));
  CHECK(static_cast<double>(buffer.next() - stands - 10) * kOwnClockS ==
        Approx(c.dead_s + t).margin(2e-6));
  CHECK(buffer.pass(buffer.next()) == -1);
}

TEST_CASE("pulse_buffer: it tells the lower of its rate and that of the pulses, in their sense") {
  for (const int sense : {1, -1}) {
    for (const std::int64_t gap : {clocks(1e-3), clocks(4e-3)}) {
      PulseBuffer buffer(own());
      std::int64_t entered = 0;
      std::int64_t comes = 0, last = gap;
      for (int left = 0; left < 20;) {
        if (comes <= buffer.next()) {
          buffer.enter(comes, sense);
          last = ++entered < 12 ? gap : 2 * gap;  // then slower ones
          comes += last;
        } else {
          left += buffer.pass(buffer.next()) == 0 ? 0 : 1;
        }
        if (left == 0) CHECK(buffer.rate() == 0);
        if (left == 0 || buffer.waiting() == 0) continue;
        CAPTURE(sense, gap, left);
        const double incoming = 1 / (static_cast<double>(entered > 12 ? last : gap) * kOwnClockS);
        REQUIRE(sense * buffer.rate() >= std::min(200.0, incoming / 2));  // the first rate
        REQUIRE(sense * buffer.rate() <= incoming * (1 + 1e-9));
        const double most = static_cast<double>(entered) + 1;  // that may wait
        REQUIRE(sense * buffer.rate() <= std::sqrt(300.0 * 300 + 2 * 5000 * most));
      }
    }
  }
}

TEST_CASE("pulse_buffer: behind a flush it is as it was new, whatever came and left before") {
  for (const double gap_s : {0.2e-3, 1e-3, 20e-3}) {
    for (int left = 0; left <= 5; ++left) {
      CAPTURE(gap_s, left);
      PulseBuffer flushed(own()), fresh(own());
      for (int k = 0; k < 5; ++k) {
        while (flushed.next() < clocks(gap_s) * k) flushed.pass(flushed.next());
        flushed.enter(clocks(gap_s) * k, 1);
      }
      for (int k = 0; k < left && flushed.waiting() > 0; ++k) flushed.pass(flushed.next());
      REQUIRE(flushed.next() != PulseBuffer::kNever);  // it waits to stand at least
      flushed.flush();
      CHECK(flushed.next() == PulseBuffer::kNever);
      CHECK(flushed.rate() == 0);
      const std::int64_t later = clocks(0.2);
      for (PulseBuffer* buffer : {&flushed, &fresh}) buffer->enter(later, -1);
      CHECK(flushed.next() == fresh.next());
      for (PulseBuffer* buffer : {&flushed, &fresh}) {
        for (int k = 1; k < 4; ++k) buffer->enter(later + 100 * k, -1);
      }
      for (int k = 0; k < 5; ++k) {
        CAPTURE(k);
        CHECK(flushed.next() == fresh.next());
        CHECK(flushed.pass(flushed.next()) == fresh.pass(fresh.next()));
        CHECK(flushed.rate() == fresh.rate());
      }
    }
  }
}
