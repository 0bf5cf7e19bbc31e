// SPDX-License-Identifier: Apache-2.0
//
// Example programs of National's application note AN-693 for the LM628. start() strobes RST; the
// timer's interrupt, 1.5 ms later, finds the part ready and begins the chosen program, which
// continues at each interrupt of the part or the timer. Freestanding; it waits for interrupts and
// polls nothing but the busy bit.
#pragma once

#include <cstdint>

#include "sw_nios/hal/lm628.hpp"
#include "sw_nios/hal/lm628_index.hpp"

namespace trammel::sw {

enum class An693Program : std::uint8_t {
  kHold,         // the loop closes where the shaft is
  kAbsolute,     // one move to a position
  kRelative,     // one move by a distance, started some time after it was loaded
  kBreakpoints,  // velocity mode: two speeds and a stop, changed at breakpoints
  kTuning        // steps there and back
};

using An693Filter = Lm628Filter;

struct An693Setup {
  An693Program program = An693Program::kHold;
  Lm628Converter converter = Lm628Converter::k12Bits;
  An693Filter filter;
  std::int32_t acceleration = 2;       // [2^-16 count/sample^2]
  std::int32_t velocity = 0x346E;      // [2^-16 count/sample]; of kBreakpoints the first speed
  std::int32_t position = 8000;        // [count] target, distance, or size of a step
  std::int32_t breakpoint = 80000;     // [count] the first; the second is at twice that
  std::uint32_t steps = 4;             // of kTuning
  std::uint32_t error_limit = 0;       // [count] position error that turns the motor off; 0: none
  std::uint32_t index_counts = 0;      // between two indexes, to check them; 0: no check
  std::uint32_t wait_clk = 5'000'000;  // before STT, between steps, and at the end
};

enum class An693Failure : std::uint32_t {
  kNone,
  kReset,         // the status after a reset is not one that the data sheet names
  kBusy,          // the busy bit did not clear
  kCommandError,  // status bit 1
  kPositionError, // status bit 5
  kIndex          // an index that is not a turn from the one before
};

class An693App final : public Firmware {
 public:
  static constexpr std::uint32_t kResetClk = 75'000;  // 1.5 ms at 50 MHz
  static constexpr std::uint32_t kResets = 3;         // attempts before it fails

  explicit An693App(const An693Setup& setup) : setup_(setup), index_(setup.index_counts) {}

  void start(Bus& bus) override;
  void isr(Bus& bus) override;
  // `failure` is an An693Failure; a point is an STT, for a move or a change of it; desired and real
  // position are read by RDDP and RDRP.
  const Mailbox& mailbox() const override { return mail_; }

 private:
  enum class State : std::uint8_t { kReset, kLoaded, kMoving, kPause, kDone };

  void load_trajectory(Lm628Port& port, std::uint32_t control) const;
  void begin(Bus& bus, Lm628Port& port);
  void go(Lm628Port& port);
  void step(Lm628Port& port);
  void on_timer(Bus& bus, Lm628Port& port);
  void on_host(Bus& bus, Lm628Port& port);
  void at_breakpoint(Lm628Port& port);
  void wait(Bus& bus, State state);
  void finish(Bus& bus, Lm628Port& port);
  void fail(Bus& bus, An693Failure failure);
  // Mask of what interrupts besides the events that a program waits for.
  std::uint32_t watched() const {
    return (setup_.error_limit != 0 ? lm628_status::kPositionError : 0u) |
           (index_.checks() ? lm628_status::kIndex : 0u);
  }

  Mailbox mail_;
  An693Setup setup_;
  Lm628Index index_;
  State state_ = State::kReset;
  std::uint32_t resets_ = 0;
};

// Trajectory module of AN-693: an absolute move with the acceleration that the part already has.
void an693_move(Lm628Port& port, std::int32_t velocity, std::int32_t position);

// Stop module of AN-693: motor off, abruptly, or smoothly.
enum class An693Stop : std::uint32_t { kOff = 0x0100, kAbrupt = 0x0200, kSmooth = 0x0400 };
void an693_stop(Lm628Port& port, An693Stop stop);

}  // namespace trammel::sw
