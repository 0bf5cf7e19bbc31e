// SPDX-License-Identifier: Apache-2.0
//
// The motor of models/ behind the interface of cosim/. Between pulses the bridge shorts it.
#pragma once

#include "cosim/cosim.hpp"
#include "machines/@name@/pins.hpp"
#include "models/pins/port.hpp"
#include "models/plant/motor_axis.hpp"

namespace trammel::@name@ {

class MotorPlant final : public cosim::Plant {
 public:
  explicit MotorPlant(const plant::MotorAxisConfig& config)
      : axis_(config, plant::Amplifier::kBridge) {}

  cosim::Lines sense() const override {
    return cosim::Lines{axis_.a()} << kEncoderA | cosim::Lines{axis_.b()} << kEncoderB;
  }
  cosim::Clk next() const override { return axis_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    const double sign = level(drive, kDirection) ? -1 : 1;
    axis_.commit(n, level(drive, kPwm) ? sign : 0);
  }
  int sample(int, cosim::Clk) const override { return 0; }  // there is no converter

  std::optional<double> supplied(cosim::Clk n) const override { return axis_.supplied(n); }

  plant::DcMotorState state(cosim::Clk n) const { return axis_.state(n); }

 private:
  plant::MotorAxis axis_;
};

}  // namespace trammel::@name@
