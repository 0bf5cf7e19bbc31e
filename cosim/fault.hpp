// SPDX-License-Identifier: Apache-2.0
//
// One fault that is injected into a run: what fails, from when and for how long. The pins between
// plant and chip, the plant and the processor are the same for both engines; a register is flipped
// in the verilated chip alone.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

enum class FaultKind {
  kNone,
  kEncoderStuck,        // a line holds its level (value 0), is low (below 0) or high (above)
  kEncoderMissing,      // each value-th count is lost, without value each tenth
  kEncoderSwapped,      // A is B
  kIndexLost,           // the index line stays low
  kConverterStuck,      // it repeats its last code, or that of value
  kConverterOffset,     // value is added to its code
  kConverterSaturated,  // its largest code, or its least where value is below 0
  kConverterSlipped,    // its frame comes a bit late, or early where value is below 0
  kGateDead,            // a gate driver leaves its switch open
  kOutputStuck,         // a bit toward the converter is low, or high where value is above 0
  kPhaseOpen,           // a phase of the motor carries no current
  kSupplyDip,           // value percent of the supply remain
  kProcessorStopped,    // it executes nothing
  kProcessorSlow,       // an access and an interrupt take value times as long, ten times without
  kProcessorGarbage,    // what it writes is random
  kBusStall,            // a transfer takes value clocks more, 1000 without
  kRegisterFlip         // a bit of the chip changes once
};

struct Fault {
  FaultKind kind = FaultKind::kNone;
  double begin_s = 0;
  double for_s = 0;  // 0: it stays
  int axis = 0;
  int line = 0;      // encoder: 0 A, 1 B; converter and phase: 0 a, 1 b, 2 c; gate: upper, lower
  int value = 0;
  std::string bit;   // of kRegisterFlip: its register, and its number in brackets

  bool any() const { return kind != FaultKind::kNone; }
  bool between(FaultKind first, FaultKind last) const { return kind >= first && kind <= last; }
  bool of_processor() const {
    return between(FaultKind::kProcessorStopped, FaultKind::kBusStall);
  }
  bool of_plant() const { return between(FaultKind::kPhaseOpen, FaultKind::kSupplyDip); }
};

// What of a machine a fault can be on: its pins in the packed words of sense() and drive().
struct FaultPins {
  int axes = 1;
  std::array<std::array<int, 3>, 2> encoder{};  // of each axis: A, B, index
  int converters = 0;                           // of an axis, on channels from 2 * axis on
  int converter_bits = 12;
  int outputs = 0;                              // of an axis, one after the other in drive()
  bool gates = false;                           // these are gates, else bits of a code
  int phases = 1;
  bool registers = false;                       // the chip's have names: not a twin
};

// Throws OptionsError where the machine has no such place.
void check_fault(const Fault& fault, const FaultPins& pins);

// Edges from `begin` to `end`, kNever where it stays.
struct FaultSpan {
  FaultSpan() = default;
  FaultSpan(const Fault& fault, std::int64_t clock_ps);

  bool holds(Clk edge) const { return edge >= begin && edge < end; }

  Clk begin = kNever, end = kNever;
};

// What it does to the processor's accesses.
class ProcessorFault {
 public:
  ProcessorFault() = default;
  ProcessorFault(const Fault& fault, std::int64_t clock_ps);

  // Clocks that `clocks` of its work take from edge `now` on; an access waits for the bus, too.
  Clk work(Clk now, Clk clocks) const;
  Clk access(Clk now, Clk clocks) const;
  std::uint32_t written(Clk now, std::uint32_t data) const;

 private:
  FaultKind kind_ = FaultKind::kNone;
  FaultSpan span_;
  Clk value_ = 0;
};

}  // namespace trammel::cosim
