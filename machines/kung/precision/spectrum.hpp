// SPDX-License-Identifier: Apache-2.0
//
// Amplitudes of the sines in a series, by Hann windows over segments of 2048 values that overlap by
// half; their powers are averaged.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace trammel::kung {

inline constexpr std::size_t kSegment = 2048;

// value(k), k < n, with its mean taken off each segment. Element m is that of m/2048 of the rate,
// up to half of it, in the unit of the values; none for less than 16 values. A shorter series is
// one segment, with zeros behind it.
std::vector<double> spectrum(std::size_t n, const std::function<double(std::size_t)>& value);

}  // namespace trammel::kung
