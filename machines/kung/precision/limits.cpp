// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/precision/limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "machines/kung/precision/plan.hpp"

namespace trammel::kung {

void LimitWatch::on(const Sample& sample, const sw::KungMailbox* program, Result& result) {
  constexpr std::int32_t kMostError = (1 << 19) - 1;  // [count / 256]
  for (std::size_t a = 0; a < 2; ++a) {
    const AxisSample& axis = sample.axis[a];
    const bool on = axis.set_point != kNoSetPoint;
    if (on && std::abs(axis.set_point - 256 * axis.x_p) > kMostError) ++result.error_limited[a];
    if (program == nullptr) continue;
    const bool limited = program->estimator(static_cast<std::uint32_t>(a)).at_limit();
    mass_limited_[a] = limited ? mass_limited_[a] + 1 : 0;
    result.mass_limited[a] = std::max(result.mass_limited[a], mass_limited_[a]);
  }
}

double swing_m(const Options& options, const Sample& sample) {
  for (std::size_t k = 0; k < 2; ++k) {
    const double way = std::abs(sample.axis[k].x_true_m - options.plant.axis[k].start_m);
    if (!(way <= std::min(kFarthestSwing_m, options.diverged_m))) return way;  // also not a number
  }
  return 0;
}

}  // namespace trammel::kung
