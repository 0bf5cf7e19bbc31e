// SPDX-License-Identifier: Apache-2.0
//
// Trajectory program of the two-axis table (specification section 10). start() sets the registers
// with both axes off. If asked, the first interrupts then average the offsets of the current
// sensors; the next one, when the chip has latched the preset positions, enables the axes; every
// later one reads the response, writes the next point and logs. After the last point the table is
// held there: COMMITs continue, so the watchdog stays fed. Freestanding; never waits longer than a
// bounded poll of a busy bit.
#pragma once

#include <array>
#include <cstdint>

#include "sw_nios/apps/kung/gain.hpp"
#include "sw_nios/apps/kung/precision.hpp"
#include "sw_nios/hal/bus.hpp"
#include "sw_nios/path/trajectory.hpp"

namespace trammel::sw {

// Register words of one axis; defaults of the specification, without adaptation.
struct AxisSetup {
  Gain kp{768, 0};
  Gain ki{839, -7};
  Gain kv{1884, 1};
  Gain eta{1140, -8};
  Gain kp_cur{1275, 2};
  Gain ki_cur{1478, -2};
  std::int32_t shift_e = 0;
  std::int32_t shift_de = 2;
  std::uint32_t a0 = 238008;      // [2^-32] with scale 0
  std::uint32_t a0_scale = 0;     // 0 2^-32, 1 2^-28, 2 2^-23
  std::uint32_t b2 = 8140683;     // [2^-23]
  std::uint32_t angle_step = 352047;  // electrical angle of a count [2^-32 revolution]
  std::uint32_t theta_ofs = 0;    // electrical angle at count 0 [2^-32 revolution]
  std::uint32_t adc_zeros = 4;    // leading zeros of a converter's frame
  std::uint32_t dead_time = 100;  // [clk]
  std::uint32_t qep_filter = 3;   // equal samples, 1..15
  std::int32_t stroke_min = 0;    // [count] no point outside is ever commanded
  std::int32_t stroke_max = 120000;
  bool stroke_check = false;  // the chip trips when the position leaves the stroke
  bool adapt = false;
  bool interpolate = false;
  bool feedforward = false;
};

struct KungSetup : PathSetup {
  std::array<AxisSetup, 2> axis;
  std::uint32_t carrier = 0;           // the fields of RATES
  std::uint32_t position_rate = 1;
  std::uint32_t irq_period = 4;        // position ticks per point; 1 for the square wave
  std::uint32_t watchdog_ticks = 100;  // 0 = off
  std::uint32_t current_limit = 1280;  // 6 A [I_fs / 2048], 0 = off
  std::uint32_t dead_time_min = 25;    // [clk]
  std::int32_t following_limit = 0;    // [count] from the model, 0 = not checked
  std::int32_t d_current_limit = 0;    // of the measured i_d [I_fs / 2048], 0 = not checked
  bool current_command = false;        // position loops open: a point's distance from the start is
                                       // i_q* [I_fs / 4096]
  std::uint32_t offset_samples = 0;    // interrupts over which offsets of sensors are averaged
  PrecisionSetup precision;            // on: in the place of the fuzzy controller
};

// Response read at one interrupt, and the point written then (in effect from the next tick on). The
// model of the precision controller is its set point.
struct LogRecord {
  std::uint32_t tick = 0;
  std::int32_t x_cmd = 0, y_cmd = 0;      // [count]
  std::int32_t x_pos = 0, y_pos = 0;      // [count]
  std::int32_t x_model = 0, y_model = 0;  // [count]
  std::int32_t x_iq = 0, y_iq = 0;        // i_q* [I_fs / 4096]
  std::uint32_t x_status = 0, y_status = 0;
};

enum class Failure : std::uint32_t {
  kNone,
  kWrongChip,    // ID is not that of the register map
  kOutOfStroke,  // the path has a point outside a stroke; nothing was enabled
  kBusy,         // a busy bit did not clear
  kSensor,       // a current sensor shows more than 1/8 of its range with the drives off
  kPreset,       // the position did not become the start point
  kLate,         // an interrupt was lost, its service crossed a tick or came behind a knot
  kFault,        // the chip latched a fault: fault()
  kFollowing,    // a position is too far from its reference model
  kDCurrent      // a measured i_d is too large, though its loop holds it at 0
};

// `failure` is a Failure; a point is one of the path, counted when written. The estimators are read
// where they are in the application, which this is a part of: a core computes nothing for them.
class KungMailbox : public Mailbox {
 public:
  KungMailbox(const KungMailbox&) = delete;
  KungMailbox& operator=(const KungMailbox&) = delete;

