// SPDX-License-Identifier: Apache-2.0
//
// The chip gantry_tau alone, each case beside its twin: acceptance tests G-01 to G-03 by the RTL,
// calibration data by commands, the line, and random traffic.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/chips/gantry_tau_bench.hpp"
#include "tests/support/checked.hpp"
#include "tests/support/random.hpp"
#include "tests/support/stripe_sensor.hpp"
#include "tests/support/traffic.hpp"

using trammel::test::GantryBench;
using trammel::test::ideal_calibration;
using trammel::test::kUnit_mm;
using trammel::test::Random;
using trammel::test::StripeSensor;
using trammel::test::trials;
namespace exact = trammel::exact;
using namespace trammel::gantry_tau_regs;

namespace {

constexpr double kClock_s = 20e-9;
constexpr std::int64_t kTickClk = 10842;

// A chip that observes a sensor in motion x(t), of which each code is remembered.
struct Track {
  exact::Calibration calib = ideal_calibration();
  StripeSensor sensor;
  GantryBench bench{&calib};
  double x = 0, v = 0;      // [mm, mm/s]
  double x_sampled = 0;     // at the last code of an encoder
  std::int64_t turned = 0;  // [clk] since x and v are those of this motion

  explicit Track(double begin_mm) : x(begin_mm) {
    bench.code = [this](int channel, std::int64_t clock) {
      const double now = at(clock);
      if (channel % 2 == 0) x_sampled = now;
      return sensor.code(channel, now, v);
    };
    bench.put(kObserver, 0x11);
    bench.clocks(6 * kTickClk);
  }
  double at(std::int64_t clock) const {
    return x + v * static_cast<double>(clock - turned) * kClock_s;
  }
  void move(double speed) {
    x = at(bench.now());
    turned = bench.now();
    v = speed;
  }
  double position() const { return bench.twin().observed().position * kUnit_mm; }
};

}  // namespace

TEST_CASE("gantry_tau reads its calibration after reset, then observes when asked to") {
  const exact::Calibration calib = ideal_calibration();
  GantryBench bench(&calib);
  CHECK(bench.get(kId) == kIdValue);
  CHECK(bench.get(kCalibration) == kCalibrationValid);
  CHECK(bench.get(kStatus) == 0);
  const StripeSensor sensor;
  bench.code = [&](int channel, std::int64_t) { return sensor.code(channel, 1.7, 0); };
  bench.put(kObserver, 0x11);
  bench.clocks(6 * kTickClk);
  CHECK((bench.get(kAngle) & kAngleKnown) != 0);
  const double x = static_cast<std::int32_t>(bench.get(kPosition)) * kUnit_mm;
  CHECK(x == Approx(1.7).margin(0.0026));
  CHECK(bench.get(kVelocity) == 0);
  CHECK(bench.get(kTicks) == 6);
}

TEST_CASE("G-01 sweeps by the RTL: within 0.02 mm, no period lost, both directions") {
  // 4 um is what the cubic is off within its region, which at 200 mm/s a sample leaves by 0.09 mm.
  for (const auto& [speed_mm_s, bound_mm] : {std::pair{20.0, 0.004}, std::pair{200.0, 0.02}}) {
    Track track(1);
    double worst = 0;
    std::int32_t before = track.bench.twin().observed().position;
    int moved = 0;
    for (const double speed : {speed_mm_s, -speed_mm_s}) {
      track.move(speed);
      track.bench.clocks(2 * kTickClk);
      before = track.bench.twin().observed().position;
      track.bench.watch = [&, speed] {
        const std::int32_t now = track.bench.twin().observed().position;
        if (now == before) return;
        moved += (now - before) * speed > 0 ? 1 : -1'000'000;
        before = now;
        worst = std::max(worst, std::fabs(track.position() - track.x_sampled));
      };
      track.bench.clocks(1000 * kTickClk);
      track.bench.watch = nullptr;
    }
    CHECK(moved >= 990);
    CHECK(worst < bound_mm);
  }
}

