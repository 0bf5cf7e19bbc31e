// SPDX-License-Identifier: Apache-2.0
#include <Vserial2002_rx.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "models/exact/bus/serial2002_rx.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Frame;
using trammel::exact::Serial2002Rx;
using trammel::test::Random;

namespace {

struct Bench {
  trammel::test::Rtl<Vserial2002_rx> rtl;
  Serial2002Rx twin;
  std::vector<Frame> frames;
  int malformed = 0;

  Bench() {
    rtl->leap_i = 0;
    put({});
    rtl.reset();
  }
  void put(const Serial2002Rx::In& in) {
    rtl->valid_i = in.valid;
    rtl->bad_i = in.bad;
    rtl->byte_i = in.byte;
    rtl->gap_i = in.gap;
    rtl.eval();
  }
  void clock(const Serial2002Rx::In& in) {
    put(in);
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    if (twin.quiescent(in)) REQUIRE(rtl->next_o == twin.next());
    const Serial2002Rx::Out out = twin.step(in);
    rtl.tick();
    REQUIRE(bool(rtl->valid_o) == out.valid);
    REQUIRE(bool(rtl->malformed_o) == out.malformed);
    const Frame& f = out.frame;
    REQUIRE(rtl->frame_o ==
            (std::uint64_t{f.kind} << 37 | std::uint64_t{f.channel} << 32 | f.value));
    if (out.valid) frames.push_back(f);
    malformed += out.malformed;
  }
  // Each with so many clocks behind it until the next one.
  void paced(const std::vector<std::uint8_t>& all, int clocks, std::uint32_t gap) {
    for (const std::uint8_t byte : all) {
      clock({true, false, byte, gap});
      for (int k = 1; k < clocks; ++k) clock({false, false, 0, gap});
    }
  }
  void bytes(std::initializer_list<int> all) {
    for (const int byte : all) {  // + 256: without a stop bit
      clock({true, byte >= 256, static_cast<std::uint8_t>(byte)});
      clock({});
    }
  }
};

}  // namespace

