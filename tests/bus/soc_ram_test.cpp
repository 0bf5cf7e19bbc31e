// SPDX-License-Identifier: Apache-2.0
//
// Random accesses of both ports beside an array.

#include <Vsoc_ram.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

using trammel::test::Random;
using trammel::test::same;

namespace {

constexpr std::uint32_t kWords = 64;  // all of the memory

constexpr std::uint8_t place(std::uint32_t n) { return static_cast<std::uint8_t>(n); }

struct Bench {
  trammel::test::Rtl<Vsoc_ram> rtl;

  Bench() {
    rtl->i_valid_i = rtl->d_valid_i = 0;
    rtl->i_addr_i = rtl->d_addr_i = 0;
    rtl->d_wstrb_i = 0;
    rtl->d_wdata_i = 0;
    rtl.reset();
  }

  std::uint32_t access(std::uint32_t address, unsigned strobes, std::uint32_t data) {
    rtl->d_valid_i = 1;
    rtl->d_addr_i = place(address);
    rtl->d_wstrb_i = static_cast<std::uint8_t>(strobes);
    rtl->d_wdata_i = data;
    rtl.tick();
    CHECK(rtl->d_ready_o == 1);
    rtl.tick();
    CHECK(rtl->d_ready_o == 0);
    rtl->d_valid_i = 0;
    return rtl->d_rdata_o;
  }
};

}  // namespace

TEST_CASE("soc_ram gives what was written, by bytes, at both ports at once") {
  Bench bench;
  Random random{23};
  std::array<std::uint32_t, kWords> words{};
  for (std::uint32_t n = 0; n < kWords; ++n) {
    words[n] = static_cast<std::uint32_t>(random());
    bench.access(n, 0xF, words[n]);
  }
  bool i_asked = false, d_asked = false;
  std::uint32_t i_word = 0, d_word = bench.rtl->d_rdata_o;
  bool i_known = false;
  for (std::int64_t clock = 0; clock < 50'000; ++clock) {
    bench.rtl->i_valid_i = random() % 4 != 0;
    bench.rtl->d_valid_i = random() % 4 != 0;
    const auto i_at = random() % kWords, d_at = random() % kWords;
    bench.rtl->i_addr_i = place(static_cast<std::uint32_t>(i_at));
    bench.rtl->d_addr_i = place(static_cast<std::uint32_t>(d_at));
    bench.rtl->d_wstrb_i = random() % 2 == 0 ? random() % 16 : 0;
    bench.rtl->d_wdata_i = static_cast<std::uint32_t>(random());
    i_asked = bench.rtl->i_valid_i != 0 && !i_asked;
    d_asked = bench.rtl->d_valid_i != 0 && !d_asked;
    if (i_asked) {
      i_word = words[i_at];
      i_known = true;
    }
    std::uint32_t& word = words[d_at];
    if (d_asked && bench.rtl->d_wstrb_i == 0) d_word = word;
    for (unsigned n = 0; n < 4 && d_asked; ++n) {
      const std::uint32_t mask = 0xFFu << 8 * n;
      if ((bench.rtl->d_wstrb_i >> n & 1u) == 0) continue;
      word = (word & ~mask) | (bench.rtl->d_wdata_i & mask);
    }
    bench.rtl.tick();
    same("i_ready_o", bench.rtl->i_ready_o, i_asked, clock);
    same("d_ready_o", bench.rtl->d_ready_o, d_asked, clock);
    if (i_known) same("i_rdata_o", bench.rtl->i_rdata_o, i_word, clock);
    same("d_rdata_o", bench.rtl->d_rdata_o, d_word, clock);
  }
}

TEST_CASE("soc_ram keeps its words over a reset and answers nothing in it") {
  Bench bench;
  bench.access(5, 0xF, 0x12345678);
  bench.rtl->rst_i = 1;
  bench.rtl->i_valid_i = bench.rtl->d_valid_i = 1;
  bench.rtl.tick();
  CHECK(bench.rtl->i_ready_o == 0);
  CHECK(bench.rtl->d_ready_o == 0);
  bench.rtl->rst_i = 0;
  bench.rtl->i_valid_i = bench.rtl->d_valid_i = 0;
  bench.rtl.tick();
  CHECK(bench.access(5, 0, 0) == 0x12345678);
}
