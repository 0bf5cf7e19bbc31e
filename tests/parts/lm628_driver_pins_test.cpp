// SPDX-License-Identifier: Apache-2.0
//
// The C driver of the LM628 at the pins of the part, the RTL beside its twin.

#include "parts/lm628/driver/lm628_gpio.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "parts/lm628/driver/example.h"
#include "tests/chips/lm628_pair.hpp"

using namespace trammel;
using Bench = test::Lm628Bench<test::Lm628Pair>;

namespace {

// Pins of a board, which the host sets, samples and waits between.
struct Pins {
  Bench bench;
  lm628_gpio gpio{};
  lm628_port port{};
  lm628_device part{};
  bool driven = false;    // the bus, by the host
  bool selected = true;   // CS is wired

  explicit Pins(bool has_reset = true) {
    gpio.set_lines = [](void* self, std::uint8_t levels) {
      auto& in = at(self).bench.chip.in;
      in.host.cs_n = (levels & LM628_GPIO_CS) != 0 || !at(self).selected;
      in.host.rd_n = (levels & LM628_GPIO_RD) != 0;
      in.host.wr_n = (levels & LM628_GPIO_WR) != 0;
      in.host.ps = (levels & LM628_GPIO_PS) != 0;
      in.reset_n = (levels & LM628_GPIO_RST) != 0;
    };
    gpio.drive_bus = [](void* self, std::uint8_t byte) {
      at(self).bench.chip.in.host.d = byte;
      at(self).driven = true;
    };
    gpio.release_bus = [](void* self) { at(self).driven = false; };
    gpio.read_bus = [](void* self) {
      const exact::Lm628::Out out = at(self).bench.out();
      return out.d_oe ? out.d : std::uint8_t{0xFF};
    };
    gpio.wait_ns = [](void* self, std::uint32_t ns) { at(self).wait(ns); };
    gpio.has_reset = has_reset;
    gpio.context = this;
    REQUIRE(lm628_gpio_port(&port, &gpio) == LM628_OK);
    REQUIRE(lm628_init(&part, &port) == LM628_OK);
  }
  Pins(const Pins&) = delete;
  Pins& operator=(const Pins&) = delete;

 private:
  static Pins& at(void* self) { return *static_cast<Pins*>(self); }

  void wait(std::uint32_t ns) {
    const std::int64_t before = bench.samples();
    bench.clocks((ns + 19) / 20);
    REQUIRE_FALSE((driven && bench.out().d_oe));
    if (bench.follows && bench.samples() != before) {
      bench.move_to(bench.engine().desired().position >> 16);
    }
  }
};

}  // namespace

TEST_CASE("lm628 driver by pins: the example's move, on the RTL beside its twin") {
  for (const bool has_reset : {true, false}) {
    Pins pins(has_reset);
    pins.bench.clocks(51000);  // the reset routine after power-up
    pins.bench.follows = true;
    std::int32_t reached = 0;
    const lm628_error error = lm628_example_move(&pins.port, 120, &reached);
    CHECK(std::string(lm628_error_text(error)) == "done");
    CHECK(reached >= 119);
    CHECK(reached <= 120);
    CHECK_FALSE(pins.bench.engine().signals().eight_bits);
    CHECK(pins.bench.engine().filter().kd == 1000);
    CHECK(pins.bench.engine().filter().kp == 50);
  }
}

