// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/record.hpp"

#include <cstdlib>

#include "machines/larson/plant.hpp"

namespace trammel::larson {

Sample sample_of(cosim::Clk edge, const LarsonChip& chip, const TablePlant& plant,
                 const std::array<double, 2>& platforms) {
  Sample sample;
  sample.edge = edge;
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::StepperAxis& axis = plant.axis(k);
    const plant::StepperMotor::State state = axis.state(edge);
    sample.axis[k] = {chip.words(static_cast<int>(k)),
                      static_cast<std::int32_t>(axis.translated()),
                      axis.waiting(),
                      state.at,
                      state.speed,
                      axis.load_angle(edge),
                      axis.rate(),
                      0,
                      platforms[k],
                      axis.torque(edge),
                      axis.current(),
                      axis.power(edge)};
  }
  sample.switches = plant.switches();
  sample.irq = chip.irq();
  return sample;
}

void note_plant(Result& result, const TablePlant& plant, cosim::Clk end) {
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::StepperAxis& axis = plant.axis(k);
    result.lost[k] = std::abs(axis.steps_lost());
    result.slips[k] = axis.lost();
    result.breaches[k] = axis.breaches();
    result.moves[k] = axis.moves();
    result.peaks[k] = axis.peaks();
    result.mean_current[k] = axis.mean_current(end);
  }
}

}  // namespace trammel::larson
