// SPDX-License-Identifier: Apache-2.0
#include "models/plant/current_sensor.hpp"

#include <catch2/catch.hpp>

#include "models/plant/ad7476.hpp"

using namespace trammel::plant;

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
