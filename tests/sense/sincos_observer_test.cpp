// SPDX-License-Identifier: Apache-2.0
//
// The RTL beside its twin; and the twin on a sensor: acceptance tests G-01 and G-02, accuracy, and
// long motions in which no period may be lost.
#include <Vsincos_observer.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "models/exact/sense/sincos_observer.hpp"
#include "tests/sense/observer_bench.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/stripe_sensor.hpp"

using trammel::exact::Calibration;
using trammel::exact::SincosObserver;
using namespace trammel::test;

namespace {

struct Bench {
  Rtl<Vsincos_observer> rtl;
  SincosObserver twin;
  Calibration calib = ideal_calibration();

  Bench() {
    put({});
    rtl.reset();
  }
  void put(const SincosObserver::In& in) {
    rtl->tick_i = in.tick;
    rtl->restart_i = in.restart;
    rtl->active_i = in.active;
    rtl->velocity_i = in.velocity;
    rtl->ask_i = in.ask;
    rtl->sample_i = in.sample;
    rtl->channel_i = static_cast<std::uint8_t>(in.channel);
    rtl->code_i = static_cast<std::uint16_t>(in.code);
    rtl.eval();
    rtl->calib_i = calib.words[std::min<std::size_t>(rtl->calib_addr_o, 62)];
    rtl.eval();
  }
  std::optional<std::uint32_t> clock(const SincosObserver::In& in) {
    put(in);
    const std::optional<std::uint32_t> asked = twin.asked(in);
    REQUIRE(bool(rtl->asked_o) == asked.has_value());
    if (asked) REQUIRE(rtl->channel_o == *asked);
    REQUIRE(bool(rtl->busy_o) == twin.busy());
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    twin.step(in, calib);
    rtl.tick();
    REQUIRE(static_cast<std::int32_t>(rtl->position_o) == twin.out().position);
    REQUIRE(rtl->velocity_o == (static_cast<std::uint32_t>(twin.out().velocity) & 0x7FFFFF));
    REQUIRE(rtl->phase_o == twin.out().phase);
    REQUIRE(rtl->region_o == twin.out().region);
    REQUIRE(bool(rtl->known_o) == twin.out().known);
    return asked;
  }
  void restart() {
    SincosObserver::In in;
    in.restart = true;
    clock(in);
  }
  void rest(SincosObserver::In in, Random& random) {
    in.ask = in.sample = false;
    do {
      in.tick = random() % 16 == 0;
      clock(in);
    } while (twin.busy());
  }
};

// A random word of calibration that does not leave all behaviour behind: most are near the ideal.
std::uint16_t disturbed(std::uint16_t word, Random& random) {
  if (random() % 4 == 0) return static_cast<std::uint16_t>(random());
  return static_cast<std::uint16_t>(word + random() % 64 - 32);
}

}  // namespace

TEST_CASE("sincos_observer agrees with its twin for any codes, calibration and order of asking") {
  Bench bench;
  Random random(19);
  for (int round = 0; round < 400; ++round) {
    bench.restart();
    SincosObserver::In in;
    bench.calib = ideal_calibration();
    for (unsigned n = round % 4 == 0 ? 0 : random() % 12; n > 0; --n) {
      auto& word = bench.calib.words[4 + random() % 58];
      word = disturbed(word, random);
    }
    if (round % 3 == 0) bench.calib.words[30] = 1;
    if (round % 5 == 0) bench.calib.words[61] = static_cast<std::uint16_t>(random() % 48 - 8);
    in.active = round % 16 != 7;
    in.velocity = round % 8 != 3;
    for (int k = 0; k < 60; ++k) {
      in.tick = random() % 2 == 0;
      in.ask = random() % 3 == 0;
      in.sample = !in.ask && random() % 2 == 0;
      in.channel = random() % 8 == 0 ? random() % 8 : random() % 4;
      in.code = random() % 4 == 0 ? random() % 2 * 1023 : random() % 1024;
      bench.clock(in);
      bench.rest(in, random);
    }
  }
}

