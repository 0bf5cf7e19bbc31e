// SPDX-License-Identifier: Apache-2.0
//
// A piece of every scenario, of every kind of path and of every fault with both engines: the same
// stops, words, rules and end. Whole scenarios: `trammel verify --engines`.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/run/session.hpp"
#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/tests/stop_values.hpp"
#include "tests/support/event_record.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/slope.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

using test::Event;
using Run = test::Recorded<Result>;

Run run(Options options, Engine engine) {
  options.run.engine = engine;
  options.run.platform = Platform::kDirect;
  return test::record_run<Session, Result>(options);
}

std::string text(const std::vector<Event>& events, std::size_t at) {
  if (at >= events.size()) return "no stop";
  return "edge " + std::to_string(events[at].edge) + ", why " + std::to_string(events[at].why) +
         ", gates " + std::to_string(events[at].drive);
}

void check_same(const Options& options) {
  const Run rtl = run(options, Engine::kRtl);
  const Run twin = run(options, Engine::kTwin);
  std::size_t at = 0;
  while (at < std::max(rtl.events.size(), twin.events.size()) &&
         text(rtl.events, at) == text(twin.events, at)) {
    ++at;
  }
  INFO("stop " << at << " of the RTL: " << text(rtl.events, at));
  INFO("stop " << at << " of the twin: " << text(twin.events, at));
  CHECK(at == rtl.events.size());
  CHECK(twin.result.event_hash == rtl.result.event_hash);
  CHECK(twin.result.clocks == rtl.result.clocks);
  CHECK(twin.result.end == rtl.result.end);
  CHECK(twin.result.fault.code == rtl.result.fault.code);
  CHECK(twin.result.fault.axis == rtl.result.fault.axis);
  CHECK(twin.result.fault.tick == rtl.result.fault.tick);
  CHECK(twin.result.fault.processor == rtl.result.fault.processor);
  CHECK(twin.result.snapshot.rules_first == rtl.result.snapshot.rules_first);
  CHECK(twin.result.snapshot.rules_last == rtl.result.snapshot.rules_last);
  CHECK(twin.result.snapshot.gates.compare == rtl.result.snapshot.gates.compare);
  REQUIRE(twin.result.samples.size() == rtl.result.samples.size());
  CHECK(rtl.result.samples.size() > 25);
  for (std::size_t n = 0; n < rtl.result.samples.size(); ++n) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto ours = test::integer_values(twin.result.samples[n].axis[axis]);
      const auto theirs = test::integer_values(rtl.result.samples[n].axis[axis]);
      if (ours == theirs) continue;
      CAPTURE(n, axis);
      FAIL(test::differences(test::integer_names(), theirs, ours));
    }
  }
}

// Mean distance of the table from the commands.
double mean_error_m(const Options& options, const Result& result) {
  double sum = 0;
  std::size_t n = 0;
  for (const Sample& s : result.samples) {
    if (s.tick < result.first_tick) continue;
    const auto error = [&](std::size_t k) {
      return command_m(s.axis[k], options.plant.axis[k].encoder_count_m) - s.axis[k].x_true_m;
    };
    sum += std::hypot(error(0), error(1));
    ++n;
  }
  return sum / static_cast<double>(n);
}

Options piece(double seconds = 0.05) {
  Options options;
  options.reached_m = 1;  // it ends while the table is still under way
  options.run.max_s = seconds;
  return options;
}

}  // namespace

TEST_CASE("both engines agree on a piece of every built-in scenario, fixed and adaptive") {
  int scenarios = 0;
  for (const auto& file : test::scenarios_of(machine())) {
    ++scenarios;
    for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
      Options options;
      lab::apply_file(options, file);
      lab::validate(options);
      options.controller = controller;
      options.run.max_s = 0.06;
      CAPTURE(file, static_cast<int>(controller));
      check_same(options);
    }
  }
  CHECK(scenarios >= 4);
}

