// SPDX-License-Identifier: Apache-2.0
//
// The motor of the machine an693 behind its pins, and the host's port with the times of SNVS781C
// p.4 in clocks of 20 ns.
#include <catch2/catch.hpp>
#include <vector>

#include "machines/an693/session.hpp"
#include "parts/lm628/host_port.hpp"
#include "parts/lm628/surroundings.hpp"

using namespace trammel;
using an693::MotorPlant;
using lm628::HostPins;
using lm628::HostPort;

namespace {

constexpr cosim::Clk kMs = 50'000;

void go(MotorPlant& plant, cosim::Clk end, cosim::Lines drive) {
  while (plant.next() < end) plant.commit(plant.next(), drive);
  plant.commit(end, drive);
}

MotorPlant of(lm628::Variant variant) {
  lm628::PartOptions part;
  part.variant = variant;
  return {plant::MotorAxisConfig(), part};
}

// Pins of a whole transfer, and of the clock after it.
std::vector<HostPins> transfer(HostPort& port, const cosim::BusOp& op, int* taken = nullptr) {
  std::vector<HostPins> all;
  port.request(op);
  do {
    all.push_back(port.pins());
    if (taken != nullptr && port.takes_data()) *taken = static_cast<int>(all.size()) - 1;
  } while (!port.advance());
  all.push_back(port.pins());
  return all;
}

int count(const std::vector<HostPins>& all, bool (*is)(const HostPins&)) {
  int n = 0;
  for (const HostPins& pins : all) n += is(pins) ? 1 : 0;
  return n;
}

bool idle(const HostPins& p) { return p.cs_n && p.rd_n && p.wr_n && p.reset_n; }

}  // namespace

TEST_CASE("an693: an open winding carries no current, and does so again once it is closed") {
  for (const cosim::Lines code : {cosim::Lines{0xC00}, cosim::Lines{0x400}}) {
    const double sense = code > lm628::kZeroCode ? 1 : -1;
    MotorPlant plant = of(lm628::Variant::kLm628);
    go(plant, 1, code);
    go(plant, 5 * kMs, code);
    CAPTURE(code);
    CHECK(sense * plant.axis().state(5 * kMs).i > 0.5);
    plant.open_phase(5 * kMs, 0, 0, true);
    const double speed = plant.axis().state(5 * kMs).omega;
    CHECK(sense * speed > 1);
    go(plant, 10 * kMs, code);
    CHECK(plant.axis().state(10 * kMs).i == 0);
    CHECK(plant.axis().state(10 * kMs).omega == Approx(speed).epsilon(0.01));  // nothing drives it
    plant.open_phase(10 * kMs, 0, 0, false);
    go(plant, 15 * kMs, code);
    CHECK(sense * plant.axis().state(15 * kMs).i > 0.5);
  }
}

TEST_CASE("an693: a supply that is not whole gives its motor that share of the voltage") {
  MotorPlant plant = of(lm628::Variant::kLm628);
  go(plant, 1, 0xC00);  // half of 24 V
  CHECK(plant.voltage(1) == 12);
  plant.supply(kMs, 0.25);
  CHECK(plant.voltage(kMs) == 3);
  go(plant, 2 * kMs, 0x400);
  CHECK(plant.voltage(2 * kMs) == -3);
  plant.supply(3 * kMs, 1);
  CHECK(plant.voltage(3 * kMs) == -12);
}

TEST_CASE("an693: the voltage of pulses is the mean since it was asked for, through dips and all") {
  constexpr cosim::Lines kForward = 1 << lm628::kMagnitude;
  constexpr cosim::Lines kBackward = kForward | 1 << lm628::kSign;
  MotorPlant plant = of(lm628::Variant::kLm629);
  plant.commit(0, kForward);
  CHECK(plant.voltage(0) == 24);  // of no time: as it is
  plant.supply(1000, 0.5);
  CHECK(plant.voltage(2000) == Approx((24.0 + 12) / 2));
  CHECK(plant.voltage(3000) == Approx(12));
  plant.commit(3250, 0);
  CHECK(plant.voltage(4000) == Approx(12.0 / 4));
  plant.supply(4000, 1);
  plant.commit(4500, kBackward);
  CHECK(plant.voltage(5000) == Approx(-24.0 / 2));
  plant.commit(5600, cosim::Lines{1} << lm628::kSign);
  CHECK(plant.voltage(6000) == Approx(-24 * 0.6));
}

TEST_CASE("lm628 port writes with 100 ns of WR, data 50 ns before its end and 120 ns after it") {
  HostPort port;
  const auto all = transfer(port, {sw::lm628_map::kData, 0xA5, true});
  CHECK(count(all, [](const HostPins& p) { return !p.wr_n; }) * 20 >= 100);
  int after = 0;
  bool low = false;
  for (const HostPins& p : all) {
    low = low || !p.wr_n;
    if (!p.wr_n) CHECK((p.d == 0xA5 && p.ps && !p.cs_n && p.rd_n));
    if (low && p.wr_n && p.d == 0xA5) ++after;
  }
  CHECK(after * 20 >= 120);
  CHECK(all.front().wr_n);
  CHECK(idle(all.back()));
}

