// SPDX-License-Identifier: Apache-2.0
//
// The chip of the machine mcafee, and the stage behind its pins.
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "cosim/event_hash.hpp"
#include "machines/mcafee/chip.hpp"
#include "machines/mcafee/machine_members.hpp"
#include "machines/mcafee/session.hpp"
#include "machines/mcafee/twin.hpp"
#include "models/exact/chips/mcafee_xy.hpp"
#include "rtl/chips/generated/mcafee_xy_regs.hpp"
#include "sw_nios/hal/platform_map.hpp"
#include "sw_nios/hal/lm628.hpp"
#include "tests/support/same.hpp"

using namespace trammel;
using namespace trammel::mcafee;
namespace reg = mcafee_xy_regs;
namespace map = sw::platform_map;

namespace {

// Encoders that move by themselves, X forward and Y backward, and switches, whatever drives them.
struct Motion final : cosim::Plant {
  static constexpr cosim::Clk kStep = 1111;  // [clk] a count
  cosim::Clk at = 0;

  // The marker of X is where its count is 0 modulo 64, that of Y 32 counts later.
  static cosim::Lines lines(cosim::Clk count) {
    const auto phase = static_cast<unsigned>(count & 3);
    const cosim::Lines first = phase == 1 || phase == 2, second = phase >= 2;
    return first << mcafee::encoder_a(0) | second << mcafee::encoder_b(0) |
           second << mcafee::encoder_a(1) | first << mcafee::encoder_b(1) |
           cosim::Lines{count % 64 == 0} << mcafee::marker(0) |
           cosim::Lines{count % 64 == 32} << mcafee::marker(1) |
           cosim::Lines{count > 100} << mcafee::limit_high(0) |
           cosim::Lines{count > 150} << mcafee::limit_low(1);
  }
  cosim::Lines sense() const override { return lines(at / kStep); }
  cosim::Clk next() const override { return (at / kStep + 1) * kStep; }
  void commit(cosim::Clk n, cosim::Lines) override { at = n; }
  int sample(int, cosim::Clk) const override { return 0; }
};

struct Events final : cosim::Observer {
  cosim::EventHash hash;
  int samples = 0, drives = 0;
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) override {
    if (stop.why == cosim::kLimit) return;
    hash.mix(stop, chip);
    samples += (stop.why & cosim::kSample) != 0;
    drives += (stop.why & cosim::kDrive) != 0;
  }
};

// A processor with nothing to do between two accesses.
struct Run {
  std::unique_ptr<mcafee::McafeeChip> chip;
  Motion plant;
  Events events;
  cosim::Loop loop;

  static cosim::RunOptions mode(bool leap) {
    cosim::RunOptions run;
    run.leap = leap;
    return run;
  }

  Run(bool leap, cosim::Clk window)
      : chip(mcafee::make_verilated_chip(mode(leap))), loop(*chip, plant, events, window) {}

  cosim::Stop transfer(const cosim::BusOp& op) {
    chip->request(op);
    return loop.advance(cosim::kNever, cosim::kBusDone);
  }
  std::uint32_t read(std::uint32_t address) {
    transfer({address, 0, false});
    return chip->rdata();
  }
  void write(std::uint32_t address, std::uint32_t data) { transfer({address, data, true}); }
  void rest() {
    while ((read(reg::kStatus) & reg::kStatusBusy) != 0) loop.advance(chip->now() + 40, 0);
  }
  void put(std::uint32_t pins, std::uint32_t byte) {
    write(reg::kPortC, byte);
    write(reg::kPortB, pins | reg::kPortBWriteStrobe);
    write(reg::kPortB, pins);
    rest();
    loop.advance(chip->now() + 6000, 0);  // busy, 560 ticks at most
  }
  std::uint32_t get(std::uint32_t pins) {
    write(reg::kPortB, pins | reg::kPortBRead | reg::kPortBReadStrobe);
    write(reg::kPortB, pins | reg::kPortBRead);
    rest();
    return read(reg::kPortC);
  }
  void command(std::uint32_t axis, sw::Lm628Command code, const std::vector<std::uint32_t>& bytes) {
    put(axis, static_cast<std::uint32_t>(code));
    for (const std::uint32_t byte : bytes) put(axis | reg::kPortBPs, byte);
  }