  const Estimator& estimator(std::uint32_t axis) const;  // of the precision controller

 private:
  friend class KungApp;
  KungMailbox() = default;
  ~KungMailbox() = default;
};

// The mailbox is first: a core reaches what is near the begin by one instruction.
class KungApp final : public Firmware, private KungMailbox {
 public:
  static constexpr std::uint32_t kLogSize = 128;
  static constexpr std::uint32_t kPollLimit = 4096;  // a table reset takes 50 clk
  static constexpr std::uint32_t kStopLimit = 64;    // writes that turn an axis off, once again

  [[gnu::cold]] explicit KungApp(const KungSetup& setup);

  [[gnu::cold]] void start(Bus& bus) override;
  void isr(Bus& bus) override;
  [[gnu::cold]] void stop(Bus& bus);  // drives off, no further interrupt; the program has ended
  const KungMailbox& mailbox() const override { return *this; }

  std::uint32_t fault() const { return fault_; }  // FAULT register at kFault: code, axis, tick
  std::uint32_t points() const { return size_; }  // of the whole path

  std::uint32_t log_size() const { return logged_ < kLogSize ? logged_ : kLogSize; }
  // The n-th of the kept records, oldest first; n < log_size().
  const LogRecord& log(std::uint32_t n) const {
    return log_[(logged_ - log_size() + n) % kLogSize];
  }

 private:
  friend class KungMailbox;

  enum class State : std::uint8_t { kOff, kCalibrating, kArming, kRunning, kPrecise };

  bool within_stroke(Point at) const;
  [[gnu::cold]] bool path_within_stroke() const;
  [[gnu::cold]] void calibrate(Bus& bus);
  [[gnu::cold]] void arm(Bus& bus);
  void serve(Bus& bus);
  void command(Bus& bus);
  void read_response(Bus& bus, LogRecord& record) const;
  bool follows(const LogRecord& record) const;
  bool d_currents_plausible(Bus& bus) const;
  bool begin(Bus& bus, LogRecord& record);
  void keep(LogRecord& record);
  // Apart, so that a core does not save for them the registers that serve() has no use for.
  [[gnu::noinline]] void serve_precision(Bus& bus);
  bool await_tick(Bus& bus, std::uint32_t tick);
  void look_ahead();
  [[gnu::cold]] void fail(Bus& bus, Failure why);

  // Small ones first.
  std::uint32_t last_tick_ = 0;
  std::uint32_t fault_ = 0;
  State state_ = State::kOff;
  std::array<std::int32_t, 4> currents_{};  // sums of X a, X b, Y a, Y b
  std::uint32_t calibrated_ = 0;            // interrupts in them
  std::uint32_t logged_ = 0;
  Trajectory trajectory_;
  Point start_;
  Point command_;
  std::uint32_t size_;
  KungSetup setup_;
  PrecisionControl precision_;
  std::uint32_t drawn_ = 0;  // points of the path that the precision controller was given
  Point path_point_;         // the last of them [2^-8 count]
  std::array<LogRecord, kLogSize> log_{};
};

inline const Estimator& KungMailbox::estimator(std::uint32_t axis) const {
  return static_cast<const KungApp&>(*this).precision_.estimator(axis);
}

}  // namespace trammel::sw
