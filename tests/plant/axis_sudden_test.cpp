// SPDX-License-Identifier: Apache-2.0
//
// What moves an axis of a sudden, a load that comes or a supply that returns, is not seen late: how
// far ahead no edge can be was bounded before.
#include <catch2/catch.hpp>

#include <algorithm>

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
