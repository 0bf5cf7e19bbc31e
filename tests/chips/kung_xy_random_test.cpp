// SPDX-License-Identifier: Apache-2.0
//
// Both axes of the chip against their twins under random registers, pins and commands, and the
// exact limits at which they trip.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>

#include "models/exact/chips/kung_axis.hpp"
#include "tests/chips/kung_bench.hpp"
#include "tests/support/random.hpp"

using namespace trammel;
namespace reg = trammel::kung_xy_regs;
using test::KungBench;

namespace {

constexpr int kPeriod = 3125;

std::int32_t draw(test::Random& random, int bits) {
  return static_cast<std::int32_t>(test::as_signed(random(), bits));
}

std::uint32_t gain_word(const fixed::Gain& gain) {
  return test::as_bits(gain.exp, 5) << reg::kKpExpShift | test::as_bits(gain.mant, 11);
}

// One axis as its registers and pins are, and its twin.
struct Axis {
  int number = 0;
  std::uint32_t base = 0;
  exact::KungAxis twin{};
  exact::KungAxis::Config config{};
  exact::CurrentLoop::Out now{}, loaded{};  // of the last tick; its compare values act one later
  std::int32_t count = 0, r = 0;
  int quarter = 0;  // of the encoder's lines
  int dead_time = 100;
  std::uint32_t ctrl = 0;
  bool enabled = false, rests = false;
  bool limited = false, saturated = false;

  // Gains that saturate hide what is behind them: most are small.
  void configure(KungBench& chip, test::Random& random) {
    const auto gain = [&random](int most) {
      return fixed::Gain{static_cast<std::int32_t>(random() % 2048), most - int(random() % 8)};
    };
    const auto put = [&](std::uint32_t reg, std::uint32_t data) { chip.write(base + reg, data); };
    exact::Afc::Config& p = config.position;
    p = {};
    if (random() % 2 == 0) {
      p.kp = gain(2);
      p.ki = gain(0);
      p.kv = gain(3);
      p.eta = gain(-2);
      p.shift_e = int(random() % 6) - 2;
      p.shift_de = int(random() % 6) - 2;
    }
    if (random() % 4 == 0) p.eta = gain(10);
    if (random() % 4 == 0) {
      p.a0 = std::int32_t(random() % (1u << 18));
      p.a0_scale = int(random() % 4);
      p.b2 = draw(random, 24);
    }
    p.adapt = random() % 4 != 0;
    p.feedforward = random() % 2 == 0;
    config.kp_cur = gain(3);
    config.ki_cur = gain(0);
    config.theta_ofs = random();
    config.iq_manual = draw(random, 12);
    config.close_position = random() % 4 != 0;
    enabled = random() % 8 != 0;
    const bool current = random() % 8 != 0;
    config.close_current = enabled && current;
    put(reg::kKp, gain_word(p.kp));
    put(reg::kKi, gain_word(p.ki));
    put(reg::kKv, gain_word(p.kv));
    put(reg::kEta, gain_word(p.eta));
    put(reg::kShift, test::as_bits(p.shift_e, 5) << reg::kShiftEShift |
                         test::as_bits(p.shift_de, 5) << reg::kShiftDeShift);
    put(reg::kA0, std::uint32_t(p.a0) | std::uint32_t(p.a0_scale) << reg::kA0ScaleShift);
    put(reg::kB2, test::as_bits(p.b2, 24));
    put(reg::kKpCur, gain_word(config.kp_cur));
    put(reg::kKiCur, gain_word(config.ki_cur));
    put(reg::kThetaOfs, config.theta_ofs);
    put(reg::kIqManual, test::as_bits(config.iq_manual, 12));
    rests = random() % 4 != 0;  // the model starts again where the axis is
    if (rests) put(reg::kCtrl, ctrl | reg::kCtrlResetModel);
    ctrl = (enabled ? reg::kCtrlEnable : 0) | (current ? reg::kCtrlCurrentLoop : 0) |
           (config.close_position ? reg::kCtrlPositionLoop : 0) |
           (p.adapt ? reg::kCtrlAdapt : 0) | (p.feedforward ? reg::kCtrlFeedforward : 0);
    put(reg::kCtrl, ctrl);
    const unsigned filter = 1 + random() % 5;
    const unsigned own = random() % 300, least = chip.read(reg::kDeadtimeMin);
    put(reg::kDeadtime, own | filter << reg::kDeadtimeQepFilterShift);
    dead_time = int(std::max(own, least));
    if (random() % 2 == 0) {  // far away
      count = draw(random, 24);
      put(reg::kPosPreset, test::as_bits(count, 24));
      r = count;
      const int index = int(random() % 49);
      const std::int32_t value = draw(random, 24);
      put(reg::kTabAddr, unsigned(index));
      put(reg::kTabData, std::uint32_t(value));
      twin.position().set_rule(index, value);
    }
  }

