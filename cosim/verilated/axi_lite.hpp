// SPDX-License-Identifier: Apache-2.0
//
// The master of a verilated chip's AXI4-Lite port s_axil: one transfer at a time, always ready for
// its response. It holds no model, so that a copy can continue with another one.
#pragma once

#include <cstdint>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

class AxiLiteMaster {
 public:
  bool active() const { return active_; }
  std::uint32_t rdata() const { return rdata_; }  // of the last read

  // Before time zero.
  template <class Model>
  void reset(Model& m) {
    m.s_axil_awvalid_i = m.s_axil_wvalid_i = m.s_axil_arvalid_i = 0;
    m.s_axil_awaddr_i = m.s_axil_araddr_i = 0;
    m.s_axil_awprot_i = m.s_axil_arprot_i = 0;
    m.s_axil_wdata_i = 0;
    m.s_axil_wstrb_i = 0xf;
    m.s_axil_bready_i = 1;
    m.s_axil_rready_i = 1;
  }

  template <class Model>
  void request(Model& m, const BusOp& op) {
    if (op.write) {
      put(m.s_axil_awaddr_i, op.addr);
      m.s_axil_wdata_i = op.data;
      m.s_axil_awvalid_i = 1;
      m.s_axil_wvalid_i = 1;
    } else {
      put(m.s_axil_araddr_i, op.addr);
      m.s_axil_arvalid_i = 1;
    }
    active_ = true;
  }

  // Looks at the handshakes that the next rising edge completes: ready and valid settle before it.
  template <class Model>
  void before_edge(const Model& m) {
    aw_ = m.s_axil_awvalid_i && m.s_axil_awready_o;
    w_ = m.s_axil_wvalid_i && m.s_axil_wready_o;
    ar_ = m.s_axil_arvalid_i && m.s_axil_arready_o;
    b_ = m.s_axil_bvalid_o != 0;
    r_ = m.s_axil_rvalid_o != 0;
    if (r_) rdata_ = m.s_axil_rdata_o;
  }

  // Takes the handshakes of the edge just executed; true when the transfer ended.
  template <class Model>
  bool after_edge(Model& m) {
    if (aw_) m.s_axil_awvalid_i = 0;
    if (w_) m.s_axil_wvalid_i = 0;
    if (ar_) m.s_axil_arvalid_i = 0;
    active_ = !b_ && !r_;
    return !active_;
  }

 private:
  template <class Pin>
  static void put(Pin& pin, std::uint32_t address) {
    pin = static_cast<Pin>(address);  // as wide as the chip's map
  }

  bool active_ = false;
  bool aw_ = false, w_ = false, ar_ = false, b_ = false, r_ = false;
  std::uint32_t rdata_ = 0;
};

}  // namespace trammel::cosim
