// SPDX-License-Identifier: Apache-2.0
//
// The routines of the macro .TABLE (Larson 1974, section IV) over the four words of the interface.
// What Larson's routines wait for is a state here: they start something, the caller passes the
// interrupts on, and busy() says when it is over. Freestanding.
//
// Positions are steps from the calibration point. A target outside the soft range is clipped to it;
// the table stops there, its calibration is kept, and WTTBL gives the error return.
#pragma once

#include <cstdint>

#include "sw_nios/hal/bus.hpp"

namespace trammel::sw {

struct StepPoint {
  std::int32_t x = 0, y = 0;  // [step], or [pulse/s] of a velocity
};

struct StepTableSetup {
  std::int32_t soft_end = 5980;     // [step] largest coordinate; the least is 0
  std::int32_t margin = 10;         // [step] from where a switch opens to the coordinate 0
  std::int32_t seek_rate = 400;     // [pulse/s] toward the switches
  std::int32_t back_rate = 100;     // and away from them
  std::int32_t most_rate = 4000;    // that the motors may be driven at
  std::uint32_t poll_clk = 100'000; // [clk] from one look at an open switch to the next
  // [clk] from the end of a move to the return of WTTBL or CALTBL: 25 ms of 50 MHz. A buffer stands
  // 20 ms behind its last pulse, so that the next move begins with a ramp, by a rotor that hardly
  // swings any more. 0: none.
  std::uint32_t settle_clk = 1'250'000;
};

enum class StepAnswer : std::int32_t {
  kStarted = 0,
  kNotCalibrated = -1,  // CALTBL must be the first routine
  kMoving = -2          // nothing happens: WTTBL comes first
};

class StepTable {
 public:
  explicit StepTable(const StepTableSetup& setup) : setup_(setup) {}

  void caltbl(Bus& bus);
  void veltbl(const StepPoint& rate);
  StepAnswer abstbl(Bus& bus, const StepPoint& to);
  StepAnswer reltbl(Bus& bus, const StepPoint& by);  // `by` is kept: the caller repeats it
  StepPoint whrtbl(Bus& bus) const;                  // also while it moves

  // WTTBL: true as long as it has to wait; then, once, 1 for a normal return and 0 for an error.
  bool busy() const { return calibrating() || axes_[0].moving || axes_[1].moving; }
  bool wttbl();

  // Of an interrupt: the chip's; the timer's, which runs where wants_timer() says so.
  void on_vector(Bus& bus, std::uint32_t vector);
  void on_timer(Bus& bus);
  bool wants_timer() const;
  std::uint32_t poll_clk() const { return setup_.poll_clk; }

  // Where nothing moves any more: [clk] until the last move has settled, 0 if that was waited for.
  // Who asks waits: it is told once.
  std::uint32_t settling();

  bool calibrated() const { return calibrated_; }
  // Axes that a switch has stopped since the table was calibrated: bit 0 X, bit 1 Y.
  std::uint32_t stopped() const { return stopped_; }
  StepPoint known() const { return {axes_[0].from, axes_[1].from}; }  // where the last moves ended

  // The rate code of a velocity: 240 kHz / (4096 - code), at most 4000 pulses per second.
  std::uint32_t code(std::int32_t rate) const;

 private:
  enum class Seek : std::uint8_t { kNone, kToSwitch, kOffSwitch, kMargin };

  struct Axis {
    std::int32_t from = 0;   // where the move began, or the table stands
    std::int32_t steps = 0;  // of the move, with its sign
    std::uint32_t rate = 07704;
    bool moving = false;
    bool at_switch = false;  // a switch ended the last move: the channel waits for a reset
    Seek seek = Seek::kNone;
  };

  bool calibrating() const {
    return axes_[0].seek != Seek::kNone || axes_[1].seek != Seek::kNone;
  }
  void run(Bus& bus, std::uint32_t axis, std::int32_t steps, std::uint32_t code);
  std::int32_t position(Bus& bus, std::uint32_t axis) const;
  void ended(Bus& bus, std::uint32_t axis);
  void seek_on(Bus& bus, std::uint32_t axis);
  void look(Bus& bus, std::uint32_t axis);
  std::int32_t clipped(std::int32_t target);

  StepTableSetup setup_;
  Axis axes_[2];
  bool calibrated_ = false;
  std::uint32_t stopped_ = 0;  // by a switch, since then
  bool error_ = false;  // of the moves since the last WTTBL
  bool settled_ = true;  // no move since
};

}  // namespace trammel::sw
