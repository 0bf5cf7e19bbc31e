// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/judge/motor_load.hpp"

#include <fmt/format.h>

namespace trammel::kung {
namespace {

constexpr double kAbove = 1.001;               // a rating, so that four digits show it

}  // namespace

void add_motor_load(std::vector<lab::Figure>& list, const Options& options, const Result& result) {
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
