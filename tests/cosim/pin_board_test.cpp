// SPDX-License-Identifier: Apache-2.0
//
// No leap passes the sample tick of a chip without a bus, nor its timer.
#include "cosim/pin_board.hpp"

#include <catch2/catch.hpp>

using namespace trammel::cosim;

TEST_CASE("the sample tick is the last edge of each period, and the edge before a leap's end") {
  PinBoard board;
  board.sample_clk = 100;
  for (Clk edge = 0; edge < 300; ++edge) {
    CHECK(board.samples(edge) == (edge % 100 == 99));
    const Clk waiting = board.waiting(edge);
    CHECK(waiting == (edge % 100 == 99 ? 1 : 99 - edge % 100));
    for (Clk passed = edge; passed < edge + waiting && waiting > 1; ++passed) {
      CHECK_FALSE(board.samples(passed));
    }
  }
}

TEST_CASE("a timer beside the chip ends the wait") {
  PinBoard board;
  board.sample_clk = 1000;
  board.timer.write(10, 20);
  CHECK(board.waiting(11) == 19);
  CHECK(board.waiting(30) == 1);
}
