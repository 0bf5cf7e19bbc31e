// SPDX-License-Identifier: Apache-2.0
//
// One fault that is injected into a run: what fails, from when and for how long. The pins between
// plant and chip, the plant and the processor are the same for both engines; a register is flipped
// in the verilated chip alone.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

// In the order of fault_words().
enum class FaultKind {
  kNone,
  kEncoderStuck,        // an input holds its level (value 0), is low (below 0) or high (above)
  kEncoderMissing,      // each value-th count is lost, without value each tenth
  kEncoderSwapped,      // A is B
  kIndexLost,           // the index line stays low
  kEncoderJump,         // A and B are inverted: both change at once
  kTripPin,             // the input that turns the chip's outputs off is high
  kConverterStuck,      // it repeats its last code, or that of value
  kConverterOffset,     // value is added to its code
  kConverterSaturated,  // its largest code, or its least where value is below 0
  kConverterSlipped,    // its frame comes a bit late, or early where value is below 0
  kGateDead,            // a gate driver leaves its switch open
  kOutputStuck,         // a bit toward the converter is low, or high where value is above 0
  kProcessorHung,       // its service routine does nothing more than a read
  kPhaseOpen,           // a phase of the motor carries no current
  kSupplyDip,           // value percent of the supply remain; from here on, of every machine
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
  int line = 0;      // of those that the machine has at the place of this kind
  int value = 0;
  std::string bit{};  // of kRegisterFlip: its register, and its number in brackets

  bool any() const { return kind != FaultKind::kNone; }
  bool between(FaultKind first, FaultKind last) const { return kind >= first && kind <= last; }
  bool of_processor() const {
    return between(FaultKind::kProcessorStopped, FaultKind::kBusStall);
  }
};

// Names of the kinds, as inject.fault has them.
const std::vector<std::string>& fault_words();

// Kinds of fault that a machine has at one sort of place.
struct FaultPlace {
  FaultKind first = FaultKind::kNone, last = FaultKind::kNone;
  int lines = 0;      // of an axis, those of the next axis follow; 0: the kinds have no line
  std::string names;  // of the place and its lines, in their order
};

// What of a machine a fault can be on, and so which kinds of fault it has.
struct FaultPins {
  std::vector<std::string> axes;           // their names; empty: there is one axis
  std::vector<FaultPlace> places;          // but those of the kinds that every machine has
  std::vector<std::array<int, 3>> inputs;  // of each axis, in sense(): lines 0 and 1, index
  int trip = 0;                            // in sense(), of kTripPin
  int converter_bits = 12;
  bool registers = false;                  // the chip's have names: not a twin

  FaultPlace place(FaultKind kind) const;  // without a kind where the machine has none
  std::vector<std::string> words() const;  // of the kinds that it has, "none" first
  int last_axis() const { return axes.empty() ? 0 : static_cast<int>(axes.size()) - 1; }
};

// Throws OptionsError where the machine has no such fault or place.
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
