// SPDX-License-Identifier: Apache-2.0
//
// Codes and bits of the drivers of the LM628, in C and of the firmware, by the numbers of the data
// sheet (SNVS781C, command summary and tables of the status byte, signals register, LTRJ and LFIL).

#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <utility>

#include "parts/lm628/driver/lm628.h"
#include "sw_nios/hal/lm628.hpp"

namespace {

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
