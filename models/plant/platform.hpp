// SPDX-License-Identifier: Apache-2.0
//
// One axis of a platform on its screw: where it is for a place of the rotor, in steps.
//
//   place = p + accuracy sin(2 pi p / travel),   p = the rotor's place -+ repeatability / 2
//
// The sign is that of the translator's last step: a place is reached from one side or the other. A
// play would not do: the swing of a step is larger, and ends in the middle of it.
#pragma once

#include <cmath>

namespace trammel::plant {

struct PlatformConfig {
  double accuracy = 0;       // [step] off at most; 0 = an ideal screw
  double repeatability = 0;  // [step] from the place by one side to that by the other
  double travel = 6000;      // [step] of one period of the screw's error
};

// side: +1 by a step forward, -1 by one backward, 0 by none so far.
inline double platform_place(const PlatformConfig& c, double rotor, int side) {
  const double p = rotor - side * c.repeatability / 2;
  return p + c.accuracy * std::sin(6.283185307179586 * p / c.travel);
}

}  // namespace trammel::plant