TEST_CASE("sincos_observer starts in the quarter of the larger of A and B, however near they are") {
  Bench bench;
  Random random(30);
  for (int k = 0; k < 8000; ++k) {
    bench.restart();
    SincosObserver::In in;
    in.active = true;
    if (k % 100 == 0) {
      for (const std::size_t origin : {4u, 5u}) {
        const std::uint32_t any = k % 400 == 0 ? 512 : random() % 1024;
        bench.calib.words[origin] = static_cast<std::uint16_t>(any);
      }
    }
    const int by = static_cast<int>(random() % 512), near = by + static_cast<int>(random() % 3) - 1;
    const bool b_first = random() % 2 == 0;
    for (const bool b : {b_first, !b_first}) {
      const int off = (random() % 2 == 0 ? 1 : -1) * (b ? near : by);
      in.sample = true;
      in.channel = b ? 2 : 0;
      in.code = static_cast<std::uint32_t>(std::clamp(bench.calib.words[b ? 5 : 4] + off, 0, 1023));
      bench.clock(in);
      bench.rest(in, random);
    }
    in.sample = false;
    in.ask = true;
    bench.clock(in);
    bench.rest(in, random);
    REQUIRE(bench.rtl->known_o == 1);
  }
}

TEST_CASE("sincos_observer takes a derivative up to its limits, and asks for it where it may") {
  Bench bench;
  Random random(31);
  for (int k = 0; k < 6000; ++k) {
    SincosObserver::In in;
    if (k % 40 == 0) {
      bench.restart();
      bench.calib = ideal_calibration();
      for (const std::size_t limit : {33u, 34u, 35u, 36u}) {
        if (k % 80 == 0) bench.calib.words[limit] = static_cast<std::uint16_t>(random() % 1024);
      }
    }
    in.active = true;
    in.velocity = random() % 4 != 0;
    in.sample = true;
    for (const std::uint32_t channel : {0u, 2u, 0u, 1u, 2u, 3u}) {
      const std::size_t limit = 33 + (channel == 3 ? 1 : 0) + random() % 2 * 2;
      const int edge = bench.calib.words[limit] + static_cast<int>(random() % 3) - 1;
      in.channel = channel;
      in.code = channel % 2 == 0 ? random() % 1024
                                 : static_cast<std::uint32_t>(std::clamp(edge, 0, 1023));
      in.sample = true;
      bench.clock(in);
      bench.rest(in, random);
      in.sample = false;
      in.ask = true;
      bench.clock(in);
      bench.rest(in, random);
      in.ask = false;
    }
  }
}

TEST_CASE("sincos_observer's answer to an ask and its results come as late as it says") {
  Bench bench;
  SincosObserver::In in;
  in.active = in.velocity = true;
  const auto busy = [&](bool sample, std::uint32_t channel, std::uint32_t code) {
    in.sample = sample;
    in.ask = !sample;
    in.channel = channel;
    in.code = code;
    bench.clock(in);
    in.sample = in.ask = false;
    int clocks = 0;
    for (; bench.twin.busy(); ++clocks) bench.clock(in);
    return clocks;
  };
  CHECK(busy(true, 0, 912) == 0);
  CHECK(busy(true, 2, 512) == 2);
  CHECK(bench.rtl->known_o == 1);
  CHECK(busy(false, 0, 0) == 4);     // region 0
  CHECK(busy(true, 2, 600) == 6);
  CHECK(busy(false, 0, 0) == 0);     // its derivative
  CHECK(busy(true, 3, 600) == 11);
  CHECK(busy(true, 3, 1020) == 4);   // saturated
}