TEST_CASE("lm628 driver by pins: breakpoint, index, home, masks and what the part reports") {
  Pins pins;
  lm628_device* part = &pins.part;
  std::int32_t l = 0;
  std::int16_t s = 0;
  std::uint16_t u = 0;
  std::uint8_t status = 0;
  pins.bench.follows = true;
  REQUIRE(lm628_reset(part, LM628_OUTPUT_8_BITS) == LM628_OK);
  REQUIRE(lm628_mask_interrupts(part, LM628_BREAKPOINT | LM628_INDEX) == LM628_OK);
  REQUIRE(lm628_set_breakpoint(part, 30) == LM628_OK);
  REQUIRE(lm628_capture_index(part) == LM628_OK);
  REQUIRE(lm628_read_signals(part, &u) == LM628_OK);
  CHECK(u == (LM628_EIGHT_BITS | LM628_MOTOR_OFF | LM628_ACQUIRE_INDEX));
  pins.bench.set_index(40);
  const lm628_trajectory forward{LM628_VELOCITY_MODE | LM628_FORWARD | LM628_LOAD_VELOCITY |
                                     LM628_LOAD_ACCELERATION,
                                 32768, 65536, 0};
  REQUIRE(lm628_load_trajectory(part, &forward) == LM628_OK);
  REQUIRE(lm628_start(part) == LM628_OK);
  REQUIRE(lm628_wait_for(part, LM628_BREAKPOINT, 20000, &status) == LM628_OK);
  CHECK((status & LM628_INDEX) == 0);
  CHECK(pins.bench.out().hi);
  REQUIRE(lm628_clear(part, LM628_BREAKPOINT) == LM628_OK);
  REQUIRE(lm628_wait_ready(part) == LM628_OK);
  CHECK_FALSE(pins.bench.out().hi);
  REQUIRE(lm628_wait_for(part, LM628_INDEX, 20000, &status) == LM628_OK);
  CHECK(pins.bench.out().hi);
  REQUIRE(lm628_read_index(part, &l) == LM628_OK);
  CHECK(l == 40);
  REQUIRE(lm628_read_desired_velocity(part, &l) == LM628_OK);
  CHECK(l == 65536);
  REQUIRE(lm628_read_velocity(part, &s) == LM628_OK);
  CHECK(s == 1);
  REQUIRE(lm628_clear(part, LM628_EVENTS) == LM628_OK);
  REQUIRE(lm628_load_trajectory(part, &forward) == LM628_OK);  // a new acceleration in motion
  REQUIRE(lm628_start(part) == LM628_OK);
  CHECK(lm628_check(part) == LM628_ERROR_COMMAND);
  REQUIRE(lm628_clear(part, LM628_EVENTS) == LM628_OK);
  CHECK(lm628_check(part) == LM628_OK);
  REQUIRE(lm628_stop(part, LM628_STOP_ABRUPTLY) == LM628_OK);
  REQUIRE(lm628_wait_for(part, LM628_TRAJECTORY_COMPLETE, 20000, &status) == LM628_OK);
  REQUIRE(lm628_define_home(part) == LM628_OK);
  REQUIRE(lm628_read_position(part, &l) == LM628_OK);
  CHECK(l == 0);
  pins.bench.follows = false;
  REQUIRE(lm628_interrupt_on_error(part, 50) == LM628_OK);
  const lm628_filter sums{LM628_KI | LM628_IL, 0, 1, 0, 100, 1};
  REQUIRE(lm628_load_filter(part, &sums) == LM628_OK);
  REQUIRE(lm628_update_filter(part) == LM628_OK);
  pins.bench.move_to(pins.bench.position() - 200);
  REQUIRE(lm628_wait_for(part, LM628_POSITION_ERROR, 20000, &status) == LM628_OK);
  CHECK((status & LM628_MOTOR_OFF) == 0);
  pins.bench.sample(20);
  REQUIRE(lm628_read_sum(part, &s) == LM628_OK);
  CHECK(s >= 200 * 20 / 256);
  REQUIRE(lm628_stop_on_error(part, 50) == LM628_OK);
  REQUIRE(lm628_wait_for(part, LM628_MOTOR_OFF, 2000, &status) == LM628_OK);
  REQUIRE(lm628_set_breakpoint_relative(part, 7) == LM628_OK);
  pins.bench.sample(2);
  std::int32_t real = 0;
  REQUIRE(lm628_read_position(part, &real) == LM628_OK);
  CHECK(real <= -200);
  REQUIRE(lm628_read_desired_position(part, &l) == LM628_OK);
  CHECK(l == real);  // while it is off
  CHECK(lm628_check(part) == LM628_OK);
}

TEST_CASE("lm628 driver by pins: a part that is not there, or held in reset, ends with an error") {
  Pins absent;
  absent.selected = false;
  std::int32_t reached = 0;
  CHECK(lm628_example_move(&absent.port, 100, &reached) == LM628_ERROR_STATUS);
  absent.part.polls = 200;
  CHECK(lm628_start(&absent.part) == LM628_ERROR_TIMEOUT);
  CHECK(lm628_read_position(&absent.part, &reached) == LM628_ERROR_TIMEOUT);
  Pins held(false);  // RST is not wired to the host
  held.bench.clocks(100);
  CHECK(lm628_reset(&held.part, LM628_OUTPUT_8_BITS) == LM628_OK);  // in its routine, then ready
  held.bench.hardware_reset(100);
  CHECK(lm628_check(&held.part) == LM628_OK);
  held.bench.chip.in.reset_n = false;
  held.bench.clocks(100);
  std::uint8_t status = 0xFF;
  CHECK(lm628_read_status(&held.part, &status) == LM628_OK);
  CHECK(status == 0x00);
}

