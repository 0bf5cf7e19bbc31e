// SPDX-License-Identifier: Apache-2.0
//
// The whole machine mcafee: firmware, verilated chip, stage. Its behaviour is tested with the twin;
// here, that the chip and every wiring do the same.

#include <catch2/catch.hpp>

#include "machines/mcafee/machine_members.hpp"
#include "machines/mcafee/session.hpp"
#include "tests/support/event_record.hpp"
#include "tests/support/failed_assertion.hpp"
#include "tests/support/slope.hpp"
#include "tests/support/wirings.hpp"

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

TEST_CASE("mcafee: one record in every wiring, and watched in every way, at 6 and at 8 MHz") {
  for (const int clock_MHz : {6, 8}) {
    CAPTURE(clock_MHz);
    Options options = small_corner();
    options.clock_MHz = clock_MHz;
    options.filter = {255, 20, 3000, 500, 2};
    options.run.max_s = 0.03;  // the first rows
    const Result first = test::check_wirings(options);
    REQUIRE(first.samples.size() > 80);
    REQUIRE(first.samples.back().row > 0);
    CHECK(first.evaluated < first.clocks / 2);
    options.run.max_s = 0.02;
    test::check_watched(options, 97 * 20e-9, 5003 * 20e-9);
  }
}

TEST_CASE("mcafee: a failed assertion ends the run at the next sample") {
  Options options = small_corner();
  options.run.assertions = true;
  cosim::Hooks hooks;
  hooks.progress = [](double) { test::fail_assertion("mcafee_xy.u_x.u_lm628_props.kept"); };
  const Result result = simulate(options, hooks);
  CHECK(result.end == cosim::EndReason::kAssertion);
  REQUIRE(result.assertion);
  CHECK(result.assertion->instance == "mcafee_xy.u_x");
  CHECK(result.samples.size() == 65);
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

TEST_CASE("mcafee: parts of 8 MHz follow a table in 3/4 of the time") {
  Options options = small_corner();
  const Result slow = run(options);
  const double slow_s = slow.seconds(slow.clocks) - options.wait_s;
  options.clock_MHz = 8;
  const Result chip = run(options);
  REQUIRE(chip.end == cosim::EndReason::kDone);
  CHECK(chip.samples.back().row == chip.table.rows.size());
  CHECK(chip.seconds(chip.clocks) - options.wait_s == Approx(0.75 * slow_s).epsilon(0.05));
}
