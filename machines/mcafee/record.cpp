// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/record.hpp"

#include "machines/mcafee/plant.hpp"

namespace trammel::mcafee {

Sample sample_of(cosim::Clk edge, const McafeeChip& chip, const StagePlant& plant) {
  Sample sample;
  sample.edge = edge;
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::LeadscrewAxis& axis = plant.stage().axis(k);
    const plant::DcMotorState state = axis.state(edge);
    const double mm = 1e3 / axis.sensor().radians_per_m();  // a radian
    const int part = static_cast<int>(k);
    sample.axis[k] = {chip.words(part), chip.host_irq(part), mm * state.theta,
                      mm * state.omega, state.i,             axis.voltage()};
  }
  sample.limits = plant.limits();
  return sample;
}

}  // namespace trammel::mcafee