  void move(KungBench& chip, int steps) {
    for (int n = 0; n < std::abs(steps); ++n) {
      quarter = (quarter + (steps > 0 ? 1 : 3)) & 3;
      chip.encoder(number, quarter);
      chip.edges(12);
    }
    count = std::int32_t(test::as_signed(std::uint64_t(std::int64_t{count} + steps), 24));
  }

  void check_current(KungBench& chip) const {
    const std::uint32_t i = chip.read(base + reg::kIdIq), v = chip.read(base + reg::kVdVq);
    CHECK(test::as_signed(i, 16) == now.i_d);
    CHECK(test::as_signed(i >> 16, 16) == now.i_q);
    CHECK(test::as_signed(v, 16) == now.v_d);
    CHECK(test::as_signed(v >> 16, 16) == now.v_q);
  }

  void check_position(KungBench& chip, const exact::Afc::Out& out, test::Random& random) {
    const auto same = [&](std::uint32_t offset, std::int32_t expected) {
      INFO(test::register_name(reg::kRegisters, base + offset) << test::after_clock(chip.now()));
      CHECK(chip.read_signed(base + offset) == expected);
    };
    same(reg::kPos, count);
    same(reg::kPosModel, out.x_r);
    same(reg::kErr, out.e);
    same(reg::kDerr, out.de);
    same(reg::kU, out.u);
    same(reg::kVstar, out.v_star);
    same(reg::kSpeed, out.v);
    same(reg::kIqCmd, config.close_position ? out.i_q_ref : config.iq_manual);
    const std::uint32_t status = chip.read(base + reg::kStatus);
    CHECK(status ==
          ((saturated ? reg::kStatusSaturated : 0) | (limited ? reg::kStatusLimited : 0)));
    chip.write(base + reg::kStatus, status);
    CHECK(chip.read(base + reg::kStatus) == 0);
    saturated = limited = false;
    for (int n = 0; n < 6; ++n) {
      const auto fired = exact::RuleStore::fired(out.i, out.j);
      const int index = n < 4 ? fired[std::size_t(n)] : int(random() % 49);
      chip.write(base + reg::kTabAddr, unsigned(index));
      same(reg::kTabData, twin.position().rule(index));
    }
    chip.index(number, true);
    chip.edges(20);
    same(reg::kIndexLatch, count);
    chip.index(number, false);
    chip.edges(20);
  }
};

}  // namespace

