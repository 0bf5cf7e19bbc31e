// SPDX-License-Identifier: Apache-2.0
//
// Serial converters bit by bit as their data sheets draw them, and sensors of other ranges.
#include <catch2/catch.hpp>
#include <cmath>

#include "models/plant/ad7476.hpp"
#include "models/plant/current_sensor.hpp"
#include "models/plant/mcp3008.hpp"

using namespace trammel::plant;

TEST_CASE("ad7476: 16 bits, the highest at the fall of cs_n, each next one at a fall of sclk") {
  for (const int frame : {0x0ABC, 0x8001, 0x5A5A, 0xFFFF, 0x0000}) {
    Ad7476 converter;
    int samples = 0;
    const auto code = [&] { return ++samples, frame; };
    for (int again = 0; again < 2; ++again) {
      CHECK_FALSE(converter.step(true, true, code));
      int word = converter.step(false, true, code) ? 1 : 0;
      for (int bit = 1; bit < 16; ++bit) {
        const bool fallen = converter.step(false, false, code);
        CAPTURE(frame, bit);
        CHECK(converter.step(false, true, code) == fallen);  // a rise moves nothing
        word = word * 2 + (fallen ? 1 : 0);
      }
      CHECK(word == frame);
      converter.step(false, false, code);
      CHECK_FALSE(converter.step(false, true, code));  // zeros follow
      CHECK(samples == again + 1);
    }
  }
}

TEST_CASE("ad7476: without cs_n the line is low and nothing is shifted") {
  Ad7476 converter;
  const auto code = [] { return 0xFFFF; };
  CHECK(converter.step(false, true, code));
  CHECK_FALSE(converter.step(true, true, code));
  CHECK_FALSE(converter.step(true, false, code));
  CHECK_FALSE(converter.step(true, true, code));
}

namespace {

// A transfer: `before` clocks with din low, the start bit, single-ended, three bits of channel;
// then a clock in which it holds, a 0 and the ten bits.
int converted(Mcp3008& converter, int channel, int before, int* asked) {
  const auto code = [&](int of) { return *asked = of, 0x155 + of; };
  converter.step(true, false, false, code);
  const auto clock = [&](bool din) {
    converter.step(false, false, din, code);
    converter.step(false, true, din, code);
    return converter.step(false, false, din, code);
  };
  for (int k = 0; k < before; ++k) clock(false);
  clock(true);
  clock(true);
  for (int bit = 2; bit >= 0; --bit) clock((channel >> bit & 1) != 0);
  REQUIRE(*asked == -1);
  CHECK_FALSE(clock(true));  // it holds, and shows a 0
  int word = 0;
  for (int bit = 0; bit < 10; ++bit) word = word * 2 + (clock(true) ? 1 : 0);
  return word;
}

}  // namespace

TEST_CASE("mcp3008: each channel's ten bits follow its address and a zero, in any transfer") {
  Mcp3008 converter;
  for (const int before : {0, 1, 3}) {
    for (int channel = 0; channel < 8; ++channel) {
      int asked = -1;
      CAPTURE(before, channel);
      CHECK(converted(converter, channel, before, &asked) == 0x155 + channel);
      CHECK(asked == channel);
    }
  }
}

TEST_CASE("mcp3008: a transfer that is cut leaves nothing to the next") {
  for (int cut = 1; cut < 16; ++cut) {
    Mcp3008 converter;
    const auto code = [](int) { return 0x3FF; };
    for (int k = 0; k < cut; ++k) {
      converter.step(false, true, true, code);
      converter.step(false, false, true, code);
    }
    CAPTURE(cut);
    CHECK_FALSE(converter.step(true, false, true, code));
    int asked = -1;
    CHECK(converted(converter, 5, 0, &asked) == 0x155 + 5);
    CHECK(asked == 5);
  }
}

TEST_CASE("a sensor of any range and bits has half of its codes for each sign") {
  for (const int bits : {6, 10, 12, 16}) {
    for (const double full : {2.0, 20.0}) {
      CurrentSensorConfig c;
      c.bits = bits;
      c.full_scale = full;
      c.gain = 0.9;
      c.offset = 0.05 * full;
      const CurrentSensor sensor(c);
      const int half = 1 << (bits - 1);
      CAPTURE(bits, full);
      CHECK(sensor.code(-c.offset / c.gain, 1, 0, 0) == half);
      for (const double part : {-0.8, -0.25, 0.1, 0.5}) {
        const double shown = 0.9 * part + 0.05;
        CHECK(sensor.code(part * full, 1, 0, 0) ==
              half + static_cast<int>(std::floor(shown * half + 0.5)));
      }
      CHECK(sensor.code(2 * full, 1, 0, 0) == 2 * half - 1);
      CHECK(sensor.code(-2 * full, 1, 0, 0) == 0);
    }
  }
}
