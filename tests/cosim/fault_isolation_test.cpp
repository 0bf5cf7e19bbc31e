// SPDX-License-Identifier: Apache-2.0
//
// Each kind of fault in each axis, line and sense: it changes its own pin as it says, and no other.
#include <catch2/catch.hpp>
#include <string>

#include "cosim/fault_plant.hpp"
#include "cosim/fault_watch.hpp"
#include "cosim/run.hpp"
#include "tests/cosim/fault_pins.hpp"

using namespace trammel::cosim;
using trammel::test::two_axes;

namespace {

constexpr std::int64_t kClockPs = 20'000;

constexpr Clk kBegin = 100, kEnd = 150;
constexpr int kCodes[] = {1001, 2002, 3003, 4004};

// X counts up, Y down, both at each tenth clock; converters have a code of their own.
struct Pair final : FalliblePlant {
  static Lines lines(int count) {
    return ((count + 1) & 2 ? 1u : 0u) | (count & 2 ? 2u : 0u) | 4u;
  }
  Lines sense() const override { return lines(count) | lines(-count) << 3; }
  Clk next() const override { return due; }
  void commit(Clk n, Lines lines) override {
    if (n >= due) ++count, due += 10;
    drive = lines;
  }
  int sample(int channel, Clk) const override { return kCodes[channel]; }
  void open_phase(Clk, int axis, int phase, bool open) override {
    opened += (open ? "open " : "close ") + std::to_string(axis) + std::to_string(phase) + ' ';
  }
  void supply(Clk, double left) override { share = left; }

  int count = 0;
  Clk due = 10;
  Lines drive = 0;
  std::string opened;
  double share = 1;
};

// With a trip pin too.
FaultPins pins(bool gates) {
  FaultPins p = two_axes(gates);
  p.places[1].last = FaultKind::kTripPin;
  p.trip = 6;
  return p;
}

struct Bench {
  explicit Bench(const Fault& fault, bool gates = true)
      : plant(pair, pins(gates), fault, kClockPs) {}
  void to(Clk n, Lines drive = 0) {
    while (plant.next() <= n) plant.commit(plant.next(), drive);
  }
  Pair pair;
  FaultPlant plant;
};

Fault fault_of(FaultKind kind, int axis, int line = 0, int value = 0) {
  Fault f;
  f.kind = kind;
  f.axis = axis;
  f.line = line;
  f.value = value;
  f.begin_s = 2e-6;
  f.for_s = 1e-6;
  return f;
}

// Lines that were not those of the plant at some edge before, while, and after the fault.
struct Changed {
  Lines before = 0, during = 0, after = 0;
};
Changed changed(const Fault& fault, Clk end = 300) {
  Bench bench(fault);
  Changed c;
  while (bench.plant.next() <= end) {
    const Clk n = bench.plant.next();
    bench.plant.commit(n, 0);
    (n < kBegin ? c.before : n < kEnd ? c.during : c.after) |=
        bench.plant.sense() ^ bench.pair.sense();
  }
  return c;
}

}  // namespace

TEST_CASE("a fault of an encoder changes the lines of its own axis, and no others") {
  for (const int axis : {0, 1}) {
    const auto check = [&](const char* what, const Fault& f, Lines own) {
      CAPTURE(what, axis, f.line, f.value);
      const Changed c = changed(f);
      CHECK(c.before == 0);
      CHECK(c.during == own << 3 * axis);
      CHECK(c.after == 0);
    };
    for (const int line : {0, 1}) {
      for (const int value : {-1, 0, 1}) {
        check("encoder_stuck", fault_of(FaultKind::kEncoderStuck, axis, line, value), 1u << line);
      }
    }
    check("encoder_swapped", fault_of(FaultKind::kEncoderSwapped, axis), 3);
    check("index_lost", fault_of(FaultKind::kIndexLost, axis), 4);
    check("encoder_jump", fault_of(FaultKind::kEncoderJump, axis), 3);
    CHECK(changed(fault_of(FaultKind::kTripPin, axis)).during == Lines{1} << 6);
  }
}

