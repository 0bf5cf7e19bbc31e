// SPDX-License-Identifier: Apache-2.0
//
// Two chips in lock-step, each a counter that can be made to err.
#include "cosim/verilated/in_step.hpp"

#include <catch2/catch.hpp>

#include "cosim/machine_chip.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel;

namespace {

struct Registers {
  int count = 0;
  int input = 0;
};

struct Faults {
  bool leaps_too_far = false;   // its leaps count one clock more
  bool stops_too_late = false;  // a leaping chip sees its own event a clock later
};
Faults faults;

// Counts, and drives at every 100th clock; waiting is leapt over.
class Counter : public cosim::MachineChip {
 public:
  Counter(cosim::NoTrace, cosim::ModelMode mode) : leap_(mode.leap) {}

  cosim::Clk now() const override { return state_; }
  void sense(cosim::Lines lines) override { registers_.input = static_cast<int>(lines); }
  void request(const cosim::BusOp& op) override { registers_.count = static_cast<int>(op.data); }
  cosim::Stop run(cosim::Clk end, const cosim::Plant&) override {
    const cosim::Clk late = leap_ && faults.stops_too_late ? 1 : 0;
    const cosim::Clk event = state_ / 100 * 100 + 99 + late;
    const cosim::Clk last = std::min(end - 1, event);
    registers_.count += static_cast<int>(last + 1 - state_);
    if (leap_ && faults.leaps_too_far && last + 1 - state_ > 1) ++registers_.count;
    state_ = last + 1;
    ++evaluated_;
    return {last, last == event ? cosim::kDrive : cosim::kLimit};
  }
  cosim::Lines drive() const override { return 0; }
  bool irq() const override { return false; }
  std::uint32_t rdata() const override { return 0; }
  cosim::Clk evaluated() const override { return evaluated_; }

  Registers& registers() { return registers_; }
  cosim::Clk& state() { return state_; }

 private:
  bool leap_;
  Registers registers_;
  cosim::Clk state_ = 0, evaluated_ = 0;
};

struct Visited {
  template <class A, class B, class Visit>
  static void for_each(A& a, B& b, Visit visit) {
    visit("chip.count", a.count, b.count);
    visit("chip.input", a.input, b.input);
  }
};

using Audited = cosim::AuditedChip<Counter, Visited>;

// The failed assertion, if any, after some runs with a transfer and a changed pin between.
std::optional<cosim::BrokenPromise> audited(const Faults& wrong) {
  faults = wrong;
  Audited chip;
  const test::NoPlant plant;
  chip.run(60, plant);
  chip.sense(5);
  chip.run(150, plant);
  chip.request({0, 40, true});
  while (chip.now() < 1000) chip.run(1000, plant);
  faults = {};
  return chip.broken_promise();
}

}  // namespace

TEST_CASE("chips that agree break no assertion, and from outside look like the first one") {
  CHECK_FALSE(audited({}));
  Audited chip;
  CHECK(chip.run(1000, test::NoPlant()).edge == 99);
  CHECK(chip.now() == 100);
  CHECK(chip.evaluated() == 1);
  CHECK(chip.registers().count == 100);
}

TEST_CASE("a leap that counts one clock too many is reported with register, values and clock") {
  const auto broken = audited({true, false});
  REQUIRE(broken);
  CHECK(broken->name == "leap_is_exact");
  CHECK(broken->instance == "chip.count");
  CHECK(broken->place == "60 plain, 61 leapt");
  CHECK(broken->edge == 59);
}

TEST_CASE("a stop that comes at another clock is reported with both clocks and reasons") {
  const auto broken = audited({false, true});
  REQUIRE(broken);
  CHECK(broken->instance == "the stop");
  CHECK(broken->edge == 99);
  CHECK(broken->place == "99 for 2 plain, 100 for 2 leapt");
}
