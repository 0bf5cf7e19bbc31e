// SPDX-License-Identifier: Apache-2.0
//
// The first law of thermodynamics, for each motor of models/: energy from the supply is the rise of
// the stored energy and all losses. Losses are integrated here, by the trapezoidal rule over 1 us.
#include <catch2/catch.hpp>
#include <cmath>

#include "models/plant/leadscrew_axis.hpp"
#include "models/plant/motor_axis.hpp"
#include "models/plant/stepper_axis.hpp"
#include "vector_pwm.hpp"

using namespace trammel::plant;

namespace {

constexpr Clk kMicrosecond = 50;

double square(double x) { return x * x; }

// Of a `Bench` that gives supplied(n) and stored(n) [J], loss(n) [W] and advance(n) over time.
template <class Bench>
void check_balance(Bench bench, Clk end, double tolerance) {
  const double stored = bench.stored(0);
  double lost = 0;
  for (Clk n = 0; n < end; n += kMicrosecond) {
    const double before = bench.loss(n);
    bench.advance(n + kMicrosecond);
    lost += 0.5e-6 * (before + bench.loss(n + kMicrosecond));
    bench.change(n + kMicrosecond);
  }
  const double risen = bench.stored(end) - stored;
  CAPTURE(lost, risen);
  CHECK(lost > 0);
  CHECK(bench.supplied(end) == Approx(lost + risen).epsilon(tolerance));
}

// Both axes of the table are driven forward, then braked by the reverse voltage; a stiff supply is
// at half its voltage in the last quarter.
struct TableBench {
  XyTableConfig config;
  XyTable table{config};
  test::Runner runner{table};

  const AxisConfig& axis(int k) const { return config.axis[static_cast<std::size_t>(k)]; }

  // To a whole PWM period, that is at a multiple of 62.5 us.
  double run(Clk end) {
    double lost = 0;
    const auto before = [&](Clk to) {
      for (Clk n = runner.now; n < to; n += kMicrosecond) {
        const Clk m = std::min(to, n + kMicrosecond);
        lost += 10e-9 * static_cast<double>(m - n) * (loss(n) + loss(m));
      }
    };
    const auto period = [&](Clk n) {
      for (test::Pwm& pwm : runner.pwm) pwm.u_q = n < end / 2 ? 60 : -40;
      if (n == end / 4 * 3 && axis(0).supply_ohm == 0) table.supply(n, 0.5);
    };
    runner.run(end, [](Clk) {}, period, before);
    return lost;
  }

  double loss(Clk n) const {
    double sum = 0;
    for (int k = 0; k < 2; ++k) {
      const AxisConfig& c = axis(k);
      const AxisState s = table.state(k, n);
      const double v = s.v_m_s, i_c = s.i_a_a + s.i_b_a;
      sum += 1.5 * c.resistance_ohm * (square(s.i_d_a) + square(s.i_q_a));
      sum += c.viscous_n_s_m * v * v;
      sum += c.coulomb_n * v * v / std::sqrt(v * v + square(c.friction_speed_m_s));
      sum += c.switch_drop_v * (std::fabs(s.i_a_a) + std::fabs(s.i_b_a) + std::fabs(i_c));
      if (c.supply_ohm != 0) sum += square(std::max(0.0, c.dc_link_v - s.dc_link_v)) / c.supply_ohm;
    }
    return sum;
  }
  double stored(Clk n) const {
    double sum = 0;
    for (int k = 0; k < 2; ++k) {
      const AxisConfig& c = axis(k);
      const AxisState s = table.state(k, n);
      sum += 0.5 * (c.mass_kg + c.payload_kg) * square(s.v_m_s);
      sum += 0.75 * (c.inductance_d_h * square(s.i_d_a) + c.inductance_q_h * square(s.i_q_a));
      sum += c.external_force_n * s.x_m;
      sum -= c.cogging_n * c.pole_pitch_m / (2 * kPi) * std::cos(2 * kPi * s.x_m / c.pole_pitch_m);
      if (c.supply_ohm != 0) sum += 0.5 * c.dc_link_f * square(s.dc_link_v);
    }
    return sum;
  }
  double supplied(Clk n) const { return table.axis(0).supplied(n) + table.axis(1).supplied(n); }
};

void check_table(void (*change)(AxisConfig&), double tolerance) {
  constexpr Clk kEnd = 400 * test::kPeriod;  // 25 ms
  XyTableConfig config = default_xy_table();
  for (AxisConfig& axis : config.axis) {
    axis.start_m = 0.3;
    change(axis);
  }
  TableBench bench{config};
  const double stored = bench.stored(0);
  const double lost = bench.run(kEnd), risen = bench.stored(kEnd) - stored;
  CAPTURE(lost, risen);
  CHECK(lost > 0.1);
  CHECK(bench.supplied(kEnd) == Approx(lost + risen).epsilon(tolerance));
}

double dc_loss(const DcMotorConfig& c, const DcMotorState& s) {
  const double w = s.omega;
  return c.resistance * s.i * s.i + c.viscous * w * w +
         c.coulomb * w * w / std::sqrt(w * w + square(c.friction_speed));
}
double dc_stored(const DcMotorConfig& c, const DcMotorState& s) {
  return 0.5 * (c.inertia * s.omega * s.omega + c.inductance * s.i * s.i);
}

// A DC motor that is sent forth, back with its supply at 70 %, and left.
template <class Axis>
struct DcBench {
  DcMotorConfig motor;
  Axis axis;
  bool bridge;
  double share = 1;

