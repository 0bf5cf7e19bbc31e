// SPDX-License-Identifier: Apache-2.0
//
// Triggers of a chip with a host: cosim/trigger.hpp with these words, which are seen from outside
// the chip at their very clock, and the words of its samples, seen where a sample is published.
//
//   EVENT := drive | hi | irq
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cosim/machine_chip.hpp"
#include "cosim/trigger.hpp"
#include "cosim/wave_plan.hpp"

namespace trammel::cosim {

// One line of it, for help texts.
inline constexpr char kWaveEvents[] =
    "drive (a converter's code changes), hi (the pin HI rises), irq (HI or the timer interrupts), "
    "at 10ms, rise|fall|change status.breakpoint, e > 20, each with `after TIME` behind it if "
    "wanted";

// Throws UnknownName, or std::invalid_argument that says what is wrong and what is allowed.
Trigger parse_wave_event(const std::string& text, const std::vector<Signal>& signals);

// All that may stand for a NAME or EVENT, for suggestions.
std::vector<std::string> wave_event_names(const std::vector<Signal>& signals);

class EventSearch {
 public:
  static constexpr char kStart[] = "drive";  // of the default window

  explicit EventSearch(const Trigger& trigger) : trigger_(trigger), signal_(trigger) {}

  // `words` are read where a sample was published.
  void on(const Stop& stop, const MachineChip& chip, const SignalReader& words);

  // The first clock edge after which the event is there.
  std::optional<Clk> found() const { return found_; }

 private:
  Trigger trigger_;
  SignalSearch signal_;
  std::optional<Clk> found_;
};

// Of a machine with these signals.
template <const std::vector<Signal>& (*kSignals)()>
struct EventSearchOf : EventSearch {
  using EventSearch::EventSearch;

  // What these options look for.
  static std::optional<Trigger> event(const RunBasics& run) {
    const auto text = wave_trigger_text(run, kStart);
    if (!text) return {};
    return parse_wave_event(*text, kSignals());
  }
};

}  // namespace trammel::cosim
