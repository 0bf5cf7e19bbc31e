// SPDX-License-Identifier: Apache-2.0
//
// What a fault on the pins makes of a plant whose lines count up by one at each edge it commits.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <vector>

#include "cosim/fault_plant.hpp"
#include "cosim/fault_watch.hpp"
#include "cosim/run.hpp"
#include "tests/cosim/fault_pins.hpp"
#include "tests/cosim/still_chip.hpp"
#include "tests/support/message.hpp"

using namespace trammel::cosim;
using trammel::test::two_axes;

namespace {

constexpr std::int64_t kClockPs = 20'000;

constexpr Clk kEvery = 10;  // clocks of a count

struct Counter final : FalliblePlant {
  Lines sense() const override {
    return ((count + 1) & 2 ? 1u : 0u) | (count & 2 ? 2u : 0u) | (count % 8 == 0 ? 4u : 0u);
  }
  Clk next() const override { return due; }
  void commit(Clk n, Lines lines) override {
    if (n >= due) ++count, due += kEvery;
    drive = lines;
  }
  int sample(int channel, Clk n) const override { return static_cast<int>(1000 * channel + n); }
  void open_phase(Clk, int axis, int phase, bool open) override { opened = {axis, phase, open}; }
  void supply(Clk, double left) override { share = left; }

  int count = 0;
  Clk due = kEvery;
  Lines drive = 0;
  std::array<int, 3> opened{};
  double share = 1;
};

// A fault of 1 us from edge 100 to edge 150.
struct Bench {
  explicit Bench(Fault fault) : plant(counter, two_axes(true), timed(fault), kClockPs) {}

  static Fault timed(Fault fault) {
    fault.begin_s = 2e-6;
    fault.for_s = 1e-6;
    return fault;
  }
  void to(Clk n, Lines drive = 0) {
    while (plant.next() <= n) plant.commit(plant.next(), drive);
  }
  bool line(int n) const { return (plant.sense() >> n & 1) != 0; }

  Counter counter;
  FaultPlant plant;
};

Fault of(FaultKind kind, int line = 0, int value = 0) {
  Fault fault;
  fault.kind = kind;
  fault.line = line;
  fault.value = value;
  return fault;
}

}  // namespace

TEST_CASE("a fault begins and ends at an event of the plant") {
  Bench bench(of(FaultKind::kConverterSaturated));
  bench.to(99);
  CHECK(bench.plant.next() == 100);
  CHECK(bench.plant.sample(0, 99) == 99);
  bench.plant.commit(100, 0);
  CHECK(bench.plant.sample(0, 105) == 4095);
  CHECK(bench.plant.sample(1, 105) == 1105);
  bench.to(150);
  CHECK(bench.plant.sample(0, 155) == 155);
}

TEST_CASE("of counts that go missing one in so many is lost, wherever the fault ends") {
  for (const int value : {0, 1, 2, 3, 4}) {
    const int one_in = value == 0 ? 10 : value;
    for (int counts = 1; counts <= 19; ++counts) {
      Fault fault = of(FaultKind::kEncoderMissing, 0, value);
      fault.begin_s = 2e-6;  // with the tenth count
      fault.for_s = counts * kEvery * 20e-9;
      Counter counter;
      FaultPlant plant(counter, two_axes(true), fault, kClockPs);
      int position = 0, before = -1;
      while (plant.next() <= 300) {
        plant.commit(plant.next(), 0);
        const bool a = (plant.sense() & 1) != 0, b = (plant.sense() & 2) != 0;
        const int now = b ? (a ? 2 : 3) : (a ? 1 : 0);
        const int step = before < 0 ? 1 : (now - before) & 3;
        before = now;
        INFO(fmt::format("one in {} lost, {} counts, edge {}", one_in, counts, counter.due));
        REQUIRE(step < 2);
        position += step;
      }
      CAPTURE(one_in, counts);
      CHECK(counter.count - position == counts / one_in);
    }
  }
}

TEST_CASE("a register flips once, at the edge at which the fault begins") {
  FaultPins named = two_axes(true);
  named.registers = true;
  Fault fault = Bench::timed(of(FaultKind::kRegisterFlip));
  fault.bit = "q[0]";
  Counter counter;
  FaultPlant plant(counter, named, fault, kClockPs);
  Clk at = 0;
  std::vector<Clk> flips;
  plant.flip = [&] { flips.push_back(at); };
  while ((at = plant.next()) <= 300) plant.commit(at, 0);
  CHECK(flips == std::vector<Clk>{100});
}

TEST_CASE("swapped lines are each the other") {
  Bench bench(of(FaultKind::kEncoderSwapped));
  bench.to(110);
  CHECK(bench.line(0) == ((bench.counter.count & 2) != 0));
  CHECK(bench.line(1) == (((bench.counter.count + 1) & 2) != 0));
}

TEST_CASE("a converter that is stuck repeats its frame, and a dip reaches the plant") {
  Bench stuck(of(FaultKind::kConverterStuck));
  stuck.to(100);
  CHECK(stuck.plant.sample(0, 140) == 100);
  Bench dip(of(FaultKind::kSupplyDip, 0, 40));
  dip.to(100);
  CHECK(dip.counter.share == 0.4);
  dip.to(150);
  CHECK(dip.counter.share == 1);
}

// A chip of one bit that can be flipped.
struct OneBit final : trammel::test::StillChip {
  bool flip(const std::string& bit, bool really) override {
    flips += really ? 1 : 0;
    return bit == "q[0]";
  }

  int flips = 0;
};

TEST_CASE("a bit to be flipped must be one of the chip, and is only asked for ahead of the run") {
  OneBit chip;
  require_bit(chip, "q[0]");
  CHECK(chip.flips == 0);
  const std::string said =
      trammel::test::refusal_of<OptionsError>([&chip] { require_bit(chip, "q[1]"); });
  CHECK(said.rfind("inject.bit: \"q[1]\" is no bit of a register of this chip", 0) == 0);
}

TEST_CASE("a fault that is shorter than a clock lasts one, and one of no length does not end") {
  Fault fault = Bench::timed(of(FaultKind::kPhaseOpen));
  fault.for_s = 1e-12;
  CHECK(FaultSpan(fault, kClockPs).begin == 100);
  CHECK(FaultSpan(fault, kClockPs).end == 101);
  fault.for_s = 0;
  CHECK(FaultSpan(fault, kClockPs).end == kNever);
}

TEST_CASE("a fault counts from its first edge, and the way behind it in both axes") {
  FaultWatch watch(Bench::timed(of(FaultKind::kGateDead)), kClockPs);
  FaultTruth now;
  const auto truth = [&now] { return now; };
  const auto by = [] { return std::string("a check"); };
  now.current_A = 9;
  watch.on({99, kDrive}, true, by, truth);
  CHECK(watch.report().detected == kNever);
  CHECK(watch.report().peak_A == 0);
  now = {{1, 2}, 3, false};
  watch.on({100, kDrive}, true, by, truth);
  CHECK(watch.report().detected == 100);
  CHECK(watch.report().off == 100);
  CHECK(watch.report().peak_A == 3);
  now.at = {4, -2};
  watch.on({120, kDrive}, true, by, truth);
  CHECK(watch.report().stopping == Approx(5));
}
