// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip with the ports clk_i, leap_i, next_o and quiescent_o, in a context of its own.
// An edge is one evaluation: the model's stored clock value is set back by hand, so that the next
// evaluation sees a rising edge. Inputs that changed settle before it.
//
// While every register waits (quiescent_o) the timers alone move, for next_o edges: one evaluation
// with leap_i = n - 1 stands for n of them. No pin may move inside a leap.
#pragma once

#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

// The clock value that a model compares with: its name is that of Verilator 5.006, or of 5.48.
template <class Root>
auto stored_clock(Root& root, int) -> decltype(root.__Vtrigrprev__TOP__clk_i)& {
  return root.__Vtrigrprev__TOP__clk_i;
}
template <class Root>
auto stored_clock(Root& root, long) -> decltype(root.__Vtrigprevexpr___TOP__clk_i__0)& {
  return root.__Vtrigprevexpr___TOP__clk_i__0;
}

template <class Model>
class ClockedModel {
 public:
  // leap: waiting() may be more than one edge; checked: assertions are looked at.
  explicit ClockedModel(bool leap, bool checked = false) : leap_(leap) {
    context_->assertOn(checked);
    context_->randReset(2);
    context_->randSeed(1);
    model_ = std::make_unique<Model>(context_.get(), "");  // no scope around the chip's
    model_->leap_i = 0;
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
  VerilatedContext& context() const { return *context_; }

  void raise() {
    model_->clk_i = 1;
    stored_clock(*model_->rootp, 0) = 0;
    model_->eval();
  }

  // Edges from the present one on that only count; at least 1, the evaluated one.
  Clk waiting() const {
    if (!leap_ || !model_->quiescent_o) return 1;
    return std::max<Clk>(1, model_->next_o);
  }

  // One evaluation for so many edges, at most waiting().
  void leap(Clk clocks) {
    model_->leap_i = static_cast<std::uint16_t>(clocks - 1);
    raise();
    model_->leap_i = 0;
  }

 private:
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Model> model_;
  bool leap_;
};

}  // namespace trammel::cosim
