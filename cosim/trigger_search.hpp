// SPDX-License-Identifier: Apache-2.0
//
// Looks for the event of a trigger in a separate run. A chip whose inside is watched shows every
// evaluated edge; of the others the stops of the loop are seen, outputs at their very clock, and
// the words of a sample where it is published.
#pragma once

#include <optional>

#include "cosim/machine_chip.hpp"
#include "cosim/trigger.hpp"
#include "cosim/wave_plan.hpp"

namespace trammel::cosim {

// Events that are visible from outside the chip, for TriggerForms.
inline constexpr const char* kStopEventNames[] = {"drive", "hi", "irq"};
bool name_stop_event(Trigger& trigger, const std::string& word);
// These words and those signals; help: one line of both, with the machine's own meanings.
TriggerForms stop_forms(const std::vector<Signal>& signals, const char* help);

class TriggerSearch final : public Watcher {
 public:
  explicit TriggerSearch(const Trigger& trigger) : trigger_(trigger), signal_(trigger) {}

  // An edge that was evaluated; at the others no signal changes.
  void after(Clk edge, const SignalReader& chip) override;

  // A stop of the loop; `words` are read where a sample was published.
  void on(const Stop& stop, const MachineChip& chip, const SignalReader& words);

  // The first clock edge after which the event is there.
  std::optional<Clk> found() const { return found_; }

 private:
  Trigger trigger_;
  SignalSearch signal_;
  std::optional<Clk> found_;
};

// What a session does for waves: looks for the trigger, or dumps a window, or neither.
struct Waves {
  TriggerSearch* search = nullptr;  // the run ends when it has found its trigger
  std::optional<WaveWindow> window;

  bool found() const { return search != nullptr && search->found(); }
};

// The event that a run's window of waves is anchored to; none when it counts from the start.
// Throws as parse_trigger() does.
std::optional<Trigger> wave_event(const RunOptions& run, const TriggerForms& forms);

}  // namespace trammel::cosim
