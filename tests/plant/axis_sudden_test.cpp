// SPDX-License-Identifier: Apache-2.0
//
// What moves an axis of a sudden is not seen late, and windings and carriages that are faster than
// the plant's usual spans of 6.25 us follow their closed forms.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "models/plant/axis.hpp"
#include "models/plant/spans.hpp"

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 20e-9;          // [s]
constexpr unsigned kShorted = 070;         // the lower gates
constexpr unsigned kForward = 001 | 060;   // upper a, lower b and c

AxisConfig quick() {
  AxisConfig c;
  c.start_m = 0.3;
  c.mass_kg = 0.1;
  c.coulomb_n = c.viscous_n_s_m = 0;
  return c;
}

// Commits the axis' own events before clock `end`, and gives by how many clocks the latest of them
// was behind the first clock at which the encoder's lines change.
Clk latest(Axis& axis, Clk from, Clk end, unsigned gates) {
  Clk late = 0, edges = 0;
  while (axis.next() < end) {
    const Clk n = axis.next();
    if (axis.encoder().leaves(axis.position(n))) ++edges;
    Clk first = n;
    while (first - 1 > from && axis.encoder().leaves(axis.position(first - 1))) --first;
    late = std::max(late, n - first);
    axis.commit(from = n, gates);
  }
  CHECK(edges > 3);
  return late;
}

constexpr unsigned kAOverBAndC = 1u | 2u << 3 | 4u << 3;

}  // namespace

TEST_CASE("a load that comes while no edge is near is not seen late") {
  for (const Clk begin : {100, 1000, 3000}) {
    AxisConfig c = quick();
    c.load_n = -1000;
    c.brake = false;
    c.load_begin_s = static_cast<double>(begin) * kPeriod;
    Axis axis(c, kPeriod);
    axis.commit(1, kShorted);
    CHECK(latest(axis, 1, begin + 4000, kShorted) == 0);
  }
}

TEST_CASE("a load that goes while no edge is near is not seen late") {
  for (const Clk end : {100, 1000, 3000}) {
    AxisConfig c = quick();
    c.external_force_n = -1000;
    c.load_n = 1000;
    c.brake = false;
    c.load_end_s = static_cast<double>(end) * kPeriod;
    Axis axis(c, kPeriod);
    axis.commit(1, kShorted);
    CHECK(latest(axis, 1, end + 4000, kShorted) == 0);
  }
}

TEST_CASE("the edges of a supply that returns are not seen late") {
  AxisConfig c = quick();
  c.inductance_d_h = c.inductance_q_h = 1e-4;
  c.force_constant_n_a = 10;
  c.encoder_count_m = 1e-7;
  Axis axis(c, kPeriod);
  axis.supply(1, 0);
  axis.commit(1, kForward);
  axis.commit(500, kForward);
  axis.supply(500, 1);
  CHECK(latest(axis, 500, 5000, kForward) == 0);
}

// Thrown up against a stop half a micrometre behind an edge, a carriage falls back over that edge
// in 32 us: sooner than one that has to turn by itself.
TEST_CASE("the edge behind a carriage that a stop turns back is not seen late, at either stop") {
  for (const double sense : {1.0, -1.0}) {
    for (int k = 0; k < 14; ++k) {
      AxisConfig c = quick();
      c.dc_link_v = 10;
      c.encoder_hysteresis_counts = 0;
      c.brake = false;
      (sense > 0 ? c.stroke_max_m : c.stroke_min_m) = c.start_m + sense * 3e-6;
      c.external_force_n = sense * 100;
      c.load_n = -sense * 200;  // 1000 m/s^2 toward the stop, and then back
      c.load_end_s = (2700 + 90 * k) * kPeriod;
      Axis axis(c, kPeriod);
      axis.commit(1, kShorted);
      std::int64_t count = axis.encoder().count();
      int edges = 0;
      for (Clk n = 2, from = 1; n < 12'000; ++n) {
        const bool due = axis.next() == n;
        const bool out = axis.encoder().leaves(axis.position(n));
        CAPTURE(sense, k, n, from);
        REQUIRE((due || !out));
        if (!due) continue;
        axis.commit(from = n, kShorted);
        edges += axis.encoder().count() != count ? 1 : 0;
        count = axis.encoder().count();
      }
      CHECK(edges >= 2);
    }
  }
}

