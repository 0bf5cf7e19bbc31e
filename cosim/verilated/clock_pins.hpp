// SPDX-License-Identifier: Apache-2.0
//
// Clock and reset of a verilated model, by our names or by the usual ones; enables of its clocks.
#pragma once

#include <type_traits>
#include <utility>

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

template <class Port>
void enable_clocks(Port& port, unsigned domains) {
  port = static_cast<Port>(domains);
}

// Whether a model has clock domains.
template <class Model, class = void>
inline constexpr bool kHasDomains = false;
template <class Model>
inline constexpr bool kHasDomains<Model, std::void_t<decltype(std::declval<Model&>().clock_en_i)>> =
    true;

// Which of them are awake; a block with one enable has no such port.
template <class Model, class = void>
inline constexpr unsigned kAllDomains = 1;
template <class Model>
inline constexpr unsigned
    kAllDomains<Model, std::void_t<decltype(std::declval<Model&>().awake_o)>> = ~0u;

// No clock is gated.
template <class Model>
void enable_all_clocks([[maybe_unused]] Model& model) {
  if constexpr (kHasDomains<Model>) enable_clocks(model.clock_en_i, kAllDomains<Model>);
}

}  // namespace trammel::cosim
