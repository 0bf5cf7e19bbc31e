// SPDX-License-Identifier: Apache-2.0
//
// Bits of STATUS of mcafee_xy that events set and a write of 1 clears. A strobe is refused in the
// clock behind the write that asks for it: only transfers that do not wait for each other's answer
// come that close, and those are for the RTL alone. Its twin takes one at a time.
#include <catch2/catch.hpp>

#include <cstdint>
#include <vector>

#include "tests/chips/mcafee_bench.hpp"
#include "tests/support/flags.hpp"

using trammel::test::clears_what_a_new_bench_shows;
using trammel::test::McafeePair;
namespace reg = trammel::mcafee_xy_regs;
using Bench = trammel::test::McafeeBench<McafeePair>;

TEST_CASE("mcafee_xy: a sample in the very clock of the write that clears its bit is kept") {
  std::int64_t first = 0;  // [clk] since the reset
  {
    Bench bench;
    bench.sample();
    first = bench.now();
  }
  clears_what_a_new_bench_shows<Bench>(
      first - 8, first + 20, [](Bench& bench, std::int64_t n) { bench.clocks(n); },
      [](Bench& bench) { return (bench.read(reg::kStatus) & reg::kStatusSample) != 0; },
      [](Bench& bench) { bench.write(reg::kStatus, reg::kStatusSample); });
}

namespace {

// A master that offers one request at a clock, which an idle bus takes at the next edge.
class Hasty {
 public:
  Hasty() {
    chip_->leap_i = 0;
    chip_->s_axil_awvalid_i = chip_->s_axil_wvalid_i = chip_->s_axil_arvalid_i = 0;
    chip_->s_axil_bready_i = chip_->s_axil_rready_i = 1;
    chip_->s_axil_awprot_i = chip_->s_axil_arprot_i = 0;
    chip_->s_axil_wstrb_i = 15;
    chip_->enc_a_i = chip_->enc_b_i = chip_->limit_i = 0;
    chip_->enc_idx_n_i = 3;
    chip_.reset();
  }
  void clocks(std::int64_t n) {
    for (std::int64_t i = 0; i < n; ++i) chip_.tick();
  }
  void write(std::uint32_t address, std::uint32_t data) {
    chip_->s_axil_awaddr_i = static_cast<std::uint8_t>(address);
    chip_->s_axil_wdata_i = data;
    chip_->s_axil_awvalid_i = chip_->s_axil_wvalid_i = 1;
    chip_.eval();
    REQUIRE((chip_->s_axil_awready_o && chip_->s_axil_wready_o));
    chip_.tick();
    chip_->s_axil_awvalid_i = chip_->s_axil_wvalid_i = 0;
  }
  std::uint32_t read(std::uint32_t address) {
    chip_->s_axil_araddr_i = static_cast<std::uint8_t>(address);
    chip_->s_axil_arvalid_i = 1;
    chip_.eval();
    REQUIRE(chip_->s_axil_arready_o);
    chip_.tick();
    chip_->s_axil_arvalid_i = 0;
    int waited = 0;
    for (chip_.eval(); !chip_->s_axil_rvalid_o && waited < 10; ++waited) chip_.tick();
    REQUIRE(chip_->s_axil_rvalid_o);
    const std::uint32_t data = chip_->s_axil_rdata_o;
    chip_.tick();
    return data;
  }

 private:
  trammel::test::Rtl<Vmcafee_xy> chip_;
};

}  // namespace

TEST_CASE("mcafee_xy: a refusal in the very clock of the write that clears its bit is kept") {
  struct Case {
    const char* name;
    std::vector<std::uint32_t> before;  // writes of PORT_B
    std::uint32_t refused;
  };
  const Case cases[] = {
      {"RD against the direction", {}, reg::kPortBReadStrobe},
      {"WR against the direction", {reg::kPortBRead}, reg::kPortBRead | reg::kPortBWriteStrobe},
      {"both at once", {}, reg::kPortBReadStrobe | reg::kPortBWriteStrobe},
      {"WR in a pulse", {reg::kPortBWriteStrobe, 0}, reg::kPortBWriteStrobe}};
  for (const Case& one : cases) {
    CAPTURE(one.name);
    clears_what_a_new_bench_shows<Hasty>(
        0, 8,
        [&one](Hasty& bus, std::int64_t n) {
          for (const std::uint32_t word : one.before) {
            bus.write(reg::kPortB, word);
            bus.clocks(8);
          }
          REQUIRE((bus.read(reg::kStatus) & reg::kStatusRefused) == 0);
          bus.write(reg::kPortB, one.refused);
          bus.clocks(n);
        },
        [](Hasty& bus) { return (bus.read(reg::kStatus) & reg::kStatusRefused) != 0; },
        [](Hasty& bus) { bus.write(reg::kStatus, reg::kStatusRefused); });
  }
}
