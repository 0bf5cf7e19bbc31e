// SPDX-License-Identifier: Apache-2.0
//
// Stimuli for blocks of the flow shape.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <vector>

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

// Law of the flow shape, whatever the block computes: valid_o at the latency only, outputs that
// hold after it while inputs change, ticks inside a calculation ignored, quiescent_o exactly
// between calculations, and reset to `at_rest` from everywhere. `drive` sets random inputs,
// `outputs` reads all outputs but valid_o and quiescent_o.
template <class Model, class Drive, class Outputs>
void require_flow_shape(Rtl<Model>& rtl, int latency, const std::vector<std::int64_t>& at_rest,
                        Drive drive, Outputs outputs) {
  Words words(4);
  const auto below = [&](int n) { return static_cast<int>(words.below(static_cast<unsigned>(n))); };
  const auto rests = [&](int clocks, const std::vector<std::int64_t>& held) {
    for (int k = 0; k < clocks; ++k) {
      drive();
      rtl.eval();
      REQUIRE(rtl->quiescent_o);
      REQUIRE_FALSE(rtl->valid_o);
      REQUIRE(outputs() == held);
      rtl.tick();
    }
  };
  const auto works = [&](int edges) {
    const int second_tick = below(latency);  // 0: none
    for (int edge = 0; edge < edges; ++edge) {
      rtl->tick_i = edge == 0 || edge == second_tick;
      rtl.eval();
      REQUIRE_FALSE(rtl->quiescent_o);
      REQUIRE_FALSE(rtl->valid_o);
      rtl.tick();
    }
    rtl->tick_i = 0;
    rtl.eval();
  };
  begin(rtl);
  rests(3, at_rest);
  for (int n = 0; n < 300; ++n) {
    works(latency);
    REQUIRE(rtl->valid_o);
    REQUIRE_FALSE(rtl->quiescent_o);
    const std::vector<std::int64_t> result = outputs();
    rtl.tick();
    rests(below(5), result);
    if (n % 8 == 0) {
      works(1 + below(latency - 1));
      rtl->tick_i = 1;  // reset wins over a tick
      rtl.reset();
      rtl->tick_i = 0;
      rests(latency + 2, at_rest);
    }
  }
}

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
