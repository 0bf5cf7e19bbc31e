// SPDX-License-Identifier: Apache-2.0
//
// How a run of the table ends, by what stopped it, and the faults that are put on its lines.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/figures.hpp"
#include "machines/kung/run/session.hpp"
#include "machines/kung/tests/fake_chip.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;

namespace {

// A slow line of 20 x 30 mm, by the twin.
Options line() {
  Options options;
  options.run.engine = Engine::kTwin;
  options.run.platform = Platform::kDirect;
  options.run.max_s = 0.5;
  options.path.kind = PathKind::kLine;
  options.path.line_end_x_m = 0.12;
  options.path.line_end_y_m = 0.13;
  options.path.line_ticks = 150;
  return options;
}

double off_model_m(const Options& options, const Sample& sample, std::size_t axis) {
  const AxisSample& at = sample.axis[axis];
  return std::abs(model_m(at, options.plant.axis[axis].encoder_count_m) - at.x_true_m);
}

}  // namespace

TEST_CASE("a session has the times of its keys, and tells where each axis is") {
  Options options = line();
  test::set_timing(options);
  Session session(options, {});
  test::check_timing(session, 20'000);
  const auto places = session.places();
  REQUIRE(places.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(places[k].axis == (k == 0 ? "x" : "y"));
    CHECK(places[k].unit == "m");
    CHECK(places[k].value == Approx(0.1));
  }
  options.path.line_start_y_m = 0.25;
  CHECK(Session(options, {}).places()[0].value == Approx(0.1));
  CHECK(Session(options, {}).places()[1].value == Approx(0.25));
}

TEST_CASE("a run that is asked to stop does, and says so") {
  std::atomic<bool> stop{true};
  cosim::Hooks hooks;
  hooks.stop = &stop;
  Session session(line(), hooks);
  CHECK_FALSE(session.stopped());
  test::run_through(session);
  CHECK(session.finished());
  CHECK(session.stopped());
  CHECK(session.result()->end == EndReason::kStopped);
}

TEST_CASE("a table that is pulled away before the path ends the run in either axis, with its way") {
  for (const std::size_t axis : {0u, 1u}) {
    for (const double diverged_m : {0.05, 0.002}) {
      Options options = line();
      options.controller = Controller::kPrecision;
      options.diverged_m = diverged_m;
      options.plant.axis[axis].external_force_n = axis == 0 ? -900 : 900;  // the motor has 383 N
      const Result result = simulate(options, {});
      CAPTURE(axis, diverged_m, result.swing_m, result.fault_text());
      REQUIRE(result.end == EndReason::kDiverged);
      CHECK(result.points == 0);
      const auto way_m = [&](std::size_t from_end, std::size_t k) {
        const Sample s = result.samples[result.samples.size() - from_end];
        return std::abs(s.axis[k].x_true_m - 0.1);
      };
      const double most_m = std::min(diverged_m, 0.005);
      CHECK(result.swing_m == Approx(way_m(1, axis)));
      CHECK(result.swing_m > most_m);
      CHECK(way_m(2, axis) <= most_m);
      CHECK(way_m(1, 1 - axis) < most_m);
      CHECK_THAT(verdict(options, result),
                 Catch::StartsWith("diverged: " + fmt::format("{:.2f}", 1e3 * result.swing_m) +
                                   " mm from the start in the identification move of 0.8 mm" +
                                   (diverged_m < 0.005 ? ", above run.diverged_m = 0.002" : "") +
                                   "; precision.mass_kg"));
    }
  }
}

TEST_CASE("run.diverged_m below the way of the identification move is what ended the run") {
  Options options = line();
  options.controller = Controller::kPrecision;
  options.diverged_m = 2e-4;
  const Result result = simulate(options, {});
  REQUIRE(result.end == EndReason::kDiverged);
  CHECK_THAT(verdict(options, result),
             Catch::EndsWith(" mm from the start in the identification move of 0.8 mm, above "
                             "run.diverged_m = 0.0002; allowed with the precision controller: "
                             "above 0.0008"));
}

TEST_CASE("a run ends at the first sample at which an axis is too far from its model") {
  for (const std::size_t axis : {0u, 1u}) {
    Options options = line();
    options.diverged_m = 0.004;
    options.fault.kind = cosim::FaultKind::kPhaseOpen;
    options.fault.axis = static_cast<int>(axis);
    options.fault.begin_s = 0.05;
    const Result result = simulate(options, {});
    CAPTURE(axis, result.fault_text());
    REQUIRE(result.end == EndReason::kDiverged);
    const std::size_t n = result.samples.size();
    CHECK(off_model_m(options, result.samples[n - 1], axis) > 0.004);
    CHECK(off_model_m(options, result.samples[n - 1], 1 - axis) < 0.004);
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const Sample sample = result.samples[k];
      if (sample.tick < result.first_tick) continue;
      REQUIRE(off_model_m(options, sample, axis) <= 0.004);
    }
    CHECK(result.beside_m == 0);
  }
}

