// SPDX-License-Identifier: Apache-2.0
//
// The words of the precision controller from physical options (docs/precision.md): gains from
// poles, and everything that depends on encoder, motor and current sensors.
#pragma once

#include "machines/kung/chip/record.hpp"
#include "machines/kung/options.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

// Gains of these poles, as words. Throws std::invalid_argument where one has no word.
sw::LawGains law_gains(const std::string& keys, double w1_rad_s, double zeta, double w2_rad_s,
                       double w3_rad_s);

// Of a set-up that is complete but for this; its `on` is false with another controller. Throws
// std::invalid_argument that names the key and the permitted range.
sw::PrecisionSetup plan_precision(const Options& options, const sw::KungSetup& setup);

inline constexpr int kKnee = 4;  // friction is complete at a sixteenth of its speed word

// Estimates in physical units, and which of them are at the ends of their ranges.
AxisEstimate estimate_of(const Options& options, std::size_t axis,
                         const sw::Estimator::Theta& theta);
// The same with whether anything was learned, the estimates that the path did not separate (an own
// share below 0.1), and within what the mass is.
AxisEstimate estimate_of(const Options& options, std::size_t axis, const sw::Estimator& found);
// The same from the words that the chip was told; cogging and force are one current there.
AxisEstimate told_estimate(const Options& options, std::size_t axis, const AxisLaw& law);

}  // namespace trammel::kung
