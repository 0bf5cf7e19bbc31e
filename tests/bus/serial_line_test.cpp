// SPDX-License-Identifier: Apache-2.0
//
// Beside its twin, and beside cosim/serial_host.hpp at the other end of the line.
#include <Vserial_line.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <optional>
#include <vector>

#include "cosim/serial_host.hpp"
#include "models/exact/bus/serial_line.hpp"
#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::SerialLine;
using trammel::test::Random;

namespace {

constexpr int kBit = 434;  // [clk]

struct Bench {
  trammel::test::Rtl<Vserial_line> rtl;
  SerialLine twin;
  SerialLine::In in;
  std::int64_t clock = 0;
  std::vector<int> came;  // bytes; bad ones + 256

  Bench() {
    rtl->leap_i = 0;
    put();
    rtl.reset();
  }
  void put() {
    rtl->send_i = in.send;
    rtl->byte_i = in.byte;
    rtl->rx_i = in.rx;
    rtl.eval();
  }
  // Up to n clocks as one, where nothing but timers moves.
  void pass(Gap n) {
    put();
    const SerialLine::Out out = twin.out();
    REQUIRE(bool(rtl->busy_o) == out.busy);
    REQUIRE(bool(rtl->valid_o) == out.valid);
    REQUIRE(bool(rtl->tx_o) == out.tx);
    if (out.valid) {
      REQUIRE(bool(rtl->bad_o) == out.bad);
      REQUIRE(rtl->byte_o == out.byte);
      came.push_back(out.byte + (out.bad ? 256 : 0));
    }
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    if (!twin.quiescent(in)) n = 1;
    if (twin.quiescent(in)) {
      REQUIRE(rtl->next_o == twin.next());
      n = std::max<Gap>(1, std::min(n, twin.next()));
    }
    if (n > 1) {
      twin.advance(n);
    } else {
      twin.step(in);
    }
    rtl->leap_i = (n - 1) & 0xFFF;
    rtl.tick();
    rtl->leap_i = 0;
    clock += n;
  }
  void line(bool level, int clocks) {
    in.rx = level;
    for (const std::int64_t end = clock + clocks; clock < end;) pass(static_cast<Gap>(end - clock));
  }
  void frame(unsigned byte, int bit = kBit, bool stop = true) {
    line(false, bit);
    for (int k = 0; k < 8; ++k) line((byte >> k & 1u) != 0, bit);
    line(stop, bit);
  }
};

}  // namespace

TEST_CASE("serial_line receives every byte back to back, also of a sender 4 % slow or fast") {
  for (const int bit : {kBit, kBit * 96 / 100, kBit * 104 / 100}) {
    Bench bench;
    for (unsigned byte = 0; byte < 256; ++byte) bench.frame(byte, bit);
    bench.line(true, 2 * kBit);
    REQUIRE(bench.came.size() == 256);
    for (int byte = 0; byte < 256; ++byte) {
      CHECK(bench.came[static_cast<std::size_t>(byte)] == byte);
    }
  }
}

TEST_CASE("serial_line sends every byte to a host, one frame of 10 bits each") {
  Bench bench;
  std::vector<int> heard;
  trammel::cosim::SerialHost host(
      kBit, [](trammel::cosim::Clk) { return std::optional<unsigned char>(); },
      [&heard](unsigned char byte) { heard.push_back(byte); });
  for (int byte = 0; byte < 256; ++byte) {
    bench.in.byte = static_cast<std::uint8_t>(byte);
    bench.in.send = true;
    bench.pass(1);
    bench.in.send = false;
    bench.in.byte = 0x55;
    const std::int64_t begin = bench.clock;
    while (bench.rtl->busy_o != 0) {
      host.see(bench.clock, bench.rtl->tx_o != 0);
      bench.pass(1);
    }
    CHECK(bench.clock - begin == 10 * kBit);
    host.see(bench.clock, true);
  }
  REQUIRE(heard.size() == 256);
  for (int byte = 0; byte < 256; ++byte) CHECK(heard[static_cast<std::size_t>(byte)] == byte);
}

TEST_CASE("serial_line has the byte 9.5 bits and 3 clocks behind the start bit, for one clock") {
  Bench bench;
  CHECK(bench.rtl->byte_o == 0);
  bench.in.rx = false;
  while (bench.came.empty() && bench.clock < 20 * kBit) {
    if (bench.clock == kBit) bench.in.rx = true;
    bench.pass(1);
  }
  CHECK(bench.clock - 1 == 19 * kBit / 2 + 3);
  CHECK(bench.came == std::vector<int>{0xFF});
  bench.line(true, 5 * kBit);
  CHECK(bench.came.size() == 1);
}

TEST_CASE("serial_line drops a start bit that does not last; a break is one bad byte") {
  Bench bench;
  bench.line(false, kBit / 2 - 4);
  bench.line(true, 20 * kBit);
  CHECK(bench.came.empty());
  bench.line(false, 100 * kBit);
  bench.line(true, 2 * kBit);
  CHECK(bench.came == std::vector<int>{256});
  bench.frame(0x31, kBit, false);
  bench.line(true, kBit);
  bench.frame(0x32);
  bench.line(true, kBit);
  CHECK(bench.came == std::vector<int>{256, 256 + 0x31, 0x32});
}

TEST_CASE("serial_line agrees with its twin for any line, leaping and not") {
  Bench bench;
  Random random(12);
  for (int i = 0; i < 30'000; ++i) {
    if (random() % 8 == 0) bench.in.rx = random() % 2 != 0;
    bench.in.send = random() % 32 == 0;
    bench.in.byte = static_cast<std::uint8_t>(random());
    bench.pass(random() % 3 == 0 ? 1 : 1 + random() % 500);
    if (random() % 3000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
  }
}
