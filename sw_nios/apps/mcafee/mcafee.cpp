// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/mcafee/mcafee.hpp"

#include "sw_nios/hal/platform_map.hpp"
#include "sw_nios/apps/mcafee/mcafee_xy.hpp"

namespace trammel::sw {

namespace regs = mcafee_xy_regs;

namespace {

// Control words of LTRJ.
constexpr std::uint32_t kAcceleration = 0x0020;
constexpr std::uint32_t kRowMove = 0x000B;       // velocity and position, the latter relative
constexpr std::uint32_t kMotorOff = 0x0100;

constexpr std::uint32_t kLeastVelocity = 0xF1;  // one of the steps of mcafee_velocity
constexpr std::uint32_t kSoon = 2'500;          // [clk], a seventh of a sample

constexpr std::uint32_t kFaults = lm628_status::kCommandError | lm628_status::kPositionError;

constexpr std::uint32_t magnitude(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return value < 0 ? 0 - bits : bits;
}

}  // namespace

struct McafeeApp::Parts {
  explicit Parts(Bus& bus)
      : x_bus(bus, false), y_bus(bus, true), port{Lm628Port(x_bus), Lm628Port(y_bus)} {}

  McafeePart x_bus, y_bus;
  std::array<Lm628Port, 2> port;

  bool stuck() const { return port[0].stuck() || port[1].stuck(); }
};

// Both parts at once, by their pins, so that their samples coincide from then on.
void McafeeApp::start(Bus& bus) {
  bus.write(regs::kReset, regs::kResetStrobe);
  wait(bus, State::kReset, kResetClk);
}

void McafeeApp::isr(Bus& bus) {
  Parts parts(bus);
  if ((bus.read(platform_map::kIrq) & platform_map::kIrqTimer) != 0) {
    bus.write(platform_map::kTimer, 0);
    if (state_ != State::kReset && bus.read(regs::kLimits) != 0) {
      fail(bus, McafeeFailure::kLimit);
    } else {
      on_timer(bus, parts);
    }
  }
  if (bus.read(regs::kIrq) != 0) on_host(bus, parts);
  if (parts.stuck()) fail(bus, McafeeFailure::kBusy);
}

void McafeeApp::on_timer(Bus& bus, Parts& parts) {
  switch (state_) {
    case State::kReset:
      for (Lm628Port& port : parts.port) {
        if (!initialise(port, Lm628Converter::k8Bits)) return fail(bus, McafeeFailure::kReset);
      }
      begin(bus, parts);
      break;
    case State::kReading:
      parts.port[0].ask_long(Lm628Command::kRdrp);
      if (++mail_.point == setup_.readings) {
        finish(bus, parts);
      } else {
        wait(bus, State::kReading, setup_.wait_clk);
      }
      break;
    case State::kMoving:  // the end of the move interrupts; the timer watches the limit switches
      wait(bus, State::kMoving, setup_.sample_clk);
      break;
    case State::kRow:
      watch_row(bus, parts);
      break;
    case State::kSample:
      if ((bus.read(regs::kStatus) & regs::kStatusSample) != 0) {
        start_row(bus, parts);
      } else {
        wait(bus, State::kSample, kSoon);
      }
      break;
    case State::kLast: {
      bool there = true;
      for (std::uint32_t k = 0; k < 2; ++k) {
        there = there && parts.port[k].ask_long(Lm628Command::kRddp) == axes_[k].target;
      }
      wait(bus, there ? State::kPause : State::kLast, there ? setup_.wait_clk : setup_.sample_clk);
      break;
    }
    case State::kPause:
      finish(bus, parts);
      break;
    case State::kDone:
      break;
  }
}

void McafeeApp::on_host(Bus& bus, Parts& parts) {
  bool complete = false;
  for (unsigned k = 0; k < 2; ++k) {
    Lm628Port& port = parts.port[k];
    const std::uint8_t status = port.status();
    if ((status & lm628_status::kCommandError) != 0) fail(bus, McafeeFailure::kCommandError);
    if ((status & lm628_status::kPositionError) != 0) fail(bus, McafeeFailure::kPositionError);
    complete = complete || (status & lm628_status::kTrajectoryComplete) != 0;
    port.command(Lm628Command::kRsti, 0x0000);
    if (index_[k].checks() && (status & lm628_status::kIndex) != 0 &&
        index_[k].lost_at_index(port)) {
      fail(bus, McafeeFailure::kIndex);
    }
  }
  if (complete && state_ == State::kMoving) wait(bus, State::kPause, setup_.wait_clk);
}

void McafeeApp::begin(Bus& bus, Parts& parts) {
  if (setup_.stage == McafeeStage::kRead) return wait(bus, State::kReading, 1);
  if (setup_.stage == McafeeStage::kMove) {
    Lm628Port& port = parts.port[0];
    stop_on_error(port, setup_.error_limit);
    index_[0].arm(port);
    load_filter(port, setup_.filter);
    port.command(Lm628Command::kLtrj, kLm628AbsoluteMove);
    port.long_word(setup_.acceleration);
    port.long_word(setup_.velocity);
    port.long_word(setup_.position);
    port.command(Lm628Command::kStt);
    return wait(bus, State::kMoving, setup_.sample_clk);
  }
  for (unsigned k = 0; k < 2; ++k) {
    Lm628Port& port = parts.port[k];
    port.command(Lm628Command::kMski,
                 kFaults | (setup_.index_counts != 0 ? lm628_status::kIndex : 0u));
    stop_on_error(port, setup_.error_limit);
    index_[k].arm(port);
    load_filter(port, setup_.filter);
    port.command(Lm628Command::kLtrj, kAcceleration);
    port.long_word(setup_.acceleration);
    port.command(Lm628Command::kStt);
  }
  load_row(bus, parts);
  bus.write(regs::kStatus, regs::kStatusSample);
  wait(bus, State::kSample, kSoon);
}

std::uint32_t McafeeApp::feed_rate(Bus& bus, const McafeeRow& row) {
  bus.write(regs::kFeedIn, row.c | std::uint32_t{row.cc} << 8);
  for (std::uint32_t polls = 0; polls < McafeePart::kPollLimit; ++polls) {
    const std::uint32_t out = bus.read(regs::kFeedOut);
    if ((out & regs::kFeedOutReady) != 0) return out & 0xFF;
  }
  fail(bus, McafeeFailure::kBusy);
  return 0;
}

// While a row runs, the next one waits in the buffers of the parts. An axis that does not move in
// it is left alone; a move of velocity 0 would never end.
void McafeeApp::load_row(Bus& bus, Parts& parts) {
  const McafeeRow& row = setup_.rows[loaded_++];
  const std::uint32_t v = setup_.speed != 0 ? setup_.speed : feed_rate(bus, row);
  speed_ = v < setup_.least_speed ? setup_.least_speed : v;
  const std::array<std::int32_t, 2> way{row.dx, row.dy};
  const std::array<std::uint32_t, 2> scale{row.vx, row.vy};
  for (std::uint32_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    axis.loaded = way[k] != 0;
    if (!axis.loaded) continue;
    const std::uint32_t velocity = mcafee_velocity(speed_, scale[k]);
    axis.velocity = (velocity < kLeastVelocity ? kLeastVelocity : velocity)
                    << setup_.velocity_shift;
    axis.next = axis.target + way[k];
    parts.port[k].command(Lm628Command::kLtrj, kRowMove);
    parts.port[k].long_word(static_cast<std::int32_t>(axis.velocity));
    parts.port[k].long_word(way[k]);
  }
}

// A sample was just published: no other one may fall between the two STT. A command that comes
// within a sample is executed after it, so that a part which is ready again has taken its STT, and
// the samples until then have been published.
void McafeeApp::start_row(Bus& bus, Parts& parts) {
  bus.write(regs::kStatus, regs::kStatusSample);
  for (std::uint32_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    if (!axis.loaded) continue;
    parts.port[k].command(Lm628Command::kStt);
    axis.target = axis.next;
    axis.fastest = axis.velocity;
    axis.near = false;
  }
  if (axes_[0].loaded && axes_[1].loaded && parts.port[1].ready() &&
      (bus.read(regs::kStatus) & regs::kStatusSample) != 0) {
    return fail(bus, McafeeFailure::kLate);
  }
  mail_.speed = speed_;
  ++mail_.point;
  if (loaded_ == setup_.row_count) return wait(bus, State::kLast, setup_.sample_clk);
  load_row(bus, parts);
  wait(bus, State::kRow, kSoon);
}

// The next row is due when both axes have come within two samples of their targets, at the speed
// they had: the one with the shorter move is often later, since its velocity is rounded down more.
void McafeeApp::watch_row(Bus& bus, Parts& parts) {
  bool due = true;
  std::uint32_t samples = 0;
  for (std::uint32_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    if (axis.near) continue;
    const std::int32_t desired = parts.port[k].ask_long(Lm628Command::kRddp);
    const std::uint32_t speed = magnitude(parts.port[k].ask_long(Lm628Command::kRddv));
    const std::uint32_t left = magnitude(axis.target - desired) << 16;
    axis.near = left <= 2 * speed;
    if (axis.near) continue;
    due = false;
    const std::uint32_t least = left / (speed > axis.fastest ? speed : axis.fastest);
    samples = samples > least ? samples : least;
  }
  if (due) {
    bus.write(regs::kStatus, regs::kStatusSample);
    return wait(bus, State::kSample, kSoon);
  }
  // Sleeps until two samples before that, for axes at their highest speed.
  wait(bus, State::kRow, samples > 5 ? (samples - 4) * setup_.sample_clk : kSoon);
}

void McafeeApp::finish(Bus& bus, Parts& parts) {
  for (std::uint32_t k = 0; k < 2; ++k) {
    mail_.real[k] = parts.port[k].ask_long(Lm628Command::kRdrp);
    if (index_[k].lost_before(mail_.real[k])) return fail(bus, McafeeFailure::kIndex);
  }
  state_ = State::kDone;
  mail_.done = 1;
}

void McafeeApp::wait(Bus& bus, State state, std::uint32_t clocks) {
  if (state_ == State::kDone) return;
  state_ = state;
  bus.write(platform_map::kTimer, clocks);
}

void McafeeApp::fail(Bus& bus, McafeeFailure failure) {
  if (mail_.failure != 0) return;
  mail_.failure = static_cast<std::uint32_t>(failure);
  state_ = State::kDone;
  bus.write(platform_map::kTimer, 0);
  if (failure != McafeeFailure::kBusy && failure != McafeeFailure::kReset) {
    Parts parts(bus);
    for (Lm628Port& port : parts.port) {
      port.command(Lm628Command::kLtrj, kMotorOff);
      port.command(Lm628Command::kStt);
    }
  }
  mail_.done = 1;
}

}  // namespace trammel::sw
