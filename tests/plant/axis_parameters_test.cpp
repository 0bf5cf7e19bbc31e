// SPDX-License-Identifier: Apache-2.0
//
// Each value of an axis' supply, switches, sensors and encoder reaches its own part, and each line
// of the table is of its own axis.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/plant/xy_table.hpp"

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 20e-9;  // [s]
constexpr unsigned kForward = 1u | 2u << 3 | 4u << 3, kBack = 1u << 3 | 2u | 4u;

AxisConfig standing() {
  AxisConfig c;
  c.start_m = 0.3;
  c.pole_pitch_m = 0.03;  // 0.3 m: angle 0, phase a along d
  return c;
}

void pass(Axis& axis, Clk end, unsigned gates) {
  while (axis.next() <= end) axis.commit(axis.next(), gates);
}

}  // namespace

TEST_CASE("an axis: its chopper limits what a pushed motor charges its link to") {
  AxisConfig c = standing();
  c.coulomb_n = c.viscous_n_s_m = 0;
  c.brake = false;
  c.supply_ohm = 5;
  c.dc_link_v = 40;
  c.dc_link_f = 2e-3;
  c.chopper_v = 42;
  c.external_force_n = -60;
  Axis axis(c, kPeriod);
  double most = 0;
  for (Clk n = 50'000; n <= 4'000'000; n += 50'000) {
    pass(axis, n, 0);
    most = std::max(most, axis.state(n).dc_link_v);
  }
  CHECK(most == Approx(42));
}

