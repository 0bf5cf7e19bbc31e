// SPDX-License-Identifier: Apache-2.0
//
// What moves an axis of a sudden, a load that comes or goes, a supply that returns or a stop, is
// not seen late: how far ahead no edge can be was bounded before.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "models/plant/axis.hpp"

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