TEST_CASE("G-02 velocity by the RTL: of the derivative at 20 mm/s, mostly of the phase at 600") {
  for (const double speed : {20.0, 600.0, -600.0}) {
    Track track(1);
    track.move(speed);
    track.bench.clocks(50 * kTickClk);
    double sum = 0, squares = 0;
    int numerical = 0, analog = 0;
    for (int k = 0; k < 600; ++k) {
      track.bench.clocks(kTickClk);
      const auto velocity = static_cast<std::int32_t>(track.bench.get(kVelocity));
      const double mm_s = velocity * kUnit_mm / 512 / trammel::test::kTick_s;
      const bool phase = (velocity & 1) != 0;
      (phase ? numerical : analog) += 1;
      if (phase != (std::fabs(speed) > 500)) continue;
      sum += mm_s;
      squares += (mm_s - speed) * (mm_s - speed);
    }
    if (speed == 20) {
      CHECK(numerical == 0);
      CHECK(sum / analog == Approx(20).epsilon(0.03));
      CHECK(std::sqrt(squares / analog) < 0.05 * 20);
    } else {
      CHECK(numerical > 300);
      CHECK(sum / numerical == Approx(speed).epsilon(0.03));
    }
  }
}

TEST_CASE("G-03 the bytes of the examples, and values of every length there and back") {
  GantryBench bench;
  const auto send = [&](std::uint32_t channel, std::uint32_t value) {
    bench.put(kSendValue, value);
    bench.put(kSend, 4u << 8 | channel);
    const std::size_t before = bench.from_chip.size();
    REQUIRE(bench.until([&] { return (bench.twin().serial().idle()); }, 100 * 4340));
    return std::vector<std::uint8_t>(bench.from_chip.begin() + static_cast<std::ptrdiff_t>(before),
                                     bench.from_chip.end());
  };
  using Bytes = std::vector<std::uint8_t>;
  CHECK(send(9, 42) == Bytes{0x8A, 0x49});
  CHECK(send(21, 305) == Bytes{0xCC, 0x35});
  CHECK(send(22, 170000) == Bytes{0x82, 0xCC, 0x84, 0x16});
  const std::array<std::pair<std::uint32_t, std::size_t>, 6> lengths{
      {{0, 2}, {511, 2}, {512, 3}, {1u << 16, 4}, {1u << 23, 5}, {0xFFFFFFFF, 6}}};
  for (const auto& [value, length] : lengths) {
    const Bytes bytes = send(17, value);
    CHECK(bytes.size() == length);
    bench.to_chip.insert(bench.to_chip.end(), bytes.begin(), bytes.end());
    REQUIRE(bench.until([&] { return bench.twin().serial().in().waits(); }, 2'000'000));
    CHECK(bench.get(kReceive) == (kReceiveWaits | 4u << 8 | 17u));
    CHECK(bench.get(kReceiveValue) == value);
    bench.put(kReceive, kReceiveTake);
    CHECK(bench.get(kReceive) == 0);
  }
  CHECK(bench.get(kReceiveErrors) == 0);
}

TEST_CASE("no period lost or added in 10 s of random speeds up to 1 m/s, by the RTL") {
  Track track(235);
  const double begin = track.position() - track.x;  // whole periods from the true position
  Random random(24);
  double worst = 0;
  track.bench.watch = [&] {
    const auto adc = track.bench.twin().adc();
    if (!adc.valid || adc.channel % 2 != 0) return;
    worst = std::max(worst, std::fabs(track.position() - begin - track.x_sampled));
  };
  for (const std::int64_t end = track.bench.now() + trials(500'000'000); track.bench.now() < end;) {
    const double x = track.at(track.bench.now());
    double speed = static_cast<int>(random() % 2001) - 1000;
    if (random() % 4 == 0) speed = speed < 0 ? -1000 : 1000;
    if (x < 60) speed = std::fabs(speed);
    if (x > 410) speed = -std::fabs(speed);
    track.move(speed);
    track.bench.clocks(1 + random() % 3'000'000);
    if (random() % 4 == 0) track.bench.put(kRequest, kRequestCurrent);
  }
  // Of a code, against the position that the one before gave: 2 or 3 ticks at 1 m/s.
  CHECK(worst < trammel::test::kPeriod_mm / 3);
  track.move(0);
  track.bench.clocks(8 * kTickClk);
  CHECK(track.position() - begin == Approx(track.x).margin(0.008));
}

