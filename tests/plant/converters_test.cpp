// SPDX-License-Identifier: Apache-2.0
//
// Serial converters bit by bit as their data sheets draw them, sensors of any range, and a plant
// that currents drive.
#include <catch2/catch.hpp>
#include <cmath>

#include "models/plant/ad7476.hpp"
#include "models/plant/current_sensor.hpp"
#include "models/plant/current_source.hpp"
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

TEST_CASE("codes are offset binary of 4.6875 mA with 9.6 A full scale") {
  const CurrentSensor s(CurrentSensorConfig{});
  CHECK(s.code(0, 1, 0, 0) == 2048);
  CHECK(s.code(4.6875e-3, 1, 0, 0) == 2049);
  CHECK(s.code(2.3e-3, 1, 0, 0) == 2048);
  CHECK(s.code(2.4e-3, 1, 0, 0) == 2049);
  CHECK(s.code(-4.6875e-3, 1, 0, 0) == 2047);
  CHECK(s.code(4.8, 1, 0, 0) == 3072);
  CHECK(s.code(9.6, 1, 0, 0) == 4095);
  CHECK(s.code(50, 1, 0, 0) == 4095);
  CHECK(s.code(-9.6, 1, 0, 0) == 0);
  CHECK(s.code(-50, 1, 0, 0) == 0);
}

TEST_CASE("a sensor with an error of gain and offset shows both") {
  CurrentSensorConfig c;
  c.gain = 1.1;
  c.offset = -0.6;
  const CurrentSensor s(c);
  CHECK(s.code(0, 1, 0, 0) == 2048 - 128);
  CHECK(s.code(4, 1, 0, 0) == 2048 - 128 + 939);  // 4.4 A of 9.6 A / 2048
}

TEST_CASE("a frame has the bits of a converter behind its leading zeros") {
  CHECK(serial_frame(0xABC, 12) == 0x0ABC);
  CHECK(serial_frame(0xAB, 8) == 0x0AB0);
  CHECK(serial_frame(0x2A, 6) == 0x0A80);
  CHECK(serial_frame(0x2ABC, 14) == 0x2ABC);
  CHECK(serial_frame(0xABCD, 16) == 0xABCD);
  CHECK(leading_zeros(6) == 4);
  CHECK(leading_zeros(13) == 3);
  CHECK(leading_zeros(16) == 0);
}

TEST_CASE("noise is a function of seed, channel and clock alone") {
  CurrentSensorConfig c;
  c.noise = 0.02;
  const CurrentSensor s(c);
  int differs_by_seed = 0, differs_by_channel = 0;
  for (int n = 0; n < 1000; ++n) {
    REQUIRE(s.code(1, 7, 2, n) == s.code(1, 7, 2, n));
    differs_by_seed += s.code(1, 7, 2, n) != s.code(1, 8, 2, n);
    differs_by_channel += s.code(1, 7, 2, n) != s.code(1, 7, 3, n);
  }
  CHECK(differs_by_seed > 500);
  CHECK(differs_by_channel > 500);
}

TEST_CASE("noise has mean 0, variance 1 and no memory") {
  double sum = 0, square = 0, product = 0, last = 0;
  const int count = 200000;
  for (int n = 0; n < count; ++n) {
    const double x = unit_noise(3, 1, n);
    sum += x;
    square += x * x;
    product += x * last;
    last = x;
  }
  // Standard errors: 1/sqrt(200000) = 0.0022; bounds are about five of them.
  CHECK(sum / count == Approx(0).margin(0.011));
  CHECK(square / count == Approx(1).margin(0.016));
  CHECK(product / count == Approx(0).margin(0.011));
}

TEST_CASE("with viscous friction alone the speed is an exponential") {
  AxisConfig config;
  config.coulomb_n = 0;
  config.start_m = 0.1;
  CurrentSource axis(config);
  const double tau = config.mass_kg / config.viscous_n_s_m;
  const double top = config.force_constant_n_a * 0.5 / config.viscous_n_s_m;
  for (int n = 1; n <= 200; ++n) {
    axis.drive(0.5, 0.5e-3);
    const double t = n * 0.5e-3;
    // The current falls short within a span of 25 us, by less than 1e-4 of 0.5 A.
    CHECK(axis.v() == Approx(top * (1 - std::exp(-t / tau))).epsilon(2e-4));
    CHECK(axis.x() == Approx(0.1 + top * (t - tau * (1 - std::exp(-t / tau)))).epsilon(2e-4));
  }
}

TEST_CASE("a thrust below the friction moves it no faster than the friction's smoothing lets it") {
  AxisConfig config;
  config.start_m = 0.1;
  CurrentSource axis(config);
  axis.drive(0.5 * config.coulomb_n / config.force_constant_n_a, 0.2);
  // F/F_c = v/sqrt(v^2 + v_f^2): v = v_f/sqrt(3) for a half
  CHECK(axis.v() == Approx(config.friction_speed_m_s / std::sqrt(3.0)).epsilon(0.01));
}

TEST_CASE("one long drive is two short ones") {
  AxisConfig config;
  CurrentSource one(config), two(config);
  one.drive(1.2, 1e-3);
  two.drive(1.2, 0.5e-3);
  two.drive(1.2, 0.5e-3);
  CHECK(one.x() == Approx(two.x()).epsilon(1e-9));
  CHECK(one.v() == Approx(two.v()).epsilon(1e-9));
}

// The ideal source needs no inductance: the thrust is K_F i_q with any, salient or not.
TEST_CASE("the impressed current's thrust is that of any winding, at any place and speed") {
  for (const double ratio : {0.4, 1.0, 2.5}) {
    for (const double cogging : {0.0, 4.0}) {
      AxisConfig config;
      config.start_m = 0.2;
      config.coulomb_n = 0;
      config.inductance_d_h = 20e-3;
      config.inductance_q_h = ratio * 20e-3;
      config.cogging_n = cogging;
      CurrentSource axis(config);
      double x = 0.2, v = 0;
      const double h = 1e-6;
      for (int k = 0; k < 200; ++k) {
        const double i = k < 100 ? 1.5 : -0.8;
        axis.drive(i, 0.4e-3);
        for (int n = 0; n < 400; ++n) {
          const double thrust = config.force_constant_n_a * i - config.viscous_n_s_m * v -
                                cogging * std::sin(2 * kPi * x / config.pole_pitch_m);
          x += h * (v + 0.5 * h * thrust / config.mass_kg);
          v += h * thrust / config.mass_kg;
        }
        CAPTURE(ratio, cogging, k);
        REQUIRE(axis.v() == Approx(v).epsilon(5e-4).margin(2e-3));
        REQUIRE(axis.x() == Approx(x).margin(5e-5));
      }
    }
  }
}

TEST_CASE("a drive of any length takes that time") {
  AxisConfig config;
  config.coulomb_n = config.viscous_n_s_m = 0;
  for (const double seconds : {3e-6, 24e-6, 26e-6, 100e-6, 101e-6}) {
    CurrentSource axis(config);
    axis.drive(1, seconds);
    CAPTURE(seconds);
    CHECK(axis.v() == Approx(79.9 / 2.5 * seconds).epsilon(2e-4));
  }
}
