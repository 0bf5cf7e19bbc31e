// SPDX-License-Identifier: Apache-2.0
//
// Accesses beside parts/lm628/host_port.hpp, which has the data sheet's times in clocks of 20 ns.

#include <Vlm628_host.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "parts/lm628/host_port.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

using trammel::lm628::HostPins;
using trammel::lm628::HostPort;
using trammel::test::Random;
using trammel::test::same;
namespace map = trammel::sw::lm628_map;

namespace {

struct Bench {
  trammel::test::Rtl<Vlm628_host> rtl;
  HostPort port;
  Random random{91};
  std::int64_t clock = 0;
  std::uint8_t given = 0;  // by the part, at the end of RD

  Bench() {
    rtl->start_i = 0;
    rtl.reset();
  }

  // An edge, with random inputs where they must not matter.
  void edge(bool start) {
    rtl->start_i = start;
    rtl->write_i = random() % 2;
    rtl->ps_i = random() % 2;
    rtl->byte_i = random() & 0xFF;
    rtl->d_i = random() & 0xFF;
    rtl.eval();
    const bool begins = start && !port.active();
    const trammel::cosim::BusOp op{rtl->ps_i != 0 ? map::kData : map::kCommand, rtl->byte_i,
                                   rtl->write_i != 0};
    same("busy_o", rtl->busy_o, port.active(), clock);
    same("quiescent_o", rtl->quiescent_o, !start && !port.active(), clock);
    if (port.takes_data()) given = rtl->d_i;
    const bool was_done = rtl->done_o != 0;
    const bool active = port.active();
    same("done_o", was_done, active && port.advance(), clock);
    if (begins) port.request(op);
    rtl.tick();
    ++clock;
    const HostPins pins = port.pins();
    same("rd_n_o", rtl->rd_n_o, pins.rd_n, clock);
    same("wr_n_o", rtl->wr_n_o, pins.wr_n, clock);
    same("byte_o", rtl->byte_o, given, clock);
    same("cs_n_o", rtl->cs_n_o, !port.active(), clock);
    same("drive_o", rtl->drive_o, port.active() && port.op().write, clock);
    if (!port.active()) return;
    same("ps_o", rtl->ps_o, pins.ps, clock);
    same("d_o", rtl->d_o, pins.d, clock);
  }
};

}  // namespace

TEST_CASE("lm628_host has the data sheet's pins over random accesses, starts while busy, resets") {
  Bench bench;
  for (int i = 0; i < 40'000; ++i) {
    bench.edge(bench.random() % 4 == 0);
    if (bench.random() % 2000 == 0) {
      bench.rtl.reset();
      bench.port = {};
      bench.given = 0;
    }
  }
}

TEST_CASE("lm628_host takes 13 clocks of 20 ns for a write and 20 for a read") {
  Bench bench;
  for (const bool write : {true, false}) {
    bench.rtl->start_i = 1;
    bench.rtl->write_i = write;
    bench.rtl.eval();
    int clocks = 0, low = 0;
    do {
      bench.rtl.tick();
      ++clocks;
      low += bench.rtl->wr_n_o == 0 || bench.rtl->rd_n_o == 0 ? 1 : 0;
    } while (bench.rtl->done_o == 0);
    CHECK(clocks == (write ? 13 : 20));
    CHECK(low == (write ? 5 : 9));
    bench.rtl->start_i = 0;
    bench.rtl.tick();
    CHECK(bench.rtl->busy_o == 0);
  }
}