TEST_CASE("an axis: its switches and its diodes have their own drops, in each leg") {
  AxisConfig c = standing();
  c.locked = true;
  c.switch_drop_v = 2;
  c.diode_drop_v = 5;
  Axis axis(c, kPeriod);
  axis.commit(1, kForward);
  pass(axis, 50'000, kForward);
  axis.commit(50'000, kForward);
  const std::array<double, 3> through{311 - 2, 2, 2}, freed{-5, 311 + 5, 311 + 5};
  for (std::size_t leg = 0; leg < 3; ++leg) {
    CAPTURE(leg);
    CHECK(axis.leg_volt(leg) == Approx(through[leg]));
  }
  axis.commit(50'100, kBack);  // the currents go on, through the diodes
  for (std::size_t leg = 0; leg < 3; ++leg) {
    CAPTURE(leg);
    CHECK(axis.leg_volt(leg) == Approx(freed[leg]));
  }
}

TEST_CASE("an axis: each sensor has its own gain, offset and bits, and sees its own phase") {
  for (const int bits : {10, 12, 14}) {
    AxisConfig c = standing();
    c.locked = true;
    c.current_full_scale_a = 12;
    c.current_gain_a = 1.1;
    c.current_gain_b = 0.7;
    c.current_offset_a_a = 0.4;
    c.current_offset_b_a = -0.9;
    c.adc_bits = bits;
    Axis axis(c, kPeriod);
    axis.commit(1, kForward);
    pass(axis, 20'000, kForward);
    const AxisState s = axis.state(20'000);
    REQUIRE(s.i_a_a > 2);
    REQUIRE(s.i_b_a < -1);
    const int half = 1 << (bits - 1);
    const auto code = [&](double shown) {
      return half + static_cast<int>(std::floor(shown * half / 12 + 0.5));
    };
    CAPTURE(bits, s.i_a_a, s.i_b_a);
    CHECK(axis.code(0, 1, 0, 20'000) == code(1.1 * s.i_a_a + 0.4));
    CHECK(axis.code(1, 1, 1, 20'000) == code(0.7 * s.i_b_a - 0.9));
  }
}

TEST_CASE("an axis: its encoder has the counts, hysteresis, index, error and period asked") {
  AxisConfig c = standing();
  c.encoder_count_m = 2e-6;
  c.encoder_hysteresis_counts = 0.4;
  c.index_m = 0.3;
  c.encoder_error_m = 0.4e-6;
  c.encoder_period_m = 13e-6;
  const Axis axis(c, kPeriod);
  const auto k = static_cast<double>(axis.encoder().count());
  CHECK(std::fabs(k - 150'000) <= 1);
  const auto boundary = [](double counts) {
    return 2e-6 * counts + 0.4e-6 * std::sin(2 * kPi * counts * 2e-6 / 13e-6);
  };
  CHECK(std::fabs(axis.encoder().low() - (boundary(k - 0.5) - 0.4e-6)) < 1e-12);
  CHECK(std::fabs(axis.encoder().high() - (boundary(k + 0.5) + 0.4e-6)) < 1e-12);
  CHECK(axis.encoder().z() == (axis.encoder().count() == 150'000));
}

TEST_CASE("an axis: one that is locked stays where it is, whatever its gates do, brake or none") {
  for (const bool brake : {false, true}) {
    AxisConfig c = standing();
    c.locked = true;
    c.brake = brake;
    c.external_force_n = 200;
    Axis axis(c, kPeriod);
    for (const unsigned gates : {0u, kForward, kBack, 0u}) {
      axis.commit(axis.next(), gates);
      pass(axis, axis.next() + 100'000, gates);
    }
    CAPTURE(brake);
    CHECK(axis.position(axis.next()) == 0.3);
    CHECK_FALSE(axis.at_stop());
  }
}

TEST_CASE("a table opens the phase asked of the axis asked, and its supply is that of both") {
  for (int k = 0; k < 2; ++k) {
    for (int phase = 0; phase < 3; ++phase) {
      XyTable table(XyTableConfig{});
      table.open_phase(10, k, phase, true);
      for (int other = 0; other < 2; ++other) {
        for (int leg = 0; leg < 3; ++leg) {
          table.commit(20, (Lines{kForward} << 6) | kForward);
          CAPTURE(k, phase, other, leg);
          CHECK(table.axis(other).leg_floats(static_cast<std::size_t>(leg)) ==
                (other == k && leg == phase));
        }
      }
      table.supply(30, 0.5);
      CHECK(table.state(0, 40).dc_link_v == Approx(155.5));
      CHECK(table.state(1, 40).dc_link_v == Approx(155.5));
    }
  }
}

TEST_CASE("a table: each channel is a phase of its axis, and each axis has noise of its own") {
  XyTableConfig c;
  const std::array<double, 4> offset{1, -2, 3, -4};
  for (std::size_t k = 0; k < 2; ++k) {
    c.axis[k].current_offset_a_a = offset[2 * k];
    c.axis[k].current_offset_b_a = offset[2 * k + 1];
    c.axis[k].encoder_jitter_m = 0.1e-6;
  }
  c.axis[1].adc_bits = 10;  // before two zeros in a frame
  XyTable table(c);
  for (int channel = 0; channel < 4; ++channel) {
    CAPTURE(channel);
    const int half = channel < 2 ? 2048 : 512, step = 2048 / half;
    const double shown = offset[static_cast<std::size_t>(channel)] * half / 9.6;
    CHECK(table.sample(channel, 10) ==
          (half + static_cast<int>(std::floor(shown + 0.5))) * step);
  }
  CHECK(table.axis(0).encoder().high() != table.axis(1).encoder().high());
  c.seed = 2;
  CHECK(table.axis(0).encoder().high() != XyTable(c).axis(0).encoder().high());
}

TEST_CASE("a table: an axis has the same bits whatever the other does, and no event is missed") {
  for (int k = 0; k < 2; ++k) {
    XyTableConfig c;
    for (AxisConfig& axis : c.axis) axis.start_m = 0.1;
    XyTable busy(c), quiet(c);
    const auto gates = [k](unsigned own, unsigned other) {
      return Lines{own} << (6 * k) | Lines{other} << (6 * (1 - k));
    };
    for (Clk n = 500; n < 100'000; n += 500) {
      for (XyTable* table : {&busy, &quiet}) {
        const auto drive = [&](Clk at) {
          const unsigned own = at / 4000 % 3 == 0 ? kBack : kForward;
          const unsigned other = table == &quiet ? 0 : at / 1500 % 2 == 0 ? kForward : kBack;
          table->commit(at, gates(own, other));
        };
        while (table->next() < n) {
          REQUIRE(table->next() <= std::min(table->axis(0).next(), table->axis(1).next()));
          drive(table->next());
        }
        drive(n);
      }
      CAPTURE(k, n);
      REQUIRE(busy.axis(k).position(n) == quiet.axis(k).position(n));
      REQUIRE(busy.axis(k).encoder().count() == quiet.axis(k).encoder().count());
    }
    CHECK(std::fabs(busy.axis(1 - k).position(100'000) - 0.1) > 1e-8);
  }
}

TEST_CASE("a table's clocks are those of its chip") {
  for (const std::int64_t clock_ps : {10'000, 20'000, 50'000}) {
    XyTableConfig c;
    c.clock_ps = clock_ps;
    for (AxisConfig& axis : c.axis) {
      axis.start_m = 0.1;
      axis.brake = false;
      axis.coulomb_n = axis.viscous_n_s_m = 0;
      axis.external_force_n = -25;
    }
    XyTable table(c);
    const Clk end = 2'000'000'000 / clock_ps;  // 2 ms
    while (table.next() <= end) table.commit(table.next(), 0);
    for (int k = 0; k < 2; ++k) {
      CAPTURE(clock_ps, k);
      CHECK(table.state(k, end).v_m_s == Approx(25 / 2.5 * 2e-3).epsilon(1e-3));
    }
  }
}
