// SPDX-License-Identifier: Apache-2.0
//
// A master of a chip's AXI4-Lite port s_axil whose channels come late, for a chip beside its twin.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "tests/support/axi_failure.hpp"
#include "tests/support/random.hpp"

namespace trammel::test {

// One transfer at a time, with channels that come late by so many clocks: address, data, and the
// readiness for the response. The chip sees the request when the last of address and data is there.
struct AxiPace {
  int address = 0, data = 0, answer = 0;
  std::uint32_t strobes = 15;

  static AxiPace random(Random& random, bool whole) {
    const auto late = [&random] { return random() % 3 == 0 ? static_cast<int>(random() % 6) : 0; };
    AxiPace pace;
    pace.address = late();
    pace.data = late();
    pace.answer = random() % 3 == 0 ? static_cast<int>(random() % 20) : 0;
    if (!whole) pace.strobes = random() % 16;
    return pace;
  }
  std::uint32_t bits() const {
    std::uint32_t all = 0;
    for (unsigned byte = 0; byte < 4; ++byte) all |= (strobes >> byte & 1) * (0xFFu << 8 * byte);
    return all;
  }
};

class PacedMaster {
 public:
  bool active() const { return active_; }
  std::uint32_t rdata() const { return rdata_; }  // of the last read

  template <class Model>
  void reset(Model& m) {
    active_ = false;
    m.s_axil_awvalid_i = m.s_axil_wvalid_i = m.s_axil_arvalid_i = 0;
    m.s_axil_awaddr_i = m.s_axil_araddr_i = 0;
    m.s_axil_awprot_i = m.s_axil_arprot_i = 0;
    m.s_axil_wdata_i = 0;
    m.s_axil_wstrb_i = 15;
    m.s_axil_bready_i = m.s_axil_rready_i = 1;
  }

  void request(std::uint32_t address, std::uint32_t data, bool write, const AxiPace& pace) {
    address_ = address;
    data_ = data;
    write_ = write;
    pace_ = pace;
    clock_ = 0;
    active_ = true;
  }

  // Before each edge of the transfer; true where the request is whole from this edge on.
  template <class Model>
  bool before_edge(Model& m) {
    if (write_) {
      if (clock_ == pace_.address) {
        put(m.s_axil_awaddr_i, address_);
        m.s_axil_awvalid_i = 1;
      }
      if (clock_ == pace_.data) {
        m.s_axil_wdata_i = data_;
        put(m.s_axil_wstrb_i, pace_.strobes);
        m.s_axil_wvalid_i = 1;
      }
    } else if (clock_ == pace_.address) {
      put(m.s_axil_araddr_i, address_);
      m.s_axil_arvalid_i = 1;
    }
    m.s_axil_bready_i = m.s_axil_rready_i = clock_ >= pace_.answer;
    m.eval();
    aw_ = m.s_axil_awvalid_i && m.s_axil_awready_o;
    w_ = m.s_axil_wvalid_i && m.s_axil_wready_o;
    ar_ = m.s_axil_arvalid_i && m.s_axil_arready_o;
    if ((m.s_axil_bvalid_o && (!write_ || m.s_axil_bresp_o != 0)) ||
        (m.s_axil_rvalid_o && (write_ || m.s_axil_rresp_o != 0))) {
      fail_transfer(write_, address_,
                    "an answer that is not OKAY, or not to it: BVALID " + text(m.s_axil_bvalid_o) +
                        ", BRESP " + text(m.s_axil_bresp_o) + ", RVALID " +
                        text(m.s_axil_rvalid_o) + ", RRESP " + text(m.s_axil_rresp_o), clock_);
    }
    ends_ = (m.s_axil_bvalid_o && m.s_axil_bready_i) || (m.s_axil_rvalid_o && m.s_axil_rready_i);
    if (ends_ && !write_) rdata_ = m.s_axil_rdata_o;
    return clock_ == (write_ ? std::max(pace_.address, pace_.data) : pace_.address);
  }

  // True when the transfer ended by the edge.
  template <class Model>
  bool after_edge(Model& m) {
    if (aw_) m.s_axil_awvalid_i = 0;
    if (w_) m.s_axil_wvalid_i = 0;
    if (ar_) m.s_axil_arvalid_i = 0;
    if (++clock_ > 1000) {
      fail_transfer(write_, address_,
                    waits_on(write_, !m.s_axil_awvalid_i && !m.s_axil_arvalid_i,
                             !m.s_axil_wvalid_i), clock_);
    }
    active_ = !ends_;
    if (ends_) m.s_axil_bready_i = m.s_axil_rready_i = 1;
    return ends_;
  }

 private:
  static std::string text(unsigned value) { return std::to_string(value); }

  template <class Pin>
  static void put(Pin& pin, std::uint32_t value) {
    pin = static_cast<Pin>(value);
  }

  std::uint32_t address_ = 0, data_ = 0, rdata_ = 0;
  bool write_ = false, active_ = false, aw_ = false, w_ = false, ar_ = false, ends_ = false;
  AxiPace pace_;
  int clock_ = 0;
};

}  // namespace trammel::test