TEST_CASE("gantry_tau drops what is malformed, counts it, and takes the next good frame") {
  GantryBench bench;
  const std::vector<std::uint8_t> bytes{0x84, 0x80, 0x80, 0x80, 0x80, 0x05,        // above 32 bits
                                        0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x05,  // 6 leading
                                        0x8A, 0x49};
  bench.to_chip.assign(bytes.begin(), bytes.end());
  REQUIRE(bench.until([&] { return bench.twin().serial().in().waits(); }, 3'000'000));
  CHECK(bench.get(kReceiveErrors) == 2);
  CHECK(bench.get(kReceiveValue) == 42);
  CHECK(bench.get(kStatus) == (kStatusFrame | kStatusRefused));  // an empty store
}

namespace {

void load(GantryBench& bench, const exact::Calibration& calib) {
  bench.put(kCalibrate, 1u << 16);
  for (const std::uint16_t word : calib.words) bench.put(kCalibrate, 2u << 16 | word);
}

}  // namespace

TEST_CASE("gantry_tau refuses calibration data with a wrong checksum and keeps the previous") {
  const exact::Calibration good = ideal_calibration();
  GantryBench bench(&good);
  exact::Calibration other = good;
  other.words[14] = 100;
  load(bench, other);  // with the checksum of the other
  bench.put(kCalibrate, 7u << 16);
  bench.clocks(300);
  CHECK(bench.get(kStatus) == kStatusRefused);
  CHECK(bench.get(kCalibration) == (kCalibrationValid | 63u << 8));
  CHECK(bench.twin().calibration().data().words == good.words);
  CHECK(std::equal(good.words.begin(), good.words.end(), bench.store.begin()));
  bench.put(kStatus, kStatusRefused);
  load(bench, exact::sealed(other));
  bench.put(kCalibrate, 7u << 16);
  bench.clocks(300);
  CHECK(bench.get(kStatus) == kStatusStored);
  CHECK(bench.twin().calibration().data().words == exact::sealed(other).words);
  CHECK(bench.store[14] == 100);
  // A store of nothing new is refused as well; what is stored comes back after a reset.
  bench.put(kCalibrate, 7u << 16);
  CHECK(bench.get(kStatus) == (kStatusStored | kStatusRefused));
  bench.reset();
  bench.clocks(100);
  CHECK(bench.get(kCalibration) == kCalibrationValid);
  CHECK(bench.twin().calibration().data().words[14] == 100);
}

TEST_CASE("gantry_tau: calibration data are taken beside ticks and samples, not at their clocks") {
  Track track(1.7);
  GantryBench& bench = track.bench;
  constexpr std::int64_t kSample = 274;  // [clk] behind a tick, about
  for (std::int64_t n = 0; n < 24; ++n) {
    CAPTURE(n);
    load(bench, track.calib);
    const std::uint32_t ticks = bench.twin().ticks();
    REQUIRE(bench.until([&] { return bench.twin().ticks() != ticks; }, kTickClk + 1));
    bench.clocks(kTickClk - 14 + (n < 12 ? n : n - 12 + kSample));
    bench.put(kCalibrate, 7u << 16);
    bench.clocks(700);
    CHECK((bench.get(kStatus) & (kStatusStored | kStatusRefused)) == kStatusStored);
    bench.put(kStatus, kStatusStored);
  }
}

TEST_CASE("gantry_tau with an empty store does not observe, and serves the requester alone") {
  GantryBench bench;
  bench.code = [](int channel, std::int64_t) { return 100 + channel; };
  bench.put(kObserver, 0x11);
  bench.put(kRequest, 0x4F);
  bench.clocks(6 * kTickClk);
  CHECK((bench.get(kAngle) & kAngleKnown) == 0);
  CHECK(bench.get(kRequest) == 0);
  CHECK(bench.get(kEncoderA) == (101u << 16 | 100u));
  CHECK(bench.get(kEncoderB) == (103u << 16 | 102u));
  CHECK(bench.get(kCurrent) == 106);
  CHECK((bench.get(kStatus) & kStatusSample) != 0);
}

