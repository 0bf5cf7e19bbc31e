// SPDX-License-Identifier: Apache-2.0
//
// The drivers of the LM628: the one in C at addresses of a bus, with a motor, on RTL and twin, and
// in memory; codes and bits of it and of the firmware's by the numbers of the data sheet (SNVS781C,
// command summary and tables of the status byte, signals register, LTRJ and LFIL).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "cosim/direct.hpp"
#include "models/plant/motor_axis.hpp"
#include "parts/lm628/chip.hpp"
#include "parts/lm628/driver/example.h"
#include "parts/lm628/driver/lm628.h"
#include "parts/lm628/driver/lm628_mmio.h"
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

using Code = trammel::sw::Lm628Command;

struct Command {
  int code, of_c;
  Code of_firmware;
};

constexpr unsigned bit(unsigned n) { return 1u << n; }

// Gives these data bytes, and is busy from the so many-th read of the status on.
struct Replies {
  std::deque<std::uint8_t> data;
  int ready = 1000;
  lm628_port port{};
  lm628_device part{};

  explicit Replies(std::deque<std::uint8_t> bytes) : data(std::move(bytes)) {
    port.write = [](void*, bool, std::uint8_t) {};
    port.read = [](void* self, bool ps) {
      auto& r = *static_cast<Replies*>(self);
      if (!ps) return static_cast<std::uint8_t>(r.ready-- > 0 ? 0x80 : 0x81);
      const std::uint8_t byte = r.data.empty() ? std::uint8_t{0} : r.data.front();
      if (!r.data.empty()) r.data.pop_front();
      return byte;
    };
    port.wait_us = [](void*, std::uint32_t) {};
    port.context = this;
    REQUIRE(lm628_init(&part, &port) == LM628_OK);
    part.polls = 3;
  }
  Replies(const Replies&) = delete;
  Replies& operator=(const Replies&) = delete;
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

TEST_CASE("lm628 commands have the data sheet's codes, in C and in the firmware") {
  for (const auto& [code, of_c, of_firmware] :
       {Command{0x00, LM628_RESET, Code::kReset}, {0x01, LM628_STT, Code::kStt},
        {0x02, LM628_DFH, Code::kDfh}, {0x03, LM628_SIP, Code::kSip}, {0x04, LM628_UDF, Code::kUdf},
        {0x05, LM628_PORT8, Code::kPort8}, {0x06, LM628_PORT12, Code::kPort12},
        {0x07, LM628_RDDV, Code::kRddv}, {0x08, LM628_RDDP, Code::kRddp},
        {0x09, LM628_RDIP, Code::kRdip}, {0x0A, LM628_RDRP, Code::kRdrp},
        {0x0B, LM628_RDRV, Code::kRdrv}, {0x0C, LM628_RDSIGS, Code::kRdsigs},
        {0x0D, LM628_RDSUM, Code::kRdsum}, {0x1A, LM628_LPES, Code::kLpes},
        {0x1B, LM628_LPEI, Code::kLpei}, {0x1C, LM628_MSKI, Code::kMski},
        {0x1D, LM628_RSTI, Code::kRsti}, {0x1E, LM628_LFIL, Code::kLfil},
        {0x1F, LM628_LTRJ, Code::kLtrj}, {0x20, LM628_SBPA, Code::kSbpa},
        {0x21, LM628_SBPR, Code::kSbpr}}) {
    CAPTURE(code);
    CHECK(of_c == code);
    CHECK(static_cast<int>(of_firmware) == code);
  }
}

TEST_CASE("lm628 bits of status, signals, LTRJ and LFIL are the data sheet's") {
  CHECK(LM628_BUSY == bit(0));
  CHECK(LM628_COMMAND_ERROR == bit(1));
  CHECK(LM628_TRAJECTORY_COMPLETE == bit(2));
  CHECK(LM628_INDEX == bit(3));
  CHECK(LM628_WRAPAROUND == bit(4));
  CHECK(LM628_POSITION_ERROR == bit(5));
  CHECK(LM628_BREAKPOINT == bit(6));
  CHECK(LM628_MOTOR_OFF == bit(7));
  CHECK(LM628_EVENTS == 0x7E);
  CHECK(LM628_ACQUIRE_INDEX == bit(0));
  CHECK(LM628_EIGHT_BITS == bit(8));
  CHECK(LM628_OFF_ON_ERROR == bit(9));
  CHECK(LM628_ON_TARGET == bit(10));
  CHECK(LM628_IN_VELOCITY_MODE == bit(11));
  CHECK(LM628_IS_FORWARD == bit(12));
  CHECK(LM628_FILTER_UPDATED == bit(13));
  CHECK(LM628_ACCELERATION_LOADED == bit(14));
  CHECK(LM628_HOST_INTERRUPT == bit(15));
  CHECK(LM628_POSITION_RELATIVE == bit(0));
  CHECK(LM628_LOAD_POSITION == bit(1));
  CHECK(LM628_VELOCITY_RELATIVE == bit(2));
  CHECK(LM628_LOAD_VELOCITY == bit(3));
  CHECK(LM628_ACCELERATION_RELATIVE == bit(4));
  CHECK(LM628_LOAD_ACCELERATION == bit(5));
  CHECK(LM628_STOP_MOTOR_OFF == bit(8));
  CHECK(LM628_STOP_ABRUPTLY == bit(9));
  CHECK(LM628_STOP_SMOOTHLY == bit(10));
  CHECK(LM628_VELOCITY_MODE == bit(11));
  CHECK(LM628_FORWARD == bit(12));
  CHECK(LM628_IL == bit(0));
  CHECK(LM628_KD == bit(1));
  CHECK(LM628_KI == bit(2));
  CHECK(LM628_KP == bit(3));
  namespace status = trammel::sw::lm628_status;
  CHECK(status::kBusy == bit(0));
  CHECK(status::kCommandError == bit(1));
  CHECK(status::kTrajectoryComplete == bit(2));
  CHECK(status::kIndex == bit(3));
  CHECK(status::kPositionError == bit(5));
  CHECK(status::kBreakpoint == bit(6));
  CHECK(status::kMotorOff == bit(7));
}

TEST_CASE("lm628 driver's text of an error says what happened") {
  for (const auto& [error, words] :
       {std::pair{LM628_OK, "done"}, {LM628_ERROR_NULL, "pointer"}, {LM628_ERROR_RANGE, "range"},
        {LM628_ERROR_TIMEOUT, "stays busy"}, {LM628_ERROR_STATUS, "status after a reset"},
        {LM628_ERROR_COMMAND, "command error"}, {static_cast<lm628_error>(7), "unknown"}}) {
    CHECK_THAT(lm628_error_text(error), Catch::Contains(words));
  }
}

TEST_CASE("lm628 driver gives what it read whole, or after a timeout leaves it as it was") {
  for (const int ready : {0, 1, 2, 3}) {  // busy before the command, or one of its two words
    CAPTURE(ready);
    Replies replies({0x01, 0x02, 0x83, 0x84});
    replies.ready = ready;
    std::int32_t position = 77;
    const lm628_error error = lm628_read_position(&replies.part, &position);
    CHECK(error == (ready < 3 ? LM628_ERROR_TIMEOUT : LM628_OK));
    CHECK(position == (ready < 3 ? 77 : 0x01028384));
    Replies shorts({0xFF, 0xFE});
    shorts.ready = ready;
    std::int16_t sum = 77;
    CHECK(lm628_read_sum(&shorts.part, &sum) == (ready < 2 ? LM628_ERROR_TIMEOUT : LM628_OK));
    CHECK(sum == (ready < 2 ? 77 : -2));
  }
}

TEST_CASE("lm628 driver waits for any one of the bits it was told, and for no other") {
  Replies replies({});
  std::uint8_t status = 0;
  CHECK(lm628_wait_for(&replies.part, LM628_INDEX | LM628_MOTOR_OFF, 0, &status) == LM628_OK);
  CHECK(status == 0x80);
  CHECK(lm628_wait_for(&replies.part, LM628_BREAKPOINT, 99, &status) == LM628_ERROR_TIMEOUT);
}
