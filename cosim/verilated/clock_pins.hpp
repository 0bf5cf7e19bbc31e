// SPDX-License-Identifier: Apache-2.0
//
// Clock and reset of a verilated model, by our names or by the usual ones.
#pragma once

namespace trammel::cosim {

template <class Model>
auto clock_pin(Model& model) -> decltype(model.clk_i)& {
  return model.clk_i;
}
template <class Model>
auto clock_pin(Model& model) -> decltype(model.clk)& {
  return model.clk;
}
template <class Model>
auto reset_pin(Model& model) -> decltype(model.rst_i)& {
  return model.rst_i;
}
template <class Model>
auto reset_pin(Model& model) -> decltype(model.rst)& {
  return model.rst;
}

}  // namespace trammel::cosim
