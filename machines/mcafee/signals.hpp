// SPDX-License-Identifier: Apache-2.0
//
// What a trigger may name of a run of mcafee: the words of both parts, and of the program.
#pragma once

#include "parts/lm628/signals.hpp"

namespace trammel::mcafee {

// Those behind the signals of the parts, in this order; columns of trace.csv too.
enum class OwnSignal : std::size_t { kRow, kSpeed, kLimits };
inline constexpr cosim::Word kOwnWords[] = {
    {"row", "", "rows begun, Stage III", 16, false},
    {"v", "", "speed of the last of them, 0..255", 8, false},
    {"limits", "", "open switches: bits X low, X high, Y low, Y high", 4, false}};

inline const std::vector<cosim::Signal>& signals() {
  static const std::vector<cosim::Signal> all = [] {
    std::vector<cosim::Signal> list = lm628::signals_of_part(true);
    for (const cosim::Word& word : kOwnWords) list.push_back({word, false});
    return list;
  }();
  return all;
}

inline const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms = cosim::stop_forms(signals(), lm628::kTriggerHelp);
  return forms;
}

}  // namespace trammel::mcafee
