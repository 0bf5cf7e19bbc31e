// SPDX-License-Identifier: Apache-2.0
//
// The words of an interface that moves at once, and the program of a script on it.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <utility>
#include <vector>

#include "sw_nios/apps/larson/larson.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::test {

namespace map = sw::larson_map;
using namespace sw;

// Two axes between switches, a step at a time when told to; and the platform's timer.
struct FakeTable final : Bus {
  struct Axis {
    std::uint32_t count = map::kTerminal, status = 0;
    bool latch = false, done = false;
    int at = 5, low = -10, high = 6000;
    bool closed_always = false;  // the lower one
    bool closed() const { return closed_always || at <= low || at >= high; }
  };
  Axis axes[2];
  std::uint32_t timer = 0;
  bool timer_irq = false;
  std::vector<std::uint32_t> starts;  // status words that said start
  std::vector<std::uint32_t> timers;  // what was written to the timer
  std::vector<std::uint32_t> bytes;   // addresses and data of byte writes

  std::uint32_t read(std::uint32_t address) override {
    if (address == map::kIrq) {
      return (vector() != 0 ? map::kIrqChip : 0) | (timer_irq ? map::kIrqTimer : 0);
    }
    if (address == map::kVector) {
      const std::uint32_t taken = vector();
      if (taken != 0) axes[taken == map::kVectorX ? 0 : 1].done = false;
      return taken;
    }
    const Axis& a = axes[address / 8];
    return address % 8 == 0 ? a.count : a.status | (a.closed() ? map::kLimit : 0);
  }

  void write(std::uint32_t address, std::uint32_t data) override {
    if (address == map::kTimer) {
      timer = data;
      timers.push_back(data);
      timer_irq = false;
      return;
    }
    if (address >= map::kBytes) {
      bytes.insert(bytes.end(), {address, data});
      return;
    }
    Axis& a = axes[address / 8];
    if (address % 8 == 0) {
      a.count = data;
      return;
    }
    if ((data & map::kReset) != 0) a.latch = a.done = false;
    a.status = data & ~map::kLimit & (a.latch ? ~map::kBusy : ~0u);
    if ((a.status & map::kBusy) != 0) {
      starts.push_back(data);
      a.done = false;
    }
  }

  std::uint32_t vector() const {
    const auto asks = [](const Axis& a) { return a.done && (a.status & map::kEnable) != 0; };
    return asks(axes[0]) ? map::kVectorX : asks(axes[1]) ? map::kVectorY : 0;
  }
  bool irq() const { return vector() != 0 || timer_irq; }

  void step() {
    for (Axis& a : axes) {
      if ((a.status & map::kBusy) == 0) continue;
      const bool forward = (a.status & map::kForward) != 0;
      if (forward ? a.at >= a.high : a.closed_always || a.at <= a.low) {
        a.latch = true;
      } else if (a.count != map::kTerminal) {
        a.at += forward ? 1 : -1;
        ++a.count;
      }
      if (a.latch || a.count == map::kTerminal) {
        a.status &= ~map::kBusy;
        a.done = true;
      }
    }
    if (timer != 0) {
      timer = 0;
      timer_irq = true;
    }
  }
};

struct Program {
  std::vector<LarsonCall> calls;
  std::vector<LarsonAnswer> answers;
  FakeTable bus;
  LarsonApp app;

  explicit Program(std::vector<LarsonCall> all, const StepTableSetup& setup = {})
      : calls(std::move(all)),
        answers(calls.size()),
        app(setup, calls.data(), answers.data(), static_cast<std::uint32_t>(calls.size())) {}

  void run(int steps = 200'000) {
    app.start(bus);
    while (app.mailbox().done == 0 && steps-- > 0) {
      if (bus.irq()) app.isr(bus);
      if (app.mailbox().done == 0) bus.step();
    }
  }

  // From the start, until so many calls have ended.
  void run_to(std::uint32_t ended) {
    app.start(bus);
    for (int n = 0; app.mailbox().point < ended; ++n) {
      REQUIRE(n < 200'000);
      if (bus.irq()) app.isr(bus);
      if (app.mailbox().point < ended) bus.step();
    }
  }
};

inline constexpr LarsonCall kCal{LarsonOp::kCaltbl, 0, 0}, kWait{LarsonOp::kWttbl, 0, 0},
    kWhere{LarsonOp::kWhrtbl, 0, 0};

}  // namespace trammel::test
