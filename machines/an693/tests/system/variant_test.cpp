// SPDX-License-Identifier: Apache-2.0
//
// The variants of the part: LM628 or LM629, converters of 8 and 12 bits, 6 and 8 MHz, filters that
// wrap. Each is the same in RTL, twin and SystemC.

#include <catch2/catch.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "machines/an693/machine_members.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/wirings.hpp"

using namespace trammel;
using namespace trammel::an693;
using lm628::PartOptions;
using lm628::Variant;

namespace {

// A move of 100 counts in 0.08 s or, at 6 MHz, in 0.1 s.
Options short_move(const PartOptions& part) {
  Options options;
  options.run.platform = cosim::Platform::kDirect;
  options.part = part;
  options.filter.kp = 50;
  options.filter.kd = 1000;
  options.filter.interval = 4;
  options.acceleration = 300;
  options.velocity = 60000;
  options.position = 100;
  options.wait_s = 0.03;
  return options;
}

Result run(const Options& options, cosim::Engine engine = cosim::Engine::kRtl) {
  Options same = options;
  same.run.engine = engine;
  return simulate(same, {});
}

int wrapped(std::int64_t value) { return static_cast<std::int16_t>(value); }
int saturated(std::int64_t value) {
  return static_cast<int>(std::clamp<std::int64_t>(value, -32767, 32767));
}

}  // namespace

TEST_CASE("an693: each variant reaches its target, with the same events in RTL, twin and SystemC") {
  for (const Variant variant : {Variant::kLm628, Variant::kLm629}) {
    for (const int dac_bits : {8, 12}) {
      for (const int clock_MHz : {6, 8}) {
        for (const bool wrap : {false, true}) {
          CAPTURE(variant, dac_bits, clock_MHz, wrap);
          Options options = short_move({variant, dac_bits, clock_MHz, wrap});
          Result chip = run(options);
          REQUIRE(chip.end == cosim::EndReason::kDone);
          CHECK(chip.desired == 100);
          CHECK(std::abs(chip.real - 100) <= 5);
          CHECK(test::figure(options, chip, "motion.samples") == 296);
          CHECK(test::figure(options, chip, "motion.time_s") ==
                Approx(296 * 2048 / (clock_MHz * 1e6)));
          CHECK(run(options, cosim::Engine::kTwin).event_hash == chip.event_hash);
          options.run.platform = cosim::Platform::kSystemC;
          CHECK(run(options).event_hash == chip.event_hash);
        }
      }
    }
  }
}

TEST_CASE("an693: a sample of 6 MHz takes 341.33 us, one of 8 MHz 256 us") {
  for (const int clock_MHz : {6, 8}) {
    const Result result = run(short_move({Variant::kLm628, 12, clock_MHz, false}));
    const std::size_t count = result.samples.size();
    REQUIRE(count > 300);
    const Sample first = result.samples[0], last = result.samples[count - 1];
    const auto clocks = static_cast<double>(last.edge - first.edge);
    CHECK(std::abs(clocks - static_cast<double>(count - 1) * 102400 / clock_MHz) < 1);
  }
}

TEST_CASE("an693: an LM629 gives its motor |u / 256| / 128 of the supply, on the mean") {
  for (const int clock_MHz : {6, 8}) {
    const Options options = short_move({Variant::kLm629, 12, clock_MHz, false});
    const Result result = run(options);
    // At 6 MHz a pulse is less than a clock too short, and so is the last period of a sample.
    const double most = clock_MHz == 8 ? 1e-9 : 24 * 8 / 17066.0;
    int forward = 0, backward = 0;
    for (std::size_t k = 1; k < result.samples.size(); ++k) {
      CAPTURE(clock_MHz, k);
      const Sample before = result.samples[k - 1], sample = result.samples[k];
      const int top = std::max(-127, before.words.output >> 8);
      REQUIRE(std::abs(sample.volt - top * 24.0 / 128) <= most);
      forward += top > 0 ? 1 : 0;
      backward += top < 0 ? 1 : 0;
    }
    CHECK(forward > 20);
    CHECK(backward > 5);
  }
}

TEST_CASE("an693: a filter that wraps gives the lower 16 bits of its sum, else it saturates") {
  for (const bool wrap : {false, true}) {
    Options options = short_move({Variant::kLm628, 12, 8, wrap});
    options.program = sw::An693Program::kTuning;
    options.acceleration = options.velocity = 0x3FFFFFFF;
    options.position = 800;
    options.steps = 2;
    options.run.max_s = 0.08;
    const Result result = run(options);
    int beyond = 0;
    for (const Sample& sample : result.samples) {
      const lm628::Words& w = sample.words;
      if ((w.status & sw::lm628_status::kMotorOff) != 0) continue;
      const std::int64_t p = w.proportional, d = w.derivative;
      CAPTURE(wrap, sample.edge, p, d);
      REQUIRE(w.output == (wrap ? wrapped(p + d) : saturated(saturated(p) + saturated(d))));
      beyond += std::abs(p + d) > 32767 ? 1 : 0;
    }
    CHECK(beyond > 10);
    CHECK(run(options, cosim::Engine::kTwin).event_hash == result.event_hash);
  }
}

TEST_CASE("an693: an LM629 of 6 MHz gives one record in every wiring, and watched in every way") {
  Options options = short_move({Variant::kLm629, 12, 6, true});
  options.run.max_s = 0.02;
  REQUIRE(test::check_wirings(options).samples.size() > 50);
  test::check_watched(options, 97 * 20e-9, 2503 * 20e-9);
}

TEST_CASE("an693: the drive of an LM629 is off when its pulses have ended, not between two") {
  Options options = short_move({Variant::kLm629, 12, 8, false});
  options.position = 8 * options.plant.counts;
  options.velocity = 600000;
  options.index_check = true;
  options.fault.kind = cosim::FaultKind::kEncoderMissing;
  options.fault.begin_s = 0.04;
  const Result result = run(options, cosim::Engine::kTwin);
  const cosim::FaultReport& report = result.fault_report;
  REQUIRE(report.by == "an index is not a turn from the one before");
  REQUIRE(report.off != cosim::kNever);
  int seen = 0, off = 0;  // output of the filter when the fault was seen, and as the drive was off
  for (const Sample& sample : result.samples) {
    if (sample.edge <= report.detected) seen = sample.words.output;
    if (sample.edge <= report.off) off = sample.words.output;
  }
  INFO("seen in clock " << report.detected << " at output " << seen << ", off in " << report.off);
  REQUIRE(seen >> 8 != 0);
  CHECK(off >> 8 == 0);
}

TEST_CASE("an693: a bridge whose pins or supply fail does the same in the twin") {
  for (const auto& [kind, line, value] :
       {std::tuple{cosim::FaultKind::kOutputStuck, lm628::kMagnitude, 0},
        {cosim::FaultKind::kOutputStuck, lm628::kSign, 1},
        {cosim::FaultKind::kSupplyDip, 0, 20}}) {
    Options options = short_move({Variant::kLm629, 12, 8, false});
    options.error_limit = 40;
    options.fault.kind = kind;
    options.fault.line = line;
    options.fault.value = value;
    options.fault.begin_s = 0.04;
    const Result chip = run(options), twin = run(options, cosim::Engine::kTwin);
    CAPTURE(static_cast<int>(kind), line);
    CHECK(chip.event_hash == twin.event_hash);
    CHECK(chip.end == twin.end);
    CHECK(chip.fault_report.off == twin.fault_report.off);
    if (chip.end == cosim::EndReason::kFault) CHECK(chip.fault_report.off != cosim::kNever);
  }
}
