// SPDX-License-Identifier: Apache-2.0
//
// Faults on machines of other converters and outputs than the table's, held levels, a trip without
// an injected fault, and the timer beside a chip.
#include <catch2/catch.hpp>
#include <string>

#include "cosim/fault_plant.hpp"
#include "cosim/fault_watch.hpp"
#include "cosim/host_timer.hpp"
#include "cosim/run.hpp"
#include "tests/cosim/fault_pins.hpp"

using namespace trammel::cosim;
using trammel::test::two_axes;

namespace {

constexpr std::int64_t kClockPs = 20'000;

constexpr Clk kBegin = 100, kEnd = 150;

// Lines and codes as they are set by hand.
struct Still final : FalliblePlant {
  Lines sense() const override { return lines; }
  Clk next() const override { return kNever; }
  void commit(Clk, Lines out) override { drive = out; }
  int sample(int, Clk) const override { return code; }
  void open_phase(Clk, int, int, bool) override {}
  void supply(Clk, double) override {}

  Lines lines = 0, drive = 0;
  int code = 0;
};

struct Bench {
  Bench(const Fault& fault, int bits, int outputs, bool gates, Lines lines = 0)
      : plant((still.lines = lines, still), two_axes(gates, outputs, bits), fault, kClockPs) {}

  Still still;
  FaultPlant plant;
};

Fault fault_of(FaultKind kind, int axis, int line, int value) {
  Fault f;
  f.kind = kind;
  f.axis = axis;
  f.line = line;
  f.value = value;
  f.begin_s = 2e-6;
  f.for_s = 1e-6;
  return f;
}

}  // namespace

TEST_CASE("a stuck line holds the level that it had where the fault began, high or low") {
  for (const int axis : {0, 1}) {
    for (const int line : {0, 1}) {
      for (const bool high : {false, true}) {
        const Lines own = Lines{1} << (3 * axis + line);
        Bench b(fault_of(FaultKind::kEncoderStuck, axis, line, 0), 12, 6, true, high ? 0 : own);
        b.still.lines = high ? own : 0;  // since the start it has moved once
        b.plant.commit(kBegin, 0);
        b.still.lines ^= own;
        CAPTURE(axis, line, high);
        CHECK(((b.plant.sense() & own) != 0) == high);
        b.plant.commit(kEnd, 0);
        CHECK(((b.plant.sense() & own) != 0) != high);
      }
    }
  }
}

TEST_CASE("before a fault the lines are those of the plant, wherever its encoder starts") {
  for (const int axis : {0, 1}) {
    for (unsigned levels = 0; levels < 4; ++levels) {
      Bench b(fault_of(FaultKind::kEncoderMissing, axis, 0, 1), 12, 6, true,
              Lines{levels} << 3 * axis);
      CAPTURE(axis, levels);
      CHECK(b.plant.sense() == b.still.lines);
      b.plant.commit(1, 0);
      CHECK(b.plant.sense() == b.still.lines);
    }
  }
}

TEST_CASE("a converter of 14 or 16 bits fails by the same share of its range as one of 12") {
  for (const int bits : {10, 12, 14, 16}) {
    const int unit = bits <= 12 ? 1 : 1 << (bits - 12), top = 4096 * unit - 1;
    const auto faulty = [&](FaultKind kind, int value, int code) {
      Bench b(fault_of(kind, 1, 0, value), bits, 6, true);
      b.still.code = code;
      b.plant.commit(kBegin, 0);
      return b.plant.sample(2, kBegin);
    };
    CAPTURE(bits);
    CHECK(faulty(FaultKind::kConverterStuck, 77, 5) == 77 * unit);
    CHECK(faulty(FaultKind::kConverterStuck, 4095, 5) == 4095 * unit);
    CHECK(faulty(FaultKind::kConverterOffset, 100, 5) == 5 + 100 * unit);
    CHECK(faulty(FaultKind::kConverterOffset, 4000, 1000 * unit) == top);
    CHECK(faulty(FaultKind::kConverterOffset, -100, 5) == 0);
    CHECK(faulty(FaultKind::kConverterSaturated, 0, 5) == top);
    CHECK(faulty(FaultKind::kConverterSlipped, 0, 0x800F) == 0x4007);
    CHECK(faulty(FaultKind::kConverterSlipped, -1, 0x800F) == 0x001E);  // the frame has 16 bits
  }
}

TEST_CASE("outputs of an axis follow those of the axes before it, however many each has") {
  for (const int outputs : {3, 8, 12}) {
    for (const int axis : {0, 1}) {
      const int line = outputs - 1;
      Bench b(fault_of(FaultKind::kOutputStuck, axis, line, 1), 12, outputs, false);
      b.plant.commit(kBegin, 0);
      CAPTURE(outputs, axis);
      CHECK(b.still.drive == Lines{1} << (axis * outputs + line));
    }
  }
}

TEST_CASE("a register flips where the chip's have names, and else it is refused") {
  Fault fault = fault_of(FaultKind::kRegisterFlip, 0, 0, 0);
  fault.bit = "q[0]";
  FaultPins pins = two_axes(true);
  CHECK_THROWS_AS(check_fault(fault, pins), OptionsError);
  pins.registers = true;
  CHECK_NOTHROW(check_fault(fault, pins));
}

TEST_CASE("without an injected fault a trip is watched from where it is noticed") {
  FaultWatch watch({}, kClockPs);
  FaultTruth now{{1, 2}, 9, true};
  const auto on = [&](Clk edge, bool off, const char* by) {
    watch.on({edge, kDrive}, off, [by] { return std::string(by); }, [&] { return now; });
  };
  on(10, false, "");  // nothing is noticed yet: this current and stop are none of the trip's
  CHECK(watch.report().peak_A == 0);
  CHECK_FALSE(watch.report().at_stop);
  now = {{1, 2}, 3, false};
  on(20, true, "a check");
  now.at = {4, 6};
  on(30, true, "");
  CHECK(watch.report().begin == kNever);
  CHECK(watch.report().detected == 20);
  CHECK(watch.report().off == 20);
  CHECK(watch.report().peak_A == 3);
  CHECK_FALSE(watch.report().at_stop);
  CHECK(watch.report().stopping == Approx(5));
}

TEST_CASE("an injected fault counts its current and stops before anything notices it") {
  FaultWatch watch(fault_of(FaultKind::kGateDead, 0, 0, 0), kClockPs);
  watch.on({kBegin, kDrive}, false, [] { return std::string(); },
           [] { return FaultTruth{{0, 0}, 7, true}; });
  CHECK(watch.report().detected == kNever);
  CHECK(watch.report().peak_A == 7);
  CHECK(watch.report().at_stop);
}

TEST_CASE("a timer interrupts once, its clocks behind the write, and a write of 0 ends it") {
  HostTimer timer;
  timer.write(10, 20);
  for (Clk edge = 11; edge < 30; ++edge) {
    CAPTURE(edge);
    CHECK(timer.waiting(edge) == 30 - edge);
    timer.pass(edge);
    CHECK_FALSE(timer.irq());
  }
  timer.pass(30);
  CHECK(timer.irq());
  CHECK(timer.waiting(31) == kNever);
  timer.write(40, 5);  // and takes the interrupt back
  CHECK_FALSE(timer.irq());
  timer.write(42, 0);
  CHECK(timer.waiting(43) == kNever);
  for (const Clk edge : {42, 43, 45}) timer.pass(edge);
  CHECK_FALSE(timer.irq());
}
