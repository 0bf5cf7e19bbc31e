// SPDX-License-Identifier: Apache-2.0
//
// A part that is always ready, with a status set by the test, stands in for the LM628; and a
// program of AN-693 on it.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "sw_nios/apps/an693/an693.hpp"
#include "tests/support/port_byte.hpp"

namespace trammel::an693_test {

using namespace trammel::sw;

// Writes as text: c 1F, d 00, and R for a strobe of RST.
class FakePart final : public Bus {
 public:
  std::string log;
  std::uint32_t irq = 0;
  std::uint32_t timer = 0;
  std::deque<std::uint8_t> states;  // status of the next reads; the last one stays
  std::deque<std::uint8_t> reply;   // bytes of the next replies; then 00
  std::uint32_t busy_polls = 0;     // of every command and word
  std::uint32_t written_busy = 0;   // commands and words that came while it was busy

  std::uint32_t read(std::uint32_t addr) override {
    if (addr == lm628_map::kIrq) return irq;
    if (addr == lm628_map::kData) {
      if (reply.empty()) return 0;
      const std::uint8_t byte = reply.front();
      reply.pop_front();
      return byte;
    }
    if (busy_ > 0) {
      --busy_;
      return lm628_status::kBusy;
    }
    const std::uint8_t status = states.front();
    if (states.size() > 1) states.pop_front();
    return status;
  }

  void write(std::uint32_t addr, std::uint32_t data) override {
    if (addr == lm628_map::kTimer) {
      timer = data;
      return;
    }
    if (addr == lm628_map::kReset) {
      log += "R ";
      return;
    }
    const bool is_data = addr == lm628_map::kData;
    log += test::port_byte(is_data ? 'd' : 'c', data) + ' ';
    second_ = is_data && !second_;
    if (busy_ > 0) ++written_busy;
    if (!second_) busy_ = busy_polls;
  }

 private:
  bool second_ = false;  // the first byte of a word was written
  std::uint32_t busy_ = 0;
};

inline constexpr const char* kInit = "c06 c1D d00 d00 ";
inline constexpr const char* kFilter = "c1E d00 d08 d00 d0A c04 ";

struct Bench {
  FakePart part;
  An693App app;

  explicit Bench(const An693Setup& setup) : app(setup) {
    part.states = {0x84, 0x80};
    app.start(part);
    part.log.clear();
  }
  std::string on_timer() { return interrupt(lm628_map::kIrqTimer); }
  std::string on_host(std::uint8_t status) {
    part.states = {status, 0x80};
    return interrupt(lm628_map::kIrqHost);
  }

 private:
  std::string interrupt(std::uint32_t cause) {
    part.log.clear();
    part.irq = cause;
    app.isr(part);
    return part.log;
  }
};

inline An693Failure failure_of(const An693App& app) {
  return static_cast<An693Failure>(app.mailbox().failure);
}

inline An693Setup make_setup(An693Program program) {
  An693Setup setup;
  setup.program = program;
  return setup;
}

}  // namespace trammel::an693_test