  double command(Clk n) const {
    const double mean = n < 1'000'000 ? 0.6 : n < 2'000'000 ? -0.4 : 0;
    if (!bridge) return mean;
    const double sign = mean < 0 ? -1 : 1;
    return static_cast<double>(n % 2500) < 2500 * std::fabs(mean) ? sign : 0;
  }
  void advance(Clk n) {
    while (axis.next() <= n) axis.commit(axis.next(), command(n - 1));
  }
  void change(Clk n) {
    axis.commit(n, command(n));
    if (n != 1'000'000) return;
    share = 0.7;
    axis.supply(n, share);
  }
  double loss(Clk n) const {
    const DcMotorState s = axis.state(n);
    const bool limited = std::fabs(s.i) >= motor.current_limit;
    const double volt = limited ? motor.resistance * s.i + motor.constant * s.omega
                                : axis.voltage();
    const double amplifier = bridge ? 0 : share * motor.supply * std::fabs(s.i) - volt * s.i;
    return amplifier + dc_loss(motor, s);
  }
  double stored(Clk n) const { return dc_stored(motor, axis.state(n)); }
  double supplied(Clk n) const { return axis.supplied(n); }
};

// A stepper whose pulses end before the rest.
struct StepperBench {
  StepperAxisConfig config;
  StepperAxis axis{config};
  bool high = false;

  void advance(Clk n) {
    while (axis.next() <= n) axis.drive(axis.next(), high, true, false);
  }
  void change(Clk n) {
    high = n < 2'000'000 && n % 20'000 < 1000;
    axis.drive(n, high, true, false);
  }
  double speed(Clk n) const { return axis.state(n).speed * 2 * kPi / config.motor.steps; }
  double loss(Clk n) const {
    const StepperConfig& m = config.motor;
    const double rub = m.friction * std::tanh(axis.state(n).speed / m.friction_speed);
    return axis.current() * m.phase_A * m.winding_ohm + rub * speed(n);
  }
  double stored(Clk n) const { return 0.5 * config.motor.inertia * square(speed(n)); }
  double supplied(Clk n) const { return axis.supplied(n); }
};

}  // namespace

TEST_CASE("a motor on an inverter turns the energy from its supply into heat and motion") {
  check_table([](AxisConfig&) {}, 1e-5);
  check_table([](AxisConfig& c) { c.switch_drop_v = c.diode_drop_v = 2; }, 1e-5);
  check_table([](AxisConfig& c) { c.inductance_q_h *= 1.6; }, 1e-4);
  check_table([](AxisConfig& c) { c.cogging_n = 6, c.external_force_n = 9; }, 1e-5);
  check_table([](AxisConfig& c) { c.supply_ohm = 5; }, 1e-3);
}

TEST_CASE("a DC motor turns the energy from its supply into heat and motion") {
  const MotorAxisConfig c;
  check_balance(DcBench<MotorAxis>{c.motor, MotorAxis(c), false}, 3'000'000, 1e-5);
  check_balance(DcBench<MotorAxis>{c.motor, MotorAxis(c, Amplifier::kBridge), true}, 3'000'000,
                1e-5);
  const LeadscrewConfig screw;
  check_balance(DcBench<LeadscrewAxis>{screw.motor, LeadscrewAxis(screw), false}, 3'000'000, 3e-5);
}

TEST_CASE("a stepper turns the energy into its windings into heat and motion") {
  StepperAxisConfig c;
  c.motor.friction = 0.05;
  check_balance(StepperBench{c}, 1'000'000, 1e-4);  // on its way
  check_balance(StepperBench{c}, 20'000'000, 1e-4);
}
