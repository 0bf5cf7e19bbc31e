// SPDX-License-Identifier: Apache-2.0

#include "models/exact/drive/lm628_output.hpp"

#include <Vlm628_output.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::Lm628Output;
using trammel::test::as_bits;
using trammel::test::leap_or_step;
using trammel::test::Random;
using In = Lm628Output::In;

namespace {

struct Rtl : trammel::test::Rtl<Vlm628_output> {
  Rtl() {
    (*this)->leap_i = 0;
    apply({});
  }

  void apply(const In& in) {
    (*this)->commit_i = in.commit;
    (*this)->u_i = as_bits(in.u >> 4, 12) & 0xFFF;
    (*this)->eight_bits_i = in.eight_bits;
    eval();
  }

  void commit(std::int32_t u, bool eight_bits) {
    apply({true, u, eight_bits});
    tick();
    apply({});
  }

  void run(int clocks) {
    for (int i = 0; i < clocks; ++i) tick();
  }
};

std::int32_t word(Random& random) {
  const auto u = static_cast<std::int32_t>(random() % 65536) - 32768;
  return random() % 8 == 0 ? (u < 0 ? -32768 : 32767) : u;
}

}  // namespace

TEST_CASE("lm628_output agrees with its twin on random commands, leaps and resets") {
  Rtl rtl;
  Lm628Output twin({});
  rtl.reset();
  Random random(41);
  In in;
  for (int i = 0; i < 60000; ++i) {
    in = {random() % 400 == 0, word(random), random() % 2 == 0};
    rtl.apply(in);
    if (random() % 5000 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    if (twin.quiescent(in)) REQUIRE(rtl->next_o == twin.next(in));
    rtl->clock_en_i = !twin.quiescent(in);  // its clock is gated where it rests
    leap_or_step(rtl, twin, twin.next(in), random, 4, in);
    rtl->clock_en_i = 1;
    const Lm628Output::Out out = twin.out();
    REQUIRE(rtl->dac_o == out.dac);
    REQUIRE(bool(rtl->dac_hi_lo_o) == out.dac_hi_lo);
    REQUIRE(bool(rtl->dac_wr_n_o) == out.dac_wr_n);
    REQUIRE(bool(rtl->pwm_mag_o) == out.pwm_mag);
    REQUIRE(bool(rtl->pwm_sign_o) == out.pwm_sign);
  }
}

// AN-693: kp = 10 and an error of 100 are 1000 = 03E8h.
TEST_CASE("L-04 lm628_output puts out 83h and 83Eh for +1000, 7Ch and 7C1h for -1000") {
  Rtl rtl;
  rtl.reset();
  rtl.run(300);
  REQUIRE(rtl->dac_o == 0x80);
  rtl.commit(1000, true);
  REQUIRE(rtl->dac_o == 0x83);
  rtl.commit(-1000, true);
  REQUIRE(rtl->dac_o == 0x7C);
  for (const int u : {1000, -1000}) {
    unsigned code = 0;
    int strobes = 0;
    bool wr_n = true;
    rtl.commit(u, false);
    for (int i = 0; i < 300; ++i) {
      if (!wr_n && rtl->dac_wr_n_o) {
        code |= (rtl->dac_o >> 2) << (rtl->dac_hi_lo_o ? 6 : 0);
        REQUIRE((i == 50 || i == 150));  // 8 ticks after tick 400 and 416
        ++strobes;
      }
      wr_n = rtl->dac_wr_n_o;
      rtl.tick();
    }
    REQUIRE(strobes == 2);
    REQUIRE(code == (u > 0 ? 0x83E : 0x7C1));
  }
}

TEST_CASE("lm628_output puts out the zero code of 12 bits in a reset, and then that of 8") {
  Rtl rtl;
  rtl.reset();
  unsigned code = 0;
  bool wr_n = true;
  for (int i = 0; i < 300; ++i) {
    if (!wr_n && rtl->dac_wr_n_o) code |= (rtl->dac_o >> 2) << (rtl->dac_hi_lo_o ? 6 : 0);
    wr_n = rtl->dac_wr_n_o;
    rtl.tick();
  }
  REQUIRE(code == 0x800);
  REQUIRE(rtl->dac_o == 0x80);
}

// LM629: 7 bits of magnitude, period 512 ticks = 3200 clocks, 4 m ticks high.
TEST_CASE("lm628_output is high for 4 m of 512 ticks, with the sign beside it") {
  Rtl rtl;
  rtl.reset();
  for (const int u : {0, 255, 256, -1, -256, 1000, 32767, -32512, -32768}) {
    rtl.commit(u, true);
    const int magnitude = std::min(std::abs(u >= 0 ? u / 256 : -((-u + 255) / 256)), 127);
    for (int period = 0; period < 2; ++period) {
      int high = 0;
      for (int i = 0; i < 3200; ++i) {
        REQUIRE(bool(rtl->pwm_mag_o) == (i < 25 * magnitude));
        high += rtl->pwm_mag_o;
        rtl.tick();
      }
      REQUIRE(high == 25 * magnitude);
      REQUIRE(bool(rtl->pwm_sign_o) == (u < 0));
    }
  }
}
