// SPDX-License-Identifier: Apache-2.0
#include <Vserial2002_tx.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/exact/bus/serial2002_rx.hpp"
#include "models/exact/bus/serial2002_tx.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Frame;
using trammel::exact::Serial2002Rx;
using trammel::exact::Serial2002Tx;
using trammel::test::Random;
using Bytes = std::vector<std::uint8_t>;

namespace {

struct Bench {
  trammel::test::Rtl<Vserial2002_tx> rtl;
  Serial2002Tx twin;
  Bytes bytes;

  Bench() {
    put({});
    rtl.reset();
  }
  void put(const Serial2002Tx::In& in) {
    rtl->waits_i = in.waits;
    rtl->frame_i = std::uint64_t{in.frame.kind} << 37 | std::uint64_t{in.frame.channel} << 32 |
                   in.frame.value;
    rtl->busy_i = in.busy;
    rtl.eval();
  }
  bool clock(const Serial2002Tx::In& in) {
    put(in);
    const Serial2002Tx::Out out = twin.out(in);
    REQUIRE(bool(rtl->send_o) == out.send);
    REQUIRE(bool(rtl->take_o) == out.take);
    REQUIRE(bool(rtl->idle_o) == twin.idle(in));
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    REQUIRE(rtl->byte_o == out.byte);  // also where it is not sent
    if (out.send) bytes.push_back(out.byte);
    twin.step(in);
    rtl.tick();
    return out.take;
  }
  // Through a line that is busy for 3 clocks with each byte.
  Bytes send(const Frame& frame) {
    bytes.clear();
    int busy = 0;
    for (bool taken = false; !taken;) {
      const std::size_t before = bytes.size();
      taken = clock({true, frame, busy > 0});
      busy = bytes.size() != before ? 3 : busy > 0 ? busy - 1 : 0;
    }
    return bytes;
  }
};

}  // namespace

TEST_CASE("G-03 serial2002_tx: bytes of the examples, and the fewest for each value") {
  Bench bench;
  CHECK(bench.send({Frame::kValue, 9, 42}) == Bytes{0x8A, 0x49});
  CHECK(bench.send({Frame::kValue, 21, 305}) == Bytes{0xCC, 0x35});
  CHECK(bench.send({Frame::kValue, 22, 170'000}) == Bytes{0x82, 0xCC, 0x84, 0x16});
  const std::array<std::pair<std::uint32_t, std::size_t>, 10> lengths{
      {{0, 2}, {511, 2}, {512, 3}, {65535, 3}, {1u << 16, 4}, {(1u << 23) - 1, 4},
       {1u << 23, 5}, {(1u << 30) - 1, 5}, {1u << 30, 6}, {0xFFFFFFFF, 6}}};
  for (const auto& [value, length] : lengths) {
    const Bytes bytes = bench.send({Frame::kValue, 17, value});
    CHECK(bytes.size() == length);
    Serial2002Rx rx;
    Serial2002Rx::Out out;
    for (const std::uint8_t byte : bytes) out = rx.step({true, false, byte});
    CHECK(out.valid);
    CHECK(out.frame == Frame{Frame::kValue, 17, value});
  }
  CHECK(bench.send({Frame::kClearBit, 0, 7}) == Bytes{0x00});
  CHECK(bench.send({Frame::kSetBit, 1, 7}) == Bytes{0x21});
  CHECK(bench.send({Frame::kPollBit, 1, 7}) == Bytes{0x41});
  CHECK(bench.send({Frame::kPollChannel, 31, 7}) == Bytes{0x7F});
}

TEST_CASE("serial2002_tx agrees with its twin, and what it sends is received") {
  Bench bench;
  Random random(15);
  Serial2002Rx rx;
  Frame frame;
  bool waits = false;
  for (int i = 0; i < 60'000; ++i) {
    if (!waits && random() % 4 == 0) {
      waits = true;
      frame = {random() % 5, random() % 32, 0};
      if (frame.kind == Frame::kValue) frame.value = random() >> random() % 32;
    }
    const std::size_t before = bench.bytes.size();
    const bool taken = bench.clock({waits, frame, random() % 3 == 0});
    if (bench.bytes.size() != before) {
      const auto out = rx.step({true, false, bench.bytes.back()});
      REQUIRE(out.valid == taken);
      if (taken) REQUIRE(out.frame == frame);
    }
    if (taken) waits = false;
  }
}
