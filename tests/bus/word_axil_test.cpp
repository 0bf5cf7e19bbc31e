// SPDX-License-Identifier: Apache-2.0
#include <Vword_axil.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>

#include "tests/support/axi_lite.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::test::AxiLiteTraffic;
using trammel::test::AxiWrite;
using trammel::test::Random;

namespace {

// Four words of 32 bits behind the block, which count what is done to them.
struct Bench {
  trammel::test::Rtl<Vword_axil> rtl;
  std::array<std::uint32_t, 4> words{};
  int writes = 0, reads = 0;

  Bench() {
    rtl->s_axil_awvalid_i = rtl->s_axil_wvalid_i = rtl->s_axil_arvalid_i = 0;
    rtl->s_axil_bready_i = rtl->s_axil_rready_i = 1;
    rtl->s_axil_awprot_i = rtl->s_axil_arprot_i = 0;
    rtl->data_i = 0;
    rtl.reset();
  }

  void clock() {
    rtl->data_i = words[rtl->word_o];
    rtl.eval();
    const bool write = rtl->write_o, read = rtl->read_o;
    const unsigned word = rtl->word_o, bytes = rtl->bytes_o;
    const std::uint32_t data = rtl->data_o;
    rtl.tick();
    writes += write;
    reads += read;
    if (!write) return;
    for (unsigned byte = 0; byte < 4; ++byte) {
      const std::uint32_t mask = 0xFFu << 8 * byte;
      if ((bytes >> byte & 1) != 0) words[word] = (words[word] & ~mask) | (data & mask);
    }
  }
};

}  // namespace

TEST_CASE("word_axil: random transfers, on channels that come late, do each what they ask once") {
  Bench bench;
  const auto clock = [&bench] { bench.clock(); };
  AxiLiteTraffic<decltype(bench.rtl), std::function<void()>> traffic(bench.rtl, clock, 3);
  Random random(5);
  std::array<std::uint32_t, 4> expected{};
  int writes = 0, reads = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<AxiWrite> some;
    for (unsigned n = random() % 5; n > 0; --n) {
      const AxiWrite one{random() % 4 * 4 + random() % 4, random(), random() % 16};
      for (unsigned byte = 0; byte < 4; ++byte) {
        const std::uint32_t mask = (one.strobes >> byte & 1) != 0 ? 0xFFu << 8 * byte : 0;
        std::uint32_t& word = expected[one.address / 4];
        word = (word & ~mask) | (one.data & mask);
      }
      some.push_back(one);
      ++writes;
    }
    traffic.write(some);
    REQUIRE(bench.words == expected);
    const std::vector<std::uint32_t> values = traffic.read({0, 4, 8, 12});
    reads += 4;
    for (std::size_t k = 0; k < 4; ++k) REQUIRE(values[k] == expected[k]);
  }
  CHECK(bench.writes == writes);
  CHECK(bench.reads == reads);
}

TEST_CASE("word_axil: a transfer alone takes three clocks, and it rests before and after it") {
  Bench bench;
  bench.rtl.eval();
  REQUIRE(bench.rtl->quiescent_o);
  bench.rtl->s_axil_awvalid_i = bench.rtl->s_axil_wvalid_i = 1;
  bench.rtl->s_axil_awaddr_i = 4;
  bench.rtl->s_axil_wdata_i = 77;
  bench.rtl->s_axil_wstrb_i = 15;
  bench.rtl.eval();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
  bench.clock();
  bench.rtl->s_axil_awvalid_i = bench.rtl->s_axil_wvalid_i = 0;
  bench.rtl.eval();
  REQUIRE(bench.rtl->write_o);
  bench.clock();
  CHECK(bench.words[1] == 77);
  CHECK(bench.rtl->s_axil_bvalid_o);
  bench.clock();
  CHECK_FALSE(bench.rtl->s_axil_bvalid_o);
  CHECK(bench.rtl->quiescent_o);
}

TEST_CASE("word_axil: while both responses wait, one more of each direction is taken and waits") {
  Bench bench;
  bench.rtl->s_axil_bready_i = bench.rtl->s_axil_rready_i = 0;
  bench.words = {1, 2, 3, 4};
  for (int n = 0; n < 2; ++n) {
    bench.rtl->s_axil_awvalid_i = bench.rtl->s_axil_wvalid_i = bench.rtl->s_axil_arvalid_i = 1;
    bench.rtl->s_axil_awaddr_i = 4;
    bench.rtl->s_axil_araddr_i = 12;
    bench.rtl->s_axil_wdata_i = 70 + static_cast<std::uint32_t>(n);
    bench.rtl->s_axil_wstrb_i = 15;
    bench.clock();
    bench.rtl->s_axil_awvalid_i = bench.rtl->s_axil_wvalid_i = bench.rtl->s_axil_arvalid_i = 0;
    for (int k = 0; k < 4; ++k) bench.clock();
  }
  CHECK(bench.writes == 1);
  CHECK(bench.reads == 1);
  CHECK(bench.words[1] == 70);
  CHECK_FALSE(bench.rtl->s_axil_awready_o);
  CHECK_FALSE(bench.rtl->s_axil_arready_o);
  CHECK(bench.rtl->s_axil_rdata_o == 4);
  bench.rtl->s_axil_bready_i = bench.rtl->s_axil_rready_i = 1;
  for (int k = 0; k < 6; ++k) bench.clock();
  CHECK(bench.writes == 2);
  CHECK(bench.reads == 2);
  CHECK(bench.words[1] == 71);
}
