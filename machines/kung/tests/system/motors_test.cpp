// SPDX-License-Identifier: Apache-2.0
//
// Motors that are not the paper's, with gains by the documented rule: each follows the circle, and
// its error is that of a model that knows no inverter, no words and no chip.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "cosim/direct.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/session.hpp"
#include "models/ideal/fuzzy_controller.hpp"
#include "models/ideal/reference_model.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

// Data as their sheets give them; amplitudes of a phase.
struct Motor {
  const char* name;
  double resistance_ohm, inductance_h, force_n_a, pole_pitch_m, mass_kg, link_v, full_scale_a,
      count_m;
  double coulomb_n, viscous_n_s_m, circle_m;
  int circle_ticks;
};

const Motor kMotors[]{
    {"small ironless, 48 V", 6.0, 1.2e-3, 17.0, 15e-3, 0.6, 48, 5, 1e-6, 0.8, 3, 0.02, 628},
    {"ironless, 325 V", 11.0, 3.5e-3, 56, 16e-3, 3.0, 325, 15, 2e-6, 2, 5, 0.05, 800},
    {"iron core, 325 V", 4.3, 33e-3, 82, 24e-3, 14.0, 325, 30, 5e-6, 12, 30, 0.1, 628},
    {"large iron core, 565 V", 1.7, 18e-3, 120, 24e-3, 45.0, 565, 60, 10e-6, 40, 60, 0.15, 900},
    // 4 pole pairs, 10 mm lead, 0.5 N m/A, 1e-4 kg m^2 as seen along the screw
    {"rotary servo on a screw", 2.8, 8e-3, 314, 1.25e-3, 60, 325, 12, 1e-6, 40, 400, 0.02, 900},
    // 7 pole pairs, 5 mm lead, 0.04 N m/A, 4096 counts a revolution
    {"flat rotary motor on a fine screw", 0.23, 0.145e-3, 49.6, 5e-3 / 14, 8, 48, 30, 5e-3 / 4096,
     6, 30, 0.02, 900},
    // The least inductance of the keys, with a ripple above the current that moves it.
    {"coreless, 0.01 mH, 24 V", 0.1, 0.01e-3, 5, 16e-3, 1, 24, 100, 2e-6, 1, 5, 0.02, 628},
};

Options circle(const Motor& motor, Controller controller) {
  Options o;
  o.run.engine = Engine::kTwin;
  o.run.platform = Platform::kDirect;
  o.controller = controller;
  o.gains_by_rule = true;
  o.path.circle_radius_m = motor.circle_m;
  o.path.circle_center_x_m = o.path.circle_center_y_m = 0.03;
  if (motor.circle_m > 0.03) o.path.circle_center_x_m = o.path.circle_center_y_m = 0.2;
  o.path.circle_ticks = motor.circle_ticks;
  o.chip.current_limit_A = motor.full_scale_a * 0.9;
  o.settle_s = 0.2;
  for (std::size_t a = 0; a < 2; ++a) {
    plant::AxisConfig& p = o.plant.axis[a];
    p.resistance_ohm = motor.resistance_ohm;
    p.inductance_d_h = p.inductance_q_h = motor.inductance_h;
    p.force_constant_n_a = motor.force_n_a;
    p.pole_pitch_m = motor.pole_pitch_m;
    p.mass_kg = motor.mass_kg;
    p.dc_link_v = motor.link_v;
    p.current_full_scale_a = motor.full_scale_a;
    p.encoder_count_m = motor.count_m;
    p.coulomb_n = motor.coulomb_n;
    p.viscous_n_s_m = motor.viscous_n_s_m;
    p.stroke_max_m = o.chip.axis[a].stroke_max_m = std::min(0.6, 129000 * motor.count_m);
  }
  return o;
}