TEST_CASE("lm628 port takes data 180 ns after RD falls and leaves the bus idle for 180 ns more") {
  HostPort port;
  int taken = -1;
  const auto all = transfer(port, {sw::lm628_map::kCommand, 0, false}, &taken);
  CHECK(count(all, [](const HostPins& p) { return !p.rd_n; }) * 20 >= 180);
  const auto at = static_cast<std::size_t>(taken);
  CHECK_FALSE(all[at].rd_n);
  CHECK(all[at + 1].rd_n);
  CHECK_FALSE(all[at].ps);
  CHECK((static_cast<int>(all.size()) - 2 - taken) * 20 >= 180);
  CHECK(idle(all.back()));
}

TEST_CASE("lm628 port strobes RST for 8 clocks of a part of 6 MHz") {
  HostPort port;
  const auto all = transfer(port, {sw::lm628_map::kReset, 1, true});
  CHECK(count(all, [](const HostPins& p) { return !p.reset_n; }) * 20 >= 8 * 1000 / 6);
  CHECK(idle(all.back()));
  CHECK(count(transfer(port, {sw::lm628_map::kIrq, 0, false}), idle) == 2);
}

TEST_CASE("lm628 surroundings take each half of the converter's word as WR rises, no other byte") {
  lm628::Surroundings surroundings;
  CHECK(surroundings.lines == lm628::kZeroCode);
  CHECK_FALSE(surroundings.output({0x15 << 2, false, false}));
  CHECK_FALSE(surroundings.output({0x15 << 2, false, true}));  // WR rises: the low half
  CHECK_FALSE(surroundings.output({0x3F << 2, false, true}));  // no strobe
  CHECK_FALSE(surroundings.output({0x2A << 2, true, false}));
  CHECK(surroundings.output({0x2A << 2, true, true}));  // the high half: the word is complete
  CHECK(surroundings.lines == (0x2A << 6 | 0x15));
  CHECK_FALSE(surroundings.output({0x01 << 2, true, true}));  // no strobe
}

TEST_CASE("a converter of 8 bits has the byte at once, and zero while the part puts out low bits") {
  lm628::PartOptions part;
  part.dac_bits = 8;
  lm628::Surroundings surroundings(part);
  CHECK(surroundings.lines == lm628::kZeroCode);
  CHECK_FALSE(surroundings.output({0x00, false, false}));  // of 800h, as the part leaves its reset
  CHECK(surroundings.output({0x81, true, true}));
  CHECK(lm628::share_of_code(surroundings.lines) == 1.0 / 128);
  CHECK(surroundings.output({0x00, true, true}));
  CHECK(lm628::share_of_code(surroundings.lines) == -1);
}

TEST_CASE("an LM629 drives its bridge by sign and magnitude, whatever is on the converter's pins") {
  lm628::PartOptions part;
  part.variant = lm628::Variant::kLm629;
  lm628::Surroundings surroundings(part);
  CHECK(surroundings.lines == 0);
  CHECK_FALSE(surroundings.output({0xFF, true, true, false, false}));
  CHECK(surroundings.output({0x80, true, true, true, false}));
  CHECK(lm628::share_of_pulse(surroundings.lines) == 1);
  CHECK(surroundings.output({0x80, true, true, true, true}));
  CHECK(lm628::share_of_pulse(surroundings.lines) == -1);
  CHECK(surroundings.output({0x80, true, true, false, true}));
  CHECK(lm628::share_of_pulse(surroundings.lines) == 0);
}

TEST_CASE("what is none of the permitted clocks and converters is refused by one line") {
  using Catch::Contains;
  CHECK_NOTHROW(lm628::check_clock(6));
  CHECK_THROWS_WITH(lm628::check_clock(7), "chip.clock_MHz: value 7 is neither 6 nor 8");
  lm628::PartOptions part;
  CHECK_NOTHROW(lm628::check_part(part));
  CHECK(lm628::part_warning(part).empty());
  part.dac_bits = 10;
  CHECK_THROWS_WITH(lm628::check_part(part), "chip.dac_bits: value 10 is neither 8 nor 12");
  part.dac_bits = 8;
  for (const int clock_MHz : {0, 5, 7, 9, -6}) {
    part.clock_MHz = clock_MHz;
    CHECK_THROWS_WITH(lm628::check_part(part), Contains("chip.clock_MHz: value " +
                                                        std::to_string(clock_MHz) + " is neither"));
  }
  part.clock_MHz = 8;
  CHECK(lm628::part_warning(part).empty());
  part.variant = lm628::Variant::kLm629;
  CHECK_THAT(lm628::part_warning(part), Contains("chip.dac_bits = 8 has no effect"));
}
