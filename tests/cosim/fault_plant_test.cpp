// SPDX-License-Identifier: Apache-2.0
//
// What a fault on the pins makes of a plant whose lines count up by one at each edge it commits.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <vector>

#include "cosim/fault_plant.hpp"
#include "cosim/fault_watch.hpp"
#include "cosim/machine.hpp"

using namespace trammel::cosim;

namespace {

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

FaultPins pins() {
  FaultPins p;
  p.axes = 2;
  p.encoder[0] = {0, 1, 2};
  p.encoder[1] = {3, 4, 5};
  p.converters = 2;
  p.outputs = 6;
  p.gates = true;
  p.phases = 3;
  return p;
}

// A fault of 1 us from edge 100 to edge 150.
struct Bench {
  explicit Bench(Fault fault) : plant(counter, pins(), timed(fault), kClockPs) {}

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

// Position that a decoder reads from the lines, and how often both jumped at once.
struct Decoded {
  int position = 0, errors = 0;
};
Decoded decode(Bench& bench, Clk end) {
  Decoded d;
  const auto now = [&] {
    const bool a = bench.line(0), b = bench.line(1);
    return b ? (a ? 2 : 3) : (a ? 1 : 0);
  };
  int before = now();
  while (bench.plant.next() <= end) {
    bench.plant.commit(bench.plant.next(), 0);
    const int step = (now() - before) & 3;
    before = now();
    d.position += step == 1 ? 1 : step == 3 ? -1 : 0;
    d.errors += step == 2;
  }
  return d;
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

TEST_CASE("a stuck line holds its level, or has the one asked for") {
  Bench held(of(FaultKind::kEncoderStuck, 1));
  held.to(100);
  const bool level = (10 & 2) != 0;  // of the tenth count, which is at this edge
  CHECK(held.line(1) == level);
  for (Clk n = 110; n < 150; n += 10) {
    held.to(n);
    CHECK(held.line(1) == level);
  }
  Bench low(of(FaultKind::kEncoderStuck, 0, -1)), high(of(FaultKind::kEncoderStuck, 0, 1));
  for (Clk n = 100; n < 150; n += 10) {
    low.to(n);
    high.to(n);
    CHECK_FALSE(low.line(0));
    CHECK(high.line(0));
  }
}

TEST_CASE("missing counts stay lost, without a double transition") {
  Bench bench(of(FaultKind::kEncoderMissing, 0, 2));
  const Decoded d = decode(bench, 300);
  CHECK(bench.counter.count == 30);
  CHECK(d.position == 28);  // two of the five while it lasts
  CHECK(d.errors == 0);
}

TEST_CASE("of counts that go missing one in so many is lost, wherever the fault ends") {
  for (const int value : {0, 1, 2, 3, 4}) {
    const int one_in = value == 0 ? 10 : value;
    for (int counts = 1; counts <= 19; ++counts) {
      Fault fault = of(FaultKind::kEncoderMissing, 0, value);
      fault.begin_s = 2e-6;  // with the tenth count
      fault.for_s = counts * kEvery * 20e-9;
      Counter counter;
      FaultPlant plant(counter, pins(), fault, kClockPs);
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
  FaultPins named = pins();
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

TEST_CASE("swapped lines count down, a lost index is low") {
  Bench bench(of(FaultKind::kEncoderSwapped));
  bench.to(110);
  CHECK(bench.line(0) == ((bench.counter.count & 2) != 0));
  CHECK(bench.line(1) == (((bench.counter.count + 1) & 2) != 0));
  Bench index(of(FaultKind::kIndexLost));
  index.to(80);
  CHECK(index.line(2));
  for (Clk n = 100; n < 150; n += 10) {
    index.to(n);
    CHECK_FALSE(index.line(2));
  }
  index.to(160);
  CHECK(index.line(2));
}

TEST_CASE("a converter repeats, adds, or shifts its frame") {
  Bench stuck(of(FaultKind::kConverterStuck));
  stuck.to(100);
  CHECK(stuck.plant.sample(0, 140) == 100);
  Bench offset(of(FaultKind::kConverterOffset, 0, -120));
  offset.to(100);
  CHECK(offset.plant.sample(0, 140) == 20);
  CHECK(offset.plant.sample(0, 110) == 0);
  Bench late(of(FaultKind::kConverterSlipped)), early(of(FaultKind::kConverterSlipped, 0, -1));
  late.to(100);
  early.to(100);
  CHECK(late.plant.sample(0, 140) == 70);
  CHECK(early.plant.sample(0, 140) == 280);
}

TEST_CASE("a dead gate driver, an open phase and a dip reach the plant") {
  Bench gate(of(FaultKind::kGateDead, 3));
  gate.to(90, 0xFFF);
  CHECK(gate.counter.drive == 0xFFF);
  gate.to(100, 0xFFF);
  CHECK(gate.counter.drive == 0xFF7);
  gate.to(150, 0xFFF);
  CHECK(gate.counter.drive == 0xFFF);
  Bench phase(of(FaultKind::kPhaseOpen, 2));
  phase.to(100);
  CHECK(phase.counter.opened == std::array<int, 3>{0, 2, 1});
  phase.to(150);
  CHECK(phase.counter.opened == std::array<int, 3>{0, 2, 0});
  Bench dip(of(FaultKind::kSupplyDip, 0, 40));
  dip.to(100);
  CHECK(dip.counter.share == 0.4);
  dip.to(150);
  CHECK(dip.counter.share == 1);
}

TEST_CASE("a fault of the second axis is on its own pins") {
  Fault fault = of(FaultKind::kGateDead, 3);
  fault.axis = 1;
  Bench gate(fault);
  gate.to(100, 0xFFF);
  CHECK(gate.counter.drive == 0xDFF);  // bit 3 of its six
  fault.kind = FaultKind::kConverterStuck;
  fault.line = 1;
  Bench stuck(fault);
  stuck.to(100);
  CHECK(stuck.plant.sample(1, 140) == 1140);
  CHECK(stuck.plant.sample(3, 140) == 3100);
  fault.kind = FaultKind::kPhaseOpen;
  Bench phase(fault);
  phase.to(100);
  CHECK(phase.counter.opened == std::array<int, 3>{1, 1, 1});
}

TEST_CASE("a fault that is shorter than a clock lasts one, and one of no length does not end") {
  Fault fault = Bench::timed(of(FaultKind::kPhaseOpen));
  fault.for_s = 1e-12;
  CHECK(FaultSpan(fault, kClockPs).begin == 100);
  CHECK(FaultSpan(fault, kClockPs).end == 101);
  fault.for_s = 0;
  CHECK(FaultSpan(fault, kClockPs).end == kNever);
}

TEST_CASE("a place that the machine has not is refused, with what it has") {
  CHECK_THROWS_WITH(check_fault(of(FaultKind::kConverterStuck, 2), pins()),
                    "inject.line: value 2 is out of range, allowed 0..1");
  CHECK_THROWS_WITH(check_fault(of(FaultKind::kOutputStuck), pins()),
                    "inject.fault: this machine has no such part");
  CHECK_THROWS_WITH(check_fault(of(FaultKind::kSupplyDip, 0, 101), pins()),
                    "inject.value: value 101 is out of range, allowed 0..100");
  CHECK_THROWS_WITH(check_fault(of(FaultKind::kEncoderStuck, 2), pins()),
                    "inject.line: value 2 is out of range, allowed 0..1");
  CHECK_NOTHROW(check_fault(of(FaultKind::kGateDead, 5), pins()));
  CHECK_THROWS_WITH(check_fault(of(FaultKind::kConverterStuck, 0, 4096), pins()),
                    "inject.value: value 4096 is out of range, allowed 0..4095");
  for (const FaultKind kind : {FaultKind::kEncoderMissing, FaultKind::kProcessorSlow,
                               FaultKind::kBusStall}) {
    CHECK_THROWS_WITH(check_fault(of(kind, 0, -3), pins()),
                      "inject.value: value -3 is out of range, allowed 0..65535");
    CHECK_NOTHROW(check_fault(of(kind, 0, 65535), pins()));
  }
}

TEST_CASE("a processor is stopped, slow or waits for its bus while its fault lasts") {
  const auto at = [](FaultKind kind, int value = 0) {
    return ProcessorFault(Bench::timed(of(kind, 0, value)), kClockPs);
  };
  CHECK(at(FaultKind::kProcessorStopped).access(110, 8) == 48);
  CHECK(at(FaultKind::kProcessorStopped).access(150, 8) == 8);
  CHECK(at(FaultKind::kProcessorSlow, 3).work(100, 100) == 300);
  CHECK(at(FaultKind::kBusStall).work(100, 100) == 100);
  CHECK(at(FaultKind::kBusStall, 70).access(100, 8) == 78);
  // The last edge of the fault, and the one after it.
  CHECK(at(FaultKind::kProcessorSlow, 3).work(149, 100) == 300);
  CHECK(at(FaultKind::kProcessorSlow, 3).work(150, 100) == 100);
  CHECK(at(FaultKind::kBusStall, 70).access(149, 8) == 78);
  CHECK(at(FaultKind::kBusStall, 70).access(150, 8) == 8);
  const ProcessorFault garbage = at(FaultKind::kProcessorGarbage);
  CHECK(garbage.written(99, 5) == 5);
  CHECK(garbage.written(100, 5) != 5);
  CHECK(garbage.written(100, 5) == garbage.written(100, 7));
  CHECK(garbage.written(149, 5) != 5);
  CHECK(garbage.written(150, 5) == 5);
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