TEST_CASE("gantry_tau interrupts each control pass, and tells of one that was missed") {
  GantryBench bench;
  bench.put(kIrqEnable, kIrqEnablePass);
  bench.put(kPassPeriod, 5000);
  std::int64_t first = 0;
  REQUIRE(bench.until([&] { return bench.twin().irq(); }, 6000));
  first = bench.now();
  bench.put(kStatus, ~0u);
  CHECK_FALSE(bench.twin().irq());
  REQUIRE(bench.until([&] { return bench.twin().irq(); }, 6000));
  CHECK(bench.now() - first == 5000);
  CHECK((bench.get(kStatus) & kStatusOverrun) == 0);
  bench.clocks(5000);
  CHECK((bench.get(kStatus) & kStatusOverrun) != 0);
  bench.put(kPassPeriod, 15);  // none
  bench.put(kStatus, ~0u);
  bench.clocks(20'000);
  CHECK_FALSE(bench.twin().irq());
}

TEST_CASE("gantry_tau: a pass every 16 clocks is the fastest, and none below") {
  GantryBench bench;
  for (const auto& [period, passes] : {std::pair{16u, 10}, {32u, 5}, {15u, 0}, {0u, 0}}) {
    bench.put(kPassPeriod, period);
    bench.clocks(10);
    int seen = 0;
    bench.watch = [&] { seen += bench.twin().pass(); };
    bench.clocks(160);
    bench.watch = nullptr;
    CAPTURE(period);
    CHECK(seen == passes);
  }
}

TEST_CASE("gantry_tau: no pass is lost, whichever clock its bit of STATUS is cleared in") {
  GantryBench bench;
  bench.put(kIrqEnable, kIrqEnablePass);
  bench.put(kPassPeriod, 64);
  int kept = 0;  // set again in the clock of the write
  for (int n = 0; n < 64; ++n) {
    REQUIRE(bench.until([&] { return bench.twin().pass(); }, 65));
    bench.clocks(n);
    bench.put(kStatus, kStatusPass | kStatusOverrun);
    kept += bench.twin().irq();
    CAPTURE(n);
    const std::int64_t left = 64 - n;
    bench.clocks(left > 8 ? left - 8 : left + 56);
  }
  CHECK(kept >= 1);
}

TEST_CASE("gantry_tau shows its over-temperature pins two clocks later") {
  GantryBench bench;
  for (const unsigned pins : {1u, 2u, 3u, 0u}) {
    bench.in.overtemp_i = static_cast<std::uint8_t>(pins);
    bench.clocks(3);
    CHECK(bench.get(kOvertemp) == pins);
  }
}

TEST_CASE("gantry_tau agrees with its twin on random traffic, leaping and not") {
  const trammel::test::Traffic traffic = trammel::test::traffic(1500, 23);
  Random random(traffic.seed);
  const exact::Calibration calib = ideal_calibration();
  GantryBench bench(&calib);
  bench.code = [](int channel, std::int64_t clock) {
    return static_cast<int>((clock * 2654435761u >> 7 ^ channel * 77u) & 1023u);
  };
  bench.put(kObserver, 0x11);
  for (std::int64_t n = 0; n < traffic.transfers; ++n) {
    INFO("transfer " << n << "; " << traffic.until(n));
    bench.leaps = random() % 8 != 0;
    const auto pace = trammel::test::AxiPace::random(random, random() % 4 != 0);
    const std::uint32_t address = 4 * (random() % 26);
    std::uint32_t data = random();
    if (address == kPassPeriod && random() % 2 == 0) data &= 0x3FF;
    if (address == kCalibrate && random() % 8 != 0) data = (data & 0xFFFF) | 2u << 16;
    if (address == kObserver && random() % 16 != 0) continue;
    bench.transfer(address, data, random() % 3 != 0, pace);
    if (random() % 4 == 0) bench.in.overtemp_i = random() % 4;
    if (random() % 64 == 0) bench.nv_ready = !bench.nv_ready;
    if (random() % 8 == 0) bench.to_chip.push_back(static_cast<std::uint8_t>(random()));
    if (random() % 200 == 0) {
      exact::Calibration other = calib;
      for (int k = 0; k < 8; ++k) other.words[random() % 62] = static_cast<std::uint16_t>(random());
      load(bench, exact::sealed(other));
      bench.put(kCalibrate, 7u << 16);
    }
    if (random() % 3 == 0) bench.clocks(random() % (bench.leaps ? 60'000 : 1500));
    if (random() % 400 == 0) {
      bench.reset();
      bench.put(kObserver, 0x11);
    }
  }
  bench.nv_ready = true;
}
