// SPDX-License-Identifier: Apache-2.0
#include "cosim/wave_event.hpp"

#include <algorithm>
#include <iterator>

namespace trammel::cosim {
namespace {

constexpr const char* kEvents[] = {"drive", "hi", "irq"};
enum Event : std::size_t { kDriveChanges, kHostRises, kInterrupts };

bool name_event(Trigger& trigger, const std::string& word) {
  const auto* found = std::find(std::begin(kEvents), std::end(kEvents), word);
  if (found == std::end(kEvents)) return false;
  trigger.when = Trigger::When::kEvent;
  trigger.signal = static_cast<std::size_t>(found - std::begin(kEvents));
  return true;
}

}  // namespace

Trigger parse_wave_event(const std::string& text, const std::vector<Signal>& signals) {
  return parse_trigger(text, {signals, kWaveEvents, name_event});
}

std::vector<std::string> wave_event_names(const std::vector<Signal>& signals) {
  std::vector<std::string> names(std::begin(kEvents), std::end(kEvents));
  for (const std::string& name : signal_names(signals)) names.push_back(name);
  return names;
}

void EventSearch::on(const Stop& stop, const MachineChip& chip, const SignalReader& words) {
  if (found_) return;
  if (trigger_.when != Trigger::When::kEvent) {
    if ((stop.why & kSample) != 0) signal_.after(stop.edge, words);
    found_ = signal_.found();
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

}  // namespace trammel::cosim