  // Both loops closed with a gain, while the encoders move away.
  void program() {
    loop.advance(70000, 0);
    for (const std::uint32_t axis : {0u, reg::kPortBY}) {
      command(axis, sw::Lm628Command::kLfil, {0, 8, 0, 64});
      command(axis, sw::Lm628Command::kUdf, {});
      command(axis, sw::Lm628Command::kLtrj, {0, 0});
      command(axis, sw::Lm628Command::kStt, {});
    }
    write(map::kTimer, 60000);
    loop.advance(chip->now() + 100000, 0);
  }
};

constexpr cosim::Clk kMs = 50'000;


template <class After>
void go(StagePlant& plant, cosim::Clk end, cosim::Lines drive, After after) {
  while (plant.next() < end) {
    plant.commit(plant.next(), drive);
    after();
  }
  plant.commit(end, drive);
}
void go(StagePlant& plant, cosim::Clk end, cosim::Lines drive) {
  go(plant, end, drive, [] {});
}

}  // namespace

TEST_CASE("mcafee chip has the same events plain and leaping, in every window") {
  Run base(true, cosim::kNever);
  base.program();
  CHECK(base.events.samples >= 7);
  CHECK(base.events.drives >= 10);
  CHECK(base.chip->evaluated() < base.chip->now() / 3);
  for (const cosim::Clk window : {cosim::kNever, cosim::Clk{1}, cosim::Clk{313}}) {
    for (const bool leap : {true, false}) {
      Run other(leap, window);
      other.program();
      CHECK(other.chip->now() == base.chip->now());
      CHECK(other.events.hash.value() == base.events.hash.value());
    }
  }
}

TEST_CASE("mcafee chip drives each axis by its own error and shows its words and switches") {
  Run run(true, cosim::kNever);
  CHECK(run.read(reg::kId) == reg::kIdValue);
  CHECK(mcafee::code(run.chip->drive(), 0) == mcafee::kZeroCode);
  CHECK(mcafee::code(run.chip->drive(), 1) == mcafee::kZeroCode);
  run.program();
  for (const int axis : {0, 1}) {
    const lm628::Words words = run.chip->words(axis);
    CAPTURE(axis, words.error);
    CHECK((axis == 0 ? words.error < 0 : words.error > 0));
    CHECK(words.proportional == 64 * words.error);
    CHECK(words.output == words.proportional);
    CHECK(static_cast<int>(mcafee::code(run.chip->drive(), axis)) == 0x80 + (words.output >> 8));
    CHECK(words.status == (run.get(axis == 0 ? 0 : reg::kPortBY) & 0xFF));
  }
  CHECK(run.read(reg::kLimits) == (reg::kLimitsXHigh | reg::kLimitsYLow));
}

TEST_CASE("mcafee chip tells of which part an interrupt is") {
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    Run run(true, cosim::kNever);
    run.loop.advance(70000, 0);
    CHECK_FALSE((run.chip->host_irq(0) || run.chip->host_irq(1)));
    run.put(axis == 0 ? 0 : reg::kPortBY, 0x77);  // no command: an error
    CHECK(run.chip->host_irq(0) == (axis == 0));
    CHECK(run.chip->host_irq(1) == (axis == 1));
    CHECK(run.read(reg::kIrq) == (axis == 0 ? reg::kIrqX : reg::kIrqY));
  }
}

