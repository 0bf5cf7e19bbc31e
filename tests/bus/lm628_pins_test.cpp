// SPDX-License-Identifier: Apache-2.0
//
// What the pins share, from the part's twin: the output port in each of its forms.

#include <Vlm628_pins.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/drive/lm628_output.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

using trammel::exact::Lm628Output;
using trammel::test::Random;
using trammel::test::same;

namespace {

// The pins beside the output of the part at 8 MHz.
struct Bench {
  trammel::test::Rtl<Vlm628_pins> rtl;
  Lm628Output output{Lm628Output::Config{}};
  Random random{111};
  std::int64_t clock = 0;
  bool reading = false;

  Bench() {
    set(false);
    rtl.reset();
    output.reset();
  }

  void set(bool sample) {
    const Lm628Output::Out out = output.out();
    rtl->d_oe_i = reading;
    rtl->sample_i = sample;
    rtl->dac_i = out.dac;
    rtl->dac_hi_lo_i = out.dac_hi_lo;
    rtl->dac_wr_n_i = out.dac_wr_n;
    rtl->pwm_mag_i = out.pwm_mag;
    rtl->pwm_sign_i = out.pwm_sign;
  }

  void edge(const Lm628Output::In& in = {}) {
    set(in.commit);
    output.step(in);
    rtl.tick();
    ++clock;
  }
};

// Latches of a board with a converter of 12 bits: pin 25 strobes, pin 24 says which half.
struct Converter {
  unsigned low = 0, code = 0;
  bool was = true;
  int strobes = 0;

  void see(unsigned pins) {
    const bool wr = (pins & 1) != 0;
    if (wr && !was) {
      ++strobes;
      if ((pins & 2) == 0) {
        low = pins >> 2;
      } else {
        code = (pins & 0xFC) << 4 | low;
      }
    }
    was = wr;
  }
};

}  // namespace

TEST_CASE("lm628_pins begin with 12 bits of zero and their strobes, then show 8 bits of zero") {
  Bench bench;
  Converter converter;
  int bytes = 0;
  for (int i = 0; i < 600; ++i) {
    bench.edge();
    if (bench.rtl->out_o == 0x80) {
      ++bytes;
    } else {
      REQUIRE(bytes == 0);
      converter.see(bench.rtl->out_o);
    }
  }
  CHECK(converter.strobes == 2);
  CHECK(converter.code == 0x800);
  CHECK(bytes > 200);
}

TEST_CASE("lm628_pins give a converter of 12 bits each word, one of 8 each byte, a clock later") {
  Bench bench;
  Converter converter;
  for (int i = 0; i < 600; ++i) bench.edge();
  bool eight = true;
  for (int n = 0; n < 400; ++n) {
    if (bench.random() % 8 == 0) eight = !eight;
    const auto u = static_cast<std::int16_t>(bench.random());
    CAPTURE(n, eight, u);
    bench.edge({true, u, eight});
    bench.edge();
    const bool first = bench.random() % 4 != 0;
    for (int i = 0; i < (first ? 300 : 160); ++i) {
      bench.edge();
      if (!eight) converter.see(bench.rtl->out_o);
      if (eight) REQUIRE(bench.rtl->out_o == (u + 0x8000) >> 8);
    }
    if (!eight) REQUIRE(converter.code == static_cast<unsigned>(u + 0x8000) >> 4);
  }
}

TEST_CASE("lm628_pins turn a transceiver a clock before they drive and a clock after") {
  Bench bench;
  int drives = 0;
  bool was = false, was_direction = false;
  for (int i = 0; i < 20'000; ++i) {
    if (bench.random() % 6 == 0) bench.reading = !bench.reading;
    const bool asked = bench.reading;
    bench.edge();
    const bool drive = bench.rtl->d_oe_o != 0, direction = bench.rtl->direction_o != 0;
    same("d_oe_o", drive, asked && was_direction, bench.clock);
    same("direction_o", direction, asked || was, bench.clock);
    REQUIRE((!drive || direction));
    if (drive && !was) REQUIRE(was_direction);
    if (!drive && was) REQUIRE(direction);
    drives += drive && !was ? 1 : 0;
    was = drive;
    was_direction = direction;
  }
  CHECK(drives > 500);
}
