// SPDX-License-Identifier: Apache-2.0
//
// Columns of trace.csv for the words of an LM628, and how runs of machines with such parts end.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "lab/column.hpp"
#include "lab/record.hpp"
#include "parts/lm628/chip.hpp"

namespace trammel::lm628 {

inline constexpr double kPerCount = 65536;  // of a position or speed

// The trajectory: `words` gives those of the part from a row of the table.
template <class Table, class GetWords>
void add_trajectory(Table& t, const std::string& prefix, GetWords words, bool compared) {
  using lab::fixed;
  using At = typename Table::At;
  t.add({prefix + "desired_count", "count", 1e-3, fixed(5), "trajectory generator", compared},
        [words](const At& at) { return static_cast<double>(words(at).position) / kPerCount; });
  t.add({prefix + "desired_speed", "count per sample", 1e-5, fixed(5), "trajectory generator"},
        [words](const At& at) { return static_cast<double>(words(at).speed) / kPerCount; });
  t.add({prefix + "real_count", "count", 1, {}, "what the part counted"},
        [words](const At& at) { return static_cast<double>(words(at).actual); });
}

// The filter and the status; `irq` gives the pin HI.
template <class Table, class GetWords, class GetIrq>
void add_filter_words(Table& t, const std::string& prefix, GetWords words, GetIrq irq,
                      bool output_compared) {
  using At = typename Table::At;
  const auto add = [&](const char* name, const char* unit, auto member, const char* help,
                       bool compared = false, bool bits = false) {
    t.add({prefix + name, unit, 1, {}, help, compared, bits},
          [words, member](const At& at) { return static_cast<double>(words(at).*member); });
  };
  add("e", "count", &Words::error, "position error", true);
  add("p", "", &Words::proportional, "kp e, before its limit of 16 bits");
  add("i", "", &Words::integral, "integral term");
  add("d", "", &Words::derivative, "derivative term");
  add("output", "", &Words::output, "of the filter", output_compared);
  add("status", "", &Words::status, "status byte", false, true);
  t.add({prefix + "host_irq", "", 1, {}, "pin HI", false, true},
        [irq](const At& at) { return irq(at) ? 1.0 : 0.0; });
}

// How a run ended, in one line; a script's own words where it could not go on.
template <class Options, class Result>
std::string verdict(const lab::Settings& settings, const cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  switch (result.end) {
    case cosim::EndReason::kDone: return "done";
    case cosim::EndReason::kFault: return "tripped: " + result.fault;
    case cosim::EndReason::kDiverged:
      return fmt::format("diverged: error above run.diverged_counts = {}",
                         options.diverged_counts);
    case cosim::EndReason::kTimeout:
      return result.fault.empty() ? fmt::format("not finished within run.max_s = {:g}",
                                                options.run.max_s)
                                  : result.fault;
    case cosim::EndReason::kPromise:
      return "assertion failed: " + lab::promise_text(*result.promise);
    default: return lab::end_text(result.end);
  }
}

}  // namespace trammel::lm628
