// SPDX-License-Identifier: Apache-2.0
//
// The same run in every wiring and window gives the same events, edge by edge.
#include <catch2/catch.hpp>

#include "machines/kung/chip/record.hpp"
#include "tests/support/wirings.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

// A short piece of the circle: start-up and 40 points, 80 ms.
Options piece() {
  Options options;
  options.reached_m = 1;  // it ends while the table is still under way
  options.path.kind = PathKind::kLine;
  options.path.line_end_x_m = 0.11;
  options.path.line_end_y_m = 0.12;
  options.path.line_ticks = 40;
  return options;
}

// Ten points, for chips that evaluate every clock.
Options dash() {
  Options options = piece();
  options.run.platform = Platform::kDirect;
  options.path.line_end_x_m = 0.101;
  options.path.line_end_y_m = 0.1005;
  options.path.line_ticks = 10;
  return options;
}

Result run(Platform platform, std::int64_t window) {
  Options options = piece();
  options.run.platform = platform;
  options.run.window_clk = window;
  return simulate(options, {});
}

}  // namespace

TEST_CASE("every wiring and every way to watch gives one record") {
  const Result first = test::check_wirings(dash());
  REQUIRE(first.end == EndReason::kDone);
  CHECK(first.evaluated < first.clocks / 3);
  test::check_watched(dash(), 97 * 20e-9, 5003 * 20e-9);
}

TEST_CASE("SystemC with look-ahead gives the event log of direct wiring in windows of any length") {
  const Result systemc = run(Platform::kSystemC, 0);
  REQUIRE(systemc.end == EndReason::kDone);
  REQUIRE(systemc.samples.size() > 160);
  for (const std::int64_t window : {0, 313}) {
    CHECK(run(Platform::kDirect, window).event_hash == systemc.event_hash);
  }
}

TEST_CASE("clock domains one by one have the events of all of them together") {
  Options options = piece();
  const Result awake = simulate(options, {});
  options.run.domains = false;
  const Result all = simulate(options, {});
  CHECK(all.event_hash == awake.event_hash);
  CHECK_FALSE(awake.activity.empty());
  CHECK(all.activity.empty());
}

TEST_CASE("every evaluated clock has its cause") {
  const Result result = run(Platform::kDirect, 0);
  std::int64_t sum = 0;
  for (const auto count : result.wakes) sum += count;
  CHECK(sum == result.evaluated);
  for (std::size_t n = 0; n < kWakes; ++n) {
    // A leap of a chip whose timers lag is no evaluation.
    CHECK((result.wakes[n] > 0) == (static_cast<Wake>(n) != Wake::kLeap));
  }
  CHECK(result.wakes[static_cast<std::size_t>(Wake::kTick)] >= 2 * result.clocks / 25000 / 3);
}

TEST_CASE("the event log sees a change of one clock of dead time") {
  const Result base = run(Platform::kDirect, 0);
  Options options = piece();
  options.run.platform = Platform::kDirect;
  options.chip.axis[1].dead_time_ns += 20;
  CHECK(simulate(options, {}).event_hash != base.event_hash);
}

TEST_CASE("a sample's tick is what the TICK register reads, and ticks are 25000 clocks apart") {
  const Result result = run(Platform::kDirect, 0);
  for (std::size_t k = 1; k < result.samples.size(); ++k) {
    REQUIRE(result.samples[k].tick == result.samples[k - 1].tick + 1);
    REQUIRE(result.samples[k].edge - result.samples[k - 1].edge == 25000);
  }
  // Point 0 takes effect at first_tick: up to there the command stands still at the start.
  REQUIRE(result.first_tick > 0);
  const auto at = [&](std::uint32_t tick) { return result.samples[tick - result.samples[0].tick]; };
  CHECK(at(result.first_tick).axis[0].r == 20000);
  CHECK(at(result.first_tick + 3).axis[0].r == 20000);
  CHECK(at(result.first_tick + 4).axis[0].r == 20050);
  CHECK(at(result.end_tick - 1).axis[0].r == 22000);
}