TEST_CASE("a run ends at the first sample at which the table is too far beside its path") {
  Options options = line();
  for (AxisGains& gains : options.gains) gains.omega_n_rad_s = 30;
  options.gains[1].omega_n_rad_s = 6;  // Y comes late, as its model does
  options.diverged_m = 0.005;
  const Result result = simulate(options, {});
  CAPTURE(result.fault_text(), result.beside_m);
  REQUIRE(result.end == EndReason::kDiverged);
  // Of the line along (2, 3), which begins long before.
  const auto beside_m = [&](const Sample& s) {
    const double dx = s.axis[0].x_true_m - 0.1, dy = s.axis[1].x_true_m - 0.1;
    return std::abs(3 * dx - 2 * dy) / std::sqrt(13);
  };
  const std::size_t n = result.samples.size();
  CHECK(result.beside_m == Approx(beside_m(result.samples[n - 1])).margin(1e-5));
  CHECK(result.beside_m > 0.005);
  CHECK(beside_m(result.samples[n - 2]) < 0.005 + 1e-5);
  for (std::size_t k = 0; k < 2; ++k) CHECK(off_model_m(options, result.samples[n - 1], k) < 0.005);
  CHECK_THAT(verdict(options, result), Contains(" m beside the path asked, above run.diverged_m"));
}

TEST_CASE("an encoder that stands still is that of its axis, of either line") {
  for (const std::size_t axis : {0u, 1u}) {
    for (const int wire : {0, 1}) {
      Options options = line();
      options.run.max_s = 0.2;
      options.fault.kind = cosim::FaultKind::kEncoderStuck;
      options.fault.axis = static_cast<int>(axis);
      options.fault.line = wire;
      options.fault.begin_s = 0.08;
      const Result result = simulate(options, {});
      CAPTURE(axis, wire, result.fault_text());
      const Sample last = result.samples.back();
      const auto off = [&](std::size_t k) {  // [count]
        return std::abs(last.axis[k].x_p - last.axis[k].x_true_m / 5e-6);
      };
      CHECK(off(axis) > 100);
      CHECK(off(1 - axis) < 2);
    }
  }
}

TEST_CASE("a supply that dips leaves its share of the link of its axis, for its time") {
  for (const std::size_t axis : {0u, 1u}) {
    Options options = line();
    options.run.max_s = 0.1;
    options.fault.kind = cosim::FaultKind::kSupplyDip;
    options.fault.axis = static_cast<int>(axis);
    options.fault.value = 40;
    options.fault.begin_s = 0.05;
    options.fault.for_s = 0.02;
    const Result result = simulate(options, {});
    const double full_v = options.plant.axis[axis].dc_link_v;
    double least_v = 1e9;
    for (std::size_t k = 0; k < result.samples.size(); ++k) {
      const Sample sample = result.samples[k];
      const double t_s = 20e-9 * static_cast<double>(sample.edge);
      const double link_v = sample.axis[axis].dc_link_V;
      CAPTURE(axis, t_s);
      if (t_s > 0.051 && t_s < 0.069) least_v = std::min(least_v, link_v);
      if (t_s < 0.049) {
        REQUIRE(link_v == Approx(full_v));
      }
    }
    CHECK(least_v == Approx(0.4 * full_v));
    CHECK(result.samples.back().axis[axis].dc_link_V == Approx(full_v));
  }
}

TEST_CASE("a trip pin that the processor raises stays") {
  plant::XyTableConfig config;
  const plant::XyTable alone(config);
  const cosim::Lines trip = cosim::Lines{1} << kTripPin;
  TablePlant later(config);
  later.trip_from(400);
  later.trip_from(500);  // it has risen by then
  CHECK(later.next() <= 400);
  for (const cosim::Clk edge : {399, 400, 500, 501}) {
    later.commit(edge, 0);
    CHECK((later.sense() ^ alone.sense()) == (edge >= 400 ? trip : 0));
  }
}

TEST_CASE("a processor that hangs only reads, and nothing before its edge is lost") {
  const auto chip = make_twin_chip();  // at edge 0
  for (const cosim::Clk stall : {0, 1}) {
    cosim::FaultSpan hung;
    hung.begin = stall;
    StallableApp app(sw::KungSetup{}, *chip, hung);
    test::FakeChip bus;
    app.start(bus);
    bus.tick(4);
    const std::size_t before = bus.log.size();
    app.isr(bus);
    CAPTURE(stall);
    REQUIRE(bus.log.size() > before);
    CHECK(bus.writes(before).empty() == (stall == 0));
    if (stall != 0) continue;
    CHECK(bus.log.size() == before + 1);
    CHECK(bus.log.back().address == kung_xy_regs::kId);
  }
}
