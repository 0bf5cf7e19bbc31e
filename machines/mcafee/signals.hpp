// SPDX-License-Identifier: Apache-2.0
//
// What a trigger may name of a run of mcafee: the words of both parts, and of the program.
#pragma once

#include "parts/lm628/signals.hpp"

namespace trammel::mcafee {

// Those behind the signals of the parts, in this order.
enum class OwnSignal : std::size_t { kRow, kSpeed, kLimits };

inline const std::vector<cosim::Signal>& signals() {
  static const std::vector<cosim::Signal> all = [] {
    std::vector<cosim::Signal> list = lm628::signals_of_part(true);
    list.push_back({{"row", "", "rows begun, Stage III", 16, false}, false});
    list.push_back({{"v", "", "speed of the last of them", 8, false}, false});
    list.push_back(
        {{"limits", "", "open switches: bits X low, X high, Y low, Y high", 4, false}, false});
    return list;
  }();
  return all;
}

}  // namespace trammel::mcafee
