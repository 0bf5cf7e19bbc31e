// SPDX-License-Identifier: Apache-2.0
//
// The LM629 on an iCEBreaker, from configuration on: what the bridge gets, and when.

#include <Vlm628_icebreaker.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/support/rtl.hpp"

namespace {

// The clock pin is the board's, and there is no reset but those of the button and of the pin.
struct Model : Vlm628_icebreaker {
  using Vlm628_icebreaker::Vlm628_icebreaker;
  CData& clk_i = clk_12mhz_i;
  std::uint8_t rst_i = 0;
};

constexpr int kLocks = 16;  // [clk] of tests/boards/cells/SB_PLL40_PAD.sv

struct Board {
  trammel::test::Rtl<Model> rtl;

  Board() {
    rtl->btn_n_i = rtl->reset_n_i = 1;
    rtl->cs_n_i = rtl->rd_n_i = rtl->wr_n_i = rtl->ps_i = 1;
    rtl->enc_a_i = rtl->enc_b_i = rtl->enc_idx_n_i = 1;
    rtl.eval();
  }
  void off(int clocks) {
    for (int n = 0; n < clocks; ++n) {
      rtl.tick();
      CAPTURE(n);
      REQUIRE(rtl->driver_en_o == 0);
      REQUIRE(rtl->pwm_mag_o == 0);
      REQUIRE(rtl->pwm_sign_o == 0);
      REQUIRE(rtl->led_red_n_o == 0);  // on
      REQUIRE(rtl->led_green_n_o == 1);
    }
  }
};

}  // namespace

TEST_CASE("lm628_icebreaker: the bridge is off until RST was strobed, by the button or the pin") {
  for (const bool button : {false, true}) {
    CAPTURE(button);
    Board board;
    CData& strobe = button ? board.rtl->btn_n_i : board.rtl->reset_n_i;
    board.off(kLocks + 20'000);  // nobody strobes
    strobe = 0;
    board.off(100);
    strobe = 1;
    board.rtl.tick();
    CHECK(board.rtl->driver_en_o == 1);
    CHECK(board.rtl->led_red_n_o == 1);
  }
}

TEST_CASE("lm628_icebreaker: a strobe that ends before the PLL has locked is none") {
  Board board;
  board.rtl->reset_n_i = 0;
  board.off(kLocks / 2);
  board.rtl->reset_n_i = 1;
  board.off(1000);
}