// The gates go off shortly before the carriage meets the stop, so that the diode's current dies out
// in the same span behind it.
TEST_CASE("a stop takes the speed of a carriage, not the current of its diodes, at either stop") {
  for (const double sense : {1.0, -1.0}) {
    AxisConfig c = quick();
    c.brake = false;
    c.external_force_n = -sense * 100;
    (sense > 0 ? c.stroke_max_m : c.stroke_min_m) = c.start_m + sense * 1e-3;
    const Clk met = std::llround(std::sqrt(2 * 1e-3 / 1000) / kPeriod);
    for (Clk off = 20; off <= 140; off += 10) {
      Axis axis(c, kPeriod);
      const auto run = [&](Clk end, unsigned gates) {
        while (axis.next() < end) axis.commit(axis.next(), axis.gates());
        axis.commit(end, gates);
      };
      run(met - off - 100, kForward);
      run(met - off, 0);
      double before = axis.state(met - off).i_a_a, most = 0;
      REQUIRE(before > 0.01);
      bool stood = false;
      for (Clk n = met - off + 1; n < met + 20; ++n) {
        const AxisState s = axis.state(n);
        most = std::max(most, std::fabs(s.i_a_a - before));
        before = s.i_a_a;
        stood = s.v_m_s == 0;
      }
      CAPTURE(sense, off);
      CHECK(stood);
      CHECK(most < 0.3e-3);  // 310 V over a winding and a half, in a clock: 0.18 mA
    }
  }
}

TEST_CASE("a winding of 1 us follows its closed form") {
  AxisConfig c;
  c.resistance_ohm = 100;
  c.inductance_d_h = c.inductance_q_h = 1e-4;
  c.start_m = 0;
  c.locked = true;
  Axis axis(c, kPeriod);
  axis.commit(0, kAOverBAndC);
  const double last = c.dc_link_v / (1.5 * c.resistance_ohm);  // one winding over two
  for (Clk n = 10; n <= 50'000; n += 10) {
    while (axis.next() <= n) axis.commit(axis.next(), kAOverBAndC);
    const double t = static_cast<double>(n) * kPeriod;
    CAPTURE(n);
    REQUIRE(axis.state(n).i_a_a ==
            Approx(last * -std::expm1(-t * c.resistance_ohm / c.inductance_q_h)).epsilon(1e-4));
  }
}

