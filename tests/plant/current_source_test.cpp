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
