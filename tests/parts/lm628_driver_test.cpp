// SPDX-License-Identifier: Apache-2.0
//
// The C driver of the LM628 at a port that records: bytes of each command, refusals, bounds.

#include "parts/lm628/driver/lm628.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/port_byte.hpp"

namespace {

// A part that takes and gives what the test says.
struct Port {
  lm628_device part{};
  lm628_port port{};
  std::string written;  // "c1F d01 d00", and "R" for the pin
  std::deque<std::uint8_t> statuses;  // the next ones, then `status`
  std::uint8_t status = 0x80;
  std::deque<std::uint8_t> data;
  std::uint32_t polls = 0, waited_us = 0;

  Port() {
    port.write = [](void* self, bool ps, std::uint8_t byte) {
      at(self).note(trammel::test::port_byte(ps ? 'd' : 'c', byte));
    };
    port.read = [](void* self, bool ps) { return at(self).give(ps); };
    port.strobe_reset = [](void* self) { at(self).note("R"); };
    port.wait_us = [](void* self, std::uint32_t us) { at(self).waited_us += us; };
    port.context = this;
    REQUIRE(lm628_init(&part, &port) == LM628_OK);
  }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  static Port& at(void* self) { return *static_cast<Port*>(self); }
  void note(const std::string& access) { written += (written.empty() ? "" : " ") + access; }
  std::uint8_t give(bool ps) {
    std::deque<std::uint8_t>& from = ps ? data : statuses;
    if (!ps) ++polls;
    if (from.empty()) return ps ? 0 : status;
    const std::uint8_t byte = from.front();
    from.pop_front();
    return byte;
  }
};

using Call = std::function<lm628_error(lm628_device*)>;

// Each function that speaks to the part, with arguments that it takes, and what it writes.
const std::vector<std::pair<Call, std::string>>& calls() {
  static const lm628_filter filter{LM628_KP | LM628_KI | LM628_KD | LM628_IL, 10, 0x102, 0x7FFF,
                                   4, 256};
  static const lm628_filter only_kd{LM628_KD, 0xFFFF, 0xFFFF, 7, 0xFFFF, 1};
  static const lm628_trajectory move{0x2A, 2, 0x346E, -8000};
  static const lm628_trajectory nothing{0x1815, -1, -1, 0x7FFFFFFF};
  static const lm628_trajectory slower{0x180C, -1, -16, 0x7FFFFFFF};
  static std::int32_t l;
  static std::int16_t s;
  static std::uint16_t u;
  static const std::vector<std::pair<Call, std::string>> all{
      {[](lm628_device* p) { return lm628_set_output(p, LM628_OUTPUT_8_BITS); }, "c05"},
      {[](lm628_device* p) { return lm628_set_output(p, LM628_OUTPUT_12_BITS); }, "c06"},
      {[](lm628_device* p) { return lm628_mask_interrupts(p, LM628_BREAKPOINT); }, "c1C d00 d40"},
      {[](lm628_device* p) { return lm628_clear(p, LM628_EVENTS); }, "c1D d00 d00"},
      {[](lm628_device* p) { return lm628_clear(p, LM628_INDEX); }, "c1D d00 d76"},
      {[](lm628_device* p) { return lm628_interrupt_on_error(p, 32767); }, "c1B d7F dFF"},
      {[](lm628_device* p) { return lm628_stop_on_error(p, 0); }, "c1A d00 d00"},
      {[](lm628_device* p) { return lm628_set_breakpoint(p, LM628_POSITION_MIN); },
       "c20 dC0 d00 d00 d00"},
      {[](lm628_device* p) { return lm628_set_breakpoint_relative(p, -2); }, "c21 dFF dFF dFF dFE"},
      {[](lm628_device* p) { return lm628_capture_index(p); }, "c03"},
      {[](lm628_device* p) { return lm628_define_home(p); }, "c02"},
      {[](lm628_device* p) { return lm628_load_filter(p, &filter); },
       "c1E dFF d0F d00 d0A d01 d02 d7F dFF d00 d04"},
      {[](lm628_device* p) { return lm628_load_filter(p, &only_kd); }, "c1E d00 d02 d00 d07"},
      {[](lm628_device* p) { return lm628_update_filter(p); }, "c04"},
      {[](lm628_device* p) { return lm628_load_trajectory(p, &move); },
       "c1F d00 d2A d00 d00 d00 d02 d00 d00 d34 d6E dFF dFF dE0 dC0"},
      {[](lm628_device* p) { return lm628_load_trajectory(p, &nothing); }, "c1F d18 d15"},
      {[](lm628_device* p) { return lm628_load_trajectory(p, &slower); },
       "c1F d18 d0C dFF dFF dFF dF0"},
      {[](lm628_device* p) { return lm628_start(p); }, "c01"},
      {[](lm628_device* p) { return lm628_stop(p, LM628_STOP_MOTOR_OFF); }, "c1F d01 d00 c01"},
      {[](lm628_device* p) { return lm628_stop(p, LM628_STOP_ABRUPTLY); }, "c1F d02 d00 c01"},
      {[](lm628_device* p) { return lm628_stop(p, LM628_STOP_SMOOTHLY); }, "c1F d04 d00 c01"},
      {[](lm628_device* p) { return lm628_read_position(p, &l); }, "c0A"},
      {[](lm628_device* p) { return lm628_read_desired_position(p, &l); }, "c08"},
      {[](lm628_device* p) { return lm628_read_index(p, &l); }, "c09"},
      {[](lm628_device* p) { return lm628_read_desired_velocity(p, &l); }, "c07"},
      {[](lm628_device* p) { return lm628_read_velocity(p, &s); }, "c0B"},
      {[](lm628_device* p) { return lm628_read_signals(p, &u); }, "c0C"},
      {[](lm628_device* p) { return lm628_read_sum(p, &s); }, "c0D"},
      {[](lm628_device* p) { return lm628_write_command(p, LM628_STT); }, "c01"},
      {[](lm628_device* p) { return lm628_write_word(p, 0xA55A); }, "dA5 d5A"},
      {[](lm628_device* p) { return lm628_write_long(p, 0x12345678); }, "d12 d34 d56 d78"},
      {[](lm628_device* p) { return lm628_read_word(p, &u); }, ""},
      {[](lm628_device* p) { return lm628_read_long(p, &l); }, ""},
      {[](lm628_device* p) { return lm628_wait_ready(p); }, ""},
      {[](lm628_device* p) { return lm628_check(p); }, ""}};
  return all;
}

}  // namespace

