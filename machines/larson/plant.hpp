// SPDX-License-Identifier: Apache-2.0
//
// Two stepper axes of models/ behind the interface of cosim/.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "cosim/fault_plant.hpp"
#include "machines/larson/options.hpp"
#include "machines/larson/pins.hpp"
#include "models/plant/stepper_axis.hpp"

namespace trammel::larson {

// Of an axis whose table starts at `start` [step].
plant::StepperAxisConfig axis_of(const Options& options, double start);

class TablePlant final : public cosim::FalliblePlant {
 public:
  TablePlant(const plant::StepperAxisConfig& x, const plant::StepperAxisConfig& y)
      : axes_{plant::StepperAxis(x), plant::StepperAxis(y)} {}

  const plant::StepperAxis& axis(std::size_t k) const { return axes_[k]; }
  double at(std::size_t k, cosim::Clk edge) const { return axes_[k].state(edge).at; }  // [step]

  // Closed: X low, X high, Y low, Y high.
  unsigned switches() const {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      bits |= (axes_[k].at_low() ? 1u : 0u) << 2 * k | (axes_[k].at_high() ? 2u : 0u) << 2 * k;
    }
    return bits;
  }

  cosim::Lines sense() const override {
    cosim::Lines lines = 0;
    for (int k = 0; k < 2; ++k) {
      const plant::StepperAxis& a = axes_[static_cast<std::size_t>(k)];
      lines |= cosim::Lines{a.at_low()} << limit_low(k) |
               cosim::Lines{a.at_high()} << limit_high(k) |
               cosim::Lines{a.buffer_busy()} << buf_busy(k);
    }
    return lines;
  }
  cosim::Clk next() const override { return std::min(axes_[0].next(), axes_[1].next()); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    for (int k = 0; k < 2; ++k) {
      axes_[static_cast<std::size_t>(k)].drive(n, level(drive, step(k)), level(drive, forward(k)),
                                               level(drive, flush(k)));
    }
  }
  int sample(int, cosim::Clk) const override { return 0; }  // there is no converter

  // With one of five phases dead about three fifths of the torque are left.
  void open_phase(cosim::Clk n, int axis, int, bool open) override {
    axes_[static_cast<std::size_t>(axis)].weaken(n, open ? 0.6 : 1);
  }
  void supply(cosim::Clk n, double share) override {
    for (plant::StepperAxis& axis : axes_) axis.weaken(n, share);
  }
  std::optional<double> supplied(cosim::Clk n) const override {
    return axes_[0].supplied(n) + axes_[1].supplied(n);
  }

 private:
  std::array<plant::StepperAxis, 2> axes_;
};

}  // namespace trammel::larson