TEST_CASE("lm628 driver by pins keeps the data sheet's times") {
  struct Event {
    std::uint32_t ns;
    std::string what;
  };
  struct Record {
    std::uint32_t now = 0;
    std::vector<Event> events;
    std::uint8_t levels = 0;
    std::uint32_t at(const std::string& what) const {
      for (const Event& event : events) {
        if (event.what == what) return event.ns;
      }
      FAIL("no " << what);
      return 0;
    }
  } record;
  lm628_gpio gpio{};
  gpio.set_lines = [](void* self, std::uint8_t levels) {
    auto& r = *static_cast<Record*>(self);
    static const std::pair<int, std::string> kLines[] = {{LM628_GPIO_CS, "CS"},
                                                         {LM628_GPIO_RD, "RD"},
                                                         {LM628_GPIO_WR, "WR"},
                                                         {LM628_GPIO_PS, "PS"},
                                                         {LM628_GPIO_RST, "RST"}};
    for (const auto& [bit, name] : kLines) {
      if (((levels ^ r.levels) & bit) == 0) continue;
      r.events.push_back({r.now, ((levels & bit) != 0 ? "+" : "-") + name});
    }
    r.levels = levels;
  };
  gpio.drive_bus = [](void* self, std::uint8_t) {
    auto& r = *static_cast<Record*>(self);
    r.events.push_back({r.now, "drive"});
  };
  gpio.release_bus = [](void* self) {
    auto& r = *static_cast<Record*>(self);
    r.events.push_back({r.now, "release"});
  };
  gpio.read_bus = [](void* self) {
    auto& r = *static_cast<Record*>(self);
    r.events.push_back({r.now, "take"});
    return std::uint8_t{0x80};
  };
  gpio.wait_ns = [](void* self, std::uint32_t ns) { static_cast<Record*>(self)->now += ns; };
  gpio.has_reset = true;
  gpio.context = &record;
  lm628_port port{};
  REQUIRE(lm628_gpio_port(&port, &gpio) == LM628_OK);
  record.events.clear();
  port.write(port.context, true, 0xA5);
  CHECK(record.at("-WR") - record.at("+PS") >= 30);
  CHECK(record.at("-CS") <= record.at("-WR"));
  CHECK(record.at("+WR") - record.at("-WR") >= 100);
  CHECK(record.at("+WR") - record.at("drive") >= 50);
  CHECK(record.at("release") - record.at("+WR") >= 120);
  CHECK(record.at("-PS") - record.at("+WR") >= 30);
  CHECK(record.at("+CS") >= record.at("+WR"));
  CHECK(record.now - record.at("+WR") >= 120);
  record.events.clear();
  CHECK(port.read(port.context, true) == 0x80);
  CHECK(record.at("-RD") - record.at("+PS") >= 30);
  CHECK(record.at("take") - record.at("-RD") >= 180);
  CHECK(record.at("take") <= record.at("+RD"));
  CHECK(record.at("-PS") - record.at("+RD") >= 30);
  CHECK(record.now - record.at("+RD") >= 180);
  record.events.clear();
  port.strobe_reset(port.context);
  CHECK(record.at("+RST") - record.at("-RST") >= 8 * 1000 / 6 + 1);
  CHECK(record.levels == (LM628_GPIO_CS | LM628_GPIO_RD | LM628_GPIO_WR | LM628_GPIO_RST));

  const lm628_gpio whole = gpio;
  for (int missing = 0; missing < 5; ++missing) {
    gpio = whole;
    if (missing == 0) gpio.set_lines = nullptr;
    if (missing == 1) gpio.drive_bus = nullptr;
    if (missing == 2) gpio.release_bus = nullptr;
    if (missing == 3) gpio.read_bus = nullptr;
    if (missing == 4) gpio.wait_ns = nullptr;
    CHECK(lm628_gpio_port(&port, &gpio) == LM628_ERROR_NULL);
  }
  CHECK(lm628_gpio_port(nullptr, &gpio) == LM628_ERROR_NULL);
  CHECK(lm628_gpio_port(&port, nullptr) == LM628_ERROR_NULL);
}
