// SPDX-License-Identifier: Apache-2.0
//
// Beside models/plant/mcp3008.hpp at its pins.
#include <Vadc_serial.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/sense/adc_serial.hpp"
#include "models/plant/mcp3008.hpp"
#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::AdcSerial;
using trammel::test::Random;

namespace {

struct Bench {
  trammel::test::Rtl<Vadc_serial> rtl;
  AdcSerial twin;
  AdcSerial::In in;
  trammel::plant::Mcp3008 adc;
  int code = 0, asked = -1;         // that the converter gives; channel that it was asked for
  int clock = 0, held = 0, rises = 0;  // [clk] since the start
  bool sclk = false;

  Bench() {
    rtl->leap_i = 0;
    put();
    rtl.reset();
  }

  void put() {
    rtl->start_i = in.start;
    rtl->channel_i = static_cast<std::uint8_t>(in.channel);
    rtl->dout_i = in.dout;
    rtl.eval();
  }

  void compare() {
    const AdcSerial::Out out = twin.out();
    REQUIRE(bool(rtl->cs_n_o) == out.cs_n);
    REQUIRE(bool(rtl->sclk_o) == out.sclk);
    REQUIRE(bool(rtl->din_o) == out.din);
    REQUIRE(bool(rtl->valid_o) == out.valid);
    REQUIRE(rtl->channel_o == out.channel);
    REQUIRE(rtl->code_o == out.code);
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    if (twin.quiescent(in)) REQUIRE(rtl->next_o == twin.next());
  }

  void tick(Random* random = nullptr) {
    put();
    compare();
    if (random != nullptr) {
      trammel::test::leap_or_step(rtl, twin, twin.quiescent(in) ? twin.next() : 0, *random, 2, in);
    } else {
      twin.step(in);
      rtl.tick();
    }
    ++clock;
    compare_pins();
  }

  void compare_pins() {
    const AdcSerial::Out out = twin.out();
    if (out.sclk && !sclk) ++rises;
    sclk = out.sclk;
    in.dout = adc.step(out.cs_n, out.sclk, out.din, [this](int channel) {
      asked = channel;
      held = clock;
      return code;
    });
  }
};

}  // namespace

TEST_CASE("adc_serial reads every channel, and codes of every bit, from an MCP3008") {
  Bench bench;
  for (std::uint32_t channel = 0; channel < 8; ++channel) {
    for (const int code : {0, 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1023, 0x2AA, 0x155}) {
      bench.code = code;
      bench.clock = bench.rises = 0;
      bench.in.start = true;
      bench.in.channel = channel;
      bench.tick();
      bench.in.start = false;
      bench.in.channel = 7 - channel;
      while (!bench.twin.out().valid) bench.tick();
      CHECK(bench.asked == static_cast<int>(channel));
      CHECK(bench.rtl->code_o == code);
      CHECK(bench.rtl->channel_o == channel);
      CHECK(bench.clock == 1 + 34 * 8);
      CHECK(bench.held == 1 + 12 * 8);  // clocks behind the fall of cs_n
      CHECK(bench.rises == 17);
      bench.tick();
      CHECK(bench.rtl->valid_o == 0);
    }
  }
}

TEST_CASE("adc_serial agrees with its twin, leaping and not; a start in a frame is ignored") {
  Bench bench;
  Random random(9);
  for (int i = 0; i < 60'000; ++i) {
    bench.in.start = random() % 16 == 0;
    bench.in.channel = random() % 8;
    bench.code = static_cast<int>(random() % 1024);
    bench.tick(&random);
    if (random() % 3000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
      bench.compare_pins();
    }
  }
}
