// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/identification.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace trammel::gantry {
namespace {

constexpr int kLags = 40;               // of the impulse response
constexpr std::size_t kFewest = 400;    // samples
constexpr double kLeastSpeed = 1;       // [mm/s] rms

template <int Order>
IdentifiedModel model_of(const Samples& first, const Samples& second) {
  const auto m = ideal::identify<Order>(first.u, first.y);
  IdentifiedModel made;
  for (int n = 0; n < Order; ++n) {
    made.a.push_back(m.phi(n, 0));
    made.b.push_back(m.psi(n));
  }
  made.loss = ideal::prediction_loss(m, first.u, first.y);
  const double share = 2.0 * Order / static_cast<double>(first.y.size());
  made.fpe = made.loss * (1 + share) / (1 - share);
  made.fit = ideal::fit_percent(m, second.u, second.y);
  return made;
}

bool usable(const ideal::ImpulseResponse& r) {
  double sum = 0;
  for (const double one : r.h) sum += one;
  for (const double one : r.deviation) sum += one;
  return std::isfinite(sum);
}

bool usable(const IdentifiedModel& m) {
  double sum = m.loss + m.fpe + m.fit;
  for (const double a : m.a) sum += a;
  for (const double b : m.b) sum += b;
  return std::isfinite(sum);
}

}  // namespace

std::optional<Identified> identification(const Samples& run, int dead) {
  const std::size_t count = std::min(run.u.size(), run.y.size());
  if (count < kFewest) return {};
  const auto late = static_cast<std::size_t>(dead - 1), half = count / 2;
  Samples parts[2];
  double square = 0;
  for (std::size_t k = 0; k < count; ++k) {
    Samples& part = parts[k < half ? 0 : 1];
    part.u.push_back(k < late ? 0 : run.u[k - late]);
    part.y.push_back(run.y[k]);
    square += run.y[k] * run.y[k] / static_cast<double>(count);
  }
  if (square < kLeastSpeed * kLeastSpeed) return {};
  Identified made;
  made.impulse = ideal::impulse_response(run.u, run.y, kLags);
  made.dead_samples = made.impulse.dead_samples();
  made.models = {model_of<1>(parts[0], parts[1]), model_of<2>(parts[0], parts[1]),
                 model_of<3>(parts[0], parts[1]), model_of<kMostOrder>(parts[0], parts[1])};
  const bool all = std::all_of(made.models.begin(), made.models.end(),
                               [](const IdentifiedModel& m) { return usable(m); });
  if (!all || !usable(made.impulse)) return {};
  made.run.u.assign(run.u.begin() + static_cast<std::ptrdiff_t>(half), run.u.end());
  made.run.y.assign(run.y.begin() + static_cast<std::ptrdiff_t>(half), run.y.end());
  made.dead = dead;
  return made;
}

}  // namespace trammel::gantry
