// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/control/rule_store.sv: 49 rules c[j][i], index 7 j + i, Q20 of a unit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class RuleStore {
 public:
  static constexpr int kRules = 49;

  RuleStore() { reset(); }

  // The table of Kung eq. 19 (specification section 5): a plane, clipped at +-6 units.
  static constexpr std::int32_t initial(int index) {
    const int units = 2 * (index / 7 + index % 7 - 6);
    return static_cast<std::int32_t>(fixed::clip(units, -6, 6) * (1 << 20));
  }

  // Indices of the rules around section (i, j): (j,i) (j,i+1) (j+1,i) (j+1,i+1).
  static constexpr std::array<int, 4> fired(int i, int j) {
    const int first = 7 * j + i;
    return {first, first + 1, first + 7, first + 8};
  }

  void reset() {
    for (int n = 0; n < kRules; ++n) rules_[static_cast<std::size_t>(n)] = initial(n);
  }

  // Outside the table: reads 0, writes nothing.
  std::int32_t read(int index) const {
    return valid(index) ? rules_[static_cast<std::size_t>(index)] : 0;
  }
  void write(int index, std::int32_t value) {
    if (valid(index)) {
      rules_[static_cast<std::size_t>(index)] = static_cast<std::int32_t>(fixed::wrap(value, 24));
    }
  }

 private:
  static constexpr bool valid(int index) { return index >= 0 && index < kRules; }

  std::array<std::int32_t, kRules> rules_{};
};

}  // namespace trammel::exact
