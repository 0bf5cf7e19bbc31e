// SPDX-License-Identifier: Apache-2.0
//
// Faults on the full machine: the drives trip, the first fault is named, the record is kept.
#include <catch2/catch.hpp>

#include "lab/machine.hpp"
#include "machines/kung/chip/measures.hpp"

using namespace trammel::kung;

namespace {

Options short_circle() {
  Options options;
  options.run.max_s = 0.2;
  return options;
}

// After a trip all gates are off: the currents die out within a few L/R = 0.86 ms.
void check_tripped(const Result& result, FaultCode code, int axis) {
  CHECK(result.end == EndReason::kFault);
  CHECK(result.fault.code == code);
  CHECK(result.fault.axis == axis);
  REQUIRE(result.samples.size() > 20);
  CHECK(result.samples.back().tick > result.fault.tick);
  for (const AxisSample& a : result.samples.back().axis) {
    CHECK(std::abs(a.i_q_true_A) < 1e-3);
    CHECK(std::abs(a.i_d_true_A) < 1e-3);
  }
}

}  // namespace

TEST_CASE("a run without faults ends without one") {
  Options options = short_circle();
  const Result result = simulate(options, {});
  CHECK(result.end == EndReason::kTimeout);
  CHECK(result.fault.code == FaultCode::kNone);
}

TEST_CASE("the trip pin ends the run") {
  Options options = short_circle();
  options.fault = {trammel::cosim::FaultKind::kTripPin, 0.05};
  const Result result = simulate(options, {});
  check_tripped(result, FaultCode::kTrip, 0);
  CHECK(result.fault.tick == 101);  // ticks at 0, 0.5 ms, ..., 50 ms have passed
  CHECK(result.fault_text() == "external trip");  // not what the processor makes of its interrupt
  CHECK(result.fault.processor.empty());
}

TEST_CASE("after any trip the way to rest is recorded and told, and the figures end at the trip") {
  Options options = short_circle();
  options.run.engine = Engine::kTwin;
  options.fault = {trammel::cosim::FaultKind::kTripPin, 0.15};  // at 0.5 m/s
  options.run.max_s = 2;
  Result result = simulate(options, {});
  const double mm = result.fault_report.stopping;
  const auto last = result.samples.back().axis;
  {
    INFO("last sample: X at " << last[0].v_true_m_s << " m/s, Y at " << last[1].v_true_m_s);
    CHECK(std::hypot(last[0].v_true_m_s, last[1].v_true_m_s) < 1e-3);
  }
  const Sample at = result.samples[300];  // 0.15 s, as the pin rises
  const double way_m = std::hypot(last[0].x_true_m - at.axis[0].x_true_m,
                                  last[1].x_true_m - at.axis[1].x_true_m);
  CHECK(mm == Approx(1e3 * way_m).margin(0.01));
  CHECK(mm > 10);
  double told = 0, largest_mm = 0;
  for (const auto& figure : machine().figures(options, result)) {
    if (figure.id == "at_end.stopping_mm" && figure.shown) told = figure.value;
    if (figure.id == "tracking.model.max_mm") largest_mm = figure.value;
  }
  CHECK(told == mm);
  CHECK(largest_mm < 5);  // the model goes on while the table stops
  options.fault = {};
  options.chip.following_error_m = 0.004;  // the firmware's, not the chip's
  result = simulate(options, {});
  REQUIRE(result.end == EndReason::kFault);
  CHECK(result.fault_report.begin == trammel::cosim::kNever);  // none was injected
  CHECK(result.fault_report.off != trammel::cosim::kNever);
  CHECK(result.fault_report.stopping > 1);
}

TEST_CASE("a jump of both encoder lines ends the run") {
  Options options = short_circle();
  options.fault = {trammel::cosim::FaultKind::kEncoderJump, 0.05};
  check_tripped(simulate(options, {}), FaultCode::kEncoder, 0);
}

TEST_CASE("an over-current ends the run") {
  Options options = short_circle();
  options.chip.current_limit_A = 0.1;
  const Result result = simulate(options, {});
  check_tripped(result, FaultCode::kOverCurrent, result.fault.axis);
}

TEST_CASE("leaving the stroke ends the run") {
  Options options = short_circle();
  options.path.kind = PathKind::kSquare;  // overshoots its own end points
  options.path.square_low_m = 0.1;
  options.path.square_high_m = 0.11;
  options.plant.axis[1].payload_kg = 11;
  for (AxisChip& axis : options.chip.axis) {
    axis.stroke_check = true;
    axis.stroke_min_m = 0.09;
  }
  options.chip.axis[1].stroke_max_m = 0.1101;
  options.run.max_s = 2;
  check_tripped(simulate(options, {}), FaultCode::kStroke, 1);
}

