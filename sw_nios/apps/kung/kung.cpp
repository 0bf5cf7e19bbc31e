// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/kung/kung.hpp"

#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::sw {
namespace {

namespace reg = kung_xy_regs;

constexpr std::array<std::uint32_t, 2> kBases{reg::kX, reg::kY};
constexpr std::uint32_t kStickyStatus =
    reg::kStatusOverrun | reg::kStatusQepError | reg::kStatusSaturated | reg::kStatusLimited;
constexpr std::int32_t kMaxOffset = 256;  // of a current sensor [I_fs / 2048]
constexpr std::uint32_t kAllIrqs = reg::kIrqStatTick | reg::kIrqStatFault;

constexpr std::uint32_t word(std::int32_t value) { return static_cast<std::uint32_t>(value); }

constexpr std::uint32_t kPrecisionStatus = reg::kStatusUnderrun | reg::kStatusClipped;

static_assert(gain_word({0x7FF, -1}) == (reg::kKpMantMask | reg::kKpExpMask));

constexpr std::uint32_t mode(const AxisSetup& axis, const KungSetup& setup) {
  if (setup.precision.on) {
    return reg::kCtrlCurrentLoop | reg::kCtrlPositionLoop | reg::kCtrlPrecision;
  }
  return reg::kCtrlCurrentLoop | (setup.current_command ? 0 : reg::kCtrlPositionLoop) |
         (axis.adapt ? reg::kCtrlAdapt : 0) |
         (axis.interpolate ? reg::kCtrlInterpolate : 0) |
         (axis.feedforward ? reg::kCtrlFeedforward : 0);
}

std::int32_t read_signed(Bus& bus, std::uint32_t address) {
  return static_cast<std::int32_t>(bus.read(address));
}

bool wait_idle(Bus& bus, std::uint32_t base) {
  for (std::uint32_t polls = 0; polls < KungApp::kPollLimit; ++polls) {
    if ((bus.read(base + reg::kStatus) & reg::kStatusBusy) == 0) return true;
  }
  return false;
}

bool axis_on(Bus& bus, std::uint32_t base) {
  return (bus.read(base + reg::kCtrl) & reg::kCtrlEnable) != 0;
}

bool wait_both_idle(Bus& bus) { return wait_idle(bus, reg::kX) && wait_idle(bus, reg::kY); }

void write_command(Bus& bus, Point point) {
  bus.write(reg::kX + reg::kPosCmd, word(point.x));
  bus.write(reg::kY + reg::kPosCmd, word(point.y));
  bus.write(reg::kCommit, reg::kCommitTake);
}

void configure_axis(Bus& bus, std::uint32_t base, const AxisSetup& axis, std::int32_t start) {
  bus.write(base + reg::kKp, gain_word(axis.kp));
  bus.write(base + reg::kKi, gain_word(axis.ki));
  bus.write(base + reg::kKv, gain_word(axis.kv));
  bus.write(base + reg::kEta, gain_word(axis.eta));
  bus.write(base + reg::kShift,
            (word(axis.shift_e) << reg::kShiftEShift & reg::kShiftEMask) |
                (word(axis.shift_de) << reg::kShiftDeShift & reg::kShiftDeMask));
  bus.write(base + reg::kA0, axis.a0 << reg::kA0ValueShift | axis.a0_scale << reg::kA0ScaleShift);
  bus.write(base + reg::kB2, axis.b2);
  bus.write(base + reg::kKpCur, gain_word(axis.kp_cur));
  bus.write(base + reg::kKiCur, gain_word(axis.ki_cur));
  bus.write(base + reg::kAngleStep, axis.angle_step);
  bus.write(base + reg::kThetaOfs, axis.theta_ofs);
  bus.write(base + reg::kCurrentOffset, 0);
  bus.write(base + reg::kAdcFrame, axis.adc_zeros);
  bus.write(base + reg::kDeadtime, axis.dead_time << reg::kDeadtimeClkShift |
                                       axis.qep_filter << reg::kDeadtimeQepFilterShift);
  bus.write(base + reg::kStrokeMin, word(axis.stroke_min));
  bus.write(base + reg::kStrokeMax, word(axis.stroke_max));
  bus.write(base + reg::kIqManual, 0);
  bus.write(base + reg::kPosPreset, word(start));
}

// The way of the identification move: towards the middle of the stroke.
constexpr std::int32_t wave(const AxisSetup& axis, const PrecisionAxisSetup& precision,
                            std::int32_t start) {
  return 2 * start <= axis.stroke_min + axis.stroke_max ? precision.wave : -precision.wave;
}
constexpr Point identification(const KungSetup& setup, Point start) {
  return {wave(setup.axis[0], setup.precision.axis[0], start.x),
          wave(setup.axis[1], setup.precision.axis[1], start.y)};
}

constexpr std::uint32_t lap(const KungSetup& setup, std::uint32_t size) {
  if (setup.path == Path::kFeed) return setup.feed.ticks;
  return setup.repeats == 0 ? size : size / setup.repeats;
}

}  // namespace

