// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/kung/record.hpp"

namespace trammel::kung {
namespace {

constexpr std::int32_t kLargestIqRef = 2047;
constexpr double kVoltageLimit = 0.95 * 2047;  // the limit's table steps inside its circle
constexpr double kWorthTelling = 0.02;         // of the samples
constexpr double kAbove = 1.001;               // a rating, so that four digits show it

}  // namespace

void AxisLoad::add(const AxisSample& s, const plant::AxisConfig& plant) {
  const double square = s.i_d_true_A * s.i_d_true_A + s.i_q_true_A * s.i_q_true_A;
  least_link_V = samples == 0 ? s.dc_link_V : std::min(least_link_V, s.dc_link_V);
  most_link_V = std::max(most_link_V, s.dc_link_V);
  ++samples;
  squares_A2 += square;
  squares_N2 += s.force_N * s.force_N;
  peak_current_A = std::max(peak_current_A, std::sqrt(square));
  if (std::abs(s.i_q_ref) >= kLargestIqRef) ++at_current;
  if (std::hypot(s.v_d, s.v_q) >= kVoltageLimit) ++at_voltage;
  const bool stopped = (s.x_true_m <= plant.stroke_min_m && s.force_N < 0) ||
                       (s.x_true_m >= plant.stroke_max_m && s.force_N > 0);
  if (plant.hard_stops && stopped) ++at_stop;
}

double AxisLoad::rms_current_A() const {
  return samples == 0 ? 0 : std::sqrt(squares_A2 / static_cast<double>(samples) / 2);
}

double AxisLoad::rms_force_N() const {
  return samples == 0 ? 0 : std::sqrt(squares_N2 / static_cast<double>(samples));
}

double AxisLoad::copper_loss_W(double resistance_ohm) const {
  return 3 * resistance_ohm * rms_current_A() * rms_current_A();
}

std::string AxisLoad::limits() const {
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    const double share = static_cast<double>(count) / static_cast<double>(samples);
    if (samples == 0 || share < kWorthTelling) return;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", what, 100 * share);
  };
  add(at_current, "i_q* at its limit");
  add(at_voltage, "voltage at the supply's");
  add(at_stop, "carriage at a hard stop");
  return text.empty() ? "" : text + " of the samples";
}

void add_load(std::vector<lab::Figure>& list, const Options& options, const Result& result) {
  const auto add = [&](const char* id, const char* row, const char* unit, auto value) {
    for (std::size_t a = 0; a < 2; ++a) {
      const char* axis = a == 0 ? "x" : "y";
      list.push_back(lab::figure(fmt::format("{}.{}", axis, id), row, a == 0 ? "X" : "Y",
                                 value(result.load[a], options.plant.axis[a]), unit, 2));
      list.back().shown = result.load[a].samples > 0;
    }
  };
  using Plant = plant::AxisConfig;
  add("rms_current_A", "rms phase current", "A",
      [](const AxisLoad& load, const Plant&) { return load.rms_current_A(); });
  add("rms_force_N", "rms thrust", "N",
      [](const AxisLoad& load, const Plant&) { return load.rms_force_N(); });
  add("copper_loss_W", "copper loss", "W", [](const AxisLoad& load, const Plant& plant) {
    return load.copper_loss_W(plant.resistance_ohm);
  });
  if (options.plant.axis[0].supply_ohm == 0 && options.plant.axis[1].supply_ohm == 0) return;
  add("least_dc_link_V", "lowest DC link", "V",
      [](const AxisLoad& load, const Plant&) { return load.least_link_V; });
  add("most_dc_link_V", "highest DC link", "V",
      [](const AxisLoad& load, const Plant&) { return load.most_link_V; });
}

std::vector<std::string> overloads(const Options& options, const Result& result) {
  std::vector<std::string> lines;
  for (std::size_t a = 0; a < 2; ++a) {
    const AxisLoad& load = result.load[a];
    const plant::AxisConfig& plant = options.plant.axis[a];
    const auto check = [&](const char* what, double value, const char* key, double rating) {
      if (rating <= 0 || value <= kAbove * rating) return;
      lines.push_back(fmt::format("warning: {} of {} is {:.4g} A, above plant.{}.{} = {:g}", what,
                                  a == 0 ? 'X' : 'Y', value, a == 0 ? 'x' : 'y', key, rating));
    };
    check("rms phase current", load.rms_current_A(), "continuous_current_A",
          plant.continuous_current_a);
    check("largest vector of i_d and i_q in a sample", load.peak_current_A, "peak_current_A",
          plant.peak_current_a);
  }
  return lines;
}

}  // namespace trammel::kung
