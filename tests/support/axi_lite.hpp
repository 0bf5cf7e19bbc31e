// SPDX-License-Identifier: Apache-2.0
//
// A master of a chip's AXI4-Lite port s_axil that drives each channel independently: address, data
// and readiness for responses come at random, in any order, with as many transfers open at once as
// the chip accepts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/axi_failure.hpp"
#include "tests/support/random.hpp"

namespace trammel::test {

struct AxiWrite {
  std::uint32_t address, data, strobes;
};

// Clock: executes one rising edge and evaluates after it.
template <class Chip, class Clock>
class AxiLiteTraffic {
 public:
  AxiLiteTraffic(Chip& chip, Clock clock, std::uint32_t seed)
      : chip_(chip), clock_(clock), random_(seed) {}

  // Until all are answered; throws at an answer other than OKAY, or when none comes.
  void write(const std::vector<AxiWrite>& writes) {
    std::size_t address = 0, data = 0, answered = 0;
    for (int clocks = 0; answered < writes.size(); ++clocks) {
      if (late(clocks, writes.size())) {
        fail_transfer(true, writes[answered].address,
                      waits_on(true, answered < address, answered < data), clocks);
      }
      if (!chip_->s_axil_awvalid_i && address < writes.size() && random_() % 2 == 0) {
        put(chip_->s_axil_awaddr_i, writes[address].address);
        chip_->s_axil_awvalid_i = 1;
      }
      if (!chip_->s_axil_wvalid_i && data < writes.size() && random_() % 2 == 0) {
        chip_->s_axil_wdata_i = writes[data].data;
        put(chip_->s_axil_wstrb_i, writes[data].strobes);
        chip_->s_axil_wvalid_i = 1;
      }
      chip_->s_axil_bready_i = random_() % 4 == 0;
      chip_->eval();
      const bool aw = chip_->s_axil_awvalid_i && chip_->s_axil_awready_o;
      const bool w = chip_->s_axil_wvalid_i && chip_->s_axil_wready_o;
      const bool b = chip_->s_axil_bready_i && chip_->s_axil_bvalid_o;
      if (chip_->s_axil_bvalid_o && chip_->s_axil_bresp_o != 0) {
        fail_transfer(true, writes[answered].address, not_okay("BRESP", chip_->s_axil_bresp_o),
                      clocks);
      }
      clock_();
      if (aw) chip_->s_axil_awvalid_i = 0, ++address;
      if (w) chip_->s_axil_wvalid_i = 0, ++data;
      if (b) ++answered;
    }
    chip_->s_axil_bready_i = 1;
  }

  std::vector<std::uint32_t> read(const std::vector<std::uint32_t>& addresses) {
    std::size_t address = 0;
    std::vector<std::uint32_t> values;
    for (int clocks = 0; values.size() < addresses.size(); ++clocks) {
      if (late(clocks, addresses.size())) {
        fail_transfer(false, addresses[values.size()],
                      waits_on(false, values.size() < address, true), clocks);
      }
      if (!chip_->s_axil_arvalid_i && address < addresses.size() && random_() % 2 == 0) {
        put(chip_->s_axil_araddr_i, addresses[address]);
        chip_->s_axil_arvalid_i = 1;
      }
      chip_->s_axil_rready_i = random_() % 4 == 0;
      chip_->eval();
      const bool ar = chip_->s_axil_arvalid_i && chip_->s_axil_arready_o;
      const bool r = chip_->s_axil_rready_i && chip_->s_axil_rvalid_o;
      if (chip_->s_axil_rvalid_o && chip_->s_axil_rresp_o != 0) {
        fail_transfer(false, addresses[values.size()],
                      not_okay("RRESP", chip_->s_axil_rresp_o), clocks);
      }
      if (r) values.push_back(chip_->s_axil_rdata_o);
      clock_();
      if (ar) chip_->s_axil_arvalid_i = 0, ++address;
    }
    chip_->s_axil_rready_i = 1;
    return values;
  }

 private:
  // As wide as the chip's pin.
  template <class Pin>
  static void put(Pin& pin, std::uint32_t value) {
    pin = static_cast<Pin>(value);
  }

  static std::string not_okay(const char* pin, unsigned value) {
    return pin + (" is " + std::to_string(value)) + ", not OKAY";
  }

  static bool late(int clocks, std::size_t transfers) {
    return clocks > 100 * static_cast<int>(transfers + 1);
  }

  Chip& chip_;
  Clock clock_;
  Random random_;
};

// A register that holds what is written to its bits `mask`, to each of its bytes alone.
struct AxiRegister {
  const char* name;
  std::uint32_t address, mask;
};

// Those of a chip's list kRegisters that read as they were written, but for `others`; and its ID,
// which keeps nothing.
template <class Registers>
std::vector<AxiRegister> kept_registers(const Registers& registers,
                                        const std::vector<std::uint32_t>& others = {}) {
  std::vector<AxiRegister> kept;
  for (const auto& one : registers) {
    const bool left_out =
        std::find(others.begin(), others.end(), one.address) != others.end();
    const bool id = std::string(one.name) == "ID";
    if (id || (one.written != 0 && !left_out)) kept.push_back({one.name, one.address, one.written});
  }
  return kept;
}

// Random bytes of random registers are written, and all are read: each holds what was written to it
// alone. Says of the first that does not where it is, what it shows and what it should; else "".
template <class Traffic>
std::string wrong_register(Traffic& traffic, const std::vector<AxiRegister>& registers, int rounds,
                            std::uint32_t seed) {
  Random random(seed);
  std::vector<std::uint32_t> addresses, held;
  for (const AxiRegister& one : registers) addresses.push_back(one.address);
  held = traffic.read(addresses);
  for (int round = 0; round < rounds; ++round) {
    std::vector<AxiWrite> writes;
    for (unsigned n = 1 + random() % 8; n > 0; --n) {
      const std::size_t which = random() % registers.size();
      const AxiWrite one{registers[which].address, random(), random() % 16};
      std::uint32_t bits = 0;
      for (unsigned byte = 0; byte < 4; ++byte) {
        if ((one.strobes >> byte & 1) != 0) bits |= 0xFFu << 8 * byte;
      }
      bits &= registers[which].mask;
      held[which] = (held[which] & ~bits) | (one.data & bits);
      writes.push_back(one);
    }
    traffic.write(writes);
    const std::vector<std::uint32_t> values = traffic.read(addresses);
    for (std::size_t n = 0; n < values.size(); ++n) {
      if (values[n] == held[n]) continue;
      char text[120];
      std::snprintf(text, sizeof text, "%s (0x%03X) reads 0x%08X, not 0x%08X, in round %d",
                    registers[n].name, addresses[n], values[n], held[n], round);
      return text;
    }
  }
  return "";
}

}  // namespace trammel::test
