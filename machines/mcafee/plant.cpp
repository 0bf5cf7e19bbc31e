// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/plant.hpp"

namespace trammel::mcafee {

unsigned StagePlant::limits() const {
  unsigned lines = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::LeadscrewSensor& s = stage_.axis(k).sensor();
    lines |= (s.at_low() ? 1u : 0u) << 2 * k | (s.at_high() ? 2u : 0u) << 2 * k;
  }
  return lines;
}

cosim::Lines StagePlant::sense() const {
  cosim::Lines lines = cosim::Lines{limits()} << limit_low(0);
  for (int axis = 0; axis < kAxes; ++axis) {
    const plant::SineEncoder& e =
        stage_.axis(static_cast<std::size_t>(axis)).sensor().encoder();
    lines |= cosim::Lines{e.a()} << encoder_a(axis) | cosim::Lines{e.b()} << encoder_b(axis) |
             cosim::Lines{!e.marker()} << marker(axis);
  }
  return lines;
}

}  // namespace trammel::mcafee
