// SPDX-License-Identifier: Apache-2.0
//
// Cost against encoder speed: both axes move at one constant speed, as a real table never could,
// and no current flows. The chip is that of a run, its drives are on and its firmware writes the
// circle.
#pragma once

#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/session.hpp"
#include "machines/kung/tests/perf/row.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::perf {

// Quadrature of a table at constant speed; Y half an edge behind X, so that no two edges meet.
class MovingTable final : public cosim::Plant {
 public:
  MovingTable(double speed_m_s, std::int64_t clock_ps) {
    if (speed_m_s <= 0) return;
    constexpr double kCountM = 5e-6;  // of an encoder
    const double clocks = kCountM / speed_m_s / (1e-12 * static_cast<double>(clock_ps));
    spacing_ = static_cast<cosim::Clk>(clocks);
    next_ = {spacing_, spacing_ + spacing_ / 2};
  }

  cosim::Lines sense() const override {
    cosim::Lines lines = 0;
    for (std::size_t axis = 0; axis < count_.size(); ++axis) {
      const unsigned phase = count_[axis] & 3u;
      const int k = static_cast<int>(axis);
      lines |= cosim::Lines{phase == 1 || phase == 2} << kung::encoder_a(k);
      lines |= cosim::Lines{phase >= 2} << kung::encoder_b(k);
    }
    return lines;
  }
  cosim::Clk next() const override { return std::min(next_[0], next_[1]); }
  void commit(cosim::Clk n, cosim::Lines) override {
    for (std::size_t axis = 0; axis < count_.size(); ++axis) {
      if (n < next_[axis]) continue;
      ++count_[axis];
      next_[axis] += spacing_;
    }
  }
  int sample(int, cosim::Clk) const override { return 2048; }

 private:
  cosim::Clk spacing_ = 0;
  std::array<cosim::Clk, 2> next_{cosim::kNever, cosim::kNever};
  std::array<unsigned, 2> count_{};
};

struct Nothing final : cosim::Observer {
  void on(const cosim::Stop&, const cosim::Chip&, const cosim::Plant&) override {}
};

inline Outcome run_speed(const Arguments& arguments) {
  const kung::Options& options = arguments.options;
  const auto plan = kung::make_plan(options);
  MovingTable table(arguments.speed_m_s, options.run.clock_ps);
  const auto chip = kung::make_verilated_chip(options.run);
  kung::StallableApp firmware(plan->setup, *chip);
  Nothing nothing;
  cosim::Loop loop(*chip, table, nothing);
  cosim::run_direct(loop, firmware,
                    {options.processor.access_clk, options.processor.interrupt_latency_clk, {},
                     options.point_clk, kung_xy_regs::kX + kung_xy_regs::kPosCmd},
                    options.run.clocks(options.run.max_s), [] { return false; });
  return {chip->now(), chip->evaluated(), 0, 0};
}

}  // namespace trammel::perf