TEST_CASE("both axes compute and switch as their twins do under random registers and pins") {
  KungBench chip;
  test::Random random(1);
  std::array<Axis, 2> axes;
  axes[1] = {1, reg::kY};
  std::array<int, 6> hi{}, lo{}, cmp_before{};
  chip.write(reg::kCurrentLimit, 0);
  for (Axis& axis : axes) {
    axis.twin.step16k(axis.config, {}, 0);
    axis.twin.step2k(axis.config, 0, 0);
  }
  for (int period = 1; period <= 640; ++period) {
    CAPTURE(period);
    const bool changes = period % 32 == 1;
    const bool settled = period % 32 > 2;  // the compare values are of these registers
    if (changes) chip.write(reg::kDeadtimeMin, random() % 300);
    for (Axis& axis : axes) {
      if (changes) axis.configure(chip, random);
      const int span = random() % 2 ? 1 : 8;
      auto& codes = chip.codes[std::size_t(axis.number)];
      codes = {unsigned(2048 + draw(random, 12) / span), unsigned(2048 + draw(random, 12) / span)};
      axis.move(chip, int(random() % 13) - 6);
      if (period % 8 == 0) {
        axis.r = std::int32_t(test::as_signed(std::uint64_t(axis.count + draw(random, 11)), 24));
        chip.write(axis.base + reg::kPosCmd, test::as_bits(axis.r, 24));
      }
    }
    if (period % 8 == 0) chip.write(reg::kCommit, reg::kCommitTake);
    chip.edges(int(std::int64_t{kPeriod} * period + 10 - chip.now()));
    for (Axis& axis : axes) {
      CAPTURE(axis.number);
      const int cmp[] = {axis.loaded.cmp_a, axis.loaded.cmp_b, axis.loaded.cmp_c};
      const int next[] = {axis.now.cmp_a, axis.now.cmp_b, axis.now.cmp_c};
      for (int phase = 0; phase < 3; ++phase) {
        const auto gate = std::size_t(3 * axis.number + phase);
        const int on = std::max(3124 - 2 * cmp[phase], 0), off = kPeriod - on;
        const int dead = axis.dead_time;
        // The window ends after the tick: the next period has not switched yet.
        if (settled && axis.enabled && on > dead && next[phase] > 20) {
          CAPTURE(phase, dead, cmp[phase], cmp_before[gate]);
          CHECK(chip.on_hi[gate] - hi[gate] == on - dead);
          // Both lower ends are over in time, that of the period before too.
          const bool whole = std::min(cmp[phase], cmp_before[gate]) > dead + 20;
          if (whole) CHECK(chip.on_lo[gate] - lo[gate] == off - dead);
        }
        cmp_before[gate] = cmp[phase];
        if (settled && !axis.enabled) {
          CHECK(chip.on_hi[gate] + chip.on_lo[gate] == hi[gate] + lo[gate]);
        }
      }
      axis.loaded = axis.now;
      const auto& codes = chip.codes[std::size_t(axis.number)];
      axis.now = axis.twin.step16k(axis.config, {int(codes.a), int(codes.b)}, axis.count);
      axis.limited = axis.limited || axis.now.limited;
    }
    hi = chip.on_hi;
    lo = chip.on_lo;
    chip.edges(150);
    for (Axis& axis : axes) {
      CAPTURE(axis.number);
      axis.check_current(chip);
      if (period % 8 != 0) continue;
      if (axis.rests) axis.twin.position().reset(axis.count);
      const exact::Afc::Out out =
          axis.twin.step2k(axis.config, axis.rests ? axis.count : axis.r, axis.count);
      axis.rests = false;
      axis.saturated = axis.saturated || out.saturated;
      axis.check_position(chip, out, random);
    }
  }
}

TEST_CASE("a phase current of either sign trips at the limit and not below, in both axes") {
  KungBench chip;
  test::Random random(2);
  for (int n = 0; n < 96; ++n) {
    const int limit = n < 22 ? 1 << n / 2 : 1 + int(random() % 2046);
    const int axis = n % 2, phase = n / 2 % 3, sign = n / 6 % 2 ? 1 : -1;
    CAPTURE(n, limit, axis, phase, sign);
    const auto set = [&](int current) {  // of this phase; the others stay below the limit
      const int a = phase == 0 ? current : phase == 1 ? -current / 2 : -(current / 2);
      const int b = phase == 1 ? current : phase == 0 ? -current / 2 : -current - a;
      chip.codes[std::size_t(axis)] = {unsigned(2048 + a), unsigned(2048 + b)};
      chip.leap_until([&] { return chip->adc_cs_n_o == 0; }, kPeriod + 10);
      chip.edges(80);
    };
    chip.write(reg::kCurrentLimit, unsigned(limit));
    set(sign * (limit - 1));
    REQUIRE(chip.fault_code() == reg::kFaultCodeNone);
    set(sign * limit);
    REQUIRE(chip.fault_code() == reg::kFaultCodeOverCurrent);
    REQUIRE(((chip.read(reg::kFault) & reg::kFaultAxis) != 0) == (axis == 1));
    set(0);
    chip.write(reg::kFaultClear, reg::kKeyFaultClear);
    REQUIRE(chip.fault_code() == reg::kFaultCodeNone);
  }
}

