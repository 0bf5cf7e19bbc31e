// SPDX-License-Identifier: Apache-2.0
//
// What one run of the two-axis machine takes and gives: plain data in SI units (specification
// sections 2 to 11). The testbench fills Options and reads Result; it knows nothing else of a run.
// Axis 0 is X, axis 1 is Y.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cosim/cosim.hpp"
#include "cosim/disk_vector.hpp"
#include "cosim/kung/wakes.hpp"
#include "cosim/machine.hpp"
#include "cosim/points.hpp"
#include "cosim/promise.hpp"
#include "cosim/waves.hpp"
#include "models/plant/xy_table.hpp"

namespace trammel::kung {

using cosim::EndReason;
using cosim::Engine;
using cosim::Hooks;
using cosim::OptionsError;
using cosim::Platform;
using cosim::ProcessorOptions;
using cosim::WaveFormat;
using cosim::WaveSpan;

enum class Controller { kFc, kAfc };  // fixed rule table, or tuned while it runs
enum class PathKind { kCircle, kWindow, kStar, kSquare, kLine, kPoints };

using cosim::PointM;

// One axis of the controller: the registers of the chip, in physical units.
struct AxisGains {
  double kp = 0.375;           // position error to speed command, in words (46.9 1/s)
  double ki = 0.0032;          // integral part of it, in words a sample
  double kv = 1.840;           // speed error to current command, in words (6.9 A/(m/s))
  double learning_rate = 0.1;  // alpha; ETA = alpha (kp + ki) kv / 32 under AFC, 0 under FC
  int shift_e = 0;             // sE: one fuzzy unit = 256 / 2^sE counts
  int shift_de = 2;            // sD: one fuzzy unit = 256 / 2^sD counts a sample
  double omega_n_rad_s = 30;   // reference model
  double zeta = 1;
  double current_kp_V_A = 93.17;  // 4000 rad/s * L, rounded to the word 2.491
  double current_ki_V_A = 6.75;   // 4000 rad/s * R / 16 kHz, volts per ampere and sample
  double theta_offset_rad = 0;    // electrical angle at count 0
  bool feedforward = false;       // v* += model increment (section 15)
  bool interpolate = false;       // commands linear between two interrupts instead of held
};

struct AxisChip {
  int dead_time_ns = 2000;     // multiple of the clock period is what acts
  int qep_filter_clk = 3;      // equal samples an encoder edge needs
  bool stroke_check = false;   // leaving [stroke_min_m, stroke_max_m] trips
  double stroke_min_m = 0;     // what the chip checks; the end stops belong to the plant
  double stroke_max_m = 0.6;
};

struct ChipOptions {
  std::array<AxisChip, 2> axis;
  int dead_time_min_ns = 200;     // lowest dead time the chip accepts
  double current_limit_A = 6.0;   // trip level of the measured phase currents
  int irq_period_ticks = 4;       // 2 kHz samples an interrupt: 4 = 2 ms
  int watchdog_ticks = 100;       // 2 kHz samples between two COMMITs; 0 = off
};

// Path parameters; only those of `kind` count (specification section 10).
struct PathOptions {
  PathKind kind = PathKind::kCircle;
  int repeats = 1;  // passes of a circle, window, star or points path

  double circle_radius_m = 0.1;
  double circle_center_x_m = 0.25;
  double circle_center_y_m = 0.25;
  int circle_ticks = 628;         // interrupts a turn

  double window_side_m = 0.2;
  double window_radius_m = 0.03;
  double window_center_x_m = 0.25;
  double window_center_y_m = 0.25;
  double window_step_m = 0.7e-3;  // along the straight parts, an interrupt
  int window_arc_ticks = 67;

  double star_edge_m = 0.1;
  double star_start_x_m = 0.2;
  double star_start_y_m = 0.26625;
  int star_stroke_ticks = 182;    // interrupts a stroke

  double square_low_m = 0;
  double square_high_m = 0.01;
  int square_half_samples = 750;  // 2 kHz samples a half period: 375 ms
  int square_periods = 8;

  double line_start_x_m = 0.1;
  double line_start_y_m = 0.1;
  double line_end_x_m = 0.4;
  double line_end_y_m = 0.4;
  int line_ticks = 500;

  std::string points_file;        // CSV of x_mm,y_mm; one point an interrupt
  std::vector<PointM> points;     // its content
};

struct RunOptions : cosim::RunBasics {
  RunOptions() { max_s = 60; }

  double settle_s = 0;            // simulated after the last point, not counted in the figures
  double diverged_m = 0.05;       // tracking error that ends the run as diverged
};

// Faults to be seen by the chip; 0 = never.
struct FaultInjection {
  double trip_s = 0;     // the trip pin rises
  double encoder_s = 0;  // both encoder lines of X jump at once
  double processor_s = 0;  // the service routine stops doing its work
};

struct Options {
  std::string scenario = "circle";  // names the run and its output folder
  std::string description;
  Controller controller = Controller::kAfc;
  std::array<AxisGains, 2> gains;
  plant::XyTableConfig plant = plant::default_xy_table();
  ChipOptions chip;
  ProcessorOptions processor;
  PathOptions path;
  RunOptions run;
  FaultInjection inject;
};

// One axis at one 2 kHz sample: the words of the chip (section 3) and the truth of the plant.
struct AxisSample {
  std::int32_t r = 0;    // command [count]
  std::int32_t x_p = 0;  // encoder [count]
  std::int32_t x_r = 0;  // model, rounded [count]
  std::int32_t x_m = 0;  // model [count Q14]
  std::int32_t dx = 0;   // model increment [count Q14 a sample]
  std::int32_t e = 0, de = 0, u = 0, v_star = 0, v = 0, i_q_ref = 0;
  std::int32_t i_d = 0, i_q = 0, v_d = 0, v_q = 0;
  double x_true_m = 0;
  double v_true_m_s = 0;
  double i_d_true_A = 0;
  double i_q_true_A = 0;
  double force_N = 0;
};

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
  std::string processor = {};  // code kNone: the check of the firmware that stopped the drives
};

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
struct Detail {
  std::array<RuleTable, 2> rules_first{};    // when point 0 of the path took effect
  std::array<RuleTable, 2> rules_last{};
  Moment moment;
  GateWindow gates;
};

struct Result : cosim::RunResult {
  Result() { end = EndReason::kDone; }

  cosim::DiskVector<Sample> samples;    // every 2 kHz sample from the first tick of the chip on
  std::uint32_t first_tick = 0;   // sample at which point 0 of the path took effect
  std::uint32_t end_tick = 0;     // first sample after the last point's: figures use [first, end)
  std::uint32_t points = 0;       // written by the processor
  Fault fault;
  Detail detail;
  WakeCounts wakes{};             // why clocks were evaluated
};

}  // namespace trammel::kung
