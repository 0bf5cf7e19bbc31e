// SPDX-License-Identifier: Apache-2.0
#include "models/ideal/normal_equations.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace trammel::ideal;

TEST_CASE("regressors without a common part are known apart, by their own squares") {
  const auto known = knowledge_of<3>({{{4, 0, 0}, {0, 25, 0}, {0, 0, 0.01}}});
  CHECK(known.variance[0] == Approx(0.25));
  CHECK(known.variance[1] == Approx(0.04));
  CHECK(known.variance[2] == Approx(100));
  for (const double share : known.own_share) CHECK(share == Approx(1));
}

TEST_CASE("the variance is the spread of least-squares estimates, the share the sine squared") {
  // Two regressors at 30 degrees to each other, in ten thousand fits of 50 noisy samples.
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::array<std::array<double, 2>, 50> phi{};
  std::array<std::array<double, 2>, 2> r{};
  for (auto& p : phi) {
    p[0] = normal(random);
    p[1] = std::cos(0.5235987756) * p[0] + std::sin(0.5235987756) * normal(random);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) r[i][j] += p[i] * p[j];
    }
  }
  const auto known = knowledge_of(r);
  double squares = 0;
  constexpr int kFits = 10000;
  for (int fit = 0; fit < kFits; ++fit) {
    std::array<double, 2> q{};
    for (const auto& p : phi) {
      const double noise = normal(random);
      for (std::size_t i = 0; i < 2; ++i) q[i] += p[i] * noise;
    }
    const double off = (r[1][1] * q[0] - r[0][1] * q[1]) / (r[0][0] * r[1][1] - r[0][1] * r[1][0]);
    squares += off * off;
  }
  CHECK(squares / kFits == Approx(known.variance[0]).epsilon(0.06));  // four of its deviations
  const double cosine2 = r[0][1] * r[0][1] / (r[0][0] * r[1][1]);
  CHECK(known.own_share[0] == Approx(1 - cosine2));
  CHECK(known.own_share[1] == Approx(1 - cosine2));
}
