// SPDX-License-Identifier: Apache-2.0
//
// The platform on its screw, by what the words of Larson's list of errors mean.
#include "models/plant/platform.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using trammel::plant::platform_place;
using trammel::plant::PlatformConfig;

TEST_CASE("platform: of an ideal screw it is where the rotor is") {
  for (const double at : {12.0, 700.5, -3.0}) CHECK(platform_place({}, at, -1) == at);
}

TEST_CASE("platform: a place is off by its accuracy at most, and its two sides are apart") {
  PlatformConfig config;
  config.accuracy = 0.4;
  config.repeatability = 0.15;
  double most = 0, apart = 0;
  for (double place = 0; place <= 6000; place += 37) {
    most = std::fmax(most, std::fabs(platform_place(config, place, 0) - place));
    apart = std::fmax(apart, platform_place(config, place, -1) - platform_place(config, place, 1));
  }
  CHECK(most == Approx(0.4).epsilon(1e-3));
  CHECK(apart == Approx(0.15).epsilon(1e-3));
}