TEST_CASE("a carriage with viscous friction of 10 us settles at its force over its friction") {
  AxisConfig c;
  c.mass_kg = 0.1;
  c.viscous_n_s_m = 10'000;
  c.coulomb_n = 0;
  c.mode_hz = 100;  // only 0.01 kg are not on the spring: 1 us
  c.mode_mass_ratio = 0.9;
  c.external_force_n = -20;
  c.start_m = 0.3;
  c.brake = false;
  Axis axis(c, kPeriod);
  while (axis.next() <= 20'000'000) axis.commit(axis.next(), 0);
  CHECK(axis.state(20'000'000).v_m_s == Approx(20.0 / 10'000).epsilon(1e-3));
  CHECK(axis.state(20'000'000).x_m == Approx(0.3008).margin(1e-5));
}

TEST_CASE("spans are those of the fastest part of a motor, and some are too short") {
  AxisConfig c;
  CHECK(MotorRates(motor_config(c)).span() > 6.25e-6);
  c.resistance_ohm = 1000;
  CHECK(MotorRates(motor_config(c)).span() == Approx(0.1 * c.inductance_q_h / 1000));
  c.inductance_d_h = 1e-4;
  CHECK_THROWS_AS(Axis(c, kPeriod), std::invalid_argument);
}

TEST_CASE("a value that no axis can have is refused by its name and what it must be") {
  using C = AxisConfig;
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const auto refusal = [](const auto& change) -> std::string {
    C c;
    change(c);
    try {
      Axis(c, kPeriod);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const struct {
    const char* name;
    double C::* member;
    double refused;
  } values[]{{"resistance_ohm", &C::resistance_ohm, 0},
             {"inductance_d_h", &C::inductance_d_h, 0},
             {"inductance_q_h", &C::inductance_q_h, 0},
             {"force_constant_n_a", &C::force_constant_n_a, -1},
             {"pole_pitch_m", &C::pole_pitch_m, 0},
             {"mass_kg", &C::mass_kg, 0},
             {"payload_kg", &C::payload_kg, -1},
             {"coulomb_n", &C::coulomb_n, -1},
             {"viscous_n_s_m", &C::viscous_n_s_m, -1},
             {"cogging_n", &C::cogging_n, nan},
             {"friction_speed_m_s", &C::friction_speed_m_s, 0},
             {"external_force_n", &C::external_force_n, nan},
             {"stribeck_n", &C::stribeck_n, -1},
             {"stribeck_speed_m_s", &C::stribeck_speed_m_s, 0},
             {"cogging_harmonic_n", &C::cogging_harmonic_n, nan},
             {"cable_n_m", &C::cable_n_m, -1},
             {"cable_rest_m", &C::cable_rest_m, nan},
             {"mode_hz", &C::mode_hz, -1},
             {"mode_damping", &C::mode_damping, -1},
             {"mode_mass_ratio", &C::mode_mass_ratio, 0},
             {"mode_mass_ratio", &C::mode_mass_ratio, 1},
             {"load_n", &C::load_n, nan},
             {"load_begin_s", &C::load_begin_s, -1},
             {"load_end_s", &C::load_end_s, -1},
             {"stroke_min_m", &C::stroke_min_m, 0.6},
             {"stroke_max_m", &C::stroke_max_m, nan},
             {"dc_link_v", &C::dc_link_v, -1},
             {"supply_ohm", &C::supply_ohm, -1},
             {"dc_link_f", &C::dc_link_f, 0},
             {"chopper_v", &C::chopper_v, -1},
             {"switch_drop_v", &C::switch_drop_v, -1},
             {"diode_drop_v", &C::diode_drop_v, -1},
             {"encoder_count_m", &C::encoder_count_m, 0},
             {"encoder_hysteresis_counts", &C::encoder_hysteresis_counts, -1},
             {"encoder_hysteresis_counts", &C::encoder_hysteresis_counts, 1},
             {"encoder_error_m", &C::encoder_error_m, -1},
             {"encoder_error_m", &C::encoder_error_m, 3.2e-6},
             {"encoder_period_m", &C::encoder_period_m, 0},
             {"encoder_jitter_m", &C::encoder_jitter_m, -1},
             {"index_m", &C::index_m, nan},
             {"current_full_scale_a", &C::current_full_scale_a, 0},
             {"current_noise_a", &C::current_noise_a, -1},
             {"current_offset_a_a", &C::current_offset_a_a, nan},
             {"current_offset_b_a", &C::current_offset_b_a, nan},
             {"current_gain_a", &C::current_gain_a, nan},
             {"current_gain_b", &C::current_gain_b, nan},
             {"start_m", &C::start_m, nan},
             {"longest_span_s", &C::longest_span_s, 0}};
  CHECK(refusal([](C&) {}).empty());
  for (const auto& one : values) {
    for (const double value : {one.refused, nan, infinite, -infinite}) {
      CAPTURE(one.name, value);
      CHECK_THAT(refusal([&](C& c) { c.*one.member = value; }),
                 Catch::Contains(std::string("axis: ") + one.name + ": value "));
    }
  }
  CHECK(refusal([](C& c) { c.adc_bits = 5; }) == "axis: adc_bits: value 5 must be 6 to 16");
  CHECK(refusal([](C& c) { c.cogging_harmonic = 0; }) ==
        "axis: cogging_harmonic: value 0 must be 1 or above");
  CHECK(refusal([](C& c) {
          c.load_begin_s = 2;
          c.load_end_s = 1;
        }) == "axis: load_end_s: value 1 must be 0 or above load_begin_s = 2");
  CHECK(refusal([](C& c) { c.stroke_min_m = 0.7; }) ==
        "axis: stroke_min_m: value 0.7 must be below stroke_max_m = 0.6");
  CHECK(refusal([](C& c) {
          c.stroke_min_m = 0.7;
          c.hard_stops = false;
        }).empty());
}
