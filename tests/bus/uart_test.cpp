// SPDX-License-Identifier: Apache-2.0
//
// Beside cosim/serial_host.hpp at the other end of the line, and at odd rates and levels of it.

#include <Vuart.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <deque>
#include <string>

#include "cosim/serial_host.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::cosim::SerialHost;

namespace {

constexpr int kBit = 434;  // clocks
constexpr int kFrame = 10 * kBit;

struct Bench {
  trammel::test::Rtl<Vuart> rtl;
  std::int64_t clock = 0;

  Bench() {
    rtl->send_i = rtl->take_i = 0;
    rtl->byte_i = 0;
    rtl->rx_i = 1;
    rtl.reset();
  }

  void tick() {
    rtl.tick();
    ++clock;
  }

  void line(bool level, int clocks) {
    rtl->rx_i = level;
    for (int i = 0; i < clocks; ++i) tick();
  }

  // A frame at a rate of its own.
  void frame(unsigned byte, int clocks_per_bit, bool stop = true) {
    line(false, clocks_per_bit);
    for (int bit = 0; bit < 8; ++bit) line((byte >> bit & 1u) != 0, clocks_per_bit);
    line(stop, clocks_per_bit);
    line(true, 2 * kBit);
  }

  std::string take() {
    if (rtl->waits_o == 0) return "";
    const std::string byte(1, static_cast<char>(rtl->byte_o));
    rtl->take_i = 1;
    tick();
    rtl->take_i = 0;
    rtl.eval();
    return byte;
  }
};

}  // namespace

TEST_CASE("uart sends and receives every byte, both ways at once, back to back") {
  Bench bench;
  int next = 0;
  std::string heard, got;
  SerialHost host(
      kBit,
      [&next](trammel::cosim::Clk) -> std::optional<unsigned char> {
        return next < 256 ? std::optional<unsigned char>(static_cast<unsigned char>(next++))
                          : std::nullopt;
      },
      [&heard](unsigned char byte) { heard += static_cast<char>(byte); });
  int sent = 0;
  for (int i = 0; i < 260 * kFrame; ++i) {
    bench.rtl->rx_i = host.level(bench.clock);
    host.see(bench.clock, bench.rtl->tx_o != 0);
    bench.rtl->send_i = bench.rtl->busy_o == 0 && sent < 256;
    if (bench.rtl->send_i != 0) bench.rtl->byte_i = static_cast<std::uint8_t>(255 - sent++);
    bench.rtl->take_i = bench.rtl->waits_o;
    if (bench.rtl->waits_o != 0) got += static_cast<char>(bench.rtl->byte_o);
    bench.tick();
  }
  REQUIRE(got.size() == 256);
  REQUIRE(heard.size() == 256);
  for (int n = 0; n < 256; ++n) {
    CHECK(static_cast<unsigned char>(got[static_cast<std::size_t>(n)]) == n);
    CHECK(static_cast<unsigned char>(heard[static_cast<std::size_t>(n)]) == 255 - n);
  }
}

TEST_CASE("uart puts the start bit out one clock after it was asked, and is busy for 10 bits") {
  Bench bench;
  bench.rtl->byte_i = 0xFF;
  bench.rtl->send_i = 1;
  bench.tick();
  bench.rtl->send_i = 0;
  CHECK(bench.rtl->tx_o == 0);
  int low = 0, busy = 0;
  for (; bench.rtl->busy_o != 0; ++busy) {
    low += bench.rtl->tx_o == 0 ? 1 : 0;
    bench.rtl->byte_i = 0;  // a send while busy is ignored
    bench.rtl->send_i = busy < kFrame - 2;
    bench.tick();
  }
  CHECK(low == kBit);
  CHECK(busy == kFrame);
  CHECK(bench.rtl->tx_o == 1);
}

TEST_CASE("uart has the byte 9.5 bits and 3 clocks after the start bit") {
  Bench bench;
  bench.rtl->rx_i = 0;
  int clocks = 0;
  for (; bench.rtl->waits_o == 0 && clocks < 2 * kFrame; ++clocks) {
    if (clocks == kBit) bench.rtl->rx_i = 1;
    bench.tick();
  }
  CHECK(clocks == 19 * kBit / 2 + 3);
  CHECK(bench.rtl->byte_o == 0xFF);
}

TEST_CASE("uart takes bytes of a sender that is 4 % slow or fast") {
  constexpr int kFine = 100;
  for (const int parts : {96, 104}) {
    Bench bench;
    for (const unsigned byte : {0x00u, 0x55u, 0xAAu, 0xFFu, 0x5Au}) {
      const unsigned frame = byte << 1 | 1u << 9;
      std::int64_t at = 0;
      for (int bit = 0; bit < 10; ++bit) {
        bench.rtl->rx_i = frame >> bit & 1u;
        for (; at * kFine < std::int64_t{bit + 1} * kBit * parts; ++at) bench.tick();
      }
      bench.line(true, 2 * kBit);
      CHECK(bench.rtl->byte_o == byte);
      CHECK(bench.take().size() == 1);
    }
  }
}