TEST_CASE("sincos_observer finds the quarter at any phase, and then the phase itself") {
  for (int phase = 0; phase < 16384; phase += 37) {
    const double x = phase * kUnit_mm;
    ObserverTrack track;
    for (int k = 0; k < 6; ++k) track.tick(x, 0);
    double off = track.position_mm() - x;
    if (off < -kPeriod_mm / 2) off += kPeriod_mm;  // the nearest of its periods to 0
    CHECK(std::fabs(off) < 0.004);
  }
}

TEST_CASE("sincos_observer: the cubic is off by 8 units within its region, 2.4 um") {
  const Calibration c = ideal_calibration();
  const StripeSensor sensor;
  int worst = 0;
  for (int phase = 0; phase < 16384; ++phase) {
    const std::size_t region = SincosObserver::region(phase, c);
    std::size_t wanted = phase < 14336 ? 3 : 0;
    if (phase < 10240) wanted = phase <= 2048 ? 0 : phase <= 6144 ? 1 : 2;
    CHECK(region == wanted);
    const int code = sensor.code(region % 2 == 0 ? 2 : 0, phase * kUnit_mm, 0);
    int off = SincosObserver::phase(static_cast<std::uint32_t>(code), region, c) - phase;
    off = (off + 8192 + 16384) % 16384 - 8192;
    worst = std::max(worst, std::abs(off));
  }
  CHECK(worst <= 8 + 2);  // 8 as measured at whole codes of region 0
}

TEST_CASE("G-01 470 mm there and back: within 4 um at 20 mm/s, 20 um at 200, no period lost") {
  for (const auto& [speed, bound_mm] : {std::pair{20.0, 0.004}, std::pair{200.0, 0.02}}) {
    ObserverTrack track;
    double x = 1, worst = 0;
    for (int k = 0; k < 8; ++k) track.tick(x, 0);
    for (const double v : {speed, -speed}) {
      track.tick(x, v);
      track.tick(x, v);
      std::int32_t before = track.out().position;
      for (const double end = x + v * 470 / speed; (end - x) * v > 0; x += v * kTick_s) {
        track.tick(x, v);
        if (!track.is_encoder) continue;
        worst = std::max(worst, std::fabs(track.position_mm() - track.x_sampled));
        // At the seam of two regions it may stand still.
        CHECK((track.out().position - before) * v > -8 * std::fabs(v));
        before = track.out().position;
      }
    }
    CHECK(worst < bound_mm);
  }
}

// A new code is read by the cubic of the region that the code before was in, two ticks earlier: at
// 200 mm/s up to 284 units beyond the seam, where the cubic bends away. That is no latency, for the
// position is compared with that at the sample; its age comes on top.
TEST_CASE("position at any speed: 4 um in the region of the code before, more behind its seam") {
  for (const auto& [speed, beyond_um] : {std::pair{20.0, 4.0}, std::pair{50.0, 4.0},
                                         std::pair{200.0, 9.0}, std::pair{467.0, 30.0}}) {
    ObserverTrack track;
    double x = 1, inside = 0, beyond = 0, aged = 0;
    for (int k = 0; k < 8; ++k) track.tick(x, 0);
    for (const double v : {speed, -speed}) {
      track.tick(x, v);
      track.tick(x, v);
      for (const double end = x + v * 470 / speed; (end - x) * v > 0; x += v * kTick_s) {
        const std::size_t before =
            SincosObserver::region(static_cast<int>(track.out().phase), track.calib);
        track.tick(x, v);
        aged = std::max(aged, 1e3 * std::fabs(track.position_mm() - x));
        if (!track.is_encoder) continue;
        const int phase = static_cast<int>(std::lround(x / kUnit_mm)) & 16383;
        const double off = 1e3 * std::fabs(track.position_mm() - x);
        const bool same = SincosObserver::region(phase, track.calib) == before;
        (same ? inside : beyond) = std::max(same ? inside : beyond, off);
      }
    }
    CAPTURE(speed, inside, beyond, aged);
    CHECK(inside < 4);
    CHECK(beyond < beyond_um);
    CHECK(aged > 1e3 * speed * kTick_s);  // a tick later it is that old
    if (speed < 100) continue;
    CHECK(beyond > 0.75 * beyond_um);
  }
}

