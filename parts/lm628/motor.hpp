// SPDX-License-Identifier: Apache-2.0
//
// Limits of the integration steps of plant::DcMotor.
#pragma once

#include "models/plant/dc_motor.hpp"

namespace trammel::lm628 {

// Throws host::ConfigError, which names the keys of a motor that is too fast for them.
void check_motor(const plant::DcMotorConfig& motor);

}  // namespace trammel::lm628