TEST_CASE("counts that go missing are those of the axis, in both directions, one in so many") {
  for (const int axis : {0, 1}) {
    for (const int value : {1, 2, 5}) {
      CAPTURE(axis, value);
      Bench bench(fault_of(FaultKind::kEncoderMissing, axis, 0, value));
      bench.to(300);
      const int lost = 5 / value;  // of five counts while it lasts
      const Lines x = Pair::lines(30 - (axis == 0 ? lost : 0));
      const Lines y = Pair::lines(-30 + (axis == 1 ? lost : 0));
      CHECK((bench.plant.sense() & 3u) == (x & 3u));
      CHECK((bench.plant.sense() >> 3 & 3u) == (y & 3u));
    }
  }
  Bench every(fault_of(FaultKind::kEncoderMissing, 0));  // by default one in ten
  every.to(300);
  CHECK((every.plant.sense() & 3u) == (Pair::lines(30) & 3u));
}

TEST_CASE("a fault of a converter changes its own channel as it says, and no other") {
  struct Case {
    FaultKind kind;
    int value, of_1001, of_2002, of_3003, of_4004;
  };
  const Case cases[] = {
      {FaultKind::kConverterStuck, 0, 1001, 2002, 3003, 4004},
      {FaultKind::kConverterStuck, 77, 77, 77, 77, 77},
      {FaultKind::kConverterOffset, 100, 1101, 2102, 3103, 4095},
      {FaultKind::kConverterOffset, -1500, 0, 502, 1503, 2504},
      {FaultKind::kConverterSaturated, 0, 4095, 4095, 4095, 4095},
      {FaultKind::kConverterSaturated, 1, 4095, 4095, 4095, 4095},
      {FaultKind::kConverterSaturated, -1, 0, 0, 0, 0},
      {FaultKind::kConverterSlipped, 0, 500, 1001, 1501, 2002},
      {FaultKind::kConverterSlipped, -1, 2002, 4004, 6006, 8008}};
  for (const Case& one : cases) {
    const int wanted[] = {one.of_1001, one.of_2002, one.of_3003, one.of_4004};
    for (const int axis : {0, 1}) {
      for (const int line : {0, 1}) {
        Bench bench(fault_of(one.kind, axis, line, one.value));
        for (const Clk n : {Clk{90}, kBegin, kEnd}) {
          bench.to(n);
          for (int channel = 0; channel < 4; ++channel) {
            CAPTURE(static_cast<int>(one.kind), one.value, axis, line, n, channel);
            const bool own = n == kBegin && channel == 2 * axis + line;
            CHECK(bench.plant.sample(channel, n) == (own ? wanted[channel] : kCodes[channel]));
          }
        }
      }
    }
  }
}

TEST_CASE("a fault of an output changes its own pin while it lasts, and no other") {
  for (const int axis : {0, 1}) {
    for (int line = 0; line < 6; ++line) {
      const Lines own = Lines{1} << (6 * axis + line);
      const auto check = [&](FaultKind kind, int value, Lines drive, Lines wanted) {
        CAPTURE(static_cast<int>(kind), axis, line, value);
        Bench bench(fault_of(kind, axis, line, value), kind == FaultKind::kGateDead);
        bench.to(kBegin - 1, drive);
        CHECK(bench.pair.drive == drive);
        bench.to(kBegin, drive);
        CHECK(bench.pair.drive == wanted);
        bench.to(kEnd, drive);
        CHECK(bench.pair.drive == drive);
      };
      check(FaultKind::kGateDead, 0, 0xFFF, 0xFFF & ~own);
      check(FaultKind::kOutputStuck, 0, 0xFFF, 0xFFF & ~own);
      check(FaultKind::kOutputStuck, -1, 0xFFF, 0xFFF & ~own);
      check(FaultKind::kOutputStuck, 1, 0, own);
    }
    for (const int phase : {0, 1, 2}) {
      CAPTURE(axis, phase);
      Bench bench(fault_of(FaultKind::kPhaseOpen, axis, phase));
      bench.to(300);
      const std::string at = std::to_string(axis) + std::to_string(phase) + ' ';
      CHECK(bench.pair.opened == "open " + at + "close " + at);
    }
  }
}