// rms error [mm] of both axes to the reference model along the circle.
double fast_rms_mm(const Motor& motor, bool adapt) {
  double squares = 0;
  const MotorGains rule = [&] {
    plant::AxisConfig p;
    p.force_constant_n_a = motor.force_n_a;
    p.mass_kg = motor.mass_kg;
    return gains_by_rule(p);
  }();
  const double speed_lsb = motor.count_m / 16 / 0.5e-3, ampere_lsb = motor.full_scale_a / 4096;
  int samples = 0;
  for (const double phase : {0.0, 3.14159265358979 / 2}) {
    const auto asked = [&](int point) {
      const double angle = 2 * 3.14159265358979 * point / motor.circle_ticks;
      return motor.circle_m * std::sin(angle + phase) / motor.count_m;
    };
    ideal::ReferenceModel model;
    ideal::FuzzyController fuzzy;
    ideal::FuzzyController::Config config;
    config.kp = 0.375;
    config.ki = 0.0032;
    config.kv = rule.kv_A_s_m * speed_lsb / ampere_lsb;
    config.eta = adapt ? 0.1 * (0.375 + 0.0032) * rule.kv_A_s_m / kSpeedGain / 32 : 0;
    double x = asked(0) * motor.count_m, v = 0, i_q = 0;
    model.reset(asked(0));
    fuzzy.reset(asked(0));
    for (int n = 0; n < 4 * (motor.circle_ticks + 1); ++n) {
      const double x_m = model.step(asked(n / 4));
      const double error = x_m * motor.count_m - x;
      squares += error * error;
      ++samples;
      const double i_q_ref = fuzzy.step(config, x_m, std::floor(x / motor.count_m + 0.5)).i_q_ref;
      for (int k = 0; k < 80; ++k) {
        constexpr double kStep = 6.25e-6;
        i_q += (i_q_ref * ampere_lsb - i_q) * kStep / 0.25e-3;
        const double friction = motor.coulomb_n * v / std::sqrt(v * v + 0.25e-6);
        v += kStep * (motor.force_n_a * i_q - motor.viscous_n_s_m * v - friction) / motor.mass_kg;
        x += kStep * v;
      }
    }
  }
  return 1e3 * std::sqrt(squares / samples * 2);
}

// A plant whose energies are summed between two commits, in which the legs hold their voltage:
// without dead time no current ends in a diode.
class MeteredPlant final : public cosim::Plant {
 public:
  MeteredPlant(const Motor& motor, const plant::XyTableConfig& config)
      : motor_(motor), plant_(config) {}

  cosim::Lines sense() const override { return plant_.sense(); }
  cosim::Clk next() const override { return plant_.next(); }
  int sample(int channel, cosim::Clk n) const override { return plant_.sample(channel, n); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    for (int axis = 0; axis < kAxes; ++axis) meter(axis, n);
    plant_.commit(n, drive);
    last_ = n;
  }

  double stored_j(int axis) const {
    const plant::AxisState s = plant_.table().state(axis, last_);
    return motor_.mass_kg * s.v_m_s * s.v_m_s / 2 +
           0.75 * motor_.inductance_h * (s.i_d_a * s.i_d_a + s.i_q_a * s.i_q_a);
  }

  std::array<double, kAxes> in_j{}, out_j{}, moved_j{};

 private:
  struct Power {
    double in, out, moved;  // from the link; into heat and friction; through the shaft
  };

  Power power(int axis, cosim::Clk n) const {
    const plant::AxisState s = plant_.table().state(axis, n);
    const plant::Axis& drive = plant_.table().axis(axis);
    const double i_c = -s.i_a_a - s.i_b_a, v = s.v_m_s;
    const double friction = motor_.coulomb_n * v / std::hypot(v, 0.5e-3);
    return {drive.leg_volt(0) * s.i_a_a + drive.leg_volt(1) * s.i_b_a + drive.leg_volt(2) * i_c,
            motor_.resistance_ohm * (s.i_a_a * s.i_a_a + s.i_b_a * s.i_b_a + i_c * i_c) +
                v * (motor_.viscous_n_s_m * v + friction),
            std::abs(v * motor_.force_n_a * s.i_q_a)};
  }

