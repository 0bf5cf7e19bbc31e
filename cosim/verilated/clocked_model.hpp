// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip with a clock clk_i or clk, in its own context. An edge is one evaluation:
// the model's stored clock value is set back by hand, so that the next evaluation sees a rising
// edge. Inputs that changed settle before it. A tracer is told of every edge, and the assertions of
// a checked model are evaluated.
//
// A chip with the ports leap_i, next_o and quiescent_o leaps: while every register waits
// (quiescent_o) the timers alone move, for next_o edges, and one evaluation with leap_i = n - 1
// stands for n of them. No pin may move inside a leap. Every edge of another chip is evaluated.
#pragma once

#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "cosim/cosim.hpp"
#include "cosim/promise.hpp"
#include "cosim/verilated/clock_pins.hpp"
#include "cosim/verilated/tracer.hpp"

namespace trammel::cosim {

// The stored clock value that a model compares with: its name depends on that of the clock and on
// Verilator, 5.006 or 5.48.
template <class Root>
auto stored_clock(Root& root) -> decltype(root.__Vtrigrprev__TOP__clk_i)& {
  return root.__Vtrigrprev__TOP__clk_i;
}
template <class Root>
auto stored_clock(Root& root) -> decltype(root.__Vtrigrprev__TOP__clk)& {
  return root.__Vtrigrprev__TOP__clk;
}
template <class Root>
auto stored_clock(Root& root) -> decltype(root.__Vtrigprevexpr___TOP__clk_i__0)& {
  return root.__Vtrigprevexpr___TOP__clk_i__0;
}
template <class Root>
auto stored_clock(Root& root) -> decltype(root.__Vtrigprevexpr___TOP__clk__0)& {
  return root.__Vtrigprevexpr___TOP__clk__0;
}

// Whether a model has the ports of the leap contract.
template <class Model, class = void>
inline constexpr bool kLeaps = false;
template <class Model>
inline constexpr bool kLeaps<Model, std::void_t<decltype(std::declval<Model&>().leap_i),
                                                decltype(std::declval<Model&>().next_o),
                                                decltype(std::declval<Model&>().quiescent_o)>> =
    true;

template <class Model, class Tracer>
class ClockedModel {
 public:
  ClockedModel(Tracer tracer, ModelMode mode)
      : leap_(mode.leap && !mode.checked), checked_(mode.checked), tracer_(std::move(tracer)) {
    context_->assertOn(mode.checked);
    context_->randReset(2);
    context_->randSeed(1);
    model_ = std::make_unique<Model>(context_.get(), "");  // no scope around the chip's
    if constexpr (kLeaps<Model>) model_->leap_i = 0;
    tracer_.attach(*context_, *model_);
  }

  // The model leaves the context of the thread, which else is that of the chip evaluated last.
  ~ClockedModel() {
    Verilated::threadContextp(context_.get());
    model_->final();
  }

  ClockedModel(const ClockedModel&) = delete;
  ClockedModel& operator=(const ClockedModel&) = delete;

  Model& operator*() const { return *model_; }
  Model* operator->() const { return model_.get(); }
  Tracer& tracer() { return tracer_; }
  bool shows(Clk edge) const { return tracer_.shows(edge); }

  // Before the rising edge: inputs that changed reach the combinational logic.
  void settle(Clk edge, bool changed) {
    const bool shown = shows(edge);
    if (shown) clock_pin(*model_) = 0;
    if (changed) model_->eval();
    if (shown) tracer_.fell(edge);
  }

  void raise(Clk edge) {
    rise();
    tracer_.raised(edge);
    if (checked_ && !broken_) look_for_broken_promise(edge);
  }

  // How many edges from the present one on only count; at least 1, the evaluated one.
  Clk waiting() const {
    if constexpr (kLeaps<Model>) {
      if (leap_ && model_->quiescent_o) return std::max<Clk>(1, model_->next_o);
    }
    return 1;
  }

  // One evaluation for that many edges, at most waiting(). No assertion is checked: a checked model
  // does not leap.
  void leap(Clk edge, Clk clocks) {
    if constexpr (kLeaps<Model>) {
      model_->leap_i = static_cast<std::uint16_t>(clocks - 1);
      rise();
      model_->leap_i = 0;
    }
    tracer_.raised(edge);
  }

  const std::optional<BrokenPromise>& broken_promise() const { return broken_; }

 private:
  void rise() {
    clock_pin(*model_) = 1;
    stored_clock(*model_->rootp) = 0;
    model_->eval();
  }

  void look_for_broken_promise(Clk edge) {
    broken_ = take_broken_promise();
    if (broken_) broken_->edge = edge;
  }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Model> model_;
  bool leap_, checked_;
  Tracer tracer_;
  std::optional<BrokenPromise> broken_;
};

}  // namespace trammel::cosim
