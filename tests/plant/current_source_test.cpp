// SPDX-License-Identifier: Apache-2.0

#include "models/plant/current_source.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace trammel::plant;

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
