// SPDX-License-Identifier: Apache-2.0
//
// Frames through the whole of it, its line led back to itself, and bytes of any kind.
#include <Vserial2002_port.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "cosim/serial_host.hpp"
#include "models/exact/bus/serial2002_port.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Frame;
using trammel::exact::Gap;
using trammel::exact::Serial2002Port;
using trammel::test::Random;

namespace {

std::uint64_t bits(const Frame& f) {
  return std::uint64_t{f.kind} << 37 | std::uint64_t{f.channel} << 32 | f.value;
}

struct Bench {
  trammel::test::Rtl<Vserial2002_port> rtl;
  Serial2002Port twin;
  Serial2002Port::In in;
  std::deque<std::uint8_t> to_send;
  std::int64_t clock = 0;
  bool loop = false;
  std::optional<bool> level;  // of the line, whatever the host sends
  Gap most = 300;             // [clk] at once, then
  trammel::cosim::SerialHost host{434,
                                  [this](trammel::cosim::Clk) -> std::optional<unsigned char> {
                                    if (to_send.empty()) return std::nullopt;
                                    const unsigned char byte = to_send.front();
                                    to_send.pop_front();
                                    return byte;
                                  },
                                  [](unsigned char) {}};

  Bench() {
    rtl->leap_i = 0;
    put();
    rtl.reset();
  }
  void put() {
    rtl->rx_i = in.rx;
    rtl->send_i = in.send;
    rtl->frame_i = bits(in.frame);
    rtl->take_i = in.take;
    rtl->gap_i = in.gap;
    rtl.eval();
  }
  void pass() {
    in.rx = level ? *level : loop ? twin.tx() : host.level(clock);
    put();
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    Gap n = 1;
    if (twin.quiescent(in)) {
      REQUIRE(rtl->next_o == twin.next());
      n = std::clamp<Gap>(twin.next(), 1, 4000);
      if (level) n = std::min(n, most);
      if (!loop && !level) {
        n = static_cast<Gap>(std::clamp<std::int64_t>(host.next() - clock, 1, n));
      }
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
    in.send = in.take = false;
    REQUIRE(bool(rtl->tx_o) == twin.tx());
    REQUIRE(bool(rtl->waits_o) == twin.in().waits());
    REQUIRE(rtl->frame_o == bits(twin.in().frame()));
    REQUIRE(rtl->room_o == twin.out().room());
    REQUIRE(rtl->refused_o == twin.out().lost());
    REQUIRE(rtl->lost_o == twin.in().lost());
    REQUIRE(rtl->malformed_o == twin.malformed());
    REQUIRE(bool(rtl->idle_o) == twin.idle());
  }
};

}  // namespace

TEST_CASE("serial2002_port receives what it sends, in order") {
  Bench bench;
  bench.loop = true;
  Random random(17);
  std::deque<Frame> sent;
  int came = 0;
  while (came < 200) {
    if (bench.twin.out().room() > 0 && sent.size() < 60 && random() % 4 == 0) {
      Frame frame{random() % 5, random() % 32, 0};
      if (frame.kind == Frame::kValue) frame.value = random() >> random() % 32;
      bench.in.send = true;
      bench.in.frame = frame;
      sent.push_back(frame);
    }
    if (bench.twin.in().waits()) {
      REQUIRE(bench.twin.in().frame() == sent.front());
      sent.pop_front();
      ++came;
      bench.in.take = true;
    }
    bench.pass();
  }
  CHECK(bench.rtl->malformed_o == 0);
}

TEST_CASE("serial2002_port keeps 8 received frames and 32 to send, and counts the others") {
  Bench bench;
  for (int k = 0; k < 40; ++k) {
    bench.in.send = true;
    bench.in.frame = {Frame::kValue, 1, 0xFFFFFFFF};
    bench.pass();
  }
  CHECK(bench.rtl->room_o == 0);
  CHECK(bench.rtl->refused_o == 8);
  bench.to_send.assign(8 + 700, 0x41);
  while (bench.twin.in().lost() < 700 && bench.clock < 4'000'000) bench.pass();
  CHECK(bench.rtl->lost_o == 700);
  CHECK(bench.rtl->malformed_o == 0);
}

TEST_CASE("serial2002_port agrees with its twin for any line, whatever is sent, taken and reset") {
  Bench bench;
  Random random(25);
  bool fast = false;
  for (int i = 0; i < 60'000; ++i) {
    if (i % 5000 == 0) fast = !fast;  // else fewer are taken than come
    if (random() % 4 == 0) bench.level = random() % 3 != 0;
    if (random() % 200 == 0) bench.in.gap = random() % 3 == 0 ? 0 : random() % 20'000;
    bench.in.send = random() % 8 == 0;
    bench.in.frame = {random() % 5, random() % 32, random() >> random() % 32};
    bench.in.take = fast ? random() % 4 == 0 : random() % 4000 == 0;
    bench.pass();
    if (random() % 9000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
  }
  CHECK(bench.rtl->malformed_o > 0);
}

TEST_CASE("serial2002_port: a byte without stop bit spoils its frame alone") {
  Bench bench;
  bench.most = 14;  // a part of a bit
  const auto line = [&bench](bool level, int bits) {
    bench.level = level;
    for (const std::int64_t end = bench.clock + 434 * bits; bench.clock < end;) bench.pass();
  };
  line(true, 3);
  line(false, 10);  // 00h whose stop bit is low
  line(true, 3);
  CHECK(bench.rtl->malformed_o == 1);
  CHECK(bench.rtl->waits_o == 0);
  for (const unsigned byte : {0xCCu, 0x35u}) {
    line(false, 1);
    for (int k = 0; k < 8; ++k) line((byte >> k & 1u) != 0, 1);
    line(true, 2);
  }
  CHECK(bench.twin.in().frame() == Frame{Frame::kValue, 21, 305});
  CHECK(bench.rtl->malformed_o == 1);
}

TEST_CASE("serial2002_port: the count of refused frames ends at 65535") {
  Bench bench;
  while (bench.twin.out().lost() < 65535) {
    bench.in.send = true;
    bench.in.frame = {Frame::kPollBit, 1, 0};
    bench.pass();
  }
  for (int k = 0; k < 40; ++k) {
    bench.in.send = true;
    bench.pass();
  }
  CHECK(bench.rtl->refused_o == 65535);
}

TEST_CASE("serial2002_port: so does that of malformed ones") {
  Bench bench;
  bench.most = 4000;
  const auto line = [&bench](bool level, int bits) {
    bench.level = level;
    for (const std::int64_t end = bench.clock + 434 * bits; bench.clock < end;) bench.pass();
  };
  line(true, 3);
  for (int k = 1; k <= 65'540; ++k) {
    line(false, 10);  // without a stop bit
    line(true, 1);
    if (bench.twin.malformed() != static_cast<std::uint32_t>(std::min(k, 65535))) {
      FAIL("after " << k << " bytes");
    }
  }
  CHECK(bench.rtl->malformed_o == 65535);
}

// A million of them, 20 s: serial2002_port_test "[.million]", in the full tier.
TEST_CASE("serial2002_port stands a million bytes, a good frame after each thousand",
          "[.million]") {
  Bench bench;
  Random random(26);
  std::int64_t sent = 0, good = 0;
  Frame last;
  const auto drain = [&] {
    for (; !bench.to_send.empty() || bench.twin.in().waits(); bench.pass()) {
      if (!bench.twin.in().waits()) continue;
      last = bench.twin.in().frame();
      bench.in.take = true;
    }
    for (const std::int64_t end = bench.clock + 6000; bench.clock < end; bench.pass()) {
      if (!bench.twin.in().waits()) continue;
      last = bench.twin.in().frame();
      bench.in.take = true;
    }
  };
  while (sent < 1'000'000) {
    for (int k = 0; k < 1000; ++k, ++sent) {
      const auto byte = static_cast<std::uint8_t>(random());
      bench.to_send.push_back(random() % 4 != 0 ? byte | 0x80 : byte);
    }
    for (const int byte : {0x00, 0xCC, 0x35}) {
      bench.to_send.push_back(static_cast<std::uint8_t>(byte));
    }
    drain();
    REQUIRE(last == Frame{Frame::kValue, 21, 305});
    ++good;
  }
  CHECK(good == 1000);
  CHECK(bench.rtl->malformed_o > 50'000);
  CHECK(bench.rtl->lost_o == 0);
}

TEST_CASE("serial2002_port stands any bytes: 20 000 by the RTL, then a good frame is decoded") {
  Bench bench;
  Random random(18);
  for (int k = 0; k < 20'000; ++k) bench.to_send.push_back(static_cast<std::uint8_t>(random()));
  for (const int byte : {0x00, 0xCC, 0x35}) {
    bench.to_send.push_back(static_cast<std::uint8_t>(byte));
  }
  Frame last;
  while (!bench.to_send.empty() || bench.clock % 2 == 0 || bench.twin.in().waits()) {
    if (bench.twin.in().waits()) {
      last = bench.twin.in().frame();
      bench.in.take = true;
    }
    bench.pass();
  }
  for (const std::int64_t end = bench.clock + 20'000; bench.clock < end;) {
    if (bench.twin.in().waits()) {
      last = bench.twin.in().frame();
      bench.in.take = true;
    }
    bench.pass();
  }
  CHECK(last == Frame{Frame::kValue, 21, 305});
  CHECK(bench.rtl->malformed_o > 100);
}
