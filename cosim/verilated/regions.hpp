// SPDX-License-Identifier: Apache-2.0
//
// Clocks of a verilated chip by domain. Verilator compiles an evaluation as regions: the logic that
// follows the inputs, which clocks have risen, and what these move. Called one by one, with the
// risen clocks set by hand, they evaluate the domains that are awake and no other logic.
//
// The names are Verilator's own and change with it. Where gen-model-state knows them, it
// specialises Regions and StoredClocks for the root of a model; else the chip is evaluated as a
// whole.
#pragma once

#include <verilated.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <type_traits>
#include <utility>

#include "cosim/verilated/clock_pins.hpp"

namespace trammel::cosim {

//   static constexpr bool kKnown = true;
//   static constexpr std::size_t kDomains        bits of clock_en_i and awake_o
//   static constexpr std::size_t kTriggers       clocks that the model tells apart
//   static void inputs(Root&)                    the logic behind the inputs follows them
//   static auto& look(Root&)                     clocks that have risen since the last look
//   static auto& move(Root&)                     those by which registers() moves
//   static void registers(Root&)                 registers move, the logic behind them follows
//   static constexpr bool kRegistersOf = true;   and it has
//   static void registers_of<kRisen>(Root&)      the same of these clocks, bit k that of flag k
template <class Root>
struct Regions {
  static constexpr bool kKnown = false;
};

//   static constexpr bool kKnown = true;
//   static void fall(Root&)                      to the model all its clocks are low
template <class Root>
struct StoredClocks {
  static constexpr bool kKnown = false;
};

// Says so once where a chip with clock domains is evaluated as a whole.
inline void tell_whole() {
  static const int told =
      std::fprintf(stderr, "trammel: the regions of Verilator %s are not known: clock domains are "
                           "evaluated together, with the same events, but slower\n",
                   Verilated::productVersion());
  static_cast<void>(told);
}

template <class R, class = void>
inline constexpr bool kHasRegistersOf = false;
template <class R>
inline constexpr bool kHasRegistersOf<R, std::enable_if_t<R::kRegistersOf>> = true;

// registers_of() by the clocks that have risen: of up to so many at once, else null.
template <class R, std::size_t kClocks = 3>
class RegistersOf {
 public:
  using Move = void (*)(typename R::Root&);

  static constexpr Move of(std::size_t risen) { return kMoves[risen]; }

 private:
  static constexpr std::size_t count(std::size_t risen) {
    return risen == 0 ? 0 : (risen & 1u) + count(risen >> 1);
  }
  template <std::size_t risen>
  static constexpr Move pick() {
    if constexpr (count(risen) <= kClocks) {
      return R::template registers_of<static_cast<unsigned>(risen)>;
    } else {
      return nullptr;
    }
  }
  template <std::size_t... risen>
  static constexpr std::array<Move, sizeof...(risen)> all(std::index_sequence<risen...>) {
    return {pick<risen>()...};
  }
  static constexpr auto kMoves = all(std::make_index_sequence<std::size_t{1} << R::kTriggers>{});
};

// Verilator 5.006 has a flag for each clock, 5.48 a bit.
template <class Flags>
auto risen(Flags& flags, std::size_t n) -> decltype(static_cast<bool>(flags.at(n))) {
  return flags.at(n);
}
template <std::size_t words>
bool risen(VlUnpacked<QData, words>& flags, std::size_t n) {
  return (flags[n / 64] >> n % 64 & 1u) != 0;
}
template <class Flags, std::size_t n>
auto raise_clocks(Flags& flags, const std::array<unsigned, n>& clock, unsigned clocks)
    -> decltype(static_cast<void>(flags.at(0))) {
  for (std::size_t k = 0; k < n; ++k) flags.at(k) = (clocks >> clock[k] & 1u) != 0;
}
template <std::size_t words, std::size_t n>
void raise_clocks(VlUnpacked<QData, words>& flags, const std::array<unsigned, n>& clock,
                  unsigned clocks) {
  for (std::size_t w = 0; w < words; ++w) flags[w] = 0;
  for (std::size_t k = 0; k < n; ++k) {
    flags[k / 64] |= static_cast<QData>(clocks >> clock[k] & 1u) << k % 64;
  }
}

// The clocks of a model with domains: bit d is that of domain d, bit kTimers the free-running one.
template <class Model, class Root, class R = Regions<Root>>
class DomainClocks {
 public:
  static constexpr unsigned kTimers = 1u << R::kDomains;
  static constexpr unsigned kAll = 2 * kTimers - 1;

  // Finds by trial which clock each flag of the model stands for; false where a flag is of none or
  // of several, as in a loop of combinational logic.
  bool learn(Model& model) {
    Root& root = *model.rootp;
    std::array<int, R::kTriggers> found{};
    for (unsigned d = 0; d <= R::kDomains; ++d) {
      enable_clocks(model.clock_en_i, (1u << d) & (kTimers - 1));
      model.clk_i = 0;
      R::inputs(root);
      R::look(root);
      model.clk_i = 1;
      R::inputs(root);
      auto& flags = R::look(root);
      for (std::size_t k = 0; k < R::kTriggers; ++k) {
        if (!risen(flags, k)) continue;
        ++found[k];
        clock_[k] = d;  // the free-running clock, which rises each time, is the last
      }
    }
    for (std::size_t k = 0; k < R::kTriggers; ++k) {
      const bool free_running = clock_[k] == R::kDomains;
      if (found[k] != (free_running ? static_cast<int>(R::kDomains) + 1 : 1)) return false;
    }
    if constexpr (kHasRegistersOf<R>) {
      for (unsigned clocks = 0; clocks <= kAll; ++clocks) {
        std::size_t flags = 0;
        for (std::size_t k = 0; k < R::kTriggers; ++k) {
          flags |= static_cast<std::size_t>(clocks >> clock_[k] & 1u) << k;
        }
        move_[clocks] = RegistersOf<R>::of(flags);
      }
    }
    return true;
  }

  void rise(Root& root, unsigned clocks) {
    if constexpr (kHasRegistersOf<R>) {
      if (const auto move = move_[clocks]; move != nullptr) return move(root);
    }
    if (clocks != raised_) raise_clocks(R::move(root), clock_, raised_ = clocks);
    R::registers(root);
  }

 private:
  std::array<unsigned, R::kTriggers> clock_{};
  using Move = void (*)(Root&);
  std::array<Move, kHasRegistersOf<R> ? kAll + 1 : 1> move_{};  // of these clocks; null: by flags
  unsigned raised_ = 0;  // the model leaves its flags as they are
};

}  // namespace trammel::cosim
