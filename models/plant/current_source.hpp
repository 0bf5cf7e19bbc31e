// SPDX-License-Identifier: Apache-2.0
//
// An axis whose q current is impressed by an ideal source: motor, carriage, friction and every
// other force of pmlsm.hpp, without inverter, current loop, stops, brake and sensors. The source's
// voltage balances each span at its start, so that the current stays what it is to 1e-4 A.
#pragma once

#include <algorithm>
#include <cmath>

#include "models/plant/axis.hpp"
#include "models/plant/pmlsm.hpp"
#include "models/plant/spans.hpp"

namespace trammel::plant {

class CurrentSource {
 public:
  explicit CurrentSource(const AxisConfig& config)
      : motor_(motor_config(config)),
        longest_(std::min(kLongest, MotorRates(motor_.config()).carriage_span())),
        state_{config.start_m, 0, 0, 0} {}

  // Moves on by `seconds` with i_q [A].
  void drive(double i_q, double seconds) {
    const PmlsmConfig& c = motor_.config();
    const double spans = std::max(1.0, std::ceil(seconds / longest_ - 1e-9));
    const double length = seconds / spans;
    for (int n = 0; n < static_cast<int>(spans); ++n) {
      state_.i_d = 0;
      state_.i_q = i_q;
      const double w = motor_.angular_speed(state_.v);
      const SinCos angle = c.cogging != 0 ? motor_.angle(state_.x) : SinCos{0, 1};
      const plant::AlphaBeta u = Pmlsm::stator(
          -w * c.inductance_q * i_q, c.resistance * i_q + w * motor_.flux(), angle);
      motor_.span(span_, state_, angle, u, {});
      state_ = span_.at(length);
    }
  }

  double x() const { return state_.x; }  // [m]
  double v() const { return state_.v; }  // [m/s]

 private:
  static constexpr double kLongest = 25e-6;  // [s]

  Pmlsm motor_;
  double longest_;  // [s] of a span
  MotorState state_;
  Span span_;
};

}  // namespace trammel::plant
