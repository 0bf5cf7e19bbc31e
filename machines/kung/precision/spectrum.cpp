// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/precision/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "machines/kung/plan/parts.hpp"

namespace trammel::kung {
namespace {

constexpr std::size_t kLeast = 16;

using Complex = std::complex<double>;

// Of 2048 values, in place: swapped by their reversed bits, then joined pair by pair.
void transform(std::vector<Complex>& x) {
  for (std::size_t k = 1, j = 0; k < kSegment; ++k) {
    std::size_t bit = kSegment / 2;
    for (; (j & bit) != 0; bit /= 2) j -= bit;
    j += bit;
    if (k < j) std::swap(x[k], x[j]);
  }
  for (std::size_t half = 1; half < kSegment; half *= 2) {
    for (std::size_t k = 0; k < half; ++k) {
      const Complex turn = std::polar(1.0, -kPi * static_cast<double>(k) /
                                               static_cast<double>(half));
      for (std::size_t at = k; at < kSegment; at += 2 * half) {
        const Complex other = turn * x[at + half];
        x[at + half] = x[at] - other;
        x[at] += other;
      }
    }
  }
}

}  // namespace

std::vector<double> spectrum(std::size_t n, const std::function<double(std::size_t)>& value) {
  if (n < kLeast) return {};
  const std::size_t length = std::min(n, kSegment);
  const std::size_t last = n - length;  // where the last segment begins
  std::vector<double> window(length), power(kSegment / 2 + 1);
  double sum = 0;
  for (std::size_t k = 0; k < length; ++k) {
    const double turn = 2 * kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(length);
    sum += window[k] = 0.5 - 0.5 * std::cos(turn);
  }
  std::size_t segments = 0;
  for (std::size_t begin = 0;; begin = std::min(begin + kSegment / 2, last)) {
    std::vector<Complex> x(kSegment);
    double mean = 0;
    for (std::size_t k = 0; k < length; ++k) mean += value(begin + k) / static_cast<double>(length);
    for (std::size_t k = 0; k < length; ++k) x[k] = window[k] * (value(begin + k) - mean);
    transform(x);
    for (std::size_t m = 0; m < power.size(); ++m) power[m] += std::norm(x[m]);
    ++segments;
    if (begin == last) break;
  }
  for (double& one : power) one = 2 * std::sqrt(one / static_cast<double>(segments)) / sum;
  return power;
}

}  // namespace trammel::kung
