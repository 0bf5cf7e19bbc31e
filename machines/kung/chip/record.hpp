// SPDX-License-Identifier: Apache-2.0
//
// What a run of the X-Y table gives: the words of the chip and the truth of the plant at each 2 kHz
// sample, and a close look at one place. Axis 0 is X, axis 1 is Y.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cosim/core.hpp"
#include "host/disk_vector.hpp"
#include "machines/kung/chip/wakes.hpp"
#include "machines/kung/options.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::kung {

inline constexpr std::int32_t kNoSetPoint = std::numeric_limits<std::int32_t>::min();

// One axis at one 2 kHz sample: the words of the chip (section 3) and the truth of the plant.
struct AxisSample {
  std::int32_t r = 0;    // command [count]
  std::int32_t x_p = 0;  // encoder [count]
  std::int32_t x_r = 0;  // model, rounded [count]
  std::int32_t x_m = 0;  // model [count Q14]
  std::int32_t dx = 0;   // model increment [count Q14 a sample]
  std::int32_t e = 0, de = 0, u = 0, v_star = 0, v = 0, i_q_ref = 0;
  std::int32_t i_d = 0, i_q = 0, v_d = 0, v_q = 0;
  std::int32_t set_point = kNoSetPoint;  // of the precision controller [count / 256], where on
  double x_true_m = 0;
  double v_true_m_s = 0;
  double i_d_true_A = 0;
  double i_q_true_A = 0;
  double force_N = 0;
  double dc_link_V = 0;
};

// What the motor of an axis and its drive had to give over the samples of a path, and where they
// had no more.
struct AxisLoad {
  void add(const AxisSample& sample, const plant::AxisConfig& plant);

  double rms_current_A() const;  // of a phase
  double rms_force_N() const;
  double copper_loss_W(double resistance_ohm) const;  // of the three phases, mean
  // Why an axis could not do what was asked, or "": "i_q* at its limit 40 %, voltage at the
  // supply's 12 % of the samples".
  std::string limits() const;

  double peak_current_A = 0;  // of the current vector, as i_q
  double least_link_V = 0, most_link_V = 0;  // of the DC link
  std::size_t samples = 0, at_current = 0, at_voltage = 0, at_stop = 0;
  double squares_A2 = 0, squares_N2 = 0;
};

// Words of the law of the precision controller after the tick of a sample (docs/precision.md,
// sections 3 and 4); all 0 where it is off.
struct AxisLaw {
  std::int32_t d = 0, acc = 0, aff = 0;  // [2^-26 count a tick^2]
  std::int32_t vff = 0;                  // [2^-14 count a tick]
  std::int32_t iacc = 0;                 // feed-forward of the firmware [LSB of i_q* / 2^13]
  fixed::Gain km, kb;                    // in effect
  std::int32_t fc = 0;                   // [LSB of i_q* / 256]
};
using AxisLaws = std::array<AxisLaw, 2>;

struct Sample {
  std::uint32_t tick = 0;  // TICK register of the chip
  cosim::Clk edge = 0;     // at which the encoders were latched
  std::array<AxisSample, 2> axis;
};

enum class FaultCode { kNone, kTrip, kOverCurrent, kWatchdog, kEncoder, kStroke };

struct Fault {
  FaultCode code = FaultCode::kNone;
  int axis = 0;
  std::uint32_t tick = 0;
  std::string processor = {};  // code kNone: the check of the firmware that stopped the drives;
                               // kTrip: where the core stopped, if that was the trip
};

const char* cause_name(FaultCode code);
std::string cause_text(const Fault& fault);  // of a trip, with its axis

using RuleTable = std::array<std::int32_t, 49>;  // rule 7 j + i, Q20 of a unit

// What the position controller of one axis starts a sample from, and what it takes.
struct AfcStart {
  std::int32_t r = 0, r_1 = 0, r_2 = 0;      // command of this and of the two samples before
  std::int32_t x_p = 0, x_p_prev = 0;        // [count]
  std::int32_t x_m = 0, dx = 0;              // [count Q14]
  std::int32_t e_prev = 0;
  std::int32_t integral = 0;                 // [v* LSB / 4096]
  RuleTable rules{};
};

