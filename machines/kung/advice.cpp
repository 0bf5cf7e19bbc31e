// SPDX-License-Identifier: Apache-2.0
//
// What a motor and its supply cannot give for the path that is asked, told before a run.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "machines/kung/machine.hpp"
#include "machines/kung/plan.hpp"
#include "machines/kung/words.hpp"

namespace trammel::kung {
namespace {

// Largest speed of each axis along the path [m/s]; of a square wave that of the reference model,
// whose step response is steepest at step omega_n / e (damping ratio 1).
std::array<double, 2> top_speed_m_s(const Options& options, const sw::KungSetup& setup) {
  const PathOptions& path = options.path;
  if (path.kind == PathKind::kSquare) {
    const double step_m = std::abs(path.square_high_m - path.square_low_m);
    return {step_m * options.gains[0].omega_n_rad_s / std::exp(1),
            step_m * options.gains[1].omega_n_rad_s / std::exp(1)};
  }
  if (path.open_position()) return {};
  sw::PathSetup once = setup;
  once.repeats = 1;
  sw::Trajectory points(once);
  sw::Point last = points.start();
  std::int32_t x = 0, y = 0;  // [counts per point]
  for (std::uint32_t n = points.size(); n > 0; --n) {
    const sw::Point p = points.next();
    x = std::max(x, std::abs(p.x - last.x));
    y = std::max(y, std::abs(p.y - last.y));
    last = p;
  }
  const double point_s = ticks_per_point(path, options.chip.irq_period_ticks) *
                         options.chip.sample_s();
  return {x * options.plant.axis[0].encoder_count_m / point_s,
          y * options.plant.axis[1].encoder_count_m / point_s};
}

}  // namespace

std::vector<std::string> advice(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  std::vector<sw::Point> points;
  const sw::KungSetup setup = plan_firmware(options, points);
  const std::array<double, 2> speed_m_s = top_speed_m_s(options, setup);
  std::vector<std::string> lines;
  for (std::size_t a = 0; a < 2; ++a) {
    const plant::AxisConfig& plant = options.plant.axis[a];
    const char axis = a == 0 ? 'x' : 'y';
    const double v = speed_m_s[a];
    const double load_N = plant.coulomb_n + plant.viscous_n_s_m * v +
                          std::abs(plant.external_force_n);
    const double load_A = load_N / plant.force_constant_n_a;
    const double largest_A = 2047 * current_ref_lsb_A(plant.current_full_scale_a);
    if (load_A > largest_A) {
      lines.push_back(fmt::format("{}: friction and load of {:.4g} N at {:.3g} m/s take {:.3g} A; "
                                  "plant.{}.current_full_scale_A = {:g} allows an i_q* of {:.3g} A",
                                  axis, load_N, v, load_A, axis, plant.current_full_scale_a,
                                  largest_A));
    }
    // Of a phase: lambda omega_e = 2/3 K_F v, and the drop of the load's current.
    const double volt = 2.0 / 3 * plant.force_constant_n_a * v + plant.resistance_ohm * load_A;
    const double supply = plant.dc_link_v / std::sqrt(3.0);
    if (volt > supply) {
      lines.push_back(fmt::format("{}: back-EMF and drop of {:.4g} V at {:.3g} m/s are above the "
                                  "{:.4g} V of a phase that plant.{}.dc_link_V = {:g} gives",
                                  axis, volt, v, supply, axis, plant.dc_link_v));
    }
    const double offset_A = std::max(std::abs(plant.current_offset_a_a),
                                     std::abs(plant.current_offset_b_a));
    if (offset_A > 0 && options.chip.offset_samples == 0) {
      lines.push_back(fmt::format("{}: an offset of {:g} A of a current sensor is not measured: "
                                  "chip.offset_samples = 0", axis, offset_A));
    }
  }
  return lines;
}

}  // namespace trammel::kung
