// SPDX-License-Identifier: Apache-2.0
//
// The words that a run records of each controller, beside the truth of the plant in physical units;
// and the close look at its fastest sample, beside the samples and the gates of the run.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/precision/trace.hpp"
#include "machines/kung/run/session.hpp"
#include "tests/support/event_record.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr double kCountM = 5e-6, kSampleS = 0.5e-3;

using Run = test::Recorded<Result>;

// A line whose axes go at unlike speeds: Y down, and three times as fast as X.
Options line(Controller controller, double seconds) {
  Options options;
  options.run.engine = Engine::kTwin;
  options.run.platform = Platform::kDirect;
  options.run.max_s = seconds;
  options.controller = controller;
  options.plant.axis[0].external_force_n = 40;
  options.plant.axis[1].external_force_n = -45;
  options.path.kind = PathKind::kLine;
  options.path.line_start_y_m = 0.4;
  options.path.line_end_x_m = 0.12;
  options.path.line_end_y_m = 0.34;
  options.path.line_ticks = 100;
  return options;
}

struct Furthest {
  double is = 0;
  void add(double of) { is = std::max(is, std::abs(of)); }
};

// Largest distances of the words of an axis from the truth, on the path.
struct Words {
  Furthest place_m, speed_m_s, d_A, q_A, ref_A, model_m, change_m_s, speed_word_m_s;
};

Words compare(const Options& options, const Result& result, std::size_t axis) {
  Words far;
  const double full_scale_A = options.plant.axis[axis].current_full_scale_a;
  const double lsb_A = current_lsb_A(full_scale_A), ref_A = current_ref_lsb_A(full_scale_A);
  for (std::size_t k = 1; k < result.samples.size(); ++k) {
    const Sample sample = result.samples[k];
    if (sample.tick < result.first_tick + 100) continue;
    const AxisSample& s = sample.axis[axis];
    far.place_m.add(s.x_p * kCountM - s.x_true_m);
    far.d_A.add(s.i_d * lsb_A - s.i_d_true_A);
    far.q_A.add(s.i_q * lsb_A - s.i_q_true_A);
    far.ref_A.add(s.i_q_ref * ref_A - s.i_q_true_A);
    far.model_m.add(s.x_m / 16384.0 * kCountM - s.x_true_m);
    far.change_m_s.add(s.dx / 16384.0 * kCountM / kSampleS - s.v_true_m_s);
    far.speed_word_m_s.add(s.v / 16.0 * kCountM / kSampleS - s.v_true_m_s);
  }
  return far;
}

bool same(const AxisSample& a, const AxisSample& b) {
  return a.x_m == b.x_m && a.u == b.u && a.v_star == b.v_star && a.i_q_ref == b.i_q_ref &&
         a.e == b.e && a.de == b.de;
}

}  // namespace

TEST_CASE("words of the fuzzy controllers are those of their axis, in their units") {
  for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
    const Options options = line(controller, 0.25);
    const Run run = test::record_run<Session, Result>(options);
    CHECK(run.result.laws.empty());
    CHECK_FALSE(run.result.estimates);
    for (const std::size_t axis : {0u, 1u}) {
      const Words far = compare(options, run.result, axis);
      CAPTURE(static_cast<int>(controller), axis);
      CHECK(far.place_m.is < kCountM);
      CHECK(far.d_A.is < 0.15);  // of a current of some A, with the ripple of the PWM
      CHECK(far.q_A.is < 0.15);
      CHECK(far.ref_A.is < 0.4);
      CHECK(far.model_m.is < 5e-3);
      CHECK(far.change_m_s.is < 0.15);
      CHECK(far.speed_word_m_s.is < 0.02);
      double most_A = 0;
      for (std::size_t k = 0; k < run.result.samples.size(); ++k) {
        most_A = std::max(most_A, std::abs(run.result.samples[k].axis[axis].i_q_true_A));
        REQUIRE(run.result.samples[k].axis[axis].set_point == kNoSetPoint);
      }
      CHECK(most_A > 0.5);
    }
  }
}

TEST_CASE("a precision run records set point, law and estimates of each axis") {
  const Options options = line(Controller::kPrecision, 0.6);
  const Run run = test::record_run<Session, Result>(options);
  const Result& result = run.result;
  CAPTURE(result.fault_text());
  REQUIRE(result.points > 50);
  REQUIRE(result.laws.size() == result.samples.size());
  for (const std::size_t axis : {0u, 1u}) {
    CAPTURE(axis);
    const Words far = compare(options, result, axis);
    CHECK(far.place_m.is < kCountM);
    CHECK(far.model_m.is < 50e-6);
    CHECK(far.change_m_s.is < 0.01);
    CHECK(far.d_A.is < 0.15);
    // In the identification move a mass changes by a quarter in a knot: 0.2 A on top of the lag.
    CHECK(far.ref_A.is < 0.5);
    for (std::size_t k = 0; k < result.samples.size(); ++k) {
      const Sample sample = result.samples[k];
      if (sample.tick < result.first_tick) continue;
      const AxisSample& s = sample.axis[axis];
      CAPTURE(sample.tick);
      REQUIRE(std::abs(s.set_point - 256 * s.r) <= 128);
      REQUIRE(s.x_m == 64 * s.set_point);
      REQUIRE(s.x_r == s.r);
      REQUIRE(s.e == s.x_r - s.x_p);
      REQUIRE((s.de == 0 && s.u == 0 && s.v_star == 0 && s.v == 0));
      const CurrentParts parts = parts_of(result.laws[k][axis], 9.6);
      const double sum_A = parts.accel_A + parts.speed_A + parts.friction_A + parts.force_A +
                           parts.feedback_A;
      REQUIRE(sum_A == Approx(s.i_q_ref * current_ref_lsb_A(9.6)).margin(0.01));
    }
    REQUIRE(result.estimates);
    const AxisEstimate& found = (*result.estimates)[axis];
    const plant::AxisConfig& plant = options.plant.axis[axis];
    CHECK(found.taught);
    CHECK(found.mass_kg == Approx(plant.mass_kg + plant.payload_kg).epsilon(0.1));
    CHECK(found.force_N == Approx(plant.external_force_n).epsilon(0.3));
  }
}

