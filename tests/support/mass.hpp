// SPDX-License-Identifier: Apache-2.0
//
// A mass under a force that is constant in each period: exact.
#pragma once

namespace trammel::test {

struct Mass {
  double mass = 1;      // [kg]
  double x = 0, v = 0;  // [m], [m/s]

  void push(double force, double seconds) {
    const double a = force / mass;
    x += seconds * (v + seconds * a / 2);
    v += seconds * a;
  }
};

}  // namespace trammel::test