TEST_CASE("lm628 driver writes the data sheet's bytes, each command and word after a status") {
  for (const auto& [call, written] : calls()) {
    Port port;
    CAPTURE(written);
    CHECK(call(&port.part) == LM628_OK);
    CHECK(port.written == written);
    CHECK(port.polls > 0);
  }
}

TEST_CASE("lm628 driver looks at busy before each command and word, not between two bytes") {
  Port port;
  CHECK(lm628_write_word(&port.part, 1) == LM628_OK);
  CHECK(port.polls == 1);
  CHECK(lm628_set_breakpoint(&port.part, 1) == LM628_OK);
  CHECK(port.polls == 1 + 3);
  std::int32_t position = 0;
  port.statuses = {0x81, 0x81, 0x80, 0x80, 0x81};
  port.data = {0xFF, 0xFF, 0xE0, 0xC0};
  CHECK(lm628_read_position(&port.part, &position) == LM628_OK);
  CHECK(position == -8000);
  CHECK(port.polls == 4 + 3 + 1 + 2);
}

TEST_CASE("lm628 driver gives replies with their sign") {
  Port port;
  std::int32_t l = 0;
  std::int16_t s = 0;
  std::uint16_t u = 0;
  port.data = {0x3F, 0xFF, 0xFF, 0xFF, 0xC0, 0,    0,    0,    0x80,
               0,    0,    0,    0x80, 0,    0x7F, 0xFF, 0x81, 0x80};
  CHECK(lm628_read_index(&port.part, &l) == LM628_OK);
  CHECK(l == LM628_POSITION_MAX);
  CHECK(lm628_read_desired_position(&port.part, &l) == LM628_OK);
  CHECK(l == LM628_POSITION_MIN);
  CHECK(lm628_read_desired_velocity(&port.part, &l) == LM628_OK);
  CHECK(l == INT32_MIN);
  CHECK(lm628_read_velocity(&port.part, &s) == LM628_OK);
  CHECK(s == INT16_MIN);
  CHECK(lm628_read_sum(&port.part, &s) == LM628_OK);
  CHECK(s == INT16_MAX);
  CHECK(lm628_read_signals(&port.part, &u) == LM628_OK);
  CHECK(u == (LM628_HOST_INTERRUPT | LM628_EIGHT_BITS | LM628_MOTOR_OFF));
}

