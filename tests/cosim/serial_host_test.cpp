// SPDX-License-Identifier: Apache-2.0
//
// The other end of a serial line, bit by bit: a start bit, eight bits, lowest first, a stop bit.
#include "cosim/serial_host.hpp"

#include <catch2/catch.hpp>
#include <deque>
#include <optional>
#include <vector>

using trammel::cosim::Clk;
using trammel::cosim::SerialHost;

namespace {

constexpr Clk kBit = 52;

// Bit `n` of a frame.
bool of_frame(int byte, Clk n) { return n == 0 ? false : n > 8 || (byte >> (n - 1) & 1) != 0; }

}  // namespace

TEST_CASE("a byte is sent with start and stop bit, and the next one right behind it") {
  std::deque<unsigned char> bytes{0x00, 0xFF, 0xA5, 0x4E};
  const std::vector<int> sent{0x00, 0xFF, 0xA5, 0x4E};
  SerialHost host(kBit,
                  [&](Clk) -> std::optional<unsigned char> {
                    if (bytes.empty()) return {};
                    const unsigned char byte = bytes.front();
                    bytes.pop_front();
                    return byte;
                  },
                  [](unsigned char) { FAIL("nothing comes"); });
  for (Clk n = 0; n < 4 * 10 * kBit; ++n) {
    const Clk bit = n / kBit;
    CAPTURE(n, bit);
    REQUIRE(host.level(n) == of_frame(sent[static_cast<std::size_t>(bit / 10)], bit % 10));
    REQUIRE(host.next() == (bit + 1) * kBit);
  }
  CHECK(host.level(4 * 10 * kBit + 5000));  // at rest
}

TEST_CASE("a source that has nothing is asked again a millisecond later") {
  std::vector<Clk> asked;
  SerialHost host(kBit,
                  [&](Clk n) -> std::optional<unsigned char> {
                    asked.push_back(n);
                    if (asked.size() == 3) return 0x55;
                    return {};
                  },
                  [](unsigned char) {});
  for (Clk n = 0; n < 100'000; n += 100) CHECK(host.level(n));
  CHECK_FALSE(host.level(100'000));
  CHECK(asked == std::vector<Clk>{0, 50'000, 100'000});
}

TEST_CASE("bytes that come are read in the middle of their bits, at a rate 3 % off, too") {
  for (const double off : {0.97, 1.0, 1.03}) {
    std::vector<int> came;
    SerialHost host(kBit, [](Clk) -> std::optional<unsigned char> { return {}; },
                    [&](unsigned char byte) { came.push_back(byte); });
    const std::vector<int> sent{0x00, 0xFF, 0xA5, 0x4E, 0x80, 0x01};
    const double bit = kBit * off;
    for (Clk n = 0; n < 8'000; ++n) {
      const double bits = (static_cast<double>(n) - 100) / bit;  // a pause of a bit behind each
      const auto frame = static_cast<std::size_t>(bits < 0 ? 99 : bits / 11);
      const auto at = static_cast<Clk>(bits) % 11;
      host.see(n, frame >= sent.size() || at == 10 || of_frame(sent[frame], at));
    }
    CAPTURE(off);
    CHECK(came == sent);
  }
}

TEST_CASE("a frame without its stop bit is no byte") {
  for (const bool stop : {false, true}) {
    std::vector<int> came;
    SerialHost host(kBit, [](Clk) -> std::optional<unsigned char> { return {}; },
                    [&](unsigned char byte) { came.push_back(byte); });
    for (Clk n = 0; n < 10 * kBit; ++n) {
      host.see(n, n / kBit == 9 ? stop : of_frame(0xB4, n / kBit));
    }
    CAPTURE(stop);
    CHECK(came == (stop ? std::vector<int>{0xB4} : std::vector<int>{}));
  }
}
