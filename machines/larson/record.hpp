// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine larson gives.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/disk_vector.hpp"
#include "machines/larson/chip.hpp"
#include "machines/larson/options.hpp"

namespace trammel::larson {

class TablePlant;  // plant.hpp

struct AxisSample {
  std::uint32_t words = 0;   // of the chip: status word and count
  std::int32_t step = 0;     // of the translator, from the calibration point
  std::int32_t waiting = 0;  // pulses in the buffer
  double at = 0;             // [step] of the rotor
  double speed = 0;          // [step/s]
  double angle = 0;          // [step] that the rotor is behind, the load angle
  double rate = 0;           // [step/s] of the translator
  std::int32_t asked = 0;    // [step] by the pulses that the chip has given, as step
  double platform = 0;       // [step] of the platform
  double torque = 0;         // [N m] of the motor's currents
  double current = 0;        // [A] of all phases
  double power = 0;          // [W] at the shaft
};

// Every record.every_ms.
struct Sample {
  cosim::Clk edge = 0;
  std::array<AxisSample, 2> axis;
  std::uint32_t call = 0;  // calls that have ended
  unsigned switches = 0;   // closed: X low, X high, Y low, Y high
  bool irq = false;
};

// A call that ended: when, where the rotors then were, and what it answered.
struct CallDone {
  cosim::Clk edge = 0;
  std::array<double, 2> at{};  // [step] from the calibration point
  std::array<double, 2> platform{};  // the same of the platform
  std::array<bool, 2> moving{};      // pulses were to come, or waited
};

// What happened to one axis.
struct Event {
  cosim::Clk edge = 0;
  int axis = 0;
  std::string what;     // "interrupt", "low switch closed", "10 steps lost"...
  double at = 0;        // [step] of the rotor
  std::uint32_t count = 0, status = 0;
};

// Of an edge, from chip and plant, whose platforms [step] are there; without the program.
Sample sample_of(cosim::Clk edge, const LarsonChip& chip, const TablePlant& plant,
                 const std::array<double, 2>& platforms);

struct Result : cosim::RunResult {
  std::size_t sample_count() const override { return samples.size(); }
  std::string fault_text() const override { return fault; }

  host::DiskVector<Sample> samples;
  // Figures are of these, every millisecond, up to record.settle_s behind the last call.
  host::DiskVector<Sample> looks;
  std::string fault;             // kFault: what the program saw; kMissed: what was missed;
                                 // kTimeout: the line of the script that was running
  std::vector<Call> calls;
  std::vector<sw::LarsonAnswer> answers;
  std::vector<CallDone> done;    // of the calls that have ended
  std::vector<Event> happened;   // the first kMostEvents
  std::size_t happened_count = 0;
  std::array<std::uint32_t, 2> pulses{};   // that the chip gave
  std::array<int, 2> lost{};               // steps that the rotors are off by, slips added
  std::array<std::vector<plant::StepsLost>, 2> slips;
  std::array<std::vector<plant::StepBreach>, 2> breaches;
  std::array<std::vector<plant::BufferMove>, 2> moves;
  std::map<std::uint32_t, double> rates;   // [pulse/s] of 64 pulses of the chip, by rate code
  std::array<double, 2> travel{};          // [step] of the rotors, in all
  std::array<double, 2> mean_current{};    // [A] of all phases
  std::array<plant::StepperPeaks, 2> peaks{};
  std::array<double, 2> end_at{};          // [step] where they are at the end
  sw::StepPoint known;                     // WHRTBL at the end
  std::array<double, 2> origin{};          // [step] of the calibration point, its (0, 0)
  std::uint32_t interrupts = 0, err_byte = 0;
  bool calibrated = false;
  unsigned stopped = 0;  // bit 0 X, bit 1 Y: by a switch, without a CALTBL behind it
};

// Losses, breaches and moves of the pulses up to now, and means up to edge `end`.
void note_plant(Result& result, const TablePlant& plant, cosim::Clk end);

inline constexpr std::size_t kMostEvents = 5000;

}  // namespace trammel::larson
