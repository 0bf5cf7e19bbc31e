// SPDX-License-Identifier: Apache-2.0
#include "lab/response.hpp"

#include <cmath>

namespace trammel::lab {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kHalfPower_dB = -3.0102999566398120;

// Where a curve over log f falls through `level`: the frequency, and how far between points
// `index` and `index + 1`.
struct Crossing {
  std::size_t index = 0;
  double part = 0;

  double between(const std::vector<double>& values) const {
    return values[index] + part * (values[index + 1] - values[index]);
  }
  double hz(const Response& r) const {
    return r[index].hz * std::pow(r[index + 1].hz / r[index].hz, part);
  }
};

std::optional<Crossing> falls_through(const std::vector<double>& values, double level) {
  for (std::size_t k = 0; k + 1 < values.size(); ++k) {
    if (values[k] >= level && values[k + 1] < level) {
      return Crossing{k, (values[k] - level) / (values[k] - values[k + 1])};
    }
  }
  return {};
}

std::vector<double> decibels(const Response& response) {
  std::vector<double> all;
  for (const ResponsePoint& point : response) all.push_back(decibel(point.gain));
  return all;
}

}  // namespace

void ToneSum::add(double x) {
  const double turn = static_cast<double>(k_) / static_cast<double>(period_);
  sum_ += std::polar(x, -2 * kPi * turn);
  if (++k_ == period_) k_ = 0;
}

Response opened(const Response& closed) {
  Response open;
  for (const ResponsePoint& point : closed) {
    open.push_back({point.hz, point.gain / (1.0 - point.gain)});
  }
  return open;
}

double decibel(std::complex<double> gain) { return 20 * std::log10(std::abs(gain)); }

std::vector<double> phases(const Response& response) {
  std::vector<double> all;
  for (const ResponsePoint& point : response) {
    double degree = std::arg(point.gain) * 180 / kPi;
    const double near = all.empty() ? -90 : all.back();
    degree -= 360 * std::round((degree - near) / 360);
    all.push_back(degree);
  }
  return all;
}

Margins margins(const Response& closed) {
  Margins m;
  if (closed.empty()) return m;
  const std::vector<double> closed_dB = decibels(closed);
  m.peak_db = closed_dB[0];
  m.peak_hz = closed[0].hz;
  for (std::size_t k = 1; k < closed.size(); ++k) {
    if (closed_dB[k] <= m.peak_db) continue;
    m.peak_db = closed_dB[k];
    m.peak_hz = closed[k].hz;
  }
  if (const auto at = falls_through(closed_dB, closed_dB[0] + kHalfPower_dB)) {
    m.bandwidth_hz = at->hz(closed);
  }
  const Response open = opened(closed);
  const std::vector<double> open_dB = decibels(open), degrees = phases(open);
  if (const auto at = falls_through(open_dB, 0)) {
    m.crossover_hz = at->hz(open);
    m.phase_margin_deg = 180 + at->between(degrees);
  }
  if (const auto at = falls_through(degrees, -180)) {
    m.reversal_hz = at->hz(open);
    m.gain_margin_db = -at->between(open_dB);
  }
  return m;
}

}  // namespace trammel::lab