TEST_CASE("an enabled stroke trips one count beyond either end, in both axes") {
  KungBench chip;
  test::Random random(3);
  for (int n = 0; n < 200; ++n) {
    const int axis = n % 2;
    const std::uint32_t base = axis == 0 ? reg::kX : reg::kY;
    const std::int32_t one = draw(random, 24), other = n % 4 < 2 ? draw(random, 24) : one + 1;
    const std::int32_t low = std::min(one, other), high = std::max(one, other);
    const auto at = [&](std::int32_t place) {
      chip.write(base + reg::kPosPreset, test::as_bits(place, 24));
      chip.edges(3);
      return chip.fault_code();
    };
    CAPTURE(n, low, high);
    at(low);
    chip.write(base + reg::kStrokeMin, std::uint32_t(low));
    chip.write(base + reg::kStrokeMax, std::uint32_t(high));
    chip.write(base + reg::kStrokeEn, reg::kStrokeEnEnable);
    REQUIRE(at(low) == reg::kFaultCodeNone);
    REQUIRE(at(high) == reg::kFaultCodeNone);
    REQUIRE(at(n % 8 < 4 ? low - 1 : high + 1) == reg::kFaultCodeStroke);
    REQUIRE(((chip.read(reg::kFault) & reg::kFaultAxis) != 0) == (axis == 1));
    chip.write(base + reg::kStrokeEn, 0);
    chip.write(reg::kFaultClear, reg::kKeyFaultClear);
    REQUIRE(chip.fault_code() == reg::kFaultCodeNone);
  }
}

TEST_CASE("while the chip is quiescent its next event comes nearer by one per clock") {
  KungBench chip;
  chip.codes[0] = {2048 + 60, 2048 - 20};
  chip.codes[1] = {2048 - 90, 2048 + 120};
  chip.write(reg::kX + reg::kDeadtime, 1000);
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    chip.write(base + reg::kCtrl, reg::kCtrlEnable | reg::kCtrlCurrentLoop);
  }
  int events = 0;
  for (int n = 0; n < 20 * kPeriod; ++n) {
    const bool quiescent = chip->quiescent_o != 0;
    const int next = chip->next_o;
    const auto hi = chip->gate_hi_o, lo = chip->gate_lo_o;
    chip.edge();
    CAPTURE(n, next);
    if (!quiescent) continue;
    if (next > 1) {
      REQUIRE(chip->next_o == next - 1);
      REQUIRE(chip->quiescent_o);
      REQUIRE(chip->gate_hi_o == hi);
      REQUIRE(chip->gate_lo_o == lo);
    }
    events += next <= 1;
  }
  REQUIRE(events > 100);
}

TEST_CASE("a pin that changes ends quiescence until the encoder interface has followed") {
  KungBench chip;
  chip.until([&] { return chip->quiescent_o != 0 && chip->next_o > 100; });
  for (int axis = 0; axis < 2; ++axis) {
    const auto follows = [&] {
      CAPTURE(axis);
      for (int clock = 0; clock < 5; ++clock) {  // synchroniser and filter
        REQUIRE_FALSE(chip->quiescent_o);
        chip.edge();
      }
      chip.edges(3);
      REQUIRE(chip->quiescent_o);
    };
    for (const int quarter : {1, 2, 3, 0}) {
      chip.encoder(axis, quarter);
      follows();
    }
    for (const bool on : {true, false}) {
      chip.index(axis, on);
      follows();
    }
  }
}

TEST_CASE("a table reset is not quiescent even when all else rests") {
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    KungBench chip;
    chip.until([&] { return chip->quiescent_o != 0 && chip->next_o > 200; });
    chip.write(base + reg::kCtrl, reg::kCtrlResetTable);
    for (int clock = 0; clock < 45; ++clock) {
      REQUIRE_FALSE(chip->quiescent_o);
      chip.edge();
    }
    chip.edges(10);
    REQUIRE(chip->quiescent_o);
  }
}

TEST_CASE("both converters are clocked 16 times per frame, and their clocks rest high between") {
  KungBench chip;
  chip.until([&] { return chip->adc_cs_n_o == 0; });
  int falls = 0;
  while (chip->adc_cs_n_o == 0) {
    const auto before = chip->adc_sclk_o;
    chip.edge();
    REQUIRE((chip->adc_sclk_o == 0 || chip->adc_sclk_o == 3));
    falls += before == 3 && chip->adc_sclk_o == 0;
  }
  REQUIRE(falls == 16);
  for (int clock = 0; clock < 1000; ++clock) {
    REQUIRE(chip->adc_cs_n_o == 3);
    REQUIRE(chip->adc_sclk_o == 3);
    chip.edge();
  }
}
