// SPDX-License-Identifier: Apache-2.0
//
// A processor's RTL in the place of natively compiled firmware. The core runs ahead of the chip by
// itself until it asks for something: a register of the chip, or its interrupt line. Then the chip
// follows to the same clock; in a transfer both stand at the same one. While the core waits for the
// interrupt and stands still, its clocks are not evaluated, and the chip runs to the interrupt by
// itself. So both see what they would see as one model, clock by clock.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

struct CoreTrap {
  Clk edge = 0;               // from which its output is high
  std::uint32_t address = 0;  // of the instruction
};

// One clock each: step(), answer(), interrupt().
struct Core {
  enum class Asks { kNothing, kTransfer, kInterrupt };

  virtual ~Core() = default;
  virtual Clk now() const = 0;                         // next edge
  virtual Asks asks() const = 0;                       // before it
  virtual BusOp transfer() const = 0;                  // with kTransfer
  virtual void step() = 0;                             // without an answer
  virtual void answer(std::uint32_t data) = 0;         // the transfer ends
  virtual void interrupt(bool level) = 0;              // what it sees of the line
  // With kInterrupt and a low line: the edge to which nothing in it changes, now() if something
  // does.
  virtual Clk still() = 0;
  virtual void skip(Clk edge) = 0;                     // to an edge up to that
  virtual std::optional<CoreTrap> trap() const = 0;    // it stands for good
};

// Worst and mean of a number of clocks.
struct Spread {
  long count = 0;
  Clk worst = 0, sum = 0;

  void add(Clk clocks) {
    ++count;
    sum += clocks;
    worst = std::max(worst, clocks);
  }
  double mean() const {
    return count == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(count);
  }
};

// Of service routines, each from the clock in which the core sees the interrupt [clk].
struct CoreTimes {
  Spread first;      // to its first transfer
  Spread routine;    // until it waits again
  Spread transfers;  // of a routine, a number
  Spread answer;     // of a transfer, its clocks on the bus
  Spread between;    // an answer and the next transfer of a routine
};

class CoreRun {
 public:
  // Ends at edge `end`, or as soon as `finished()` holds after a sample. `trapped` is called once.
  CoreRun(Loop& loop, Core& core, Clk end, std::function<bool()> finished,
          std::function<void(const CoreTrap&)> trapped)
      : loop_(loop),
        core_(core),
        end_(end),
        finished_(std::move(finished)),
        trapped_(std::move(trapped)) {}

  void run() {
    while (!over_ && core_.now() < end_) {
      if (const auto trap = core_.trap()) {
        trapped_(*trap);
        follow(end_);
        return;
      }
      switch (core_.asks()) {
        case Core::Asks::kTransfer: transfer(); break;
        case Core::Asks::kInterrupt: wait(); break;
        case Core::Asks::kNothing:
          core_.step();
          // A core that computes for long asks nothing; the run may be over all the same.
          if (core_.now() - loop_.chip().now() > kAhead) follow(core_.now());
      }
    }
    if (!over_) follow(end_);
  }

  const CoreTimes& times() const { return times_; }

 private:
  static constexpr Clk kAhead = 1'000'000;

  // The chip runs to this edge; false: the run is over.
  bool follow(Clk edge) {
    while (!over_ && loop_.chip().now() < edge) advance(edge, 0);
    return !over_;
  }

  Stop advance(Clk end, unsigned until) {
    const Stop stop = loop_.advance(end, until | kSample);
    over_ = (stop.why & kSample) != 0 && finished_();
    return stop;
  }

  void transfer() {
    if (!follow(core_.now())) return;
    const Clk asked = core_.now();
    if (woken_) {
      if (in_routine_ == 0) {
        times_.first.add(asked - *woken_);
      } else {
        times_.between.add(asked - answered_);
      }
      ++in_routine_;
    }
    loop_.chip().request(core_.transfer());
    Stop stop;
    do {
      if (loop_.chip().now() >= end_) {
        over_ = true;
        return;
      }
      stop = advance(end_, kBusDone);
    } while (!over_ && (stop.why & kBusDone) == 0);
    if ((stop.why & kBusDone) == 0) return;
    while (core_.now() < stop.edge) core_.step();
    core_.answer(loop_.chip().rdata());
    answered_ = core_.now();
    if (woken_) times_.answer.add(answered_ - asked);
  }

  void wait() {
    if (!follow(core_.now())) return;
    if (woken_) {
      times_.routine.add(core_.now() - *woken_);
      times_.transfers.add(in_routine_);
      woken_.reset();
    }
    if (loop_.chip().irq()) {
      woken_ = core_.now();
      in_routine_ = 0;
      core_.interrupt(true);
      return;
    }
    const Clk still = core_.still();
    if (still <= core_.now()) {
      core_.interrupt(false);
      return;
    }
    const Stop stop = advance(std::min(still, end_), kIrq);
    core_.skip(stop.edge + 1);
  }

  Loop& loop_;
  Core& core_;
  Clk end_;
  std::function<bool()> finished_;
  std::function<void(const CoreTrap&)> trapped_;
  bool over_ = false;
  std::optional<Clk> woken_;  // the routine that runs began here
  Clk in_routine_ = 0;        // its transfers so far
  Clk answered_ = 0;
  CoreTimes times_;
};

}  // namespace trammel::cosim
