// SPDX-License-Identifier: Apache-2.0
//
// Models of the track that a run without controller gives (Brochier 2006, 3.2.2.3): its first half
// identifies them, the second judges them.
#pragma once

#include <optional>
#include <vector>

#include "machines/gantry/estimator.hpp"
#include "models/ideal/identify.hpp"

namespace trammel::gantry {

struct IdentifiedModel {
  std::vector<double> a, b;  // y[k] = a1 y[k-1] + ... + b1 u[k-dead] + ...
  double loss = 0;           // [(mm/s)^2] mean square of the prediction error
  double fpe = 0;            // [(mm/s)^2] final prediction error
  double fit = 0;            // [%] of the second half, simulated
};

struct Identified {
  int dead_samples = -1;               // from a force to its first effect; below 0: not seen
  ideal::ImpulseResponse impulse;
  std::vector<IdentifiedModel> models;  // of order 1, 2, ...
  Samples run;                          // the second half, not delayed
  int dead = 1;                         // of the models
};

// With models whose dead time is `dead` samples; nothing where the run moves too little or is too
// short.
std::optional<Identified> identification(const Samples& run, int dead);

}  // namespace trammel::gantry
