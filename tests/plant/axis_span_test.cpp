// SPDX-License-Identifier: Apache-2.0
//
// How long a span is must not be seen: the same gates, with spans of 0.5 us.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "models/plant/axis.hpp"

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 20e-9;  // [s]

// Two equal axes but for their spans, under the same gates: each leg changes over by itself, with a
// dead time, and rests for up to 60 us.
struct Pair {
  Axis coarse, fine;
  std::mt19937 random{7};
  unsigned gates = 070;
  Clk now = 0;

  static AxisConfig with(AxisConfig c, double span) {
    c.longest_span_s = span;
    return c;
  }
  explicit Pair(const AxisConfig& c)
      : coarse(c, kPeriod), fine(with(c, 0.5e-6), kPeriod) {}

  static void move(Axis& axis, Clk end, unsigned set) {
    while (axis.next() < end) axis.commit(axis.next(), axis.gates());
    axis.commit(end, set);
  }
  void set(Clk after, unsigned to) {
    now += after;
    gates = to;
    move(coarse, now, gates);
    move(fine, now, gates);
  }
  void turn_over() {
    const auto leg = static_cast<unsigned>(random() % 3);
    const unsigned upper = 1u << leg, lower = 8u << leg;
    const bool up = (gates & lower) != 0;
    set(static_cast<Clk>(1 + random() % 3000), gates & ~(upper | lower));
    set(static_cast<Clk>(1 + random() % 120), gates | (up ? upper : lower));
  }
};

struct Motor {
  std::string name;
  AxisConfig config;
  double within = 1e-6;  // of the largest value, or 10 mm
};

AxisConfig changed(void (*change)(AxisConfig&)) {
  AxisConfig c;
  c.start_m = 0.3;
  c.hard_stops = false;
  change(c);
  return c;
}

}  // namespace

TEST_CASE("spans as long as a motor allows agree with spans of 0.5 us") {
  const Motor motors[]{
      {"default", changed([](AxisConfig&) {})},
      {"slow currents", changed([](AxisConfig& c) { c.resistance_ohm = 2; })},
      {"salient", changed([](AxisConfig& c) { c.inductance_q_h = 40e-3; })},
      {"cogging and harmonic", changed([](AxisConfig& c) {
         c.cogging_n = 20;
         c.cogging_harmonic_n = 5;
         c.cogging_harmonic = 12;
       })},
      {"stribeck", changed([](AxisConfig& c) { c.stribeck_n = 4; })},
      {"light and quick", changed([](AxisConfig& c) {
         c.mass_kg = 0.2;
         c.pole_pitch_m = 2e-3;
       }), 2e-3},  // friction turns over in 17 us
      {"poles that pass fast", changed([](AxisConfig& c) {  // 5000 turns a second
         c.pole_pitch_m = 1e-4;
         c.external_force_n = -100;
         c.viscous_n_s_m = 100;
       }), 5e-5},
      {"elastic", changed([](AxisConfig& c) { c.mode_hz = 120; })},
      {"stiff and elastic", changed([](AxisConfig& c) { c.mode_hz = 800; })},
      {"a soft link", changed([](AxisConfig& c) { c.supply_ohm = 2; })},
      {"drops", changed([](AxisConfig& c) {
         c.switch_drop_v = 1.5;
         c.diode_drop_v = 0.8;
       }), 4e-4},  // the drops change sign where a span begins
  };
  for (const Motor& motor : motors) {
    Pair pair(motor.config);
    double current = 0, speed = 0, worst_current = 0, worst_speed = 0, worst_x = 0;
    for (int k = 0; k < 3000; ++k) {
      pair.turn_over();
      const AxisState a = pair.coarse.state(pair.now), b = pair.fine.state(pair.now);
      current = std::max({current, std::fabs(b.i_d_a), std::fabs(b.i_q_a)});
      speed = std::max(speed, std::fabs(b.v_m_s));
      worst_current = std::max(
          {worst_current, std::fabs(a.i_d_a - b.i_d_a), std::fabs(a.i_q_a - b.i_q_a)});
      worst_speed = std::max(worst_speed, std::fabs(a.v_m_s - b.v_m_s));
      worst_x = std::max(worst_x, std::fabs(a.x_m - b.x_m));
    }
    INFO(motor.name << ": currents to " << current << " A, off by " << worst_current
                    << " A; speed to " << speed << " m/s, off by " << worst_speed << " m/s; by "
                    << worst_x << " m");
    CHECK(current > 0.5);
    CHECK(worst_current < motor.within * current);
    CHECK(worst_speed < motor.within * speed);
    CHECK(worst_x < motor.within * 0.01);
  }
}