TEST_CASE("mcafee chip's samples are those of X") {
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    Run run(true, cosim::kNever);
    run.loop.advance(70000, 0);
    run.put(axis == 0 ? 0 : reg::kPortBY, static_cast<std::uint32_t>(sw::Lm628Command::kReset));
    const int before = run.events.samples;
    run.loop.advance(run.chip->now() + 3 * 17067, 0);  // less than the reset routine
    CHECK(run.events.samples - before == (axis == 0 ? 0 : 3));
  }
}

TEST_CASE("mcafee chip brings the marker of each axis to its own part, active low") {
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    Run run(true, cosim::kNever);
    const auto marker = [axis](cosim::Clk at) { return (at / Motion::kStep) % 64 == 32 * axis; };
    run.loop.advance(70000, 0);
    const std::uint32_t pins = axis == 0 ? 0 : reg::kPortBY;
    // From the clock after a marker to the one before the next there is none.
    while (!marker(run.chip->now())) run.loop.advance(run.chip->now() + 100, 0);
    while (marker(run.chip->now())) run.loop.advance(run.chip->now() + 100, 0);
    run.command(pins, sw::Lm628Command::kSip, {});
    run.loop.advance(run.chip->now() + 40 * Motion::kStep, 0);
    CHECK((run.get(pins) & 0x08) == 0);
    run.loop.advance(run.chip->now() + 50 * Motion::kStep, 0);
    CHECK((run.get(pins) & 0x08) == 0x08);
  }
}

TEST_CASE("mcafee chip's timer interrupts once, after its number of clocks, and not when it is 0") {
  Run run(true, cosim::kNever);
  const cosim::Stop written = run.transfer({map::kTimer, 5000, true});
  CHECK(run.read(map::kIrq) == 0);
  CHECK(run.loop.advance(cosim::kNever, cosim::kIrq).edge == written.edge + 5000);
  CHECK(run.chip->irq());
  CHECK_FALSE(run.chip->host_irq(0));
  CHECK(run.read(map::kIrq) == map::kIrqTimer);
  run.write(map::kTimer, 0);
  CHECK(run.read(map::kIrq) == 0);
  CHECK_FALSE(run.chip->irq());
}

// The twin of models/ takes the same accesses at the same edges.
TEST_CASE("mcafee chip reads and drives the same as its twin") {
  Run run(true, cosim::kNever);
  exact::McafeeXy twin;
  exact::McafeeXy::In in;
  for (int i = 0; i < 6; ++i) twin.step(in);
  twin.reset();
  cosim::Clk now = 0;
  const auto follow = [&](cosim::Clk end) {
    for (; now < end; ++now) {
      Pins::sense(in, Motion::lines(now / Motion::kStep));
      twin.step(in);
    }
  };
  for (unsigned n = 0; n < 200; ++n) {
    const cosim::BusOp op{n * 7 % 10 * 4, n * 2654435761u >> 7 & 31, n % 3 != 0};
    if (op.write && op.addr == reg::kReset) continue;
    follow(run.chip->now());
    twin.request(op.addr, op.data, op.write);
    run.transfer(op);
    follow(run.chip->now());
    REQUIRE_FALSE(twin.open());
    const std::string name = test::register_name(reg::kRegisters, op.addr);
    if (!op.write) test::same(name.c_str(), run.chip->rdata(), twin.read_data(), now);
    test::same("dac_x_o", mcafee::code(run.chip->drive(), 0), twin.out().dac_x_o, now);
    test::same("dac_y_o", mcafee::code(run.chip->drive(), 1), twin.out().dac_y_o, now);
    run.loop.advance(run.chip->now() + n * 13 % 700, 0);
  }
}

TEST_CASE("mcafee: converters give nothing before the parts have written to them") {
  for (const auto& chip : {make_twin_chip(), make_verilated_chip({})}) {
    CHECK(chip->drive() == codes(0x80, 0x80));  // before its first clock
    for (const int axis : {0, 1}) CHECK(code(chip->drive(), axis) == kZeroCode);
  }
}