KungApp::KungApp(const KungSetup& setup)
    : trajectory_(setup),
      start_(trajectory_.start()),
      command_(start_),
      size_(trajectory_.size()),
      setup_(setup),
      precision_(setup.precision, start_, identification(setup, start_), size_,
                 lap(setup, size_)) {
  if (!setup.precision.on) return;
  look_ahead();
  look_ahead();
}

bool KungApp::within_stroke(Point at) const {
  const AxisSetup& x = setup_.axis[0];
  const AxisSetup& y = setup_.axis[1];
  return at.x >= x.stroke_min && at.x <= x.stroke_max && at.y >= y.stroke_min &&
         at.y <= y.stroke_max;
}

bool KungApp::path_within_stroke() const {
  PathSetup once = setup_;  // every pass has the same bounds
  once.repeats = 1;
  Trajectory rehearsal(once);
  bool within = within_stroke(start_);
  if (setup_.precision.on && setup_.precision.identify) {
    const Point way = identification(setup_, start_);
    within = within && within_stroke({start_.x + way.x / 256, start_.y + way.y / 256});
  }
  for (std::uint32_t i = rehearsal.size(); within && i > 0; --i)
    within = within_stroke(rehearsal.next());
  return within;
}

void KungApp::start(Bus& bus) {
  bus.write(reg::kIrqEn, 0);
  for (const std::uint32_t base : kBases) bus.write(base + reg::kCtrl, reg::kCtrlResetModel);
  if (bus.read(reg::kId) != reg::kIdValue) return fail(bus, Failure::kWrongChip);
  if (!path_within_stroke()) return fail(bus, Failure::kOutOfStroke);

  bus.write(reg::kLock, reg::kKeyUnlock);
  bus.write(reg::kRates, setup_.carrier << reg::kRatesCarrierShift |
                             setup_.position_rate << reg::kRatesPositionShift);
  bus.write(reg::kIrqPeriod, setup_.irq_period);
  bus.write(reg::kWatchdog, setup_.watchdog_ticks);
  bus.write(reg::kCurrentLimit, setup_.current_limit);
  bus.write(reg::kDeadtimeMin, setup_.dead_time_min);
  for (const std::uint32_t base : kBases) bus.write(base + reg::kStrokeEn, 0);
  configure_axis(bus, reg::kX, setup_.axis[0], start_.x);
  configure_axis(bus, reg::kY, setup_.axis[1], start_.y);

  if (!wait_both_idle(bus)) return fail(bus, Failure::kBusy);
  const std::uint32_t chosen = setup_.precision.on ? reg::kCtrlPrecision : 0;
  for (const std::uint32_t base : kBases) {
    bus.write(base + reg::kCtrl, reg::kCtrlResetModel | reg::kCtrlResetTable | chosen);
  }
  if (!wait_both_idle(bus)) return fail(bus, Failure::kBusy);
  if (setup_.precision.on) precision_.start(bus);

  write_command(bus, start_);
  state_ = setup_.offset_samples == 0 ? State::kArming : State::kCalibrating;
  bus.write(reg::kIrqStat, kAllIrqs);
  bus.write(reg::kIrqEn, reg::kIrqEnTick);
}

void KungApp::isr(Bus& bus) {
  const std::uint32_t cause = bus.read(reg::kIrqStat);
  bus.write(reg::kIrqStat, cause);
  if (state_ >= State::kRunning && (cause & reg::kIrqStatFault) != 0) {
    fault_ = bus.read(reg::kFault);
    return fail(bus, Failure::kFault);
  }
  if ((cause & reg::kIrqStatTick) == 0) return;
  if (state_ == State::kCalibrating) {
    calibrate(bus);
  } else if (state_ == State::kArming) {
    arm(bus);
  } else if (state_ == State::kRunning) {
    serve(bus);
  } else if (state_ == State::kPrecise) {
    serve_precision(bus);
  }
}

