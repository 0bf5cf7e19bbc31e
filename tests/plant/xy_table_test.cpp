// SPDX-License-Identifier: Apache-2.0
#include "models/plant/xy_table.hpp"

#include <catch2/catch.hpp>
#include <cstring>

#include "tests/plant/vector_pwm.hpp"

using namespace trammel::plant;
namespace xy = trammel::xy;
using trammel::plant::test::kPeriod;
using trammel::plant::test::Runner;

namespace {

constexpr Clk kMillisecond = 50000;
constexpr Lines kAllLow = 0b111000'111000;

XyTableConfig unbraked() {
  XyTableConfig c = default_xy_table();
  for (AxisConfig& axis : c.axis) axis.brake = false;
  return c;
}

XyTableConfig middle() {
  XyTableConfig c = unbraked();
  c.axis[0].start_m = 0.3;
  c.axis[1].start_m = 0.2;
  return c;
}

std::uint64_t mix(std::uint64_t h, double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return hash(h ^ bits);
}

std::uint64_t mix(std::uint64_t h, const AxisState& s) {
  for (const double x : {s.x_m, s.v_m_s, s.i_d_a, s.i_q_a, s.i_a_a, s.i_b_a, s.force_n})
    h = mix(h, x);
  return h;
}

// Holds the drive constant for a time, committing only the table's own events.
void coast(XyTable& t, Clk& now, Clk clocks, Lines drive) {
  t.commit(now, drive);
  const Clk end = now + clocks;
  while (t.next() <= end) t.commit(now = t.next(), drive);
  now = end;
}

}  // namespace

TEST_CASE("next() is the first clock at which the position leaves the count") {
  XyTable table(middle());
  Runner run{table};
  run.pwm[0].u_q = 60;
  run.pwm[1].u_q = -45;
  std::array<Encoder, 2> reference{Encoder({}, 0.3), Encoder({}, 0.2)};
  Clk asked = 0;
  long edges = 0, missed = 0;
  // An encoder that looks at every clock must step where the table's does, and nowhere else.
  const auto ask = [&](Clk to) {
    for (int k = 0; k < 2; ++k) {
      Encoder& e = reference[static_cast<std::size_t>(k)];
      const Axis& axis = table.axis(k);
      for (Clk n = asked + 1; n <= to; ++n) {
        const bool leaves = e.leaves(axis.position(n));
        if (leaves && n < axis.next()) ++missed;
        if (n == axis.next()) edges += leaves;
        if (leaves) e.follow(axis.position(n));
      }
    }
    asked = to;
  };
  const auto compare = [&](Clk) {
    for (int k = 0; k < 2; ++k) {
      if (table.count(k) != reference[static_cast<std::size_t>(k)].count()) ++missed;
    }
  };
  run.run(
      90 * kMillisecond, compare, [](Clk) {}, ask);
  CHECK(missed == 0);
  CHECK(edges > 5000);
  CHECK(table.count(0) > 60000 + 3000);
  CHECK(table.count(1) < 40000 - 1000);
}

TEST_CASE("edges of a light carriage that starts hard and reverses are found to the clock") {
  AxisConfig c;
  c.mass_kg = 0.02;  // thousands of m/s^2: leaves a count and comes back inside one span
  c.coulomb_n = 0.05;
  c.hard_stops = false;
  const unsigned forth = 0b101'010, back = 0b011'100;  // along B and C, near theta = 0
  struct Result {
    double peak = 0;
    long missed = 0, edges = 0;
  };
  const auto run = [&](double start) {
    c.start_m = start;
    Axis axis(c, 20e-9);
    Encoder reference({}, start);
    Result r;
    axis.commit(0, forth);
    for (Clk n = 1; n <= 20000; ++n) {
      const double x = axis.position(n);
      r.peak = std::max(r.peak, x);
      if (reference.leaves(x)) {
        ++r.edges;
        reference.follow(x);
        r.missed += n != axis.next();
      }
      if (n == axis.next()) axis.commit(n, axis.gates());
      if (n == 6000) axis.commit(n, back);
      r.missed += axis.encoder().count() != reference.count();
    }
    return r;
  };
  double start = 0.305;
  const double edge = (std::floor(run(start).peak / 5e-6) + 0.6) * 5e-6;
  for (int k = 0; k < 6; ++k) start += edge - run(start).peak;
  CHECK(run(start).peak == Approx(edge).margin(1e-10));  // the carriage turns at an edge
  for (int k = -4; k < 40; ++k) {
    const Result r = run(start + k * 3e-10);
    CHECK(r.missed == 0);
    CHECK(r.edges > 4);
  }
  CHECK(run(0.305 + 0.6 * 5e-6 - 1e-9).missed == 0);  // at rest just below an edge
}