TEST_CASE("G-02 velocity: 3 % and 5 % rms of the derivative at 20 mm/s, of the phase at 600") {
  for (const double v : {20.0, -20.0, 600.0, -600.0}) {
    ObserverTrack track;
    double x = 235, sum = 0, squares = 0;
    int analog = 0, numerical = 0;
    for (int k = 0; k < 4000; ++k, x += v * kTick_s) {
      track.tick(x, v);
      if (k < 50 || track.is_encoder) continue;
      const bool phase = (track.out().velocity & 1) != 0;
      ++(phase ? numerical : analog);
      if (phase != (std::fabs(v) > 500)) continue;
      sum += track.velocity_mm_s();
      squares += std::pow(track.velocity_mm_s() - v, 2);
    }
    if (std::fabs(v) < 500) {
      CHECK(numerical == 0);
      CHECK(sum / analog == Approx(v).epsilon(0.03));
      CHECK(std::sqrt(squares / analog) < 0.05 * std::fabs(v));
    } else {
      CHECK(numerical > analog);
      CHECK(sum / numerical == Approx(v).epsilon(0.03));
    }
  }
}

TEST_CASE("sincos_observer is within 20 um with 2 % of amplitude, offset and phase, once fitted") {
  StripeSensor sensor;
  sensor.amplitude_a = 408;
  sensor.amplitude_b = 392;
  sensor.offset_a = 8;
  sensor.offset_b = -8;
  sensor.phase_b = 0.02;
  for (const bool fit : {true, false}) {
    ObserverTrack track;
    track.sensor = sensor;
    if (fit) track.calib = fitted(sensor);
    double worst = 0;
    for (double x = 1; x < 100; x += 20 * kTick_s) {
      track.tick(x, 20);
      if (track.is_encoder && x > 2) worst = std::max(worst, std::fabs(track.position_mm() - x));
    }
    CHECK((worst < 0.02) == fit);
    if (fit) CHECK(worst < 0.006);
  }
}

namespace {

// Speeds of up to 1 m/s at random, reversed at once, between 0 and 470 mm.
struct Motion {
  Random random;
  double x = 235, v = 0;  // [mm, mm/s]
  int left = 0;           // ticks until the next speed

  void tick() {
    if (left-- == 0) {
      v = (static_cast<int>(random() % 2001) - 1000);
      if (random() % 4 == 0) v = v < 0 ? -1000 : 1000;
      left = 1 + static_cast<int>(random() % 400);
    }
    if (x < 0) v = std::fabs(v);
    if (x > 470) v = -std::fabs(v);
    x += v * kTick_s;
  }
};

}  // namespace

TEST_CASE("no period lost or added in 10 minutes of random speeds up to 1 m/s, by the twin") {
  for (const bool loaded : {false, true}) {
    ObserverTrack track;
    track.loaded = loaded;
    Motion motion{Random(20)};
    for (int k = 0; k < 8; ++k) track.tick(motion.x, 0);
    const double begin = track.position_mm() - motion.x;  // whole periods from the true position
    CHECK(std::fabs(begin - std::round(begin / kPeriod_mm) * kPeriod_mm) < 0.004);
    double worst = 0, travelled = 0;
    for (int k = 0; k < 600 * 4612; ++k) {
      motion.tick();
      track.tick(motion.x, motion.v);
      worst = std::max(worst, std::fabs(track.position_mm() - begin - track.x_sampled));
      travelled += std::fabs(motion.v) * kTick_s;
    }
    CHECK(worst < kPeriod_mm / 4);
    CHECK(travelled > 200'000);
    for (int k = 0; k < 8; ++k) track.tick(motion.x, 0);
    CHECK(track.position_mm() - begin == Approx(motion.x).margin(0.008));
  }
}