TEST_CASE("uart drops a start bit that does not last and a byte without a stop bit") {
  Bench bench;
  bench.line(false, kBit / 2 - 1);
  bench.line(true, 2 * kFrame);
  CHECK(bench.rtl->waits_o == 0);
  bench.frame(0x31, kBit, false);
  bench.line(true, kFrame);
  CHECK(bench.take().empty());
  bench.frame(0x32, kBit);
  CHECK(bench.take() == "2");
}

TEST_CASE("uart keeps 16 bytes in their order; the next are lost, counted up to 255") {
  Bench bench;
  CHECK(bench.rtl->quiescent_o == 1);
  const auto byte_of = [](int n) { return static_cast<unsigned>(n * 37 + 5) & 0xFFu; };
  for (int n = 0; n < 16; ++n) bench.frame(byte_of(n), kBit);
  CHECK(bench.rtl->lost_o == 0);
  CHECK(bench.rtl->quiescent_o == 1);
  bench.frame(0xE1, kBit);
  CHECK(bench.rtl->lost_o == 1);
  bench.frame(0xE2, kBit);
  CHECK(bench.rtl->lost_o == 2);
  // A place that was freed takes the next byte, and the order stays.
  CHECK(bench.take() == std::string(1, static_cast<char>(byte_of(0))));
  bench.frame(byte_of(16), kBit);
  CHECK(bench.rtl->lost_o == 2);
  for (int n = 1; n <= 16; ++n) {
    CHECK(bench.rtl->byte_o == byte_of(n));
    CHECK(bench.take().size() == 1);
  }
  CHECK(bench.rtl->waits_o == 0);
  // Taking nothing leaves nothing behind.
  bench.rtl->take_i = 1;
  bench.line(true, 40);
  bench.rtl->take_i = 0;
  bench.frame(0x41, kBit);
  CHECK(bench.take() == "A");
  CHECK(bench.take().empty());
  for (int n = 0; n < 16; ++n) bench.frame(0x42, kBit);
  for (int lost = 3; lost < 260; ++lost) {
    bench.frame(0x42, kBit);
    CHECK(bench.rtl->lost_o == std::min(lost, 255));
  }
  bench.rtl.reset();
  CHECK(bench.rtl->waits_o == 0);
  CHECK(bench.rtl->lost_o == 0);
}

TEST_CASE("uart takes and stores in one clock, with one byte or all places taken") {
  for (const int waiting : {1, 15, 16}) {
    Bench bench;
    for (int n = 0; n < waiting; ++n) bench.frame(static_cast<unsigned>(n), kBit);
    bench.line(false, kBit);
    bench.line(true, 17 * kBit / 2 + 2);  // the clock in which 0xFF comes
    bench.rtl->take_i = 1;
    bench.tick();
    bench.rtl->take_i = 0;
    bench.rtl.eval();
    // Without a place in that clock it is lost.
    CHECK(bench.rtl->lost_o == (waiting == 16 ? 1 : 0));
    const int left = waiting == 16 ? 15 : waiting;
    for (int n = 0; n < left; ++n) {
      CHECK(bench.rtl->byte_o == (waiting < 16 && n == left - 1 ? 0xFF : n + 1));
      CHECK(bench.take().size() == 1);
    }
    CHECK(bench.rtl->waits_o == 0);
  }
}

TEST_CASE("uart is quiescent only at rest") {
  Bench bench;
  for (const bool send : {false, true}) {
    for (const bool take : {false, true}) {
      bench.rtl->send_i = send;
      bench.rtl->take_i = take;
      bench.rtl.eval();
      CHECK(bench.rtl->quiescent_o == (!send && !take));
    }
  }
  bench.rtl->send_i = bench.rtl->take_i = 0;
  bench.rtl->rx_i = 0;
  bench.rtl.eval();
  CHECK(bench.rtl->quiescent_o == 0);
  bench.tick();
  CHECK(bench.rtl->quiescent_o == 0);
}

TEST_CASE("uart stands any line: random levels leave it ready") {
  Bench bench;
  trammel::test::Random random{17};
  for (int i = 0; i < 2000; ++i) {
    bench.line(random() % 2 != 0, 1 + static_cast<int>(random() % (2 * kBit)));
  }
  bench.line(true, 2 * kFrame);
  while (!bench.take().empty()) {
  }
  bench.frame(0xA7, kBit);
  CHECK(bench.rtl->byte_o == 0xA7);
  CHECK(bench.rtl->waits_o == 1);
  bench.rtl.reset();
  CHECK(bench.rtl->waits_o == 0);
}
