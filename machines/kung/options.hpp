// SPDX-License-Identifier: Apache-2.0
//
// The parameters of a run of the X-Y table: plain data in SI units (specification sections 2 to
// 11). Axis 0 is X, axis 1 is Y.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "cosim/run.hpp"
#include "lab/settings.hpp"
#include "models/plant/xy_table.hpp"
#include "paths/points.hpp"
#include "sw_nios/path/trajectory.hpp"

namespace trammel::kung {

using cosim::EndReason;
using cosim::Engine;
using cosim::Hooks;
using cosim::OptionsError;
using cosim::Platform;
using cosim::ProcessorOptions;
using cosim::WaveFormat;
using cosim::WaveSpan;

enum class Cpu { kNative, kRtl };     // firmware compiled for this computer, or on the core's RTL
// Fixed rule table, the same tuned while it runs, or what follows the command (docs/precision.md).
enum class Controller { kFc, kAfc, kPrecision };
using PathKind = sw::Path;            // as the firmware names them
enum class SweepOf { kPosition, kCurrent };  // what a sweep commands
enum class Profile { kAuto, kConstant, kFeed };  // of the speed along a path
enum class Corner { kAuto, kStop, kPass };   // under the feed profile
enum class PointsMode { kTimed, kPath };     // one point an interrupt; lines that are followed

using paths::PointM;

// Of errors in the fuzzy universe: the memberships have two bits below its units of 1/256.
inline constexpr int kLeastShift = -2, kMostShift = 11;

// One axis of the controller: the registers of the chip, in physical units.
struct AxisGains {
  double kp = 0.375;           // position error to speed command, in words (46.9 1/s)
  double ki = 0.0032;          // integral part of it, in words per 0.5 ms
  double kv = 1.840;           // speed error to current command: 1 = 3.75 A/(m/s)
  double learning_rate = 0.1;  // alpha; ETA = alpha (kp + ki) kv / 32 under AFC, 0 under FC
  int shift_e = 0;             // sE: one fuzzy unit = 256 / 2^sE counts
  int shift_de = 2;            // sD: one fuzzy unit = 256 / 2^sD counts per sample
  double omega_n_rad_s = 30;   // reference model
  double zeta = 1;

  double lag_s() const { return 2 * zeta / omega_n_rad_s; }  // of that model on a ramp

  double current_kp_V_A = 93.17;  // 4000 rad/s * L, rounded to the word 2.491
  double current_ki_V_A = 6.75;   // 4000 rad/s * R / 16 kHz, volts per ampere and 62.5 us
  double theta_offset_rad = 0;    // electrical angle at count 0
  bool feedforward = false;       // v* += model increment (section 15)
  bool interpolate = false;       // commands linear between two interrupts instead of held
};

// One axis of the precision controller; masses and frictions are start values only.
struct AxisPrecision {
  double w1_rad_s = 300;  // feedback
  double zeta = 0.7;
  double w2_rad_s = 4000;  // observer, twice
  double w3_rad_s = 400;   // its disturbance
  double mass_kg = 7.9;
  double viscous_n_s_m = 20;
  double coulomb_n = 3;
  int lead_ticks = 6;              // of the feed-forward, carrier periods
  double hysteresis_counts = 0.2;  // of the encoder, as its edges are read
};

struct PrecisionOptions {
  PrecisionOptions() {
    axis[1].mass_kg = 15.6;
    axis[1].coulomb_n = 4.8;
  }

  std::array<AxisPrecision, 2> axis;
  bool identify = true;     // a small move of both axes before the path
  bool adapt = true;        // the estimates go on on the path
  bool subcount = true;     // the time of an encoder's edge tells the position between two counts
  bool learn = false;       // corrections from lap to lap
  double learn_gain = 0.8;  // share of an error that a lap corrects
  bool compare = true;      // also fc and afc on the same feed profile, by their twins
};

// The motor of an axis as its data sheet has it, from which the program computes the words of chip
// and firmware; 0: as the plant's is.
struct BelievedMotor {
  double force_constant_n_a = 0, resistance_ohm = 0, inductance_q_h = 0, pole_pitch_m = 0;
  double mass_kg = 0;  // with its payload
};

struct AxisChip {
  int dead_time_ns = 2000;     // rounded up to whole clocks
  int qep_filter_clk = 3;      // equal samples an encoder edge needs
  bool stroke_check = false;   // leaving [stroke_min_m, stroke_max_m] trips
  double stroke_min_m = 0;     // what the chip checks; the end stops belong to the plant
  double stroke_max_m = 0.6;
};

struct ChipOptions {
  std::array<AxisChip, 2> axis;
  int carrier_Hz = 16000;         // of the PWM, and the rate of the current loops
  int position_Hz = 2000;         // rate of the position loops
  int dead_time_min_ns = 200;     // lowest dead time the chip accepts
  double current_limit_A = 6.0;   // trip level of the measured phase currents
  double following_error_m = 0;   // from the model that the firmware allows; 0: any
  double d_current_A = 0;         // largest measured i_d that the firmware allows; 0: any
  int offset_samples = 0;         // interrupts that average the sensors' offsets first
  int irq_period_ticks = 4;       // position samples per interrupt: 4 = 2 ms
  int watchdog_ticks = 100;       // position samples between two COMMITs; 0 = off