TEST_CASE("both engines agree on motors and encoders that are not the paper's, and follow") {
  struct Motor {
    double count_m, pole_pitch_x_m, pole_pitch_y_m;
  };
  for (const Motor& motor : {Motor{5e-6, 16e-3, 12e-3}, Motor{4.9e-6, 30.5e-3, 0.1},
                             Motor{10e-6, 24e-3, 1e-3}}) {
    Options options = piece(0.1);
    options.path.kind = PathKind::kLine;
    options.path.line_ticks = 15;
    options.path.line_end_x_m = 0.103;
    options.path.line_end_y_m = 0.107;
    for (plant::AxisConfig& axis : options.plant.axis) axis.encoder_count_m = motor.count_m;
    options.plant.axis[0].pole_pitch_m = motor.pole_pitch_x_m;
    options.plant.axis[1].pole_pitch_m = motor.pole_pitch_y_m;
    CAPTURE(motor.count_m, motor.pole_pitch_x_m);
    check_same(options);
    const auto done = run(options, Engine::kTwin).result;
    CHECK(done.end == EndReason::kDone);
    const AxisSample last = done.samples.back().axis[1];
    CHECK(std::abs(model_m(last, motor.count_m) - last.x_true_m) < 1e-3);
  }
}

TEST_CASE("the event hash is that of edges, reasons, gates, reads, x_m and i_q* of all samples") {
  const Run one = run(piece(), Engine::kTwin);
  test::check_event_hash(one, [&one](std::size_t n) {
    test::HashedWords words;
    const Sample sample = one.result.samples[n];
    for (const AxisSample& s : sample.axis) {
      words.emplace_back("x_m", static_cast<std::uint32_t>(s.x_m));
      words.emplace_back("i_q*", static_cast<std::uint32_t>(s.i_q_ref));
    }
    return words;
  });
}

TEST_CASE("the true speeds of the record are the slopes of its true places") {
  const Options options = piece(0.2);
  const Result result = run(options, Engine::kTwin).result;
  for (const std::size_t axis : {0, 1}) {
    test::require_slope(axis == 0 ? "X" : "Y", result.samples.size(), options.chip.sample_s(),
                        [&](std::size_t k) {
                          const AxisSample s = result.samples[k].axis[axis];
                          return test::Motion{s.x_true_m, s.v_true_m_s};
                        });
  }
}

// The words are of the period before the sample, and the currents have a ripple within it.
TEST_CASE("the true currents of the record are those that the chip measured, and make force_N") {
  const Options options = piece(0.2);
  const Result result = run(options, Engine::kTwin).result;
  for (const std::size_t axis : {0, 1}) {
    const plant::AxisConfig& motor = options.plant.axis[axis];
    const double lsb_A = current_lsb_A(motor.current_full_scale_a);
    double largest_A = 0, d_A = 0, q_A = 0;
    for (const Sample& sample : result.samples) {
      const AxisSample& s = sample.axis[axis];
      largest_A = std::max(largest_A, std::abs(s.i_q_true_A));
      d_A += std::abs(s.i_d_true_A - s.i_d * lsb_A);
      q_A += std::abs(s.i_q_true_A - s.i_q * lsb_A);
      INFO((axis == 0 ? "X" : "Y") << ", tick " << sample.tick);
      REQUIRE(s.force_N == Approx(motor.force_constant_n_a * s.i_q_true_A).margin(1e-9));
    }
    const auto samples = static_cast<double>(result.samples.size());
    INFO((axis == 0 ? "X" : "Y") << ", largest i_q_A " << largest_A);
    CHECK(largest_A > 0.2);
    CHECK(d_A / samples < 0.05 * largest_A);
    CHECK(q_A / samples < 0.05 * largest_A);
  }
}

