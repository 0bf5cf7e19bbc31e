// SPDX-License-Identifier: Apache-2.0
//
// The whole machine mcafee: firmware, verilated chip, stage. Its behaviour is tested with the twin;
// here, that the chip and every wiring do the same.

#include <catch2/catch.hpp>
#include <filesystem>

#include "machines/mcafee/machine.hpp"
#include "machines/mcafee/session.hpp"
#include "tests/support/broken_promise.hpp"
#include "tests/support/event_record.hpp"
#include "tests/support/lm628_words.hpp"
#include "tests/support/slope.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

// Some rows around a small corner.
Options small_corner() {
  Options options;
  options.run.platform = cosim::Platform::kDirect;
  options.path.kind = PathKind::kCorner;
  options.path.side_mm = 2;
  options.path.radius_mm = 1;
  options.path.kappa_max_1_mm = 1;
  options.path.preview_rows = 2;
  options.wait_s = 0.02;
  return options;
}

Result run(const Options& options) { return simulate(options, {}); }

}  // namespace

TEST_CASE("mcafee: SystemC, direct wiring, any window, leapt or plain give the same events") {
  const Options options = small_corner();
  const Result result = run(options);
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(result.samples.back().row == result.table.rows.size());
  CHECK(result.evaluated < result.clocks / 2);
  Options other = options;
  other.run.window_clk = 313;
  CHECK(run(other).event_hash == result.event_hash);
  other = options;
  other.run.platform = cosim::Platform::kSystemC;
  CHECK(run(other).event_hash == result.event_hash);
  other = options;
  other.run.leap = false;
  CHECK(run(other).event_hash == result.event_hash);
  CHECK(run(other).evaluated >= result.clocks);
}

TEST_CASE("mcafee: audited, or with its assertions checked, it has the same events") {
  Options options = small_corner();
  options.run.max_s = 0.03;  // the first rows
  const Result base = run(options);
  REQUIRE(base.samples.size() > 80);
  REQUIRE(base.samples.back().row > 0);
  options.run.audit = true;
  const Result audited = run(options);
  CHECK_FALSE(audited.promise);
  CHECK(audited.evaluated == base.evaluated);
  CHECK(audited.event_hash == base.event_hash);
  options.run.audit = false;
  options.run.assertions = true;
  const Result checked = run(options);
  CHECK(checked.end == base.end);
  CHECK_FALSE(checked.promise);
  CHECK(checked.event_hash == base.event_hash);
}

TEST_CASE("mcafee: with waves it has the same events, and windows show them exactly") {
  Options options = small_corner();
  options.run.max_s = 0.03;
  const Result base = run(options);
  options.run.wave = cosim::WaveFormat::kFst;
  options.run.wave_file = "mcafee_machine_test.fst";
  Options every = options;
  every.run.wave_end_s = 97 * 20e-9;
  every.run.wave_every_s = 5003 * 20e-9;
  every.run.platform = cosim::Platform::kSystemC;
  for (const Options& shown : {options, every}) {
    const Result result = run(shown);
    std::filesystem::remove(shown.run.wave_file);
    CHECK_FALSE(result.promise);
    CHECK(result.waves.size() == (shown.run.wave_every_s > 0 ? 300 : 1));
    CHECK(result.event_hash == base.event_hash);
  }
}

TEST_CASE("mcafee: a failed assertion ends the run at the next sample") {
  Options options = small_corner();
  options.run.assertions = true;
  cosim::Hooks hooks;
  hooks.progress = [](double) { test::break_promise("mcafee_xy.u_x.u_lm628_props.kept"); };
  const Result result = simulate(options, hooks);
  CHECK(result.end == cosim::EndReason::kPromise);
  REQUIRE(result.promise);
  CHECK(result.promise->instance == "mcafee_xy.u_x");
  CHECK(result.samples.size() == 65);
}

TEST_CASE("mcafee: the twin gives the events of the chip") {
  Options options = small_corner();
  options.filter = {255, 20, 3000, 500, 2};
  const Result chip = run(options);
  options.run.engine = cosim::Engine::kTwin;
  const Result twin = run(options);
  REQUIRE(twin.samples.size() == chip.samples.size());
  for (std::size_t k = 0; k < chip.samples.size(); ++k) {
    CAPTURE(k, chip.samples[k].edge);
    REQUIRE(twin.samples[k].edge == chip.samples[k].edge);
    for (std::size_t a = 0; a < 2; ++a) {
      CAPTURE(a);
      const AxisSample t = twin.samples[k].axis[a], c = chip.samples[k].axis[a];
      test::require_same(t.words, c.words);
      REQUIRE(t.host_irq == c.host_irq);
    }
  }
  CHECK(twin.event_hash == chip.event_hash);
}

TEST_CASE("mcafee: the event hash is that of edges, reasons, codes, reads and positions") {
  Options options = small_corner();
  options.run.engine = cosim::Engine::kTwin;
  options.run.max_s = 0.03;
  const auto run = test::record_run<Session, Result>(options);
  test::check_event_hash(run, [&run](std::size_t n) {
    test::HashedWords words;
    const Sample sample = run.result.samples[n];
    for (const AxisSample& axis : sample.axis) {
      const lm628::Words& w = axis.words;
      words.emplace_back("desired position", static_cast<std::uint64_t>(w.position));
      words.emplace_back("actual position", static_cast<std::uint32_t>(w.actual));
    }
    return words;
  });
}

