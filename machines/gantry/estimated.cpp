// SPDX-License-Identifier: Apache-2.0
//
// Figures of runs without controller: how well the velocity is known, and the models of the track.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machines/gantry/estimated.hpp"
#include "machines/gantry/units.hpp"

namespace trammel::gantry {
namespace {


// Around the mean of each stretch.
class Spread {
 public:
  void add(double value) {
    sum_ += value;
    square_ += value * value;
    ++count_;
  }
  void end_stretch() {
    if (count_ > 0) all_ += square_ - sum_ * sum_ / count_;
    counts_ += count_;
    sum_ = square_ = 0;
    count_ = 0;
  }
  double rms() const { return counts_ == 0 ? -1 : std::sqrt(std::max(0.0, all_ / counts_)); }

 private:
  double sum_ = 0, square_ = 0, all_ = 0;
  int count_ = 0, counts_ = 0;
};

}  // namespace

// Constant is a speed that has been the same, within 1 mm/s, for 0.25 s: longer than the filters'
// lag, which is no noise.
VelocityFigures velocity_figures(const Options& options, const Result& result) {
  constexpr double kSteady_s = 0.25, kSame_mm_s = 1, kNear_s = 0.1;
  const double look_s = options.run.seconds(kLook);
  const auto samples_in = [look_s](double s) {
    return static_cast<std::size_t>(std::round(s / look_s));
  };
  const std::size_t steady = samples_in(kSteady_s), near = samples_in(kNear_s);
  std::vector<double> v, filtered;
  Spread raw, noise;
  double low = 0, high = 0;  // of the speed since it was constant last
  std::size_t since = 0;
  for (const Look& s : result.looks) {
    const double true_v = 1e3 * s.v;
    v.push_back(true_v);
    filtered.push_back(kVelocity_mm_s * s.velocity);
    low = std::min(low, true_v);
    high = std::max(high, true_v);
    if (high - low > kSame_mm_s) {
      low = high = true_v;
      since = v.size();
      raw.end_stretch();
      noise.end_stretch();
    }
    if (true_v == 0 || v.size() < since + steady) continue;
    raw.add(kVelocity_mm_s * s.words.velocity - true_v);
    noise.add(filtered.back() - true_v);
  }
  raw.end_stretch();
  noise.end_stretch();
  VelocityFigures f;
  for (std::size_t k = 0; k < v.size(); ++k) {
    f.error_mm_s += std::pow(filtered[k] - v[k], 2) / static_cast<double>(v.size());
  }
  f.error_mm_s = std::sqrt(f.error_mm_s);
  f.raw_mm_s = raw.rms();
  f.noise_mm_s = noise.rms();
  int turns = 0, seen = 0;
  double late = 0, changes = 0, before = 0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (v[k] == 0) continue;
    if (v[k] * before < 0) {
      ++turns;
      std::size_t n = k;
      while (n < v.size() && filtered[n] * v[k] <= 0) ++n;
      if (n < v.size()) {
        late += static_cast<double>(n - k);
        ++seen;
      }
      const std::size_t to = std::min(v.size() - 1, k + near);
      for (std::size_t m = k - std::min(k, near); m < to; ++m) {
        if ((filtered[m] < 0) != (filtered[m + 1] < 0)) ++changes;
      }
    }
    before = v[k];
  }
  if (seen > 0) f.late_s = look_s * late / seen;
  if (turns > 0) f.changes = changes / turns;
  return f;
}

std::vector<lab::Figure> open_figures(const Options& options, const Result& result) {
  using lab::figure;
  const VelocityFigures v = velocity_figures(options, result);
  std::vector<lab::Figure> list;
  if (v.raw_mm_s >= 0) {
    list.push_back(figure("velocity.raw_mm_s", "noise at constant speed", "of the observer",
                          v.raw_mm_s, "mm/s", 2));
    list.push_back(figure("velocity.noise_mm_s", "noise at constant speed", "filtered",
                          v.noise_mm_s, "mm/s", 2));
    list.back().tile = "Noise";
  }
  list.push_back(
      figure("velocity.error_mm_s", "filtered velocity", "rms error", v.error_mm_s, "mm/s", 2));
  if (v.late_s >= 0) {
    list.push_back(figure("velocity.late_ms", "change of sign", "filtered behind the cart",
                          1e3 * v.late_s, "ms", 1));
    list.push_back(figure("velocity.changes", "change of sign",
                          "of the filtered for one of the cart", v.changes, "", 1));
  }
  if (!result.identified) return list;
  const Identified& found = *result.identified;
  if (found.dead_samples >= 0) {
    list.push_back(
        lab::count("model.dead_samples", "dead time", "", found.dead_samples, "samples"));
    list.back().printed = 3;
    list.back().source = "Brochier 2006, figure 22";
  }
  for (const IdentifiedModel& m : found.models) {
    const std::string id = fmt::format("model.order_{}.", m.a.size());
    const std::string row = fmt::format("model of order {}", m.a.size());
    list.push_back(figure(id + "fit_percent", row, "fit", m.fit, "%", 2));
    if (m.a.size() == 3) {
      list.back().printed = 53.49;
      list.back().source = "Brochier 2006, figure 23";
      list.back().tile = "Fit";
    }
    list.push_back(figure(id + "loss", row, "loss", m.loss, "(mm/s)^2", 3));
    list.push_back(figure(id + "fpe", row, "final prediction error", m.fpe, "(mm/s)^2", 3));
  }
  return list;
}

// For the page: models, and the run that judges them in steps that its noise exceeds.
nlohmann::ordered_json identified_json(const Result& result) {
  auto json = nlohmann::ordered_json::object();
  if (!result.identified) return json;
  constexpr std::size_t kShown = 300;  // samples of the second half
  const Identified& found = *result.identified;
  const auto rounded = [](const std::vector<double>& values, std::size_t most, double digit) {
    auto list = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < std::min(most, values.size()); ++k) {
      list.push_back(std::round(values[k] / digit) * digit);
    }
    return list;
  };
  json["dead"] = found.dead;
  json["impulse"] = found.impulse.h;
  json["deviation"] = found.impulse.deviation;
  for (const IdentifiedModel& m : found.models) json["models"].push_back({{"a", m.a}, {"b", m.b}});
  json["validation"] = {{"u", rounded(found.run.u, kShown, 0.125)},
                        {"y", rounded(found.run.y, kShown, 0.0625)}};
  return json;
}

std::vector<std::string> open_remarks(const Result& result) {
  if (!result.identified) return {"no model: the run is too short, or the cart moves too little"};
  std::vector<std::string> lines;
  for (const IdentifiedModel& m : result.identified->models) {
    lines.push_back(fmt::format("model of order {}: -s velocity.model=\"{}\"", m.a.size(),
                                model_text(m.a, m.b)));
  }
  return lines;
}

}  // namespace trammel::gantry
