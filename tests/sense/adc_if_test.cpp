// SPDX-License-Identifier: Apache-2.0

#include <Vadc_if.h>

#include <catch2/catch.hpp>
#include <vector>

#include "models/exact/sense/adc_if.hpp"
#include "models/plant/ad7476.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::AdcIf;
using trammel::plant::Ad7476;
using trammel::test::Random;
using Rtl = trammel::test::Rtl<Vadc_if>;

namespace {

// The block with its two converters; the held values are those of the clock of the hold edge.
struct Bench {
  Rtl rtl;
  Ad7476 a;
  Ad7476 b;
  int clock = 0;
  int code_a = 0;
  int code_b = 0;
  int held_at = -1;

  Bench() {
    rtl->zeros_i = 4;
    rtl.reset();
  }

  void tick() {
    rtl.tick();
    ++clock;
    rtl->sdata_a_i = a.step(rtl->cs_n_o, rtl->sclk_o, [this] {
      held_at = clock;
      return code_a;
    });
    rtl->sdata_b_i = b.step(rtl->cs_n_o, rtl->sclk_o, [this] { return code_b; });
    rtl.eval();
  }

  void start() {
    rtl->start_i = 1;
    tick();
    rtl->start_i = 0;
    rtl.eval();
  }
};

}  // namespace

TEST_CASE("adc_if agrees with its twin on random starts, data and resets") {
  Rtl rtl;
  AdcIf twin;
  rtl.reset();
  Random random(7);
  for (int i = 0; i < 100000; ++i) {
    const AdcIf::In in{random() % 40 == 0, random() % 2 == 0, random() % 2 == 0,
                       static_cast<int>(random() % 8)};
    rtl->start_i = in.start;
    rtl->sdata_a_i = in.sdata_a;
    rtl->sdata_b_i = in.sdata_b;
    rtl->zeros_i = static_cast<std::uint8_t>(in.zeros);
    rtl.eval();
    if (random() % 500 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    rtl.tick();
    const AdcIf::Out out = twin.step(in);
    REQUIRE(bool(rtl->cs_n_o) == out.cs_n);
    REQUIRE(bool(rtl->sclk_o) == out.sclk);
    REQUIRE(bool(rtl->busy_o) == out.busy);
    REQUIRE(bool(rtl->valid_o) == out.valid);
    REQUIRE(rtl->code_a_o == out.code_a);
    REQUIRE(rtl->code_b_o == out.code_b);
  }
}

TEST_CASE("adc_if frame has 16 clocks of 12.5 MHz inside 64 clocks of chip select") {
  Bench bench;
  bench.start();
  REQUIRE(bench.held_at == 1);  // the edge that takes the start lowers cs_n
  std::vector<int> falls;
  int low = 0;
  int valid_at = -1;
  bool sclk = bench.rtl->sclk_o;
  while (bench.clock < 100) {
    low += !bench.rtl->cs_n_o;
    if (bench.rtl->valid_o) {
      REQUIRE(valid_at == -1);
      REQUIRE(bench.rtl->cs_n_o);
      valid_at = bench.clock;
    }
    bench.tick();
    if (sclk && !bench.rtl->sclk_o) falls.push_back(bench.clock);
    sclk = bench.rtl->sclk_o;
  }
  REQUIRE(low == 64);
  REQUIRE(valid_at == AdcIf::kLatency);
  REQUIRE(falls.size() == 16);
  for (std::size_t i = 0; i < falls.size(); ++i) REQUIRE(falls[i] == 3 + 4 * static_cast<int>(i));
}

TEST_CASE("adc_if reads every code exactly, past the four leading zeros") {
  Bench bench;
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    const int a = i < 12 ? 1 << i : static_cast<int>(random() % 4096);
    const int b = i == 20 ? 4095 : static_cast<int>(random() % 4096);
    bench.code_a = a;
    bench.code_b = b;
    bench.start();
    bench.code_a = ~a & 4095;  // the converter holds at the fall of cs_n
    bench.code_b = ~b & 4095;
    while (!bench.rtl->valid_o) bench.tick();
    REQUIRE(bench.rtl->code_a_o == a);
    REQUIRE(bench.rtl->code_b_o == b);
  }
}

TEST_CASE("adc_if takes the 12 highest bits of converters of 6 to 16 bits") {
  Bench bench;
  Random random(9);
  for (int bits = 6; bits <= 16; ++bits) {
    bench.rtl->zeros_i = static_cast<std::uint8_t>(trammel::plant::leading_zeros(bits));
    for (int i = 0; i < 40; ++i) {
      const int a = static_cast<int>(random() % (1u << bits));
      const int b = static_cast<int>(random() % (1u << bits));
      CAPTURE(bits, a, b);
      bench.code_a = trammel::plant::serial_frame(a, bits);
      bench.code_b = trammel::plant::serial_frame(b, bits);
      bench.start();
      while (!bench.rtl->valid_o) bench.tick();
      REQUIRE(bench.rtl->code_a_o == (bits < 12 ? a << (12 - bits) : a >> (bits - 12)));
      REQUIRE(bench.rtl->code_b_o == (bits < 12 ? b << (12 - bits) : b >> (bits - 12)));
    }
  }
}

TEST_CASE("adc_if keeps its codes during the next frame and ignores a start inside one") {
  Bench bench;
  bench.code_a = 0x5A5;
  bench.start();
  while (!bench.rtl->valid_o) bench.tick();
  bench.code_a = 0xA5A;
  bench.start();
  for (int i = 0; i < 40; ++i) {
    bench.tick();
    REQUIRE(bench.rtl->code_a_o == 0x5A5);
  }
  bench.start();
  int left = 23;
  while (!bench.rtl->valid_o) {
    bench.tick();
    --left;
  }
  REQUIRE(left == 0);
  REQUIRE(bench.rtl->code_a_o == 0xA5A);
  bench.tick();
  REQUIRE(bench.rtl->quiescent_o);
}
