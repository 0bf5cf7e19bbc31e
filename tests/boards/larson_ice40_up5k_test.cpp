// SPDX-License-Identifier: Apache-2.0
//
// Larson's interface in a fabric of 12 MHz, as on an iCE40 UP5K: its words over a bus of 16 bits.

#include <Vlarson_ice40_up5k.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/motion/step_table.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::StepTable;
using trammel::test::Random;

namespace {

struct Model : Vlarson_ice40_up5k {
  using Vlarson_ice40_up5k::Vlarson_ice40_up5k;
  std::uint8_t rst_i = 0;  // it has reset_n_i
};

// The board beside the twin of 12 MHz.
struct Board {
  trammel::test::Rtl<Model> rtl;
  StepTable twin{1, 50};
  StepTable::In in;

  Board() {
    rtl->reset_n_i = 0;
    rtl->a_i = 0;
    rtl->read_i = rtl->write_i = rtl->byte_i = rtl->grant_i = 0;
    rtl->limit_low_i = rtl->limit_high_i = rtl->buf_busy_i = 0;
    for (int i = 0; i < 4; ++i) rtl.tick();
    twin.reset();
    rtl->reset_n_i = 1;
  }

  void tick() {
    rtl.tick();
    twin.step(in);
    in.write = in.grant = false;
    rtl->write_i = rtl->grant_i = 0;
    const auto x = twin.axis(0), y = twin.axis(1);
    REQUIRE(rtl->step_o == (x.step | y.step << 1));
    REQUIRE(rtl->forward_o == (x.forward | y.forward << 1));
    REQUIRE(bool(rtl->irq_o) == twin.irq());
  }

  void write(unsigned word, std::uint16_t data, bool half = false) {
    rtl->a_i = word & 3;
    rtl->byte_i = half;
    rtl->d_io = data;
    rtl->write_i = 1;
    in.write = true;
    in.y = word >= 2;
    in.bytes = (half ? 1u : 3u) << (word & 1 ? 2 : 0);
    in.data = std::uint32_t{data} << 16 | data;
    tick();
  }

  std::uint16_t read(unsigned word) {
    rtl->a_i = word & 3;
    rtl->read_i = 1;
    tick();
    rtl->read_i = 0;
    return static_cast<std::uint16_t>(rtl->d_io);
  }
};

}  // namespace

TEST_CASE("larson_ice40_up5k agrees with its twin in 12 MHz, and reads back what it holds") {
  Board board;
  Random random(3);
  int steps = 0;
  bool was = false;
  for (int i = 0; i < 30000; ++i) {
    if (random() % 100 == 0) {
      const unsigned word = random() % 4;
      const std::uint32_t data = (word & 1) != 0
                                     ? (random() & 0xB000) | (4095 - random() % 20)
                                     : 0xFFFF - random() % 6;
      board.write(word, static_cast<std::uint16_t>(data), random() % 5 == 0);
    } else {
      board.tick();
    }
    if (random() % 20 == 0) {
      for (unsigned word = 0; word < 4; ++word) {
        const auto axis = board.twin.axis(word / 2);
        CAPTURE(word);  // X count and status, Y count and status
        REQUIRE(board.read(word) == ((word & 1) != 0 ? axis.status : axis.count));
      }
      board.tick();  // the bus turns
    }
    steps += board.twin.axis(0).step && !was;
    was = board.twin.axis(0).step;
  }
  CHECK(steps > 5);
}

TEST_CASE("larson_ice40_up5k: a grant shows the vector and takes it") {
  Board board;
  board.write(2, 0xFFFF);
  board.write(3, 0x9FFF);
  REQUIRE(board.rtl->irq_o);
  board.rtl->grant_i = 1;
  board.in.grant = true;
  board.tick();
  CHECK(board.rtl->d_io == 0344);
  CHECK_FALSE(board.rtl->irq_o);
}

TEST_CASE("larson_ice40_up5k leaves the bus alone while it is reset") {
  Board board;
  REQUIRE(board.read(0) == 0xFFFF);  // the count, as after the reset
  board.rtl->reset_n_i = 0;
  board.rtl->read_i = 1;
  board.rtl.tick();
  CHECK(board.rtl->d_io == 0);  // a bus that nobody drives shows as 0
  board.rtl->reset_n_i = 1;
  board.rtl.tick();
  CHECK(board.rtl->d_io == 0xFFFF);
}