  double sample_s() const { return 1.0 / position_Hz; }
};

// One axis of the feed profile.
struct AxisPath {
  double accel_m_s2 = 8;  // that no command exceeds
};

// Path parameters; only those of `kind` matter (specification section 10).
struct PathOptions {
  PathKind kind = PathKind::kCircle;
  int repeats = 1;  // passes of a circle, window, star or points path

  double circle_radius_m = 0.1;
  double circle_center_x_m = 0.25;
  double circle_center_y_m = 0.25;
  int circle_ticks = 628;         // interrupts per revolution

  double window_side_m = 0.2;
  double window_radius_m = 0.03;
  double window_center_x_m = 0.25;
  double window_center_y_m = 0.25;
  double window_step_m = 0.7e-3;  // per interrupt, on the straight parts
  int window_arc_ticks = 67;

  double star_edge_m = 0.1;
  double star_start_x_m = 0.2;
  double star_start_y_m = 0.26625;
  int star_stroke_ticks = 182;    // interrupts per stroke

  double square_low_m = 0;
  double square_high_m = 0.01;
  int square_half_samples = 750;  // position samples per half period: 375 ms
  int square_periods = 8;

  double line_start_x_m = 0.1;
  double line_start_y_m = 0.1;
  double line_end_x_m = 0.4;
  double line_end_y_m = 0.4;
  int line_ticks = 500;

  SweepOf sweep_of = SweepOf::kPosition;
  double sweep_center_m = 0.3;    // of both axes
  double sweep_amplitude_m = 0.5e-3;
  double sweep_amplitude_A = 0.5;  // of i_q*, with open position loops
  int sweep_first_ticks = 500;    // period of the first tone, in position samples
  int sweep_last_ticks = 8;       // of the last one
  int sweep_tones = 19;
  int sweep_dwell_ticks = 200;    // least time of a tone, before it is measured and while it is

  // A measurement: the table need not follow it.
  bool is_sweep() const { return kind == PathKind::kSweep; }
  // The command is a current.
  bool open_position() const { return is_sweep() && sweep_of == SweepOf::kCurrent; }

  Profile profile = Profile::kAuto;
  double feed_m_s = 0;            // of the built-in shapes; 0: of each its own
  double rapid_m_s = 0.5;
  double feed_max_m_s = 1;
  int mean_points = 8;            // over which the path length is averaged
  Corner corner = Corner::kAuto;  // stop in the shapes, pass in files
  std::array<AxisPath, 2> axis;

  std::string points_file;        // CSV of x_mm,y_mm
  PointsMode points_mode = PointsMode::kTimed;

  std::string gcode_file;         // docs/gcode.md
  double start_x_m = 0.25;        // where the table rests before the program
  double start_y_m = 0.25;
  double home_x_m = 0.25;         // where its G28 goes
  double home_y_m = 0.25;
};

const lab::Machine& machine();
const std::vector<lab::Key>& keys();
std::vector<lab::FormerKey> former_keys();

struct Result;  // chip/record.hpp

struct Options final : lab::SettingsOf<Options, machine> {
  using Result = kung::Result;

  Options() {
    scenario = "circle";
    run.max_s = 60;
    processor = {57, 50};  // as the core of kung_soc was measured to take, see README.md
  }

  Cpu cpu = Cpu::kNative;
  int point_clk = 2200;      // native: clocks in which the firmware computes a point
  std::string uart;          // other end of the serial port, see run/serial.hpp; "": nothing
  Controller controller = Controller::kAfc;
  std::array<AxisGains, 2> gains;
  // kv and those of the current loop from the motor: plan/register_values.hpp
  bool gains_by_rule = false;
  PrecisionOptions precision;
  plant::XyTableConfig plant = plant::default_xy_table();
  std::array<BelievedMotor, 2> believed;
  ChipOptions chip;
  PathOptions path;
  double settle_s = 0;       // simulated after the last point, not counted in the figures
  double settled_m = 20e-6;  // band of the settling time after it
  double diverged_m = 0.05;  // tracking error that ends the run as diverged
  double reached_m = 0;      // largest error of a table that followed; 0: by the path's extent

  // By which the reference model of the slower axis lags behind a ramp.
  double lag_s() const { return std::max(gains[0].lag_s(), gains[1].lag_s()); }
};

// Which faults this machine can have, and where.
cosim::FaultPins fault_pins(const Options& options);

}  // namespace trammel::kung