TEST_CASE("questions between commits change nothing") {
  XyTable asked(middle()), silent(middle());
  Runner a{asked}, s{silent};
  a.pwm[0].u_q = s.pwm[0].u_q = 50;
  std::uint64_t h_a = 1, h_s = 1;
  const auto look = [](const XyTable& t, std::uint64_t& h, Clk n) {
    h = hash(h ^ static_cast<std::uint64_t>(n) ^ (t.sense() << 40));
    h = mix(mix(h, t.state(0, n)), t.state(1, n));
  };
  std::uint64_t ignored = 0;
  a.run(20 * kMillisecond, [&](Clk n) {
    look(asked, h_a, n);
    for (Clk k = n; k < asked.next(); k += 37) {
      ignored = mix(ignored, asked.state(0, k));
      ignored += static_cast<std::uint64_t>(asked.sample(3, k));
    }
  });
  s.run(20 * kMillisecond, [&](Clk n) { look(silent, h_s, n); });
  CHECK(a.commits == s.commits);
  CHECK(h_a == h_s);
}

TEST_CASE("two runs with the same seed give the same bits, another seed gives other noise") {
  std::array<std::uint64_t, 3> h{};
  for (std::size_t k = 0; k < 3; ++k) {
    XyTableConfig c = middle();
    c.axis[0].current_noise_a = 0.02;
    c.seed = k == 2 ? 99 : 5;
    XyTable t(c);
    Runner run{t};
    const auto sample = [&](Clk n) {
      for (int ch = 0; ch < 4; ++ch)
        h[k] = hash(h[k] ^ static_cast<std::uint64_t>(t.sample(ch, n)));
    };
    run.run(
        5 * kMillisecond, [&](Clk n) { h[k] = mix(h[k], t.state(0, n)); }, sample, [](Clk) {});
  }
  CHECK(h[0] == h[1]);
  CHECK(h[0] != h[2]);
}

TEST_CASE("a commit at every clock agrees with commits at events") {
  const AxisConfig c = middle().axis[0];
  Axis often(c, 20e-9), seldom(c, 20e-9);
  const unsigned gates = 0b110'001;
  often.commit(0, gates);
  seldom.commit(0, gates);
  for (Clk n = 1; n <= 30000; ++n) {
    often.commit(n, gates);
    if (n == seldom.next()) seldom.commit(n, gates);
    // Other series carry the same motion: rounding of 30000 steps and truncation, far below a
    // count.
    REQUIRE(std::fabs(often.position(n) - seldom.position(n)) < 1e-10);
    REQUIRE(std::abs(often.encoder().count() - seldom.encoder().count()) <= 1);
  }
  CHECK(often.state(30000).i_q_a == Approx(seldom.state(30000).i_q_a).margin(1e-7));
  CHECK(often.encoder().count() == seldom.encoder().count());
  CHECK(seldom.encoder().count() != 60000);
}

