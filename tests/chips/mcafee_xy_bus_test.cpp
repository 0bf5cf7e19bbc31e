// SPDX-License-Identifier: Apache-2.0
//
// The bus of mcafee_xy as AXI4-Lite has it, and what a reset leaves.
#include <Vmcafee_xy.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "rtl/chips/generated/mcafee_xy_regs.hpp"
#include "tests/support/axi_lite.hpp"
#include "tests/support/rtl.hpp"

namespace reg = trammel::mcafee_xy_regs;
using trammel::test::AxiLiteTraffic;

namespace {

using Chip = trammel::test::Rtl<Vmcafee_xy>;

// Encoders at rest.
class BusBench {
 public:
  BusBench() {
    chip_->leap_i = 0;
    chip_->s_axil_awvalid_i = chip_->s_axil_wvalid_i = chip_->s_axil_arvalid_i = 0;
    chip_->s_axil_bready_i = chip_->s_axil_rready_i = 1;
    chip_->s_axil_awprot_i = chip_->s_axil_arprot_i = 0;
    chip_->enc_a_i = chip_->enc_b_i = chip_->limit_i = 0;
    chip_->enc_idx_n_i = 3;
    chip_.reset();
  }

  Chip& chip() { return chip_; }
  void clocks(int n) {
    for (int i = 0; i < n; ++i) chip_.tick();
  }
  // Clocks until it holds, leaping.
  template <class Condition>
  std::int64_t until(Condition condition) {
    std::int64_t clocks = 0;
    for (chip_.eval(); clocks == 0 || !condition(); chip_.eval()) {
      if (clocks > 200000) throw std::runtime_error("the chip never came there");
      const unsigned more = chip_->quiescent_o && chip_->next_o > 0 ? chip_->next_o - 1u : 0u;
      chip_->leap_i = static_cast<std::uint16_t>(more);
      chip_.tick();
      chip_->leap_i = 0;
      clocks += 1 + more;
    }
    return clocks;
  }
  auto traffic(std::uint32_t seed) {
    const auto clock = [this] { chip_.tick(); };
    return AxiLiteTraffic<Chip, decltype(clock)>(chip_, clock, seed);
  }

 private:
  Chip chip_;
};

}  // namespace

TEST_CASE("mcafee_xy takes bytes, in any order of the channels, and answers each transfer") {
  BusBench bench;
  auto traffic = bench.traffic(94);
  // PORT_C reads another byte than the one written.
  const auto registers = trammel::test::kept_registers(reg::kRegisters, {reg::kPortC});
  REQUIRE(registers.size() == 3);
  CHECK(wrong_register(traffic, registers, 400, 95) == "");
}

TEST_CASE("mcafee_xy reads 0 where no register is, and writes nothing there") {
  BusBench bench;
  auto traffic = bench.traffic(96);
  traffic.write({{reg::kPortB, 0x14, 15}, {0x24, ~0u, 15}, {0x34, ~0u, 15}, {0x3C, ~0u, 15}});
  CHECK(traffic.read({0x24, 0x28, 0x2C, 0x30, 0x34, 0x38, 0x3C, reg::kPortB, reg::kId}) ==
        std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 0x14, reg::kIdValue});
}

TEST_CASE("mcafee_xy: a reset ends a feed rate, done or not") {
  for (const int clocks : {0, 5, 60}) {
    CAPTURE(clocks);
    BusBench bench;
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
  BusBench bench;
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

TEST_CASE("mcafee_xy: a reset leaves in every register the value of the specification") {
  // McAfee 1994, chapter VI, and rtl/chips/mcafee_xy.rdl. All others are 0: no limit is reached.
  const std::map<std::string, std::uint32_t> values{{"ID", 0x4D430001}};  // "MC", version 1
  for (const bool used : {false, true}) {
    BusBench bench;
    auto traffic = bench.traffic(99);
    if (used) {  // not those of the power-on
      std::vector<trammel::test::AxiWrite> writes;
      for (const reg::Register& one : reg::kRegisters) {
        if (one.cleared == 0) writes.push_back({one.address, ~0u, 15});
      }
      traffic.write(writes);
      bench.clocks(700);
      CHECK(traffic.read({reg::kPortB, reg::kFeedIn, reg::kStatus}) ==
            std::vector<std::uint32_t>{0x1F, 0xFFFF, reg::kStatusRefused});
      bench.chip().reset();
    }
    for (const reg::Register& one : reg::kRegisters) {
      const auto found = values.find(one.name);
      CAPTURE(used, one.name);
      CHECK(traffic.read({one.address})[0] == (found == values.end() ? 0 : found->second));
    }
  }
}

TEST_CASE("mcafee_xy: only the written byte of PORT_C goes to the part, FEED_IN starts by its c") {
  BusBench bench;
  auto traffic = bench.traffic(100);
  for (std::uint32_t strobes = 0; strobes < 16; ++strobes) {
    CAPTURE(strobes);
    const bool low = (strobes & 1) != 0;
    traffic.write({{reg::kPortC, 0xA5, 15}, {reg::kPortC, 0xFFFFFF5A, strobes}});
    bench.clocks(4);
    CHECK(bench.chip()->d_o == (low ? 0x5A : 0xA5));
    traffic.write({{reg::kFeedIn, 0x1020, 15}});
    bench.clocks(30);
    traffic.write({{reg::kFeedIn, 0x1020, strobes & 0xD}});
    CHECK((traffic.read({reg::kFeedOut})[0] >> 31 == 0) == low);
    bench.clocks(30);
  }
}

TEST_CASE("mcafee_xy: a sticky bit is cleared by a 1 in its byte, and no other bit is") {
  for (const std::uint32_t bit : {reg::kStatusRefused, reg::kStatusSample}) {
    for (std::uint32_t strobes = 0; strobes < 16; ++strobes) {
      CAPTURE(bit, strobes);
      BusBench bench;
      auto traffic = bench.traffic(101);
      bench.until([&] { return bench.chip()->sample_o == 3; });
      // RD against the direction of a write.
      traffic.write({{reg::kPortB, reg::kPortBReadStrobe, 1}, {reg::kPortB, 0, 1}});
      const std::uint32_t both = reg::kStatusRefused | reg::kStatusSample;
      REQUIRE(traffic.read({reg::kStatus})[0] == both);
      traffic.write({{reg::kStatus, ~bit, 15}, {reg::kStatus, bit, strobes}});
      const bool cleared = (strobes & 1) != 0;
      CHECK(traffic.read({reg::kStatus})[0] == (cleared ? 0 : bit));
    }
  }
}

TEST_CASE("mcafee_xy: RESET pulls RST low by a 1 in its byte only, for 80 clocks of both parts") {
  for (std::uint32_t strobes = 0; strobes < 16; ++strobes) {
    for (const std::uint32_t data : {~0u, ~1u}) {
      CAPTURE(strobes, data);
      BusBench bench;
      auto traffic = bench.traffic(102);
      const std::int64_t first = bench.until([&] { return bench.chip()->sample_o != 0; });
      traffic.write({{reg::kReset, data, strobes}});
      const std::int64_t next = bench.until([&] { return bench.chip()->sample_o != 0; });
      CHECK(bench.chip()->sample_o == 3);
      // The reset routine takes as long as the first one; a sample is some 17 067 clocks.
      CHECK((next > first) == ((strobes & data & 1) != 0));
    }
  }
}
