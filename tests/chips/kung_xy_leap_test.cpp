// SPDX-License-Identifier: Apache-2.0
//
// The chip leaping and not, pin by pin.
#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/chips/kung_bench.hpp"

namespace reg = trammel::kung_xy_regs;
using trammel::test::KungBench;
using trammel::test::number;

TEST_CASE("a leaping chip switches the gates and completes its samples at the same clocks") {
  struct Event {
    std::int64_t clock;
    unsigned hi, lo, sample, irq;
  };
  const auto run = [](bool leap, int& evaluated) {
    KungBench chip;
    chip.codes[0] = {2048 + 60, 2048 - 20};
    chip.codes[1] = {2048 - 90, 2048 + 120};
    chip.write(reg::kX + reg::kPosCmd, 300);
    chip.write(reg::kWatchdog, 12);
    chip.write(reg::kIrqEn, reg::kIrqEnTick);
    for (const std::uint32_t base : {reg::kX, reg::kY}) {
      chip.write(base + reg::kCtrl, reg::kCtrlEnable | reg::kCtrlCurrentLoop |
                                        reg::kCtrlPositionLoop | reg::kCtrlAdapt);
    }
    chip.write(reg::kCommit, reg::kCommitTake);
    const auto seen = [&chip] {
      return Event{chip.now(), chip->gate_hi_o, chip->gate_lo_o, chip->sample_o, chip->irq_o};
    };
    std::vector<Event> events{seen()};
    while (chip.now() < 400000) {  // the watchdog bites on the way
      if (leap) {
        chip.leap_edge();
      } else {
        chip.edge();
      }
      ++evaluated;
      const Event e = seen();
      const Event& last = events.back();
      const bool same = e.hi == last.hi && e.lo == last.lo && e.sample == last.sample &&
                        e.irq == last.irq;
      if (!same) events.push_back(e);
    }
    CHECK(chip.fault_code() == reg::kFaultCodeWatchdog);
    return events;
  };
  int plain_evaluated = 0, leap_evaluated = 0;
  const std::vector<Event> plain = run(false, plain_evaluated);
  const std::vector<Event> leaping = run(true, leap_evaluated);
  CHECK(plain.size() > 1000);
  for (std::size_t n = 0; n < plain.size(); ++n) {
    const auto text = [n](const std::vector<Event>& events) {
      if (n >= events.size()) return std::string("no more");
      const Event& e = events[n];
      return "clock " + std::to_string(e.clock) + ": gate_hi_o " + number(e.hi) + ", gate_lo_o " +
             number(e.lo) + ", sample_o " + number(e.sample) + ", irq_o " + number(e.irq);
    };
    if (text(leaping) == text(plain)) continue;
    CAPTURE(n);
    REQUIRE(text(leaping) == text(plain));
  }
  CHECK(leap_evaluated < plain_evaluated / 4);
}