TEST_CASE("a stop takes the whole speed and releases when the force reverses") {
  XyTableConfig c = unbraked();
  c.axis[0].start_m = 0.001;
  c.axis[0].external_force_n = 20;
  XyTable t(c);
  Clk now = 0;
  coast(t, now, 200 * kMillisecond, 0);
  CHECK(t.at_stop(0));
  CHECK(t.state(0, now).x_m == 0);
  CHECK(t.state(0, now).v_m_s == 0);
  CHECK(t.count(0) == 0);
  // At count 0 theta is 0: the q axis is beta, so B high, C low pushes up with u_beta = 311/sqrt 3.
  coast(t, now, 5 * kMillisecond, 0b001'000 << 2 | 0b010);
  CHECK_FALSE(t.at_stop(0));
  CHECK(t.state(0, now).x_m > 0);
}

TEST_CASE("a brake holds the carriage against any force until a gate is on, and not after") {
  XyTableConfig c = middle();
  c.axis[0].external_force_n = 200;
  c.axis[0].brake = true;
  XyTable t(c);
  Clk now = 0;
  coast(t, now, 100 * kMillisecond, 0);
  CHECK((t.state(0, now).x_m == 0.3 && t.state(0, now).v_m_s == 0 && !t.at_stop(0)));
  coast(t, now, kMillisecond, 0b001);
  coast(t, now, 10 * kMillisecond, 0);
  CHECK(t.state(0, now).x_m < 0.299);
}

TEST_CASE("the upper stop holds at 600 mm") {
  XyTableConfig c = unbraked();
  c.axis[1].start_m = 0.599;
  c.axis[1].external_force_n = -30;
  XyTable t(c);
  Clk now = 0;
  coast(t, now, 200 * kMillisecond, 0);
  CHECK(t.at_stop(1));
  CHECK(t.state(1, now).x_m == 0.6);
  CHECK(t.count(1) == 120000);
}

TEST_CASE("without hard stops the carriage passes 0 and counts below it") {
  XyTableConfig c = unbraked();
  c.axis[0].hard_stops = false;
  c.axis[0].external_force_n = 20;
  XyTable t(c);
  Clk now = 0;
  coast(t, now, 50 * kMillisecond, 0);
  CHECK(t.count(0) < -100);
}

TEST_CASE("with all gates off the current dies through the diodes and stays zero") {
  XyTable t(middle());
  Clk now = 0;
  coast(t, now, 25000, 0b110'001);
  const double before = t.state(0, now).i_a_a;
  CHECK(before > 1);
  coast(t, now, 20000, 0);  // the full link opposes: L/R ln(1 + 3.4 R/207 V) = 0.32 ms
  for (Clk n = now; n < t.next(); n += 100) {
    const AxisState s = t.state(0, n);
    REQUIRE(s.i_a_a == 0);
    REQUIRE(s.i_b_a == 0);
    REQUIRE(s.force_n == 0);
  }
  CHECK(t.sample(0, now) == 2048);
  CHECK(t.axis(0).leg_floats(0));
}

TEST_CASE("a current that ends in one leg goes on in the other two") {
  XyTableConfig c = middle();
  c.axis[0].mass_kg = 1e6;  // standing: no back-EMF
  c.axis[0].start_m = 0.3 + 0.01;
  XyTable t(c);
  Clk now = 0;
  coast(t, now, 40000, 0b110'001);
  const AxisState s = t.state(0, now);
  CHECK(s.i_b_a == Approx(-0.5 * s.i_a_a).epsilon(1e-6));
  // A on, B low, C off: C's upper diode opposes, i_c ends, then A and B carry on alone.
  coast(t, now, 400000, 0b010'001);
  const AxisState e = t.state(0, now);
  CHECK(e.i_a_a + e.i_b_a == Approx(0).margin(1e-12));
  CHECK(e.i_a_a == Approx(311 / 54.0).epsilon(1e-3));
  CHECK(t.axis(0).leg_floats(2));
  CHECK(t.axis(0).leg_volt(2) == Approx(311 / 2.0).epsilon(1e-3));
}

TEST_CASE("a pushed motor with its gates off feeds the link only above the link voltage") {
  for (const double link : {311.0, 24.0}) {
    XyTableConfig c = unbraked();
    c.axis[0].hard_stops = false;
    c.axis[0].dc_link_v = link;
    c.axis[0].external_force_n = -23;
    XyTable t(c);
    Clk now = 0;
    coast(t, now, 700 * kMillisecond, 0);
    double peak = 0;
    for (int k = 0; k < 300; ++k) {
      coast(t, now, 9973, 0);
      const AxisState s = t.state(0, now);
      peak = std::max(peak, std::hypot(s.i_d_a, s.i_q_a));
      if (link < 100) REQUIRE(s.force_n <= 1e-3);  // it can only brake
    }
    // Open: (F - F_c)/B = 1 m/s; line back-EMF peak sqrt 3 * 53.267 = 92 V, of 24 V or 311 V.
    const double v = t.state(0, now).v_m_s;
    if (link > 100) {
      CHECK(peak == 0);
      CHECK(v == Approx(1.0).epsilon(0.01));
    } else {
      CHECK(peak > 0.05);
      CHECK(v < 0.6);
      CHECK(v > 24 / 92.3 * 0.9);
    }
  }
}

TEST_CASE("all lower switches on brake the motor") {
  XyTableConfig c = unbraked();
  c.axis[0].hard_stops = false;
  c.axis[0].external_force_n = -23;
  XyTable t(c);
  Clk now = 0;
  coast(t, now, 300 * kMillisecond, kAllLow);
  const double v = t.state(0, now).v_m_s;
  // Shorted: F_e = -1.5 (k lambda)^2 v R/(R^2 + (w L)^2) = -157.6 v about, so 20 = (20 + 157.6) v.
  CHECK(v == Approx(20 / 177.6).epsilon(0.01));
}

TEST_CASE("dead time takes voltage against the sign of the current") {
  // A standing motor at theta = 0, u along alpha (d axis): the mean current shows the mean voltage.
  for (const double u : {30.0, -30.0}) {
    std::array<double, 2> mean{};
    for (const Clk dead : {Clk{1}, Clk{100}}) {
      XyTableConfig c = unbraked();
      c.axis[0].mass_kg = 1e6;
      XyTable t(c);
      Runner run{t};
      run.pwm[0].u_d = u;
      run.pwm[0].u_q = 0;
      run.pwm[0].dead_time = dead;
      run.run(640 * kPeriod / 10, [](Clk) {});
      double sum = 0;
      int count = 0;
      for (int k = 0; k < 8 * kPeriod; k += 125) {
        run.run(run.now + 125, [](Clk) {});
        sum += t.state(0, run.now).i_d_a;
        ++count;
      }
      mean[dead == 1 ? 0 : 1] = sum / count * 27;
    }
    CHECK(mean[0] == Approx(u).epsilon(0.03));  // duty in whole clocks and 1 clk of dead time
    // A loses V_dc td/T = 9.95 V, B and C gain it; in the mean vector 4/3 of that, against the
    // sign.
    const double loss = 4.0 / 3 * 311 * 99 / 3125.0;
    CHECK(mean[0] - mean[1] == Approx(u > 0 ? loss : -loss).epsilon(0.1));
  }
}

TEST_CASE("energy taken from the link equals loss, friction and stored energy") {
  XyTableConfig c = middle();
  XyTable t(c);
  Runner run{t};
  run.pwm[0].u_q = 60;
  double in = 0, out = 0;
  AxisState a = t.state(0, 0);
  Clk from = 0;
  std::array<double, 3> volt{};
  const auto close = [&](Clk n) {
    // Trapezoids between commits; the legs hold their voltage but where a diode current dies.
    if (n == from) return;
    const double h = static_cast<double>(n - from) * 20e-9;
    const AxisState b = t.state(0, n);
    for (const AxisState& s : {a, b}) {
      const double i_c = -s.i_a_a - s.i_b_a;
      const double friction = 3 * s.v_m_s / std::hypot(s.v_m_s, 0.5e-3);
      in += 0.5 * h * (volt[0] * s.i_a_a + volt[1] * s.i_b_a + volt[2] * i_c);
      out += 0.5 * h *
             (27 * (s.i_a_a * s.i_a_a + s.i_b_a * s.i_b_a + i_c * i_c) +
              s.v_m_s * (20 * s.v_m_s + friction));
    }
    a = b;
    from = n;
  };
  run.run(100 * kMillisecond, [&](Clk n) {
    close(n);
    for (std::size_t k = 0; k < 3; ++k) volt[k] = t.axis(0).leg_volt(k);
  });
  const AxisState e = t.state(0, from);
  const double stored =
      0.5 * 2.5 * e.v_m_s * e.v_m_s + 0.75 * 23.3e-3 * (e.i_d_a * e.i_d_a + e.i_q_a * e.i_q_a);
  CHECK(in > 2);
  // Trapezoids between commits (some 10 us against L/R = 0.86 ms): (h R/L)^2 = 1e-4 and better.
  CHECK(in == Approx(out + stored).epsilon(2e-4));
}

TEST_CASE("both switches of a leg on are told, of each leg of X and of Y, and not forgotten") {
  for (int axis = 0; axis < xy::kAxes; ++axis) {
    for (int phase = 0; phase < 3; ++phase) {
      CAPTURE(axis, phase);
      XyTable table(middle());
      table.commit(0, kAllLow);
      CHECK_FALSE(table.shoot_through());
      table.commit(10, kAllLow | Lines{1} << xy::gate_hi(axis, phase));
      CHECK(table.shoot_through());
      table.commit(20, kAllLow);
      CHECK(table.shoot_through());
    }
  }
}
