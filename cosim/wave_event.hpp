// SPDX-License-Identifier: Apache-2.0
//
// What begins a window of waves of a chip with a host: one event that is seen from outside, found
// in a run of its own before the one that is dumped.
//
//   EXPR := EVENT [after TIME] | at TIME      EVENT := drive | hi | irq
#pragma once

#include <optional>
#include <string>

#include "cosim/machine_chip.hpp"
#include "cosim/wave_plan.hpp"

namespace trammel::cosim {

// One line of it, for help texts.
inline constexpr char kWaveEvents[] =
    "drive (a converter's code changes), hi (the pin HI rises), irq (HI or the timer interrupts), "
    "each with `after TIME` behind it if wanted; at 10ms";

struct WaveEvent {
  enum class What { kAt, kDrive, kHost, kIrq };

  What what = What::kAt;
  Clk edge = 0;  // kAt: there; else not before it

  bool known() const { return what == What::kAt; }  // without a search
};

// Throws std::invalid_argument that says what is allowed.
WaveEvent parse_wave_event(const std::string& text);

class EventSearch {
 public:
  static constexpr char kStart[] = "drive";  // of the default window

  // What these options look for.
  static std::optional<WaveEvent> event(const RunBasics& run);

  explicit EventSearch(const WaveEvent& event) : event_(event) {}

  void on(const Stop& stop, const MachineChip& chip);

  // The first clock edge after which the event is there.
  std::optional<Clk> found() const { return found_; }

 private:
  WaveEvent event_;
  std::optional<Clk> found_;
};

}  // namespace trammel::cosim
