// SPDX-License-Identifier: Apache-2.0
//
// A DC motor with an incremental encoder on its shaft, which rotates freely: signatures of
// cosim::Plant (models/ may not see cosim/, which wraps it).
#pragma once

#include <cstdint>

#include "models/plant/encoder.hpp"
#include "models/plant/sensed_motor.hpp"

namespace trammel::plant {

struct MotorAxisConfig {
  DcMotorConfig motor;
  int counts = 4000;        // per revolution, after x4 decoding
  double hysteresis = 0.2;  // [counts], full width
  std::int64_t clock_ps = 20000;
};

struct FreeShaft : Encoder {
  using Encoder::Encoder;
  DcMotorBounds bounds() const { return {}; }
};

class MotorAxis : public SensedMotor<FreeShaft> {
 public:
  explicit MotorAxis(const MotorAxisConfig& c, Amplifier amplifier = Amplifier::kLinear)
      : SensedMotor(c.motor, FreeShaft({kTurn / c.counts, c.hysteresis, 0}, 0), c.clock_ps,
                    amplifier),
        counts_(c.counts) {}

  std::int64_t count() const { return sensor().count(); }
  bool a() const { return sensor().a(); }
  bool b() const { return sensor().b(); }
  bool index() const { return count() % counts_ == 0; }

 private:
  int counts_;
};

}  // namespace trammel::plant
