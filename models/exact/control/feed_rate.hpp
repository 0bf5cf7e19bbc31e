// SPDX-License-Identifier: Apache-2.0
//
// Fuzzy feed rate of self-paced tracking (McAfee 1994, appendix D). Twin of
// rtl/control/feed_rate.sv.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class FeedRate {
 public:
  struct In {
    std::int32_t c = 0;   // curvature of the path, 0..255
    std::int32_t cc = 0;  // its change over the preview, 0..255
  };
  struct Out {
    std::int32_t v = 0;  // speed, 0..254
  };

  void reset() {}

  Out step(const In& in) const {
    const Members c = fuzzify(in.c), cc = fuzzify(in.cc);
    std::array<std::int32_t, 3> strength{};
    for (const Rule& rule : kRules) {
      const std::int32_t both = std::min(degree(c, rule.c), degree(cc, rule.cc));
      strength[rule.v] = std::max(strength[rule.v], both);
    }
    std::int64_t weighted = 0, sum = 0;
    for (std::size_t label = 0; label < 3; ++label) {
      weighted += fixed::floor_shift(std::int64_t{strength[label]} * kSingletons[label], 8);
      sum += strength[label];
    }
    // Every input fires a rule, and the average of singletons is below 256.
    return {static_cast<std::int32_t>(fixed::shift_left(weighted, 8) / sum)};
  }

  // Degrees of the labels S, M and L, 255 = 1.
  using Members = std::array<std::int32_t, 3>;

  static Members fuzzify(std::int32_t x) {
    const auto slope = [](std::int32_t from) {
      return static_cast<std::int32_t>(fixed::clip(fixed::floor_shift(32 * from, 4), 0, 255));
    };
    if (x <= 0x80) return {255 - slope(x), slope(x), 0};
    return {0, 255 - slope(x - 0x80), slope(x - 0x80)};
  }

 private:
  enum Label : std::uint8_t { S, M, L, Any };
  struct Rule {
    Label c, cc, v;
  };

  // Column c = L is one rule with a single antecedent: cc does not matter.
  static constexpr std::array<Rule, 7> kRules{
      {{L, Any, S}, {M, L, S}, {S, L, S}, {M, S, M}, {M, M, M}, {S, M, M}, {S, S, L}}};
  static constexpr std::array<std::int32_t, 3> kSingletons{0x00, 0x80, 0xff};

  static std::int32_t degree(const Members& members, Label label) {
    return label == Any ? 255 : members[label];
  }
};

}  // namespace trammel::exact
