// SPDX-License-Identifier: Apache-2.0
//
// Random requests to a slave that accepts and answers when it likes.

#include <Vaxil_master.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::test::Random;

namespace {

struct Bench {
  trammel::test::Rtl<Vaxil_master> rtl;
  Random random{61};
  // What the slave has accepted and not answered.
  bool aw = false, w = false, ar = false;
  std::uint32_t address = 0, data = 0, strobes = 0;

  Bench() {
    rtl->valid_i = 0;
    rtl->addr_i = 0;
    rtl->wstrb_i = 0;
    rtl->wdata_i = 0;
    slave(false);
    rtl.reset();
  }

  void slave(bool eager) {
    const auto may = [&] { return eager || random() % 3 == 0; };
    rtl->m_axil_awready_i = may();
    rtl->m_axil_wready_i = may();
    rtl->m_axil_arready_i = may();
    rtl->m_axil_bvalid_i = aw && w && may();
    rtl->m_axil_rvalid_i = ar && may();
    rtl->m_axil_rdata_i = static_cast<std::uint32_t>(random());
  }

  static void require(bool good, const std::string& what) {
    if (!good) throw std::logic_error(what);
  }

  // One access; clocks that it took.
  int access(std::uint32_t to, unsigned lanes, std::uint32_t word, bool eager) {
    rtl->valid_i = 1;
    rtl->addr_i = static_cast<std::uint16_t>(to);
    rtl->wstrb_i = static_cast<std::uint8_t>(lanes);
    rtl->wdata_i = word;
    aw = w = ar = false;
    for (int clocks = 1; clocks < 1000; ++clocks) {
      slave(eager);
      rtl.eval();
      require(rtl->m_axil_bready_o != 0 && rtl->m_axil_rready_o != 0, "a response would wait");
      require(rtl->m_axil_awvalid_o == (lanes != 0 && !aw), "AWVALID");
      require(rtl->m_axil_wvalid_o == (lanes != 0 && !w), "WVALID");
      require(rtl->m_axil_arvalid_o == (lanes == 0 && !ar), "ARVALID");
      require(rtl->m_axil_awprot_o == 0 && rtl->m_axil_arprot_o == 0, "PROT");
      if (rtl->m_axil_awvalid_o && rtl->m_axil_awready_i) {
        aw = true;
        address = rtl->m_axil_awaddr_o;
      }
      if (rtl->m_axil_wvalid_o && rtl->m_axil_wready_i) {
        w = true;
        data = rtl->m_axil_wdata_o;
        strobes = rtl->m_axil_wstrb_o;
      }
      if (rtl->m_axil_arvalid_o && rtl->m_axil_arready_i) {
        ar = true;
        address = rtl->m_axil_araddr_o;
      }
      const bool done = rtl->m_axil_bvalid_i || rtl->m_axil_rvalid_i;
      require((rtl->ready_o != 0) == done, "ready_o");
      const bool read = done && lanes == 0;
      require(!read || rtl->rdata_o == rtl->m_axil_rdata_i, "the word read");
      rtl.tick();
      if (!done) continue;
      require(address == to, "the address");
      require(lanes == 0 || (data == word && strobes == lanes), "the word written");
      rtl->valid_i = 0;
      return clocks;
    }
    throw std::logic_error("no answer");
  }
};

}  // namespace

TEST_CASE("axil_master makes each access one transfer of the bus, whatever the slave's pace") {
  Bench bench;
  for (int i = 0; i < 5000; ++i) {
    const unsigned lanes = bench.random() % 2 == 0 ? 0 : 1 + bench.random() % 15;
    bench.access(bench.random() % 1024, lanes, static_cast<std::uint32_t>(bench.random()), false);
    for (auto idle = bench.random() % 3; idle > 0; --idle) {
      bench.slave(false);
      bench.rtl->wstrb_i = bench.random() % 16;
      bench.rtl->m_axil_bvalid_i = bench.rtl->m_axil_rvalid_i = 0;
      bench.rtl.eval();
      CHECK(bench.rtl->m_axil_awvalid_o == 0);
      CHECK(bench.rtl->m_axil_wvalid_o == 0);
      CHECK(bench.rtl->m_axil_arvalid_o == 0);
      CHECK(bench.rtl->ready_o == 0);
      bench.rtl.tick();
    }
  }
}

TEST_CASE("axil_master adds no clock to a slave that answers in the clock after the request") {
  Bench bench;
  CHECK(bench.access(0x104, 0xF, 0xCAFE, true) == 2);
  CHECK(bench.access(0x104, 0, 0, true) == 2);
}

TEST_CASE("axil_master forgets a request in a reset") {
  Bench bench;
  bench.rtl->valid_i = 1;
  bench.rtl->wstrb_i = 0xF;
  bench.rtl->m_axil_awready_i = bench.rtl->m_axil_wready_i = 1;
  bench.rtl.tick();
  CHECK(bench.rtl->m_axil_awvalid_o == 0);
  bench.rtl.reset();
  CHECK(bench.rtl->m_axil_awvalid_o == 1);
  CHECK(bench.rtl->m_axil_wvalid_o == 1);
}
