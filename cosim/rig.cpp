// SPDX-License-Identifier: Apache-2.0
#include "cosim/rig.hpp"

namespace trammel::cosim {

ProcessorTiming Rig::timing() const {
  return {processor_.access_clk, processor_.interrupt_latency_clk, {fault_, run_.clock_ps}};
}

void Rig::wire(MachineChip& chip, FalliblePlant& plant, FaultPins pins, const char* unit) {
  if (fault_.any()) {
    pins.registers = run_.engine == Engine::kRtl;
    failing_.emplace(plant, pins, fault_, run_.clock_ps);
    watch_trips(unit);
    if (fault_.kind == FaultKind::kRegisterFlip) {
      require_bit(chip, fault_.bit);
      failing_->flip = [this] { chip_->flip(fault_.bit, true); };
    }
  }
  wire(chip, static_cast<Plant&>(plant));
}

void Rig::wire(MachineChip& chip, Plant& plant) {
  chip_ = &chip;
  plant_ = &plant;
  loop_.emplace(chip, seen(), static_cast<Observer&>(*this), run_.window());
}

Plant& Rig::seen() { return failing_ ? static_cast<Plant&>(*failing_) : *plant_; }

void Rig::watch_trips(const char* unit) {
  if (!fault_watch_) fault_watch_.emplace(fault_, run_.clock_ps, unit);
}

void Rig::watch_fault(const Stop& stop) {
  if (!fault_watch_) return;
  fault_watch_->on(stop, drives_off(), [this] { return detected_by(); },
                   [&] { return truth(stop.edge); });
}

void Rig::complete(RunResult& result) const {
  if (fault_watch_) result.fault_report = fault_watch_->report();
  result.clock_ps = run_.clock_ps;
  if (!result.supplied_J) result.supplied_J = plant_->supplied(chip_->now());
  close_result(result, *chip_, waves_.window, started_);
}

}  // namespace trammel::cosim