TEST_CASE("mcafee: the speeds of the record are the slopes of its places") {
  Options options = small_corner();
  options.run.engine = cosim::Engine::kTwin;
  const Result result = run(options);
  for (const std::size_t axis : {0, 1}) {
    test::require_slope(axis == 0 ? "X" : "Y", result.samples.size(), options.sample_s(),
                        [&](std::size_t k) {
                          const AxisSample s = result.samples[k].axis[axis];
                          return test::Motion{s.x_mm, s.mm_s};
                        });
  }
}

TEST_CASE("mcafee: over some turns the indexes are a turn apart, and a lost one is seen") {
  Options options = small_corner();
  options.run.engine = cosim::Engine::kTwin;
  options.stage = sw::McafeeStage::kMove;
  options.acceleration = 0x250;
  options.position = 16 * options.stage_axis.encoder.lines;
  options.index_check = true;
  Result result = run(options);
  CAPTURE(result.fault, result.real[0], result.real[1]);
  CHECK(result.end == cosim::EndReason::kDone);
  options.fault.kind = cosim::FaultKind::kIndexLost;
  result = run(options);
  CHECK(result.end == cosim::EndReason::kFault);
  CHECK(result.fault == "an index that is not a turn from the one before");
}

TEST_CASE("mcafee: each switch opens at its end of its axis, on the chip's line for it") {
  plant::LeadscrewConfig axis;
  axis.switch_low = -1e-3;
  axis.switch_high = 2e-3;
  for (const int part : {0, 1}) {
    for (const bool forward : {false, true}) {
      StagePlant plant({axis, axis});
      const cosim::Lines rest = kZeroCode << converter(1 - part);
      const cosim::Lines drive = rest | cosim::Lines{forward ? 0xFFu : 0u} << converter(part);
      plant.commit(0, drive);
      while (plant.limits() == 0 && plant.next() < 50'000'000) plant.commit(plant.next(), drive);
      CAPTURE(part, forward, plant.next());
      CHECK(plant.limits() == (forward ? 2u : 1u) << 2 * part);
      CHECK((plant.sense() >> (forward ? limit_high(part) : limit_low(part)) & 1) == 1);
      CHECK((plant.sense() >> limit_low(0) & 15) == plant.limits());
    }
  }
}

TEST_CASE("mcafee: the record ends with the switch that ended the run") {
  Options options = small_corner();
  options.run.engine = cosim::Engine::kTwin;
  options.stage = sw::McafeeStage::kMove;
  options.acceleration = 0x250;
  options.stage_axis.switch_high = 1e-3;
  const Result result = run(options);
  CHECK(result.end == cosim::EndReason::kFault);
  CHECK(result.fault == "a limit switch");
  const Sample last = result.samples.back();
  CAPTURE(last.axis[0].x_mm, last.axis[1].x_mm);
  CHECK(last.limits == 2);  // of X, high
  CHECK(last.axis[0].x_mm == Approx(1).margin(0.1));
}

TEST_CASE("F-05 Stage II moves the stage by 52 800 counts in 8.251 s") {
  Options options = small_corner();
  options.run.engine = cosim::Engine::kTwin;
  options.stage = sw::McafeeStage::kMove;
  options.acceleration = 0x25;
  const Result result = run(options);
  REQUIRE(result.end == cosim::EndReason::kDone);
  // Friction of 0.03 N m holds what kp = 255 makes of three counts.
  CHECK(std::abs(result.real[0] - 52'800) <= 3);
}

TEST_CASE("mcafee: parts of 8 MHz: one behaviour in RTL, twin, SystemC, in 3/4 of the time") {
  Options options = small_corner();
  const double slow_s = lab::seconds_of(run(options).clocks) - options.wait_s;
  options.clock_MHz = 8;
  const Result chip = run(options);
  REQUIRE(chip.end == cosim::EndReason::kDone);
  CHECK(chip.samples.back().row == chip.table.rows.size());
  CHECK(lab::seconds_of(chip.clocks) - options.wait_s == Approx(0.75 * slow_s).epsilon(0.05));
  Options other = options;
  other.run.engine = cosim::Engine::kTwin;
  CHECK(run(other).event_hash == chip.event_hash);
  other = options;
  other.run.platform = cosim::Platform::kSystemC;
  CHECK(run(other).event_hash == chip.event_hash);
}

TEST_CASE("mcafee: parts of 8 MHz, audited, checked or with waves, have the same events") {
  Options options = small_corner();
  options.clock_MHz = 8;
  options.run.max_s = 0.02;
  const Result base = run(options);
  REQUIRE(base.samples.size() > 60);
  Options audited = options, checked = options, shown = options;
  audited.run.audit = true;
  checked.run.assertions = true;
  shown.run.wave = cosim::WaveFormat::kFst;
  shown.run.wave_file = "mcafee_machine_test_8.fst";
  shown.run.wave_end_s = 97 * 20e-9;
  shown.run.wave_every_s = 5003 * 20e-9;
  for (const Options& one : {audited, checked, shown}) {
    const Result result = run(one);
    CHECK_FALSE(result.promise);
    CHECK(result.event_hash == base.event_hash);
  }
  std::filesystem::remove(shown.run.wave_file);
}
