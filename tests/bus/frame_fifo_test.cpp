// SPDX-License-Identifier: Apache-2.0
#include <Vframe_fifo.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/bus/frame_fifo.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Frame;
using trammel::exact::FrameFifo;
using trammel::test::Random;

namespace {

std::uint64_t bits(const Frame& f) {
  return std::uint64_t{f.kind} << 37 | std::uint64_t{f.channel} << 32 | f.value;
}

struct Bench {
  trammel::test::Rtl<Vframe_fifo> rtl;
  FrameFifo twin;

  Bench() {
    put({});
    rtl.reset();
  }
  void put(const FrameFifo::In& in) {
    rtl->push_i = in.push;
    rtl->frame_i = bits(in.frame);
    rtl->pop_i = in.pop;
    rtl.eval();
  }
  void clock(const FrameFifo::In& in) {
    put(in);
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    twin.step(in);
    rtl.tick();
    REQUIRE(bool(rtl->waits_o) == twin.waits());
    REQUIRE(rtl->frame_o == bits(twin.frame()));
    REQUIRE(rtl->room_o == twin.room());
    REQUIRE(rtl->lost_o == twin.lost());
  }
};

}  // namespace

TEST_CASE("frame_fifo keeps 8 frames in their order, refuses and counts a ninth") {
  Bench bench;
  for (std::uint32_t k = 0; k < 10; ++k) bench.clock({true, {4, k, 100 + k}, false});
  CHECK(bench.rtl->room_o == 0);
  CHECK(bench.rtl->lost_o == 2);
  for (std::uint32_t k = 0; k < 8; ++k) {
    CHECK(bench.twin.frame() == Frame{4, k, 100 + k});
    bench.clock({false, {}, true});
  }
  CHECK(bench.rtl->waits_o == 0);
  bench.clock({false, {}, true});  // a pop of none
  CHECK(bench.rtl->room_o == 8);
}

TEST_CASE("frame_fifo agrees with its twin for any input; the count of lost ends at 65535") {
  Bench bench;
  Random random(16);
  for (int i = 0; i < 40'000; ++i) {
    const std::uint32_t often = i / 1000 % 2 == 0 ? 2 : 5;
    bench.clock({random() % often < 1, {random() % 8, random() % 32, random()},
                 random() % (7 - often) < 1});
    if (random() % 4000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
  }
  for (int i = 0; i < 65'600; ++i) bench.clock({true, {4, 1, 2}, false});
  CHECK(bench.rtl->lost_o == 65535);
}