// No current flows: what the sensors show are their offsets.
void KungApp::calibrate(Bus& bus) {
  for (std::uint32_t a = 0; a < 2; ++a) {
    const std::uint32_t both = bus.read(kBases[a] + reg::kPhaseCurrents);
    currents_[2 * a] += static_cast<std::int16_t>(both & 0xFFFFu);
    currents_[2 * a + 1] += static_cast<std::int16_t>(both >> 16);
  }
  if (++calibrated_ < setup_.offset_samples) return;
  const auto count = static_cast<std::int32_t>(calibrated_);
  for (std::uint32_t a = 0; a < 2; ++a) {
    std::array<std::uint32_t, 2> offset{};
    for (std::uint32_t phase = 0; phase < 2; ++phase) {
      const std::int32_t sum = currents_[2 * a + phase];
      const std::int32_t mean = (2 * sum + (sum < 0 ? -count : count)) / (2 * count);
      if (mean > kMaxOffset || mean < -kMaxOffset) return fail(bus, Failure::kSensor);
      offset[phase] = word(mean) & reg::kCurrentOffsetAMask;
    }
    bus.write(kBases[a] + reg::kCurrentOffset, offset[0] << reg::kCurrentOffsetAShift |
                                                   offset[1] << reg::kCurrentOffsetBShift);
  }
  state_ = State::kArming;
}

// The chip has latched the preset counts and taken the start point: the model now starts at rest.
void KungApp::arm(Bus& bus) {
  last_tick_ = bus.read(reg::kTick);
  if (read_signed(bus, reg::kX + reg::kPos) != start_.x ||
      read_signed(bus, reg::kY + reg::kPos) != start_.y) {
    return fail(bus, Failure::kPreset);
  }
  const std::uint32_t sticky = kStickyStatus | (setup_.precision.on ? kPrecisionStatus : 0);
  for (const std::uint32_t base : kBases) bus.write(base + reg::kStatus, sticky);
  bus.write(reg::kFaultClear, reg::kKeyFaultClear);
  bus.write(reg::kIrqStat, reg::kIrqStatFault);
  fault_ = bus.read(reg::kFault);
  if ((fault_ & reg::kFaultCodeMask) != reg::kFaultCodeNone) return fail(bus, Failure::kFault);

  bus.write(reg::kX + reg::kStrokeEn, setup_.axis[0].stroke_check ? reg::kStrokeEnEnable : 0);
  bus.write(reg::kY + reg::kStrokeEn, setup_.axis[1].stroke_check ? reg::kStrokeEnEnable : 0);
  bus.write(reg::kLock, reg::kKeyLock);
  if (!wait_both_idle(bus)) return fail(bus, Failure::kBusy);
  bus.write(reg::kX + reg::kCtrl, mode(setup_.axis[0], setup_) | reg::kCtrlEnable);
  bus.write(reg::kY + reg::kCtrl, mode(setup_.axis[1], setup_) | reg::kCtrlEnable);
  state_ = setup_.precision.on ? State::kPrecise : State::kRunning;
  bus.write(reg::kIrqEn, reg::kIrqEnTick | reg::kIrqEnFault);
}

// The response, read in time.
[[gnu::always_inline]] inline bool KungApp::begin(Bus& bus, LogRecord& record) {
  record.tick = bus.read(reg::kTick);
  const std::uint32_t period = setup_.irq_period == 0 ? 1 : setup_.irq_period;
  if (record.tick != last_tick_ + period) return false;
  last_tick_ = record.tick;
  read_response(bus, record);
  return true;
}

// With the point that was written.
[[gnu::always_inline]] inline void KungApp::keep(LogRecord& record) {
  record.x_cmd = command_.x;
  record.y_cmd = command_.y;
  log_[logged_ % kLogSize] = record;
  ++logged_;
}

void KungApp::serve(Bus& bus) {
  LogRecord record;
  if (!begin(bus, record)) return fail(bus, Failure::kLate);
  if (!follows(record)) return fail(bus, Failure::kFollowing);
  if (!d_currents_plausible(bus)) return fail(bus, Failure::kDCurrent);

  const bool more = Mailbox::point < size_;
  if (more) command_ = trajectory_.next();
  command(bus);
  if (more && Mailbox::point == 0) {
    if (bus.read(reg::kTick) != record.tick) return fail(bus, Failure::kLate);
    Mailbox::first_tick = record.tick + 1;
  }
  if (more) ++Mailbox::point;
  if (Mailbox::point == size_) Mailbox::done = 1;

  keep(record);
}