TEST_CASE("both engines agree on each carrier and rate of the position loop, and follow alike") {
  double mean_m = 0;
  for (const int carrier : {16000, 8000, 20000, 40000}) {
    for (const int position : {2000, 1000, 4000}) {
      Options options = piece(0.04);
      options.chip.carrier_Hz = carrier;
      options.chip.position_Hz = position;
      options.chip.irq_period_ticks = position / 500;
      CAPTURE(carrier, position);
      check_same(options);
      // The whole circle: with the same loops in seconds the table is where it is by default.
      options = Options();
      options.chip.carrier_Hz = carrier;
      options.chip.position_Hz = position;
      options.chip.irq_period_ticks = position / 500;
      const auto done = run(options, Engine::kTwin).result;
      CHECK(done.end == EndReason::kDone);
      const double mean = mean_error_m(options, done);
      if (mean_m == 0) mean_m = mean;
      CHECK(mean == Approx(mean_m).epsilon(2e-3));
    }
  }
}

TEST_CASE("both engines agree on lines and points, interpolated and fed forward") {
  Options options = piece();
  options.path.kind = PathKind::kLine;
  options.path.line_ticks = 15;
  options.path.line_end_x_m = 0.12;
  options.path.line_end_y_m = 0.103;
  for (AxisGains& gains : options.gains) gains.interpolate = gains.feedforward = true;
  check_same(options);
  CHECK(run(options, Engine::kTwin).result.end == EndReason::kDone);

  options = piece();
  options.path.kind = PathKind::kPoints;
  const test::Scratch scratch("kung_engine_points");
  options.path.points_file = (scratch.path / "a.csv").string();
  std::ofstream(options.path.points_file) << "100,100\n101,100\n102,103\n100,100\n";
  options.path.repeats = 5;
  check_same(options);
}

TEST_CASE("both engines agree whatever the processor's speed") {
  for (const int access : {1, 3, 37}) {
    for (const int latency : {0, 41}) {
      Options options = piece(0.03);
      options.processor.access_clk = access;
      options.processor.interrupt_latency_clk = latency;
      CAPTURE(access, latency);
      check_same(options);
    }
  }
}

TEST_CASE("both engines agree on gates without margin, noise and a slow filter") {
  Options options = piece();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    options.chip.axis[axis].dead_time_ns = axis == 0 ? 200 : 20000;
    options.chip.axis[axis].qep_filter_clk = axis == 0 ? 1 : 15;
    options.plant.axis[axis].current_noise_a = 0.05;
    options.plant.axis[axis].cogging_n = 2;
    options.gains[axis].kp = 4;
  }
  options.chip.irq_period_ticks = 3;
  check_same(options);
}

TEST_CASE("both engines agree on a load that comes and goes, with and without a brake") {
  for (const bool brake : {true, false}) {
    Options options = piece(0.05);
    options.plant.axis[0].load_n = 60;
    options.plant.axis[0].load_begin_s = 0.0200013;
    options.plant.axis[0].load_end_s = 0.035;
    options.plant.axis[1].external_force_n = 30;
    options.plant.axis[1].brake = brake;
    check_same(options);
  }
}

TEST_CASE("both engines see the same fault at the same edge") {
  Options options = piece(0.1);
  SECTION("trip pin") { options.fault = {cosim::FaultKind::kTripPin, 0.0300311}; }
  SECTION("encoder") { options.fault = {cosim::FaultKind::kEncoderJump, 0.0300322}; }
  SECTION("processor") {
    options.fault = {cosim::FaultKind::kProcessorHung, 0.03};
    options.chip.watchdog_ticks = 10;
  }
  SECTION("over-current") { options.chip.current_limit_A = 0.1; }
  SECTION("stroke") {
    options.chip.axis[0].stroke_check = true;
    options.chip.axis[0].stroke_max_m = 0.3500001;
    options.plant.axis[0].external_force_n = -40;
    options.plant.axis[0].brake = false;
  }
  SECTION("diverged") { options.diverged_m = 0.0002; }
  check_same(options);
  const EndReason end = run(options, Engine::kTwin).result.end;
  CHECK((end == EndReason::kFault || end == EndReason::kDiverged));
}

TEST_CASE("the twin gives the same events whatever the window of the loop") {
  Options options = piece(0.03);
  const std::uint64_t whole = run(options, Engine::kTwin).result.event_hash;
  for (const int window : {1, 7, 313}) {
    options.run.window_clk = window;
    CHECK(run(options, Engine::kTwin).result.event_hash == whole);
  }
}