TEST_CASE("a place is refused one beyond its last, with its key and range, and the last is taken") {
  struct Case {
    FaultKind kind;
    const char* key;
    int most;
    bool gates;
  };
  using K = FaultKind;
  for (const Case& one :
       {Case{K::kEncoderStuck, "inject.axis", 1, true}, {K::kEncoderStuck, "inject.line", 1, true},
        {K::kConverterStuck, "inject.line", 1, true}, {K::kConverterOffset, "inject.line", 1, true},
        {K::kConverterSaturated, "inject.line", 1, true},
        {K::kConverterSlipped, "inject.line", 1, true}, {K::kGateDead, "inject.line", 5, true},
        {K::kOutputStuck, "inject.line", 5, false}, {K::kPhaseOpen, "inject.line", 2, true},
        {K::kSupplyDip, "inject.value", 100, true},
        {K::kConverterStuck, "inject.value", 4095, true},
        {K::kEncoderMissing, "inject.value", 65535, true},
        {K::kProcessorSlow, "inject.value", 65535, true},
        {K::kBusStall, "inject.value", 65535, true}}) {
    for (const int value : {-1, 0, one.most, one.most + 1}) {
      const std::string key = one.key;
      CAPTURE(static_cast<int>(one.kind), key, value);
      Fault f = fault_of(one.kind, 0);
      (key == "inject.axis" ? f.axis : key == "inject.line" ? f.line : f.value) = value;
      if (value >= 0 && value <= one.most) {
        CHECK_NOTHROW(check_fault(f, pins(one.gates)));
      } else {
        CHECK_THROWS_WITH(check_fault(f, pins(one.gates)),
                          key + ": value " + std::to_string(value) +
                              " is out of range, allowed 0.." + std::to_string(one.most));
      }
    }
  }
  CHECK_THROWS_WITH(check_fault(fault_of(K::kGateDead, 0), pins(false)),
                    "inject.fault: this machine has no gate_dead; it has: encoder_stuck, "
                    "encoder_missing, encoder_swapped, index_lost, encoder_jump, trip_pin, "
                    "converter_stuck, converter_offset, converter_saturated, "
                    "converter_slipped, output_stuck, phase_open, supply_dip, "
                    "processor_stopped, processor_slow, processor_garbage, bus_stall, "
                    "register_flip");
}

TEST_CASE("a fault of the processor has its own time and amount, at its first and last edge") {
  const auto at = [](FaultKind kind, int value) {
    return ProcessorFault(fault_of(kind, 0, 0, value), kClockPs);
  };
  Fault endless = fault_of(FaultKind::kProcessorStopped, 0, 0, 0);
  endless.for_s = 0;
  const Clk stopped = ProcessorFault(endless, kClockPs).work(120, 100);
  CHECK(stopped > clocks_of(3600, kClockPs));
  CHECK(stopped < kNever / 2);  // further times can be added
  const ProcessorFault garbage = at(FaultKind::kProcessorGarbage, 0);
  CHECK(garbage.written(kBegin, 5) == garbage.written(kBegin, 7));  // of the time, not of the word
  struct Case {
    const char* name;
    FaultKind kind;
    int value;
    Clk work, access;  // of 100 and of 8 clocks at edge 120
  };
  using K = FaultKind;
  for (const Case& one : {Case{"stopped", K::kProcessorStopped, 0, 130, 38},
                          {"slow", K::kProcessorSlow, 0, 1000, 80},
                          {"slow", K::kProcessorSlow, 7, 700, 56},
                          {"bus stall", K::kBusStall, 0, 100, 1008},
                          {"bus stall", K::kBusStall, 7, 100, 15},
                          {"garbage", K::kProcessorGarbage, 0, 100, 8}}) {
    CAPTURE(one.name, one.value);
    const ProcessorFault fault = at(one.kind, one.value);
    CHECK(fault.work(120, 100) == one.work);
    CHECK(fault.access(120, 8) == one.access);
    CHECK((fault.written(120, 5) != 5) == (one.kind == K::kProcessorGarbage));
    for (const Clk outside : {kBegin - 1, kEnd}) {
      CHECK(fault.work(outside, 100) == 100);
      CHECK(fault.access(outside, 8) == 8);
      CHECK(fault.written(outside, 5) == 5);
    }
  }
}