  void meter(int axis, cosim::Clk n) {
    cosim::Clk from = last_;
    if ((n - from) % 2 != 0) add(axis, from, from + 1, 0), ++from;  // an even number is left
    if (n > from) add(axis, from, n, 4);
  }

  // Simpson's rule where the middle weighs 4, the trapezoid's where it does not count.
  void add(int axis, cosim::Clk from, cosim::Clk to, double weight) {
    const Power a = power(axis, from), m = power(axis, (from + to) / 2), b = power(axis, to);
    const double h = static_cast<double>(to - from) * 20e-9 / (2 + weight);
    const auto k = static_cast<std::size_t>(axis);
    in_j[k] += h * (a.in + weight * m.in + b.in);
    out_j[k] += h * (a.out + weight * m.out + b.out);
    moved_j[k] += h * (a.moved + weight * m.moved + b.moved);
  }

  const Motor& motor_;
  TablePlant plant_;
  cosim::Clk last_ = 0;
};

struct Unobserved final : cosim::Observer {
  void on(const cosim::Stop&, const cosim::Chip&, const cosim::Plant&) override {}
};

}  // namespace

TEST_CASE("energy through the chip is balanced for each motor, without dead time") {
  for (const Motor& motor : kMotors) {
    for (const int carrier : {16000, 40000}) {
      Options options = circle(motor, Controller::kAfc);
      options.chip.carrier_Hz = carrier;
      options.chip.dead_time_min_ns = 0;
      for (auto& axis : options.chip.axis) axis.dead_time_ns = 0;
      const auto plan = make_plan(options);
      const sw::KungSetup& setup = plan->setup;
      const sw::Point start = sw::Trajectory(setup).start();
      options.plant.axis[0].start_m = start.x * motor.count_m;
      options.plant.axis[1].start_m = start.y * motor.count_m;
      MeteredPlant plant(motor, options.plant);
      const std::unique_ptr<KungChip> chip = make_twin_chip();
      Unobserved nobody;
      cosim::Loop loop(*chip, plant, nobody);
      sw::KungApp app(setup);
      cosim::run_direct(loop, app, {}, cosim::RunOptions().clocks(0.4), [] { return false; });
      for (int axis = 0; axis < kAxes; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        CAPTURE(motor.name, carrier, axis, plant.in_j[k], plant.out_j[k], plant.moved_j[k]);
        CHECK(plant.moved_j[k] > 0.02);
        CHECK(plant.in_j[k] - plant.out_j[k] - plant.stored_j(axis) ==
              Approx(0).margin((motor.inductance_h < 1e-4 ? 5e-4 : 1e-4) * plant.moved_j[k]));
      }
    }
  }
}

TEST_CASE("motors follow the circle with gains by the rule, as a fast model says") {
  for (const Motor& motor : kMotors) {
    for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
      const Options options = circle(motor, controller);
      Session session(options, {});
      test::run_through(session);
      const auto run = session.result();
      const auto& result = static_cast<const Result&>(*run);
      double squares = 0;
      int samples = 0;
      for (std::size_t n = 0; n < result.samples.size(); ++n) {
        const Sample s = result.samples[n];
        if (s.tick < result.first_tick || s.tick >= result.end_tick) continue;
        for (std::size_t a = 0; a < 2; ++a) {
          const double error =
              s.axis[a].x_m / 16384.0 * motor.count_m - s.axis[a].x_true_m;
          squares += error * error;
        }
        ++samples;
      }
      CAPTURE(motor.name, controller == Controller::kAfc, result.missed, result.from_last_m);
      CHECK(result.end == EndReason::kDone);
      const double ours = 1e3 * std::sqrt(squares / samples);
      CHECK(ours == Approx(fast_rms_mm(motor, controller == Controller::kAfc)).epsilon(0.02));
    }
  }
}
