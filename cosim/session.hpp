// SPDX-License-Identifier: Apache-2.0
//
// One run of any machine, ready to be driven by a wiring: chip, plant, firmware, loop and record,
// and the decision when the run is over.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cosim/core.hpp"
#include "cosim/direct.hpp"
#include "cosim/run.hpp"
#include "cosim/trigger_search.hpp"

namespace trammel::cosim {

// Where an axis of the machine really is, whatever its sensors tell.
struct Place {
  std::string axis;  // "x"; "" where there is but one
  std::string unit;  // that of the column in the trace
  double value = 0;
};

struct Session {
  virtual ~Session() = default;

  virtual Loop& loop() = 0;
  virtual sw::Firmware& firmware() = 0;
  virtual ProcessorTiming timing() const = 0;
  // The processor's RTL that runs instead of the firmware; nullptr: the firmware runs.
  virtual Core* core() { return nullptr; }
  virtual void trapped(const CoreTrap&) {}
  virtual void core_ran(const CoreTimes&) {}  // once, when the run is over
  virtual std::int64_t period_ps() const = 0;
  virtual Clk end() const = 0;        // edge at which the run ends at the latest
  virtual bool finished() const = 0;  // the record is complete
  virtual bool stopped() const = 0;   // from outside, by Hooks::stop

  // Of each axis at the chip's next edge; none where the machine does not tell.
  virtual std::vector<Place> places() const { return {}; }

  // What was recorded, with all that only the session knows; once, after the run.
  virtual std::unique_ptr<RunResult> result() = 0;
};

// Makes the session of a run, or of the search for its trigger.
using MakeSession = std::function<std::unique_ptr<Session>(const Hooks&, const Waves&)>;

}  // namespace trammel::cosim
