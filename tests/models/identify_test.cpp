// SPDX-License-Identifier: Apache-2.0
//
// What is identified of a system that is known.
#include "models/ideal/identify.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

using trammel::ideal::impulse_response;

TEST_CASE("an impulse response is that of the system, whatever is behind the last input") {
  std::minstd_rand dice(1);
  std::vector<double> u, y;
  for (int k = 0; k < 100; ++k) {
    u.push_back(dice() % 2 == 0 ? 1 : -1);
    y.push_back(k < 2 ? 0 : 0.5 * u[u.size() - 2] + 0.25 * u[u.size() - 3]);
  }
  const auto found = impulse_response(u, y, 4);
  const double expected[] = {0, 0.5, 0.25, 0};
  for (std::size_t k = 0; k < 4; ++k) CHECK(found.h[k] == Approx(expected[k]).margin(1e-12));
  y.push_back(7);  // its input is not there yet
  u.push_back(1e9);
  u.pop_back();
  CHECK(impulse_response(u, y, 4).h == found.h);
}
