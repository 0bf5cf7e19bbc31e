// SPDX-License-Identifier: Apache-2.0
//
// The RTL of the LM628 beside its twin, with every pin compared at every evaluated clock, leaping
// with the clocks of its sleeping domains off, or neither.
#pragma once

#include <Vlm628.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "tests/chips/lm628_bench.hpp"

namespace trammel::test {

// next_o of the RTL is below the twin's while its engine works: the twin waits for it.
class Lm628Pair : public Lm628Twin {
 public:
  bool leaps = true;

  Lm628Pair() {
    rtl_->leap_i = 0;
    apply();
    rtl_.reset();
  }

  std::int64_t run(std::int64_t n) {
    apply();
    std::int64_t gap = 1;
    // A sample takes 400 clocks, a command 128: after them the RTL rests wherever the twin does.
    restless_ = !rtl_->quiescent_o && twin_.next(in) > 0 ? restless_ + 1 : 0;
    if (restless_ > 600) throw std::logic_error("the RTL does not rest" + after_clock(clock_));
    if (leaps && rtl_->quiescent_o && rtl_->next_o > 0) {
      same("quiescent_o", rtl_->quiescent_o, twin_.quiescent(in), clock_);
      gap = std::min<std::int64_t>({rtl_->next_o, twin_.next(in), n});
      same("next_o", rtl_->next_o, std::min<exact::Gap>(twin_.next(in), 4095), clock_);
    }
    if (twin_.next(in) >= gap) {
      twin_.advance(static_cast<exact::Gap>(gap));
    } else {
      twin_.step(in);
    }
    rtl_->leap_i = (gap - 1) & 0xFFF;
    cosim::enable_clocks(rtl_->clock_en_i, leaps ? unsigned{rtl_->awake_o} : ~0u);
    rtl_.tick();
    rtl_->leap_i = 0;
    rtl_.eval();
    clock_ += gap;
    compare();
    return gap;
  }

 private:
  void apply() {
    set_pins(rtl_, in);
    rtl_->wrap_i = in.wrap;
    rtl_->d_i = in.host.d;
    rtl_.eval();
  }

  void compare() {
    const Lm628::Out out = twin_.out();
    same("d_o", rtl_->d_o, out.d, clock_);
    same("d_oe_o", rtl_->d_oe_o, out.d_oe, clock_);
    same_pins(rtl_, out, clock_);
  }

  Rtl<Vlm628> rtl_;
  std::int64_t clock_ = 0;
  int restless_ = 0;  // [clk]
};

}  // namespace trammel::test