TEST_CASE("an axis that did not move was not taught, the other was") {
  for (const std::size_t moves : {0u, 1u}) {
    Options options = line(Controller::kPrecision, 0.25);
    options.precision.identify = false;
    if (moves == 0) options.path.line_end_y_m = options.path.line_start_y_m;
    if (moves == 1) options.path.line_end_x_m = options.path.line_start_x_m;
    const Run run = test::record_run<Session, Result>(options);
    REQUIRE(run.result.estimates);
    CAPTURE(moves, run.result.points);
    for (const std::size_t axis : {0u, 1u}) {
      CHECK((*run.result.estimates)[axis].taught == (axis == moves));
    }
  }
}

TEST_CASE("the close look is at the fastest sample of the path, of either axis and either way") {
  for (const double to_y_m : {0.34, 0.46}) {
    Options options = line(Controller::kAfc, 0.12);
    options.path.line_end_y_m = to_y_m;
    const Run run = test::record_run<Session, Result>(options);
    const Result& result = run.result;
    const Moment& moment = result.snapshot.moment;
    const auto speed = [&](std::size_t k) {
      const Sample s = result.samples[k];
      return std::max(std::abs(s.axis[0].v_true_m_s), std::abs(s.axis[1].v_true_m_s));
    };
    std::size_t at = 0;
    double fastest = 0;
    for (std::size_t k = 0; k < result.samples.size(); ++k) {
      const Sample s = result.samples[k];
      if (s.tick < result.first_tick || s.edge + 6250 > result.clocks) continue;
      if (speed(k) <= fastest) continue;
      fastest = speed(k);
      at = k;
    }
    const Sample now = result.samples[at], before = result.samples[at - 1];
    CAPTURE(to_y_m, fastest);
    REQUIRE(fastest > 0.05);
    CHECK(moment.tick == now.tick);
    CHECK(moment.edge == now.edge);
    for (const std::size_t axis : {0u, 1u}) {
      CAPTURE(axis);
      const AxisSample &one = now.axis[axis], &last = before.axis[axis];
      const AfcStart& start = moment.start[axis];
      CHECK(same(moment.end[axis], one));
      CHECK(start.r == one.r);
      CHECK(start.r_1 == last.r);
      CHECK(start.r_2 == result.samples[at - 2].axis[axis].r);
      CHECK(start.x_p == one.x_p);
      CHECK(start.x_p_prev == last.x_p);
      CHECK(start.x_m == last.x_m);
      CHECK(start.dx == last.dx);
      CHECK(start.e_prev == last.e);
      for (std::size_t n = 0; n < 49; ++n) {
        const int unit = std::clamp(2 * static_cast<int>(n / 7 + n % 7) - 12, -6, 6);
        // At rest on its model an axis has learned next to nothing.
        CHECK(std::abs(result.snapshot.rules_first[axis][n] - unit * (1 << 20)) < 200);
      }
      CHECK(result.snapshot.rules_last[axis] != result.snapshot.rules_first[axis]);
      CHECK(start.rules != result.snapshot.rules_first[axis]);
    }
    // Two PWM periods of 3125 clocks from the sample on, with every change of a gate.
    const GateWindow& gates = result.snapshot.gates;
    CHECK(gates.begin == now.edge);
    CHECK(gates.end == now.edge + 6250);
    CHECK(gates.trip == cosim::kNever);
    CHECK(gates.compare.size() == 2);
    std::vector<GateEdge> expected{{gates.begin, 0}};
    for (const test::Event& event : run.events) {
      if ((event.why & cosim::kDrive) == 0 || event.edge >= gates.end) continue;
      if (event.edge <= gates.begin) {
        expected[0].gates = event.drive;
      } else {
        expected.push_back({event.edge, event.drive});
      }
    }
    REQUIRE(gates.edges.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      CHECK(gates.edges[k].edge == expected[k].edge);
      CHECK(gates.edges[k].gates == expected[k].gates);
    }
  }
}

TEST_CASE("the close look is at the path, however fast the move before it was") {
  Options options = line(Controller::kPrecision, 0.5);
  options.path.feed_m_s = 0.005;  // the identification move is faster
  const Run run = test::record_run<Session, Result>(options);
  REQUIRE(run.result.first_tick > 0);
  REQUIRE(run.result.points > 10);
  CHECK(run.result.snapshot.moment.tick >= run.result.first_tick);
  CHECK(run.result.snapshot.gates.begin == run.result.snapshot.moment.edge);
}