TEST_CASE("lm628 driver resets as AN-693 does, by the pin or by command") {
  Port port;
  port.statuses = {0xC4};
  CHECK(lm628_reset(&port.part, LM628_OUTPUT_12_BITS) == LM628_OK);
  CHECK(port.written == "R c06 c1D d00 d00");
  CHECK(port.waited_us == 1500);
  Port by_command;
  by_command.port.strobe_reset = nullptr;
  by_command.statuses = {0x80, 0x84};
  CHECK(lm628_reset(&by_command.part, LM628_OUTPUT_8_BITS) == LM628_OK);
  CHECK(by_command.written == "c00 c05 c1D d00 d00");
  for (const int status : {0x00, 0xFF, 0x80, 0x85}) {  // nothing there, or not reset
    Port other;
    other.status = static_cast<std::uint8_t>(status);
    CHECK(lm628_reset(&other.part, LM628_OUTPUT_8_BITS) == LM628_ERROR_STATUS);
    CHECK(other.written == "R");
  }
  Port stays;  // RSTI has no effect
  stays.status = 0x84;
  CHECK(lm628_reset(&stays.part, LM628_OUTPUT_8_BITS) == LM628_ERROR_STATUS);
  CHECK(stays.written == "R c05 c1D d00 d00");
}

TEST_CASE("lm628 driver ends with a timeout where the part stays busy, after its bound of reads") {
  for (const auto& [call, written] : calls()) {
    Port port;
    CAPTURE(written);
    port.status = 0x81;
    CHECK(call(&port.part) == LM628_ERROR_TIMEOUT);
    CHECK(port.written.empty());
    CHECK(port.polls == LM628_POLLS);
  }
  Port port;  // in the middle of a command: what follows is not written
  port.part.polls = 3;
  port.statuses = {0x80, 0x80, 0x81, 0x81, 0x81};
  CHECK(lm628_set_breakpoint(&port.part, 5) == LM628_ERROR_TIMEOUT);
  CHECK(port.written == "c20 d00 d00");
  port.part.polls = 0;
  CHECK(lm628_wait_ready(&port.part) == LM628_ERROR_RANGE);
  Port busy;
  busy.status = 0x81;
  busy.port.strobe_reset = nullptr;
  CHECK(lm628_reset(&busy.part, LM628_OUTPUT_8_BITS) == LM628_ERROR_TIMEOUT);
  CHECK(lm628_wait_for(&busy.part, LM628_INDEX, 0, nullptr) == LM628_ERROR_TIMEOUT);
  CHECK(busy.written.empty());
}

TEST_CASE("lm628 driver waits for a status bit as long as it was told") {
  Port port;
  std::uint8_t status = 0;
  port.statuses = {0x80, 0x00, 0x00, 0x44};
  CHECK(lm628_wait_for(&port.part, LM628_BREAKPOINT, 1000, &status) == LM628_OK);
  CHECK(status == 0x44);
  CHECK(port.waited_us == 200);
  port.waited_us = 0;
  CHECK(lm628_wait_for(&port.part, LM628_INDEX, 950, &status) == LM628_ERROR_TIMEOUT);
  CHECK(port.waited_us == 1000);
  CHECK(status == 0x80);
  CHECK(lm628_wait_for(&port.part, LM628_INDEX, 0, nullptr) == LM628_ERROR_TIMEOUT);
  CHECK(port.waited_us == 1000);
  CHECK(lm628_wait_for(&port.part, 0, 1000, nullptr) == LM628_ERROR_RANGE);
  CHECK(lm628_wait_for(&port.part, LM628_BUSY | LM628_INDEX, 1, nullptr) == LM628_ERROR_RANGE);
  CHECK(lm628_check(&port.part) == LM628_OK);
  port.status = 0x82;
  CHECK(lm628_check(&port.part) == LM628_ERROR_COMMAND);
  CHECK(lm628_read_status(&port.part, &status) == LM628_OK);
  CHECK(status == 0x82);
}

