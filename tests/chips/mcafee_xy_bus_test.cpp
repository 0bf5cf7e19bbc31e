// SPDX-License-Identifier: Apache-2.0
//
// The bus of mcafee_xy as AXI4-Lite has it, and what a reset leaves.
#include <Vmcafee_xy.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "rtl/chips/generated/mcafee_xy_regs.hpp"
#include "tests/support/axi_lite.hpp"
#include "tests/support/rtl.hpp"

namespace reg = trammel::mcafee_xy_regs;
using trammel::test::AxiLiteTraffic;

namespace {

using Chip = trammel::test::Rtl<Vmcafee_xy>;

// Encoders at rest.
class Bench {
 public:
  Bench() {
    chip_->leap_i = 0;
    chip_->s_axil_awvalid_i = chip_->s_axil_wvalid_i = chip_->s_axil_arvalid_i = 0;
    chip_->s_axil_bready_i = chip_->s_axil_rready_i = 1;
    chip_->s_axil_awprot_i = chip_->s_axil_arprot_i = 0;
    chip_->enc_a_i = chip_->enc_b_i = chip_->limit_i = 0;
    chip_->enc_idx_n_i = 3;
    chip_.reset();
  }

  Chip& chip() { return chip_; }
  auto traffic(std::uint32_t seed) {
    const auto clock = [this] { chip_.tick(); };
    return AxiLiteTraffic<Chip, decltype(clock)>(chip_, clock, seed);
  }

 private:
  Chip chip_;
};

}  // namespace

TEST_CASE("mcafee_xy takes bytes, in any order of the channels, and answers each transfer") {
  Bench bench;
  auto traffic = bench.traffic(94);
  // PORT_C reads another byte than the one written.
  const auto registers = trammel::test::kept_registers(reg::kRegisters, {reg::kPortC});
  REQUIRE(registers.size() == 3);
  CHECK(wrong_register(traffic, registers, 400, 95) == "");
}

TEST_CASE("mcafee_xy reads 0 where no register is, and writes nothing there") {
  Bench bench;
  auto traffic = bench.traffic(96);
  traffic.write({{reg::kPortB, 0x14, 15}, {0x24, ~0u, 15}, {0x34, ~0u, 15}, {0x3C, ~0u, 15}});
  CHECK(traffic.read({0x24, 0x28, 0x2C, 0x30, 0x34, 0x38, 0x3C, reg::kPortB, reg::kId}) ==
        std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 0x14, reg::kIdValue});
}

TEST_CASE("mcafee_xy: a reset ends a feed rate, done or not") {
  for (const int clocks : {0, 5, 60}) {
    CAPTURE(clocks);
    Bench bench;
    auto traffic = bench.traffic(97);
    traffic.write({{reg::kFeedIn, 0x2010, 3}});
    for (int n = 0; n < clocks; ++n) bench.chip().tick();
    bench.chip()->rst_i = 1;
    for (int n = 0; n < 2; ++n) bench.chip().tick();
    bench.chip()->rst_i = 0;
    for (int n = 0; n < 60; ++n) bench.chip().tick();
    CHECK(traffic.read({reg::kFeedOut, reg::kFeedIn}) == std::vector<std::uint32_t>{0, 0});
  }
}

TEST_CASE("mcafee_xy: a strobe starts a pulse only by a write of its byte") {
  Bench bench;
  auto traffic = bench.traffic(98);
  for (const std::uint32_t strobes : {0xEu, 0x1u}) {
    traffic.write({{reg::kPortB, reg::kPortBWriteStrobe, strobes}});
    int low = 0;
    for (int n = 0; n < 400; ++n) {
      bench.chip().tick();
      low += !bench.chip()->wr_n_o;
    }
    CHECK((low > 0) == (strobes == 1));
  }
}
