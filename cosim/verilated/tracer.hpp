// SPDX-License-Identifier: Apache-2.0
//
// How a verilated chip is evaluated and traced.
#pragma once

#include "cosim/cosim.hpp"

namespace trammel::cosim {

struct ModelMode {
  bool leap = true;      // waiting clocks are leapt over
  bool checked = false;  // assertions are checked, in every clock
  bool domains = true;   // clock domains that sleep are not evaluated
};

// Tracer: attach(context, model) before time zero; fell(Clk) after the falling edge before each
// rising one for which shows(Clk) holds, and raised(Clk) after every rising edge that is evaluated.
struct NoTrace {
  template <class Context, class Model>
  void attach(Context&, Model&) {}
  static constexpr bool shows(Clk) { return false; }
  void fell(Clk) {}
  void raised(Clk) {}
};

}  // namespace trammel::cosim
