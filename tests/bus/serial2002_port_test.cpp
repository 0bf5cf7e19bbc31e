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
    rtl.eval();
  }
  void pass() {
    in.rx = loop ? twin.tx() : host.level(clock);
    put();
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    Gap n = 1;
    if (twin.quiescent(in)) {
      REQUIRE(rtl->next_o == twin.next());
      n = std::clamp<Gap>(twin.next(), 1, 4000);
      if (!loop) n = static_cast<Gap>(std::clamp<std::int64_t>(host.next() - clock, 1, n));
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
  bench.to_send.assign(11, 0x41);
  while (bench.twin.in().lost() < 3 && bench.clock < 1'000'000) bench.pass();
  CHECK(bench.rtl->lost_o == 3);
  CHECK(bench.rtl->malformed_o == 0);
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
