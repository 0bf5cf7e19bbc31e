// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/an693/an693.hpp"

namespace trammel::sw {
namespace {

// Control words of LTRJ.
constexpr std::uint32_t kHere = 0x0000;           // nothing follows
constexpr std::uint32_t kRelativeMove = 0x002B;   // acceleration, velocity, relative position
constexpr std::uint32_t kForwardSpeed = 0x1828;   // velocity mode: acceleration, velocity
constexpr std::uint32_t kForwardFaster = 0x180C;  // velocity mode: an increment of velocity
constexpr std::uint32_t kMove = 0x000A;           // velocity and position, both absolute
constexpr std::uint32_t kStopBits = 0x0700;

}  // namespace

void an693_move(Lm628Port& port, std::int32_t velocity, std::int32_t position) {
  port.command(Lm628Command::kLtrj, kMove);
  port.long_word(velocity);
  port.long_word(position);
  port.command(Lm628Command::kStt);
}

void an693_stop(Lm628Port& port, An693Stop stop) {
  port.command(Lm628Command::kLtrj, static_cast<std::uint32_t>(stop) & kStopBits);
  port.command(Lm628Command::kStt);
}

// AN-693, "Hardware reset": RST, then at least 1.5 ms until the status is valid.
void An693App::start(Bus& bus) {
  ++resets_;
  state_ = State::kReset;
  bus.write(lm628_map::kReset, 1);
  bus.write(lm628_map::kTimer, kResetClk);
}

void An693App::isr(Bus& bus) {
  const std::uint32_t cause = bus.read(lm628_map::kIrq);
  Lm628Port port(bus);
  if ((cause & lm628_map::kIrqHost) != 0) {
    on_host(bus, port);
  } else if ((cause & lm628_map::kIrqTimer) != 0) {
    bus.write(lm628_map::kTimer, 0);
    on_timer(bus, port);
  }
  if (port.stuck()) fail(bus, An693Failure::kBusy);
}

void An693App::on_timer(Bus& bus, Lm628Port& port) {
  switch (state_) {
    case State::kReset:
      // A part whose status is wrong is reset again.
      if (initialise(port, setup_.converter)) {
        stop_on_error(port, setup_.error_limit);
        index_.arm(port);
        load_filter(port, setup_.filter);
        begin(bus, port);
      } else if (resets_ < kResets) {
        start(bus);
      } else {
        fail(bus, An693Failure::kReset);
      }
      break;
    case State::kLoaded:
      go(port);
      state_ = State::kMoving;
      break;
    case State::kPause:
      if (setup_.program == An693Program::kTuning && mail_.point < setup_.steps) {
        step(port);
        state_ = State::kMoving;
      } else {
        finish(bus, port);
      }
      break;
    case State::kMoving:
    case State::kDone:
      break;
  }
}

void An693App::load_trajectory(Lm628Port& port, std::uint32_t control) const {
  port.command(Lm628Command::kLtrj, control);
  port.long_word(setup_.acceleration);
  port.long_word(setup_.velocity);
  if (control != kForwardSpeed) port.long_word(setup_.position);
}

void An693App::begin(Bus& bus, Lm628Port& port) {
  switch (setup_.program) {
    case An693Program::kHold:
      port.command(Lm628Command::kLtrj, kHere);
      go(port);
      wait(bus, State::kPause);
      break;
    case An693Program::kAbsolute:
      load_trajectory(port, kLm628AbsoluteMove);
      go(port);
      state_ = State::kMoving;
      break;
    case An693Program::kRelative:
      load_trajectory(port, kRelativeMove);
      wait(bus, State::kLoaded);
      break;
    case An693Program::kBreakpoints:
      port.command(Lm628Command::kMski, lm628_status::kBreakpoint | watched());
      port.command_long(Lm628Command::kSbpa, setup_.breakpoint);
      load_trajectory(port, kForwardSpeed);
      go(port);
      state_ = State::kMoving;
      break;
    case An693Program::kTuning:
      step(port);
      state_ = State::kMoving;
      break;
  }
}

void An693App::go(Lm628Port& port) {
  port.command(Lm628Command::kStt);
  ++mail_.point;
}

// AN-693, "Step generator": there, and back.
void An693App::step(Lm628Port& port) {
  const std::int32_t distance = mail_.point % 2 == 0 ? setup_.position : -setup_.position;
  port.command(Lm628Command::kLtrj, kRelativeMove);
  port.long_word(setup_.acceleration);
  port.long_word(setup_.velocity);
  port.long_word(distance);
  go(port);
}

void An693App::on_host(Bus& bus, Lm628Port& port) {
  const std::uint8_t status = port.status();
  port.command(Lm628Command::kRsti, 0x0000);
  if ((status & lm628_status::kPositionError) != 0) return fail(bus, An693Failure::kPositionError);
  if ((status & lm628_status::kCommandError) != 0) return fail(bus, An693Failure::kCommandError);
  if (index_.checks() && (status & lm628_status::kIndex) != 0 && index_.lost_at_index(port)) {
    return fail(bus, An693Failure::kIndex);
  }
  if (state_ != State::kMoving) return;  // kHold: its trajectory is complete at once
  if (setup_.program == An693Program::kBreakpoints && mail_.point < 3) {
    if ((status & lm628_status::kBreakpoint) != 0) at_breakpoint(port);
  } else if ((status & lm628_status::kTrajectoryComplete) != 0) {
    wait(bus, State::kPause);
  }
}

// AN-693, "Velocity profile with breakpoints". The end of the stop interrupts too: it is unmasked
// before the stop, since unmasking an event that is already there raises no interrupt.
void An693App::at_breakpoint(Lm628Port& port) {
  if (mail_.point == 1) {
    port.command_long(Lm628Command::kSbpa, 2 * setup_.breakpoint);
    port.command(Lm628Command::kLtrj, kForwardFaster);
    port.long_word(setup_.velocity);
    go(port);
    port.command(Lm628Command::kMski,
                 lm628_status::kBreakpoint | lm628_status::kTrajectoryComplete | watched());
  } else {
    an693_stop(port, An693Stop::kSmooth);
    ++mail_.point;
  }
}

void An693App::wait(Bus& bus, State state) {
  state_ = state;
  bus.write(lm628_map::kTimer, setup_.wait_clk);
}

void An693App::finish(Bus& bus, Lm628Port& port) {
  mail_.desired[0] = port.ask_long(Lm628Command::kRddp);
  mail_.real[0] = port.ask_long(Lm628Command::kRdrp);
  if (index_.lost_before(mail_.real[0])) return fail(bus, An693Failure::kIndex);
  state_ = State::kDone;
  mail_.done = 1;
}

void An693App::fail(Bus& bus, An693Failure failure) {
  if (mail_.failure != 0) return;
  mail_.failure = static_cast<std::uint32_t>(failure);
  state_ = State::kDone;
  bus.write(lm628_map::kTimer, 0);
  if (failure != An693Failure::kBusy && failure != An693Failure::kReset) {
    Lm628Port port(bus);
    an693_stop(port, An693Stop::kOff);
  }
  mail_.done = 1;
}

}  // namespace trammel::sw
