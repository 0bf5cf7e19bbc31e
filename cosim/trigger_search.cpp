// SPDX-License-Identifier: Apache-2.0
#include "cosim/trigger_search.hpp"

#include <algorithm>
#include <iterator>

namespace trammel::cosim {
namespace {

enum StopEvent : std::size_t { kDriveChanges, kHostRises, kInterrupts };  // of kStopEventNames

}  // namespace

bool name_stop_event(Trigger& trigger, const std::string& word) {
  const auto* found = std::find(std::begin(kStopEventNames), std::end(kStopEventNames), word);
  if (found == std::end(kStopEventNames)) return false;
  trigger.when = Trigger::When::kEvent;
  trigger.signal = static_cast<std::size_t>(found - std::begin(kStopEventNames));
  return true;
}

TriggerForms stop_forms(const std::vector<Signal>& signals, const char* help) {
  return {signals,
          {std::begin(kStopEventNames), std::end(kStopEventNames)},
          help, "drive", name_stop_event};
}

void TriggerSearch::after(Clk edge, const SignalReader& chip) {
  if (found_) return;
  signal_.after(edge, chip);
  found_ = signal_.found();
}

void TriggerSearch::on(const Stop& stop, const MachineChip& chip, const SignalReader& words) {
  if (found_) return;
  if (trigger_.when != Trigger::When::kEvent) {
    if ((stop.why & kSample) != 0) after(stop.edge, words);
    return;
  }
  if (trigger_.signal == kHostRises) {
    const Clk rise = chip.host_rise();
    if (rise != kNever && rise >= trigger_.edge) found_ = rise;
    return;
  }
  const unsigned why = trigger_.signal == kDriveChanges ? kDrive : kIrq;
  if ((stop.why & why) != 0 && stop.edge >= trigger_.edge) found_ = stop.edge;
}

std::optional<Trigger> wave_event(const RunOptions& run, const TriggerForms& forms) {
  const auto text = wave_trigger_text(run, forms.start);
  if (!text) return {};
  return parse_trigger(*text, forms, run.clock_ps);
}

}  // namespace trammel::cosim
