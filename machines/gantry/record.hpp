// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry gives.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host/disk_vector.hpp"
#include "machines/gantry/chip.hpp"
#include "machines/gantry/identification.hpp"
#include "machines/gantry/options.hpp"

namespace trammel::gantry {

class TrackPlant;  // plant.hpp

// Figures are of these, every millisecond whatever the record has.
struct Look {
  cosim::Clk edge = 0;
  Words words;                       // of the chip
  double x = 0, v = 0;               // [m], [m/s] of the cart
  std::int32_t velocity = 0;         // filtered
};

// Every record.every_ms.
struct Sample : Look {
  double origin = 0;                 // [m] where on the track the observer's position is 0
  std::array<double, 2> motor{};     // [m] from the cart
  std::array<double, 2> force{};     // [count] of the motors, mean of a pulse's period, positive:
                                   // the position increases
  std::array<int, 2> stripes{};      // codes of A and B that the sensor has
  std::array<int, 2> flank{};        // of each gear wheel that pushes; 0: within the backlash
  std::int32_t error = 0, goal = 0, zero = 0;  // [count]
  std::int32_t goal_velocity = 0;
  int phase = 0;                     // of the firmware
};

struct Result : cosim::RunResult {
  std::size_t sample_count() const override { return samples.size(); }
  std::string fault_text() const override { return fault; }

  host::DiskVector<Sample> samples;
  host::DiskVector<Look> looks;     // to the last one that is not behind run.time_s
  std::string fault;
  std::vector<unsigned char> heard;  // bytes from the chip
  std::uint32_t passes = 0, unknown = 0, malformed = 0, lost = 0;
  std::uint32_t refused = 0, unchecked = 0, unsent = 0;  // goals; frames either way
  sw::GantryPhase phase = sw::GantryPhase::kIdle;
  bool homed = false, fitted = false;
  sw::CalibrationWords fit{};        // words of the fit
  Store store{};                     // as the run left it
  std::optional<Identified> identified;  // of a random force without controller
};

// Of an edge, from chip, plant and program.
Sample sample_of(cosim::Clk edge, const GantryChip& chip, const TrackPlant& plant,
                 const sw::GantryMailbox& mail);

// What the program has to tell of itself.
void note_program(Result& result, const sw::GantryMailbox& mail);

// What a step of the reference gives, in mm of the true cart from its zero.
struct StepFigures {
  double overshoot_mm = 0;    // beyond the reference, 0 at least
  double arrive_s = -1;       // from the command until within the band; below 0: never
  double settle_s = -1;       // until it stays within 2 % of the step
  double rest_mm = 0;         // from the reference at the end
  double swing_mm = 0;        // peak to peak over the last quarter
  bool begun = true;          // false: the last of host.sends is behind the end
};
StepFigures step_figures(const Options& options, const Result& result);  // figures.cpp

// How well the velocity is known in a run without controller.
struct VelocityFigures {
  double raw_mm_s = -1;   // rms of the observer's velocity at constant speed; below 0: no such
  double noise_mm_s = -1;  // of the filtered one
  double error_mm_s = 0;  // of the filtered one, rms over the run: with its lag and its bias
  double late_s = -1;     // from a true change of sign to that of the filtered; below 0: none
  double changes = 0;     // of sign of the filtered velocity, within 0.1 s of a true one
};
VelocityFigures velocity_figures(const Options& options, const Result& result);  // estimated.cpp

}  // namespace trammel::gantry
