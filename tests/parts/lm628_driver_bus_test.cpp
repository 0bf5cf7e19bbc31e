// SPDX-License-Identifier: Apache-2.0
//
// The C driver of the LM628 at addresses of a bus, with a motor, on RTL and twin; and in memory.

#include "parts/lm628/driver/lm628_mmio.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

#include "cosim/direct.hpp"
#include "models/plant/motor_axis.hpp"
#include "parts/lm628/chip.hpp"
#include "parts/lm628/driver/example.h"
#include "sw_nios/hal/lm628.hpp"
#include "tests/support/lm628_words.hpp"

using namespace trammel;
namespace map = sw::lm628_map;

namespace {

// The motor of an encoder of 4000 counts behind the part's converter.
class Motor final : public cosim::Plant {
 public:
  cosim::Lines sense() const override {
    return cosim::Lines{axis_.a()} << lm628::kEncoderA |
           cosim::Lines{axis_.b()} << lm628::kEncoderB |
           cosim::Lines{axis_.index()} << lm628::kIndex;
  }
  cosim::Clk next() const override { return axis_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    axis_.commit(n, (static_cast<double>(drive) - static_cast<double>(lm628::kZeroCode)) / 2048);
  }
  int sample(int, cosim::Clk) const override { return 0; }

 private:
  plant::MotorAxis axis_{plant::MotorAxisConfig{}};
};

struct Words final : cosim::Observer {
  std::vector<lm628::Words> all;  // of each sample
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) override {
    if ((stop.why & cosim::kSample) == 0) return;
    all.push_back(dynamic_cast<const lm628::Lm628Chip&>(chip).words());
  }
};

// A processor's bus with the part at the addresses of lm628_map.
struct Bus {
  std::unique_ptr<lm628::Lm628Chip> chip;
  Motor motor;
  Words words;
  cosim::Loop loop;
  cosim::DirectBus bus;
  lm628_mmio mmio{};
  lm628_port port{};

  explicit Bus(std::unique_ptr<lm628::Lm628Chip> made, bool has_reset = true)
      : chip(std::move(made)), loop(*chip, motor, words, 4096), bus(loop, {}) {
    mmio.command = map::kCommand;
    mmio.data = map::kData;
    mmio.reset = map::kReset;
    mmio.has_reset = has_reset;
    mmio.bits = 32;
    mmio.load = [](void* self, std::uintptr_t address) {
      return at(self).bus.read(static_cast<std::uint32_t>(address));
    };
    mmio.store = [](void* self, std::uintptr_t address, std::uint32_t value) {
      at(self).bus.write(static_cast<std::uint32_t>(address), value);
    };
    mmio.wait_us = [](void* self, std::uint32_t us) {
      at(self).bus.wait(static_cast<cosim::Clk>(us) * 50);
    };
    mmio.context = this;
    REQUIRE(lm628_mmio_port(&port, &mmio) == LM628_OK);
  }
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

 private:
  static Bus& at(void* self) { return *static_cast<Bus*>(self); }
};

}  // namespace

TEST_CASE("lm628 driver by addresses: the example's move with a motor, equal on RTL and twin") {
  for (const bool has_reset : {true, false}) {
    Bus twin(lm628::make_twin_chip(), has_reset), rtl(lm628::make_verilated_chip({}), has_reset);
    for (Bus* bus : {&twin, &rtl}) {
      bus->bus.wait(51000);
      std::int32_t reached = 0;
      REQUIRE(lm628_example_move(&bus->port, 400, &reached) == LM628_OK);
      CHECK(reached > 380);
      CHECK(reached < 420);
      REQUIRE(bus->words.all.size() > 300);
    }
    REQUIRE(twin.words.all.size() == rtl.words.all.size());
    for (std::size_t k = 0; k < twin.words.all.size(); ++k) {
      test::require_same(twin.words.all[k], rtl.words.all[k]);
    }
  }
}

TEST_CASE("lm628 driver by addresses reaches memory in accesses of 8, 16 and 32 bits") {
  for (const unsigned bits : {8u, 16u, 32u}) {
    alignas(4) std::uint8_t memory[16];
    std::fill(std::begin(memory), std::end(memory), std::uint8_t{0xEE});
    const std::size_t width = bits / 8;
    lm628_mmio mmio{};
    mmio.command = reinterpret_cast<std::uintptr_t>(memory);
    mmio.data = mmio.command + width;
    mmio.reset = mmio.command + 2 * width;
    mmio.has_reset = true;
    mmio.bits = static_cast<std::uint8_t>(bits);
    mmio.wait_us = [](void*, std::uint32_t) {};
    lm628_port port{};
    REQUIRE(lm628_mmio_port(&port, &mmio) == LM628_OK);
    port.write(port.context, false, 0x1F);
    port.write(port.context, true, 0xA5);
    port.strobe_reset(port.context);
    const std::uint8_t written[] = {0x1F, 0xA5, 0x01};
    for (std::size_t k = 0; k < sizeof memory; ++k) {  // little endian
      const bool is_low = k % width == 0;
      CHECK(memory[k] == (k >= 3 * width ? 0xEE : is_low ? written[k / width] : 0));
    }
    CHECK(port.read(port.context, false) == 0x1F);
    CHECK(port.read(port.context, true) == 0xA5);
  }
}

TEST_CASE("lm628 driver by addresses refuses widths, addresses and missing functions") {
  lm628_mmio right{};
  right.command = 0;
  right.data = 4;
  right.bits = 32;
  right.wait_us = [](void*, std::uint32_t) {};
  lm628_port port{};
  REQUIRE(lm628_mmio_port(&port, &right) == LM628_OK);
  CHECK(port.strobe_reset == nullptr);
  CHECK(lm628_mmio_port(nullptr, &right) == LM628_ERROR_NULL);
  CHECK(lm628_mmio_port(&port, nullptr) == LM628_ERROR_NULL);
  lm628_mmio wrong = right;
  wrong.wait_us = nullptr;
  CHECK(lm628_mmio_port(&port, &wrong) == LM628_ERROR_NULL);
  wrong = right;
  wrong.load = [](void*, std::uintptr_t) { return std::uint32_t{0}; };
  CHECK(lm628_mmio_port(&port, &wrong) == LM628_ERROR_NULL);
  for (const unsigned bits : {0u, 1u, 24u, 64u}) {
    wrong = right;
    wrong.bits = static_cast<std::uint8_t>(bits);
    CHECK(lm628_mmio_port(&port, &wrong) == LM628_ERROR_RANGE);
  }
  for (const std::uintptr_t data : {0, 2, 5}) {
    wrong = right;
    wrong.data = data;
    CHECK(lm628_mmio_port(&port, &wrong) == LM628_ERROR_RANGE);
  }
  wrong = right;
  wrong.command = 2;
  CHECK(lm628_mmio_port(&port, &wrong) == LM628_ERROR_RANGE);
  wrong = right;
  wrong.reset = 3;
  CHECK(lm628_mmio_port(&port, &wrong) == LM628_OK);  // not wired
  wrong.has_reset = true;
  CHECK(lm628_mmio_port(&port, &wrong) == LM628_ERROR_RANGE);
}