TEST_CASE("serial2002_rx: the examples of the protocol, and each form of one byte") {
  Bench bench;
  bench.bytes({0x8A, 0x49, 0xCC, 0x35, 0x82, 0xCC, 0x84, 0x16});
  bench.bytes({0x03, 0x23, 0x43, 0x7F});
  const std::vector<Frame> wanted{{Frame::kValue, 9, 42},
                                  {Frame::kValue, 21, 305},
                                  {Frame::kValue, 22, 170'000},
                                  {Frame::kClearBit, 3, 0},
                                  {Frame::kSetBit, 3, 0},
                                  {Frame::kPollBit, 3, 0},
                                  {Frame::kPollChannel, 31, 0}};
  CHECK(bench.frames == wanted);
  CHECK(bench.malformed == 0);
}

TEST_CASE("serial2002_rx takes 32 bits and no more, and the frame behind one that is too long") {
  Bench bench;
  bench.bytes({0x83, 0xFF, 0xFF, 0xFF, 0xFF, 0x61});
  REQUIRE(bench.frames.size() == 1);
  CHECK(bench.frames[0] == Frame{Frame::kValue, 1, 0xFFFFFFFF});
  bench.bytes({0x84, 0x80, 0x80, 0x80, 0x80, 0x61});        // bit 32
  bench.bytes({0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x61});  // 6 leading bytes
  CHECK(bench.malformed == 2);
  for (int k = 0; k < 1000; ++k) bench.bytes({0xFF});
  bench.bytes({0x61});
  CHECK(bench.malformed == 3);
  CHECK(bench.frames.size() == 1);
  bench.bytes({0x8A, 0x49});
  CHECK(bench.frames.back() == Frame{Frame::kValue, 9, 42});
}

TEST_CASE("serial2002_rx drops a frame with a byte without stop bit, wherever it is") {
  Bench bench;
  bench.bytes({256 + 0x8A, 0x49, 0x8A, 256 + 0x49, 256 + 0x21, 0x83, 256 + 0x80, 0x80, 0x05});
  CHECK(bench.malformed == 4);
  CHECK(bench.frames.empty());
  bench.bytes({0x8A, 0x49});
  CHECK(bench.frames.size() == 1);
}

TEST_CASE("serial2002_rx: a byte within the gap goes on with its frame, a later one begins anew") {
  const std::vector<std::uint8_t> frame{0x82, 0xCC, 0x84, 0x16};
  for (const int clocks : {1, 2, 20}) {
    Bench bench;
    CAPTURE(clocks);
    bench.paced(frame, clocks, 20);
    REQUIRE(bench.frames == std::vector<Frame>{{Frame::kValue, 22, 170'000}});
    CHECK(bench.malformed == 0);
  }
  Bench late;
  late.paced(frame, 21, 20);  // three that are alone, and a last byte: clear bit 22
  CHECK(late.frames == std::vector<Frame>{{Frame::kClearBit, 22, 0}});
  CHECK(late.malformed == 3);
  Bench never;
  never.paced(frame, 5000, 0);
  CHECK(never.frames == std::vector<Frame>{{Frame::kValue, 22, 170'000}});
}

TEST_CASE("serial2002_rx: the gap ends any partial frame, counts it once, and the next is good") {
  for (const std::vector<std::uint8_t>& part :
       {std::vector<std::uint8_t>{0x81}, {0x8A, 0xFF}, std::vector<std::uint8_t>(1000, 0xFF)}) {
    Bench bench;
    bench.paced(part, 1, 20);
    CHECK(bench.malformed == 0);
    for (int k = 0; k < 60; ++k) bench.clock({});
    CHECK(bench.malformed == 1);
    bench.paced({0x8A, 0x49}, 20, 20);
    CHECK(bench.frames == std::vector<Frame>{{Frame::kValue, 9, 42}});
    CHECK(bench.malformed == 1);
  }
}

TEST_CASE("serial2002_rx agrees with its twin, and any bytes leave it ready") {
  Bench bench;
  Random random(13);
  std::uint32_t gap = 0;
  for (int i = 0; i < 200'000; ++i) {
    if (random() % 100 == 0) gap = random() % 4 != 0 ? random() % 8 : random() & 0xFFFFFF;
    const bool lead = random() % 4 != 0;
    const auto byte = static_cast<std::uint8_t>(lead ? random() | 0x80 : random() & 0x7F);
    bench.clock({random() % 2 != 0, random() % 64 == 0, byte, gap});
    if (random() % 5000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
  }
  bench.bytes({0x00});
  bench.frames.clear();
  bench.bytes({0x8A, 0x49});
  CHECK(bench.frames == std::vector<Frame>{{Frame::kValue, 9, 42}});
}

TEST_CASE("serial2002_rx: a million bytes by the RTL, as by its twin") {
  trammel::test::Rtl<Vserial2002_rx> rtl;
  Serial2002Rx twin;
  Random random(27);
  rtl->valid_i = 0;
  rtl.reset();
  std::int64_t ends = 0, ended = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Serial2002Rx::In in{true, random() % 300 == 0, static_cast<std::uint8_t>(random())};
    rtl->valid_i = in.valid;
    rtl->bad_i = in.bad;
    rtl->byte_i = in.byte;
    const Serial2002Rx::Out out = twin.step(in);
    rtl.tick();
    ends += in.byte < 0x80;
    ended += out.valid + out.malformed;
    const Frame& f = out.frame;
    const bool same = bool(rtl->valid_o) == out.valid && bool(rtl->malformed_o) == out.malformed &&
                      rtl->frame_o == (std::uint64_t{f.kind} << 37 |
                                       std::uint64_t{f.channel} << 32 | f.value);
    if (!same) FAIL("they differ at byte " << i);
  }
  CHECK(ended == ends);
}

TEST_CASE("serial2002_rx, the twin alone: a million bytes, every frame accounted for") {
  Serial2002Rx twin;
  Random random(14);
  std::int64_t ends = 0, frames = 0, malformed = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const auto byte = static_cast<std::uint8_t>(random());
    const auto out = twin.step({true, random() % 200 == 0, byte});
    ends += byte < 0x80;
    frames += out.valid;
    malformed += out.malformed;
    if (random() % 1000 == 0) {  // the next good frame is decoded
      const auto out_end = twin.step({true, false, 0x00});
      ++ends;
      frames += out_end.valid;
      malformed += out_end.malformed;
      twin.step({true, false, 0xCC});
      const auto good = twin.step({true, false, 0x35});
      REQUIRE(good.valid);
      REQUIRE(good.frame == Frame{Frame::kValue, 21, 305});
    }
  }
  CHECK(frames + malformed == ends);
  CHECK(malformed > 10'000);
}