TEST_CASE("the way to rest is that of each axis, the peak that of the current, from the fault on") {
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    for (const double way : {3.0, -3.0}) {
      CAPTURE(axis, way);
      FaultWatch watch(fault_of(FaultKind::kGateDead, 0), kClockPs, "step");
      FaultTruth now{{10, 20}, 5, false};
      const auto on = [&](Clk edge, bool off, const char* by) {
        watch.on({edge, kDrive}, off, [by] { return std::string(by); }, [&] { return now; });
      };
      on(100, true, "");  // off before it is noticed: it stands by itself
      CHECK(watch.report().detected == kNever);
      CHECK(watch.report().off == kNever);
      on(110, false, "a check");
      CHECK(watch.report().off == kNever);
      now.at[axis] += 100;
      on(120, true, "another");
      now.at[axis] += way;
      now.current_A = 2;
      now.at_stop = axis == 1;
      on(130, true, "another");
      now.at_stop = false;
      on(140, true, "another");
      CHECK(watch.report().by == "a check");
      CHECK(watch.report().detected == 110);
      CHECK(watch.report().off == 120);
      CHECK(watch.report().stopping == Approx(3));
      CHECK(watch.report().peak_A == 5);
      CHECK(watch.report().at_stop == (axis == 1));
      CHECK(watch.report().unit == "step");
    }
  }
}

TEST_CASE("a machine has one axis or any number of them, and a fault and its way are of each") {
  for (const int axes : {1, 3, 6}) {
    FaultPins some;
    some.places = {{FaultKind::kOutputStuck, FaultKind::kOutputStuck, 2, ""}};
    for (int k = 0; axes > 1 && k < axes; ++k) some.axes.push_back(std::to_string(k));
    for (int axis = 0; axis < axes; ++axis) {
      CAPTURE(axes, axis);
      Pair pair;
      FaultPlant plant(pair, some, fault_of(FaultKind::kOutputStuck, axis, 1, 1), kClockPs);
      plant.commit(kBegin, 0);
      CHECK(pair.drive == Lines{2} << 2 * axis);
      FaultWatch watch(fault_of(FaultKind::kOutputStuck, axis), kClockPs);
      FaultTruth now;
      now.at.resize(static_cast<std::size_t>(axes));
      const auto on = [&](Clk edge) {
        watch.on({edge, kDrive}, true, [] { return std::string("a check"); }, [&] { return now; });
      };
      on(kBegin);
      now.at[static_cast<std::size_t>(axis)] = -3;
      on(kEnd);
      CHECK(watch.report().stopping == 3);
    }
    CHECK_THROWS_WITH(check_fault(fault_of(FaultKind::kOutputStuck, axes), some),
                      "inject.axis: value " + std::to_string(axes) +
                          " is out of range, allowed 0.." + std::to_string(axes - 1));
  }
}

TEST_CASE("a converter's place is one of those that the machine has, whatever its axes are") {
  for (const int converters : {1, 4}) {
    FaultPins some = pins(true);
    some.places = {{FaultKind::kConverterStuck, FaultKind::kConverterSlipped, converters, ""}};
    CAPTURE(converters);
    CHECK_NOTHROW(check_fault(fault_of(FaultKind::kConverterStuck, 0, converters - 1), some));
    CHECK_THROWS_WITH(check_fault(fault_of(FaultKind::kConverterStuck, 0, converters), some),
                      "inject.line: value " + std::to_string(converters) +
                          " is out of range, allowed 0.." + std::to_string(converters - 1));
  }
}
