// SPDX-License-Identifier: Apache-2.0
//
// A chip wired to a plant, with the loop between them: what every run has, whoever is at the
// processor's bus. The run's fault is on the lines, and what becomes of it is watched.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cosim/direct.hpp"
#include "cosim/fault_plant.hpp"
#include "cosim/fault_watch.hpp"
#include "cosim/trigger_search.hpp"

namespace trammel::cosim {

class Rig : protected Observer {
 public:
  Loop& loop() { return *loop_; }
  ProcessorTiming timing() const;
  std::int64_t period_ps() const { return run_.clock_ps; }
  Clk end() const { return run_.clocks(run_.max_s); }  // the run ends there at the latest

 protected:
  Rig(const RunOptions& run, const Fault& fault, const ProcessorOptions& processor,
      const Waves& waves)
      : waves_(waves), run_(run), fault_(fault), processor_(processor) {}

  // Once, when both are there, which outlive the run. `pins`: of the chip, for faults; their
  // `registers` are those of RTL. `unit`: of the axes in truth().
  void wire(MachineChip& chip, FalliblePlant& plant, FaultPins pins, const char* unit = "mm");
  void wire(MachineChip& chip, Plant& plant);  // of a machine without faults
  void watch_trips(const char* unit = "mm");   // of a run without a fault, too
  void watch_fault(const Stop& stop);          // after an event

  // What the machine knows of a fault.
  virtual bool drives_off() const { return false; }
  virtual std::string detected_by() const { return {}; }  // by what; "": by nothing
  virtual FaultTruth truth(Clk) const { return {}; }

  MachineChip& wired() const { return *chip_; }
  Plant& seen();  // by the chip: the plant, with the fault
  void complete(RunResult& result) const;  // but its record, its events and why it ended

  Waves waves_;

 private:
  RunOptions run_;
  Fault fault_;
  ProcessorOptions processor_;
  MachineChip* chip_ = nullptr;
  Plant* plant_ = nullptr;
  std::optional<FaultPlant> failing_;  // around the plant
  std::optional<FaultWatch> fault_watch_;
  std::optional<Loop> loop_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace trammel::cosim
