// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/record.hpp"

#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/plant.hpp"

namespace trammel::gantry {

Sample sample_of(cosim::Clk edge, const GantryChip& chip, const TrackPlant& plant,
                 const sw::GantryMailbox& mail) {
  const plant::BeltAxis axis = plant.axis().ahead(edge);  // bridges may not have switched for 1 ms
  const plant::BeltState& s = axis.state();
  Sample sample;
  sample.edge = edge;
  sample.words = chip.words();
  sample.x = s.x[plant::BeltState::kCart];
  sample.v = s.v[plant::BeltState::kCart];
  sample.origin = plant.origin(edge, sample.words.position);
  sample.motor = {s.x[plant::BeltState::kMotor1] - sample.x,
                  s.x[plant::BeltState::kMotor2] - sample.x};
  for (std::size_t m = 0; m < sample.force.size(); ++m) {
    sample.force[m] = axis.mean_force(m, TrackPlant::kCarrier);
  }
  sample.stripes = {plant.sample(kA, edge), plant.sample(kB, edge)};
  sample.flank = {axis.flank(plant::BeltState::kMotor1), axis.flank(plant::BeltState::kMotor2)};
  sample.error = mail.error;
  sample.goal = mail.goal;
  sample.zero = mail.zero;
  sample.velocity = mail.velocity;
  sample.goal_velocity = mail.goal_velocity;
  sample.phase = static_cast<int>(mail.phase);
  return sample;
}

void note_program(Result& result, const sw::GantryMailbox& mail) {
  result.fault = what_failed(mail);
  result.passes = mail.point;
  result.unknown = mail.unknown;
  result.refused = mail.refused;
  result.unchecked = mail.unchecked;
  result.unsent = mail.unsent;
  result.phase = mail.phase;
  result.homed = mail.homed != 0;
  result.fitted = mail.fitted != 0;
  result.fit = mail.words;
}

}  // namespace trammel::gantry
