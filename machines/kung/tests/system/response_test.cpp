// SPDX-License-Identifier: Apache-2.0
//
// Loops measured by sweeps on the twin, beside what gains and plant say they are.
#include <catch2/catch.hpp>
#include <cmath>

#include "cosim/direct.hpp"
#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/run/response.hpp"
#include "machines/kung/run/session.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr double kPi = 3.14159265358979323846;

Options scenario(const std::string& name) {
  Options options;
  lab::apply_file(options, lab::find_scenario(name));
  options.run.engine = Engine::kTwin;
  return options;
}

Result run(const Options& options) {
  Session session(options, {});
  test::run_through(session);
  auto result = session.result();
  return std::move(static_cast<Result&>(*result));
}

// The current loop of the specification: PI, a period of computing, the winding behind a hold.
std::complex<double> current_loop(const Options& options, double hz) {
  const plant::AxisConfig& plant = options.plant.axis[0];
  const AxisGains& gains = options.gains[0];
  const double carrier = options.chip.carrier_Hz;
  const double pole = std::exp(-plant.resistance_ohm / plant.inductance_q_h / carrier);
  const std::complex<double> z = std::polar(1.0, 2 * kPi * hz / carrier);
  const std::complex<double> pi =
      gains.current_kp_V_A + gains.current_ki_V_A * kGainCarrierHz / carrier * z / (z - 1.0);
  const std::complex<double> open = pi * (1 - pole) / plant.resistance_ohm / (z - pole) / z;
  return open / (1.0 + open);
}

}  // namespace

TEST_CASE("without dead time the current loop is that of its gains and the winding") {
  Options options = scenario("response-current");
  options.chip.dead_time_min_ns = 0;
  for (AxisChip& axis : options.chip.axis) axis.dead_time_ns = 0;
  const Result result = run(options);
  CHECK(result.end == EndReason::kDone);
  for (std::size_t a = 0; a < 2; ++a) {
    const auto loops = responses(*make_plan(options), result, a);
    REQUIRE(loops.size() == 1);
    REQUIRE(loops[0].closed.size() == 19);
    for (const lab::ResponsePoint& point : loops[0].closed) {
      INFO(point.hz << " Hz: " << point.gain << ", " << current_loop(options, point.hz));
      // The images of the held command that the position samples fold back grow with frequency.
      const double images = point.hz / 4000;
      CHECK(std::abs(point.gain - current_loop(options, point.hz)) < 0.01 + images);
    }
    CHECK(*lab::margins(loops[0].closed).phase_margin_deg == Approx(69).margin(3));
  }
}

TEST_CASE("dead time lowers the gain of the current loop, the more the smaller its amplitude") {
  Options options = scenario("response-current");
  double last = 0;
  for (const double amplitude : {0.5, 1.0, 2.0}) {
    options.path.sweep_amplitude_A = amplitude;
    const auto loops = responses(*make_plan(options), run(options), 0);
    const double crossover = lab::margins(loops[0].closed).crossover_hz.value();
    CHECK(crossover > 1.02 * last);
    last = crossover;
  }
  CHECK(last < 640);  // 4000 rad/s
}

TEST_CASE("the speed loop is that of its gain, the force constant and the mass") {
  Options options = scenario("response");
  options.path.sweep_amplitude_m = 0.004;
  for (plant::AxisConfig& plant : options.plant.axis) plant.coulomb_n = 0;
  const Result result = run(options);
  CHECK(result.end == EndReason::kDone);
  for (std::size_t a = 0; a < 2; ++a) {
    const auto loops = responses(*make_plan(options), result, a);
    REQUIRE(loops.size() == 2);
    const plant::AxisConfig& plant = options.plant.axis[a];
    const double expected = options.gains[a].kv * kSpeedGain * plant.force_constant_n_a /
                            (plant.mass_kg + plant.payload_kg) / (2 * kPi);
    const lab::Margins speed = lab::margins(loops[1].closed);
    CHECK(*speed.crossover_hz == Approx(expected).epsilon(0.1));
    const lab::Margins position = lab::margins(loops[0].closed);
    CHECK(*position.phase_margin_deg > 30);
    CHECK(*position.bandwidth_hz < *speed.bandwidth_hz);
  }
}

TEST_CASE("a sweep too small for a step of the encoder has missed its loops") {
  Options options = scenario("response");
  options.path.sweep_amplitude_m = 4e-6;
  options.path.sweep_first_ticks = 40;
  options.path.sweep_tones = 2;
  const Result result = run(options);
  CHECK(result.end == EndReason::kMissed);
  CHECK(result.missed == "the position loop of X shows no tone of the sweep: its amplitude is too "
                         "small");
}

TEST_CASE("a locked carriage does not move, whatever its current") {
  Options options = scenario("response-current");
  options.path.sweep_tones = 2;
  const Result result = run(options);
  const double start_m = result.samples[0].axis[0].x_true_m;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const Sample sample = result.samples[k];
    REQUIRE(sample.axis[0].x_true_m == start_m);
    REQUIRE(sample.axis[1].v_true_m_s == 0);
  }
  options.plant.axis[0].locked = false;
  const Result free = run(options);
  const Sample last = free.samples[free.samples.size() - 1];
  CHECK(std::abs(last.axis[0].x_true_m - start_m) > 0.001);
  CHECK(last.axis[1].x_true_m == start_m);
}
