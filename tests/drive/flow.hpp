// SPDX-License-Identifier: Apache-2.0
//
// Stimuli for blocks of the flow shape.
#pragma once

#include <cstdint>
#include <random>

#include "models/fixed/fixed.hpp"
#include "tests/support/rtl.hpp"

namespace trammel::test {

// Inputs start at random values: without a tick, reset must reach the idle state.
template <class Model>
void begin(Rtl<Model>& rtl) {
  rtl->tick_i = 0;
  rtl.reset();
}

// Gives the tick and runs until valid_o. Returns how many edges after the one that saw the tick
// see valid_o (the Latency of the block), or -1 when it does not come.
template <class Model>
int run_flow(Rtl<Model>& rtl) {
  constexpr int kPatience = 200;
  rtl->tick_i = 1;
  rtl.tick();
  rtl->tick_i = 0;
  for (int edges = 1; edges < kPatience; ++edges) {
    if (rtl->valid_o) return edges;
    rtl.tick();
  }
  return -1;
}

// Random 12-bit words; one in four is an extreme or near zero.
class Words {
 public:
  explicit Words(std::uint32_t seed) : random_(seed) {}

  std::int32_t operator()() {
    constexpr std::int32_t kEdges[] = {-2048, -2047, -1024, -1, 0, 1, 1024, 2047};
    if (below(4) == 0) return kEdges[below(8)];
    return static_cast<std::int32_t>(below(4096)) - 2048;
  }

  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }

 private:
  std::mt19937 random_;  // its sequence is fixed by the standard, a distribution's is not
};

template <class Port>
std::int32_t word(Port value) {
  return static_cast<std::int32_t>(as_signed(value, 12));
}

template <class Port>
void set_word(Port& port, std::int32_t value) {
  port = static_cast<Port>(as_bits(value, 12));
}

// A gain as the packed struct of its port.
inline std::uint16_t gain_bits(const fixed::Gain& g) {
  return static_cast<std::uint16_t>(as_bits(g.exp, 5) << 11 | as_bits(g.mant, 11));
}

}  // namespace trammel::test