// The position sample at which an axis moved fastest.
struct Moment {
  std::uint32_t tick = 0;                    // 0: the table never moved
  cosim::Clk edge = 0;
  std::array<AfcStart, 2> start;
  std::array<AxisSample, 2> end;             // words it ended with
};

struct GateEdge {
  cosim::Clk edge = 0;
  cosim::Lines gates = 0;                    // from this edge on
};

// All gates over two PWM periods: those that begin with the moment, or those around a trip.
struct GateWindow {
  cosim::Clk begin = 0;
  cosim::Clk end = 0;                        // 0: there is none
  cosim::Clk trip = cosim::kNever;           // edge at which a fault turned the gates off
  std::vector<GateEdge> edges;               // the first stands at `begin`
  // Compare values of the periods at the moment: [period][axis][phase]; none around a trip.
  std::vector<std::array<std::array<std::int32_t, 3>, 2>> compare;
};

// A close look that the 2 kHz samples cannot give.
struct Snapshot {
  std::array<RuleTable, 2> rules_first{};    // when point 0 of the path took effect
  std::array<RuleTable, 2> rules_last{};
  Moment moment;
  GateWindow gates;
};

// What the precision controller took an axis for.
struct AxisEstimate {
  double mass_kg = 0, viscous_N_s_m = 0, coulomb_N = 0;
  double mass_within_kg = 0;  // of which the true mass is, in 19 of 20 runs; 0: not known
  double cogging_sine_N = 0, cogging_cosine_N = 0;  // of pi x / pole pitch, doubled
  double force_N = 0;
  bool taught = true;  // the axis moved: else these are the start values
  bool mass_limited = false, viscous_limited = false, coulomb_limited = false,
       cogging_limited = false, force_limited = false;  // at the ends of their ranges
  bool mass_mixed = false, viscous_mixed = false, coulomb_mixed = false, cogging_mixed = false,
       force_mixed = false;  // the path does not separate them from others

  double cogging_N() const { return std::hypot(cogging_sine_N, cogging_cosine_N); }
};

inline constexpr double kFarthestSwing_m = 5e-3;  // of an identification move of 0.8 mm

struct Result : cosim::RunResult {
  Result() { end = EndReason::kDone; }
  std::size_t sample_count() const override { return samples.size(); }
  std::string fault_text() const override;
  // The path ran to its end, whether the table followed it or not.
  bool whole() const {
    return end == EndReason::kDone || (end == EndReason::kMissed && all_points);
  }

  host::DiskVector<Sample> samples;    // every 2 kHz sample from the first tick of the chip on
  host::DiskVector<AxisLaws> laws;      // of each of them; of the precision controller alone
  std::uint32_t first_tick = 0;   // sample at which point 0 of the path took effect
  std::uint32_t end_tick = 0;     // first sample after the last point's, or after a trip: figures
                                  // use [first, end)
  std::uint32_t points = 0;       // written by the processor
  double beside_m = 0;            // kDiverged: distance from the path asked, 0 if from the model
  double swing_m = 0;             // kDiverged: way of an axis in the identification move
  double from_last_m = 0;         // of the table at the end, from the last point asked
  std::string missed;             // kMissed: what
  bool all_points = false;        // of the path were handed over
  double error_m = 0;             // largest one to the command; of the precision controller
  double largest_mm = 0;          // contour error; of a square wave the error to the model
  std::array<AxisLoad, 2> load;   // over the path
  Fault fault;
  Snapshot snapshot;
  WakeCounts wakes{};             // why clocks were evaluated
  std::optional<std::array<AxisEstimate, 2>> estimates;  // at the end, of native firmware
  // Samples of the path, one after the other, with the estimated mass at the end of its range, and
  // all in which the precision controller's error was.
  std::array<std::uint32_t, 2> mass_limited{}, error_limited{};
  std::optional<cosim::CoreTimes> core;  // of run.cpu = "rtl"
  cosim::Clk core_awake = 0;             // clocks of it that were evaluated
  std::string uart;                      // what its serial port sent
};

}  // namespace trammel::kung