// The same with the precision controller, which writes the words of the next knot.
void KungApp::serve_precision(Bus& bus) {
  LogRecord record;
  if (!begin(bus, record)) return fail(bus, Failure::kLate);
  record.x_model = record.x_pos + rs(read_signed(bus, reg::kX + reg::kPrecErr), 8);
  record.y_model = record.y_pos + rs(read_signed(bus, reg::kY + reg::kPrecErr), 8);
  if (((record.x_status | record.y_status) & reg::kStatusUnderrun) != 0) {
    return fail(bus, Failure::kLate);
  }
  if (!follows(record)) return fail(bus, Failure::kFollowing);
  if (!d_currents_plausible(bus)) return fail(bus, Failure::kDCurrent);

  const bool more = Mailbox::point < size_ && precision_.on_path();
  const bool places_knots = logged_ == 0;
  if (places_knots && !await_tick(bus, record.tick)) return fail(bus, Failure::kLate);
  command_ = {rs(precision_.point().x, 8), rs(precision_.point().y, 8)};
  precision_.serve(bus);
  const std::uint32_t committed = record.tick + 1;
  if (places_knots && bus.read(reg::kTick) != committed) return fail(bus, Failure::kLate);
  if (more && Mailbox::point == 0) Mailbox::first_tick = committed + 1;
  if (more) ++Mailbox::point;
  if (Mailbox::point == size_) Mailbox::done = 1;

  keep(record);
  look_ahead();
}

// The first COMMIT of the precision controller places the knots at the tick behind it, for good.
// Given after the next tick, it leaves two ticks to every later service before its knot.
bool KungApp::await_tick(Bus& bus, std::uint32_t tick) {
  for (std::uint32_t polls = 0; polls < kPollLimit; ++polls) {
    if (bus.read(reg::kTick) != tick) return true;
  }
  return false;
}

// The next point but one, which the pre-filter needs with the next COMMIT.
void KungApp::look_ahead() {
  Point ahead{256 * start_.x, 256 * start_.y};
  if (precision_.needs_point()) {
    if (drawn_ < size_) {
      ++drawn_;
      path_point_ = trajectory_.next_q8();
    }
    ahead = path_point_;
  }
  precision_.give(ahead);
}

// Without position loops the COMMIT only feeds the watchdog.
void KungApp::command(Bus& bus) {
  if (!setup_.current_command) return write_command(bus, command_);
  bus.write(reg::kX + reg::kIqManual, word(command_.x - start_.x));
  bus.write(reg::kY + reg::kIqManual, word(command_.y - start_.y));
  bus.write(reg::kCommit, reg::kCommitTake);
}

void KungApp::read_response(Bus& bus, LogRecord& record) const {
  record.x_status = bus.read(reg::kX + reg::kStatus);
  record.y_status = bus.read(reg::kY + reg::kStatus);
  record.x_pos = read_signed(bus, reg::kX + reg::kPos);
  record.y_pos = read_signed(bus, reg::kY + reg::kPos);
  record.x_model = read_signed(bus, reg::kX + reg::kPosModel);
  record.y_model = read_signed(bus, reg::kY + reg::kPosModel);
  record.x_iq = read_signed(bus, reg::kX + reg::kIqCmd);
  record.y_iq = read_signed(bus, reg::kY + reg::kIqCmd);
}

bool KungApp::follows(const LogRecord& record) const {
  const std::int32_t limit = setup_.following_limit;
  const std::int32_t x = record.x_pos - record.x_model, y = record.y_pos - record.y_model;
  return limit == 0 || (x <= limit && x >= -limit && y <= limit && y >= -limit);
}

// The loop commands i_d* = 0: where it does not hold that, a current sensor or the angle is wrong.
bool KungApp::d_currents_plausible(Bus& bus) const {
  const std::int32_t limit = setup_.d_current_limit;
  if (limit == 0) return true;
  for (const std::uint32_t base : kBases) {
    const std::uint32_t currents = bus.read(base + reg::kIdIq);
    const std::int32_t i_d = static_cast<std::int16_t>(currents & reg::kIdIqIDMask);
    if (i_d > limit || i_d < -limit) return false;
  }
  return true;
}

void KungApp::fail(Bus& bus, Failure why) {
  Mailbox::failure = static_cast<std::uint32_t>(why);
  stop(bus);
}

// Both axes off, until they show it.
void KungApp::stop(Bus& bus) {
  Mailbox::done = 1;
  state_ = State::kOff;
  for (const std::uint32_t base : kBases) bus.write(base + reg::kCtrl, 0);
  for (const std::uint32_t base : kBases) {
    for (std::uint32_t tries = 0; tries < kStopLimit && axis_on(bus, base); ++tries) {
      bus.write(base + reg::kCtrl, 0);
    }
  }
  bus.write(reg::kIrqEn, 0);
}

}  // namespace trammel::sw
