// SPDX-License-Identifier: Apache-2.0
//
// Columns of trace.csv for the words of an LM628, and how runs of machines with such parts end.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

#include "lab/column.hpp"
#include "lab/record.hpp"
#include "parts/lm628/signals.hpp"

namespace trammel::lm628 {

// Columns of kWords[first] to kWords[last]; `words` gives the part's from a row of the table.
template <class Table, class GetWords>
void add_words(Table& t, const std::string& prefix, GetWords words, std::size_t first,
               std::size_t last, const std::string& compared) {
  for (std::size_t n = first; n <= last; ++n) {
    const PartWord& word = kWords[n];
    const double scale = std::ldexp(1.0, -word.fraction);
    t.add({prefix + word.name, word.unit, word.resolution,
           word.fraction == 0 ? lab::whole() : lab::fixed(5), word.help, compared == word.name,
           !word.is_signed},
          [words, scale, read = word.read](const typename Table::At& at) {
            return static_cast<double>(read(words(at))) * scale;
          });
  }
}

// The trajectory.
template <class Table, class GetWords>
void add_trajectory(Table& t, const std::string& prefix, GetWords words, bool compared) {
  add_words(t, prefix, words, 0, 2, compared ? kWords[0].name : "");
}

// The filter and the status; `irq` gives the pin HI.
template <class Table, class GetWords, class GetIrq>
void add_filter_words(Table& t, const std::string& prefix, GetWords words, GetIrq irq,
                      bool output_compared) {
  add_words(t, prefix, words, 3, 3, "e");
  add_words(t, prefix, words, 4, std::size(kWords) - 1, output_compared ? "output" : "");
  t.add({prefix + "host_irq", "", 1, {}, "pin HI", false, true},
        [irq](const typename Table::At& at) { return irq(at) ? 1.0 : 0.0; });
}

// How a run ended, in one line; the script's message where it could not continue.
template <class Options, class Result>
std::string verdict(const lab::Settings& settings, const cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  if (result.end == cosim::EndReason::kDiverged) {
    return fmt::format("diverged: error above run.diverged_counts = {}", options.diverged_counts);
  }
  const bool late = result.end == cosim::EndReason::kTimeout && !result.fault.empty();
  return late ? result.fault : lab::verdict_text(options, result);
}

}  // namespace trammel::lm628