TEST_CASE("the watchdog bites when the processor hangs") {
  Options options = short_circle();
  options.chip.watchdog_ticks = 10;
  options.fault = {trammel::cosim::FaultKind::kProcessorHung, 0.05};
  const Result result = simulate(options, {});
  check_tripped(result, FaultCode::kWatchdog, 0);
  CHECK(result.fault.tick > 105);  // at most 4 ticks since the last COMMIT, 10 allowed
  CHECK(result.fault.tick < 115);
}

TEST_CASE("what trips on the way to rest is not named as the cause") {
  Options options;
  options.run.engine = Engine::kTwin;
  options.fault.kind = trammel::cosim::FaultKind::kProcessorGarbage;
  options.fault.begin_s = 0.5;
  // The watchdog bites 48 ms after the firmware's check.
  const Result result = simulate(options, {});
  REQUIRE(result.end == EndReason::kFault);
  CHECK(result.fault.code == FaultCode::kNone);
  CHECK(result.fault.processor == result.fault_report.by);
}

TEST_CASE("a table that does not follow is turned off by the firmware") {
  Options options = short_circle();
  options.run.engine = Engine::kTwin;
  options.gains[0].feedforward = options.gains[1].feedforward = true;
  options.fault.kind = trammel::cosim::FaultKind::kPhaseOpen;
  options.fault.begin_s = 0.05;
  CHECK(simulate(options, {}).end != EndReason::kFault);
  options.chip.following_error_m = 0.012;
  const Result result = simulate(options, {});
  check_tripped(result, FaultCode::kNone, 0);
  CHECK(result.fault_report.detected < trammel::cosim::kNever);
  CHECK(result.fault_report.off - result.fault_report.detected < 6250);  // two current periods
}

TEST_CASE("a table away from its model ends the run as diverged, in either axis alone") {
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    Options options = short_circle();
    options.run.engine = Engine::kTwin;
    options.fault.kind = trammel::cosim::FaultKind::kPhaseOpen;
    options.fault.axis = axis;
    options.fault.begin_s = 0.05;
    options.path.kind = PathKind::kLine;
    options.run.max_s = 0.5;
    options.diverged_m = 0.004;
    const Result result = simulate(options, {});
    CHECK(result.end == EndReason::kDiverged);
    CHECK(result.beside_m == 0);  // it is told by the model
    for (const int k : {0, 1}) {
      const AxisSample last = result.samples.back().axis[static_cast<std::size_t>(k)];
      const double error_m =
          std::abs(model_m(last, options.plant.axis[0].encoder_count_m) - last.x_true_m);
      CAPTURE(k, error_m);
      CHECK((error_m > options.diverged_m) == (k == axis));
    }
  }
}

TEST_CASE("a saturated converter shows its largest current, whatever the width of its axis") {
  const auto words = [](int axis, int bits) {
    Options options = short_circle();
    options.run.engine = Engine::kTwin;
    options.plant.axis[static_cast<std::size_t>(axis)].adc_bits = bits;
    options.fault.kind = trammel::cosim::FaultKind::kConverterSaturated;
    options.fault.axis = axis;
    options.fault.begin_s = 0.05;
    const Result result = simulate(options, {});
    REQUIRE(result.fault.code == FaultCode::kOverCurrent);
    REQUIRE(result.fault.axis == axis);
    return result.samples.back().axis[static_cast<std::size_t>(axis)];  // no current flows
  };
  for (const int axis : {0, 1}) {
    const AxisSample narrow = words(axis, 12), wide = words(axis, 16);
    CAPTURE(axis, narrow.i_d, narrow.i_q, wide.i_d, wide.i_q);
    CHECK(std::hypot(narrow.i_d, narrow.i_q) > 1000);
    CHECK(std::hypot(narrow.i_d - wide.i_d, narrow.i_q - wide.i_q) < 50);
  }
}

TEST_CASE("a current sensor that stays where it was is told by the d current") {
  Options options = short_circle();
  options.run.engine = Engine::kTwin;
  options.plant.axis[0].load_n = 40;  // a current to hold
  options.fault.kind = trammel::cosim::FaultKind::kConverterStuck;
  options.fault.begin_s = 0.05;
  CHECK(simulate(options, {}).end != EndReason::kFault);
  options.chip.d_current_A = 0.3;
  const Result result = simulate(options, {});
  check_tripped(result, FaultCode::kNone, 0);
  CHECK(result.fault_report.off - result.fault_report.detected < 6250);  // two current periods
  options.fault.kind = trammel::cosim::FaultKind::kNone;
  CHECK(simulate(options, {}).end == EndReason::kTimeout);
}

TEST_CASE("a stop request ends the run with what there is") {
  Options options = short_circle();
  std::atomic<bool> stop{false};
  Hooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&stop](double fraction) { stop = fraction > 0.05; };
  const Result result = simulate(options, hooks);
  CHECK(result.end == EndReason::kStopped);
  CHECK(result.samples.size() > 100);
}