TEST_CASE("mcafee: the line of each marker is high about the place of a turn, and low elsewhere") {
  const plant::LeadscrewConfig config;
  for (const int axis : {0, 1}) {
    StagePlant plant({config, config});
    int markers = 0, others = 0;
    bool was = true;  // it starts at one
    CHECK((plant.sense() >> marker(0) & plant.sense() >> marker(1) & 1) == 1);
    go(plant, 600 * kMs, axis == 0 ? codes(0xA0, 0x80) : codes(0x80, 0xA0), [&] {
      const cosim::Lines lines = plant.sense();
      const bool is = (lines >> marker(axis) & 1) != 0;
      if (is && !was) {
        ++markers;
        const auto& encoder = plant.stage().axis(static_cast<std::size_t>(axis)).sensor().encoder();
        const std::int64_t off = encoder.count() % encoder.counts();
        CHECK((off <= 3 || off >= encoder.counts() - 3));
      }
      was = is;
      others += (lines >> marker(1 - axis) & 1) == 0 ? 1 : 0;
    });
    const double turns = plant.stage().axis(static_cast<std::size_t>(axis)).position(600 * kMs) /
                         config.pitch;
    CAPTURE(axis, turns);
    REQUIRE(turns > 2.2);
    CHECK(markers == static_cast<int>(turns + 0.01));
    CHECK(others == 0);  // the other one stands at its own
  }
}

TEST_CASE("mcafee: an open winding carries no current, that of the other axis does") {
  for (const std::size_t dead : {std::size_t{0}, std::size_t{1}}) {
    const plant::LeadscrewConfig config;
    StagePlant plant({config, config});
    const auto current = [&](std::size_t k, cosim::Clk n) {
      return plant.stage().axis(k).state(n).i;
    };
    go(plant, 1, codes(0xC0, 0xC0));
    plant.open_phase(1, static_cast<int>(dead), 0, true);
    go(plant, 2 * kMs, codes(0xC0, 0xC0));
    CAPTURE(dead);
    CHECK(current(dead, 2 * kMs) == 0);
    CHECK(current(1 - dead, 2 * kMs) > 0.1);
    plant.open_phase(2 * kMs, static_cast<int>(dead), 0, false);
    go(plant, 4 * kMs, codes(0xC0, 0xC0));
    CHECK(current(dead, 4 * kMs) > 0.1);
  }
}

TEST_CASE("mcafee: a supply that is not whole gives both motors that share of the voltage") {
  const plant::LeadscrewConfig config;
  StagePlant plant({config, config});
  const auto volts = [&] {
    return std::array<double, 2>{plant.stage().axis(0).voltage(), plant.stage().axis(1).voltage()};
  };
  const double whole = config.motor.supply;
  go(plant, 1, codes(0xC0, 0x60));  // a half forward, a quarter backward
  CHECK(volts() == std::array<double, 2>{0.5 * whole, -0.25 * whole});
  plant.supply(kMs, 0.5);
  CHECK(volts() == std::array<double, 2>{0.25 * whole, -0.125 * whole});
  go(plant, 2 * kMs, codes(0x40, 0x80));
  CHECK(volts() == std::array<double, 2>{-0.25 * whole, 0});
  plant.supply(3 * kMs, 1);
  CHECK(volts() == std::array<double, 2>{-0.5 * whole, 0});
}

TEST_CASE("mcafee: a count is a quarter of a line, the travel is from switch to switch") {
  Options options;
  options.stage_axis.pitch = 4e-3;
  options.stage_axis.encoder.lines = 250;
  options.stage_axis.switch_low = -0.1;
  options.stage_axis.switch_high = 0.2;
  CHECK(options.count_mm() == Approx(4e-3));
  const TravelMm travel = options.travel_mm();
  CHECK(travel.low == Approx(-100));
  CHECK(travel.high == Approx(200));
}