TEST_CASE("lm628 driver refuses what is out of range and writes nothing") {
  const auto refused = [](const Call& call) {
    Port port;
    CHECK(call(&port.part) == LM628_ERROR_RANGE);
    CHECK(port.written.empty());
    CHECK(port.polls == 0);
  };
  const auto filter = [&](lm628_filter f) {
    refused([f](lm628_device* p) { return lm628_load_filter(p, &f); });
  };
  filter({LM628_KP, 32768, 0, 0, 0, 1});
  filter({LM628_KI, 0, 32768, 0, 0, 1});
  filter({LM628_KD, 0, 0, 32768, 0, 1});
  filter({LM628_IL, 0, 0, 0, 32768, 1});
  filter({LM628_KP, 1, 0, 0, 0, 0});
  filter({LM628_KP, 1, 0, 0, 0, 257});
  filter({0x10, 1, 0, 0, 0, 1});
  const auto trajectory = [&](lm628_trajectory t) {
    refused([t](lm628_device* p) { return lm628_load_trajectory(p, &t); });
  };
  trajectory({LM628_LOAD_ACCELERATION, -1, 0, 0});
  trajectory({LM628_LOAD_ACCELERATION, 0x40000000, 0, 0});
  trajectory({LM628_LOAD_VELOCITY, 0, -1, 0});
  trajectory({LM628_LOAD_VELOCITY | LM628_ACCELERATION_RELATIVE, 0, -1, 0});
  trajectory({LM628_LOAD_VELOCITY | LM628_VELOCITY_RELATIVE, 0, -0x40000000, 0});
  trajectory({LM628_LOAD_POSITION, 0, 0, LM628_POSITION_MAX + 1});
  trajectory({LM628_LOAD_POSITION, 0, 0, LM628_POSITION_MIN - 1});
  for (const unsigned bit : {0x40u, 0x80u, 0x100u, 0x200u, 0x400u, 0x2000u, 0x8000u}) {
    trajectory({static_cast<std::uint16_t>(bit), 0, 0, 0});
  }
  for (const int kind : {0, 1, 0x300, 0x700}) {
    refused([kind](lm628_device* p) { return lm628_stop(p, static_cast<lm628_stop_kind>(kind)); });
  }
  const auto output = static_cast<lm628_output>(2);
  refused([=](lm628_device* p) { return lm628_set_output(p, output); });
  refused([=](lm628_device* p) { return lm628_reset(p, output); });
  refused([](lm628_device* p) { return lm628_mask_interrupts(p, LM628_MOTOR_OFF); });
  refused([](lm628_device* p) { return lm628_clear(p, LM628_BUSY); });
  refused([](lm628_device* p) { return lm628_stop_on_error(p, 32768); });
  refused([](lm628_device* p) { return lm628_interrupt_on_error(p, 32768); });
  refused([](lm628_device* p) { return lm628_set_breakpoint(p, 0x40000000); });
  refused([](lm628_device* p) { return lm628_set_breakpoint_relative(p, -0x40000001); });
}

TEST_CASE("lm628 driver reports a missing pointer or function, and uses no such part") {
  lm628_device none{};
  for (const auto& [call, written] : calls()) {
    CAPTURE(written);
    CHECK(call(nullptr) == LM628_ERROR_NULL);
    CHECK(call(&none) == LM628_ERROR_NULL);
  }
  CHECK(lm628_reset(nullptr, LM628_OUTPUT_8_BITS) == LM628_ERROR_NULL);
  CHECK(lm628_wait_for(&none, LM628_INDEX, 1, nullptr) == LM628_ERROR_NULL);
  Port port;
  std::uint8_t status = 0;
  CHECK(lm628_read_status(nullptr, &status) == LM628_ERROR_NULL);
  CHECK(lm628_read_status(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(lm628_load_filter(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(lm628_load_trajectory(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(lm628_read_position(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(lm628_read_velocity(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(lm628_read_signals(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(lm628_read_word(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(lm628_read_long(&port.part, nullptr) == LM628_ERROR_NULL);
  CHECK(port.written.empty());
  CHECK(lm628_init(nullptr, &port.port) == LM628_ERROR_NULL);
  CHECK(lm628_init(&none, nullptr) == LM628_ERROR_NULL);
  for (int missing = 0; missing < 3; ++missing) {
    lm628_port bad = port.port;
    if (missing == 0) bad.write = nullptr;
    if (missing == 1) bad.read = nullptr;
    if (missing == 2) bad.wait_us = nullptr;
    lm628_device part{&port.port, 1};
    CHECK(lm628_init(&part, &bad) == LM628_ERROR_NULL);
    CHECK(lm628_start(&part) == LM628_ERROR_NULL);
  }
}

TEST_CASE("lm628 driver has a text for each error, and for what is none") {
  std::vector<std::string> texts;
  for (int error = LM628_OK; error <= LM628_ERROR_COMMAND + 1; ++error) {
    texts.emplace_back(lm628_error_text(static_cast<lm628_error>(error)));
    CHECK_FALSE(texts.back().empty());
    CHECK_THAT(texts.back(), !Catch::Contains("\n"));
  }
  std::sort(texts.begin(), texts.end());
  CHECK(std::unique(texts.begin(), texts.end()) == texts.end());
}
