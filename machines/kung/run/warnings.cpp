// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/warnings.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "machines/kung/plan/believed.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/run/make_plan.hpp"

namespace trammel::kung {
namespace {

// A path that run.max_s cuts. Who shortens the run wants a part of a path whose time its keys say;
// those of a feed profile do not.
std::string cut_text(const Options& options, const sw::KungSetup& setup) {
  const double max_s = options.run.max_s;
  const double path_s = sw::Trajectory(setup).size() * options.chip.sample_s() *
                            ticks_per_point(options) +
                        options.settle_s;
  if (path_s <= max_s || (max_s < Options().run.max_s && !feeds(options))) return "";
  return fmt::format("the path takes {:.4g} s, longer than run.max_s = {:g}: the run ends "
                     "ahead of the path, with exit code 5", path_s, max_s);
}

// Of the speed loop [rad/s], whose open loop is kv K_F / (M s).
std::string speed_loop_text(const Options& options, std::size_t a) {
  const plant::AxisConfig& plant = options.plant.axis[a];
  const AxisGains g = gains_of(options, a);
  if (options.controller == Controller::kPrecision) return "";
  if (options.path.is_sweep() || plant.locked) return "";
  const double kg = plant.mass_kg + plant.payload_kg;
  const double rate = g.kv * kSpeedGain * plant.force_constant_n_a / kg;
  const bool slow = rate < g.omega_n_rad_s / 2, fast = rate * options.chip.sample_s() > 1.2;
  if (!slow && !fast) return "";
  const char axis = a == 0 ? 'x' : 'y';
  return fmt::format("{0}: gains.{0}.kv = {1:g}{2} makes of {3:g} kg a speed loop of {4:.3g} "
                     "rad/s, too {5}; gains.by_rule makes 220 rad/s{6}", axis, g.kv,
                     options.gains_by_rule ? " by gains.by_rule" : "", kg, rate,
                     slow ? fmt::format("slow for gains.{}.omega_n_rad_s = {:g}", axis,
                                        g.omega_n_rad_s)
                          : fmt::format("fast for chip.position_Hz = {}",
                                        options.chip.position_Hz),
                     options.gains_by_rule ? " of the motor that keys believed.* describe" : "");
}

// Of the current loop, whose axes turn on while it computes and settles. By trial, with all four
// carriers, with and without dead time, they may turn once in ten carrier periods and two of its
// time constants, L_q/K_p.
std::string turning_text(const Options& options, std::size_t a, double speed_m_s) {
  const plant::AxisConfig& plant = options.plant.axis[a];
  const double kp_V_A = gains_of(options, a).current_kp_V_A;
  if (kp_V_A == 0) return "";
  const double loop_rad_s = kp_V_A / plant.inductance_q_h;
  const double turns_Hz = speed_m_s / (2 * plant.pole_pitch_m);
  const double most_Hz = 1 / (10.0 / options.chip.carrier_Hz + 2 / loop_rad_s);
  if (turns_Hz <= most_Hz) return "";
  return fmt::format("{0}: {1:.3g} m/s are {2:.4g} electrical turns a second with "
                     "plant.{0}.pole_pitch_m = {3:g}, above the {4:.4g} that a current loop of "
                     "{5:.4g} rad/s follows with chip.carrier_Hz = {6}", a == 0 ? 'x' : 'y',
                     speed_m_s, turns_Hz, plant.pole_pitch_m, most_Hz, loop_rad_s,
                     options.chip.carrier_Hz);
}

// Of the dead times, against which a winding of little resistance has only the slow integrator of
// its current loop. By trial with 80 motors of 48 to 560 V on square waves under AFC: below 10
// times the largest drop the error is that without dead time, at 10 to 120 times it is up to 1.3
// times as large, and from 200 times on the run misses.
std::string dead_time_text(const Options& options, std::size_t a, const Demand& most) {
  constexpr double kWorthTelling = 20, kRests_m_s = 1e-6;
  const plant::AxisConfig& plant = options.plant.axis[a];
  const double dead_V = plant.dc_link_v * 1e-9 * options.chip.axis[a].dead_time_ns *
                        options.chip.carrier_Hz;
  if (most.speed_m_s < kRests_m_s || plant.locked) return "";
  if (dead_V <= kWorthTelling * most.drop_V) return "";
  return fmt::format("{0}: dead time takes {1:.3g} V of a phase whose resistance drops {2:.2g} V "
                     "at most on this path: the current is late at each change of its sign; a "
                     "lower chip.{0}.dead_time_ns, chip.carrier_Hz or plant.{0}.dc_link_V makes "
                     "it less", a == 0 ? 'x' : 'y', dead_V, most.drop_V);
}

// Of a start on a hard stop. What brakes the move before the path then presses the table against
// the stop, unseen by the encoder, until the path begins: 21 to 26 um with an empty table, and 12
// with a payload. One count farther inside it was 10 at most.
std::string stop_text(const Options& options, std::size_t a, double start_m) {
  const plant::AxisConfig& plant = options.plant.axis[a];
  if (options.controller != Controller::kPrecision || !plant.hard_stops) return "";
  const bool low = start_m - plant.stroke_min_m < plant.encoder_count_m / 2;
  const bool high = plant.stroke_max_m - start_m < plant.encoder_count_m / 2;
  if (!low && !high) return "";
  return fmt::format("{0}: the path begins on the hard stop plant.{0}.stroke_{1}_m = {2:g}: in its "
                     "first 10 ms a light table is up to 30 um from the command; a start {3:g} um "
                     "farther inside avoids it", a == 0 ? 'x' : 'y', low ? "min" : "max",
                     low ? plant.stroke_min_m : plant.stroke_max_m, 1e6 * plant.encoder_count_m);
}

}  // namespace

std::vector<std::string> warnings(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  const std::shared_ptr<const Plan> plan = plan_of(options);
  const sw::KungSetup& setup = plan->setup;
  const std::array<Demand, 2>& most = plan->walk.demand;
  std::vector<std::string> lines = plan->file.warnings;
  if (const std::string cut = cut_text(options, setup); !cut.empty()) lines.push_back(cut);
  const cosim::ProcessorOptions& cpu = options.processor;
  const Options usual;
  if (options.cpu == Cpu::kRtl &&
      (cpu.access_clk != usual.processor.access_clk || options.point_clk != usual.point_clk ||
       cpu.interrupt_latency_clk != usual.processor.interrupt_latency_clk)) {
    lines.push_back("processor.access_clk, interrupt_latency_clk and point_clk have no effect with "
                    "run.cpu = \"rtl\", whose core takes the clocks that it takes");
  }
  for (std::string& line : unused_beliefs(options)) lines.push_back(std::move(line));
  const sw::Point start = sw::Trajectory(setup).start();
  const std::array<double, 2> start_m{start.x * options.plant.axis[0].encoder_count_m,
                                      start.y * options.plant.axis[1].encoder_count_m};
  for (std::size_t a = 0; a < 2; ++a) {
    const plant::AxisConfig& plant = options.plant.axis[a];
    const char axis = a == 0 ? 'x' : 'y';
    const double load_A = most[a].force_N / plant.force_constant_n_a;
    const double largest_A = 2047 * current_ref_lsb_A(plant.current_full_scale_a);
    if (load_A > largest_A) {
      lines.push_back(fmt::format("{}: inertia, friction, cogging and load of {:.4g} N at {:.3g} "
                                  "m/s take {:.3g} A; plant.{}.current_full_scale_A = {:g} allows "
                                  "an i_q* of {:.3g} A", axis, most[a].force_N,
                                  std::abs(most[a].at_force_m_s), load_A, axis,
                                  plant.current_full_scale_a, largest_A));
    }
    const double supply = plant.dc_link_v / std::sqrt(3.0);
    if (most[a].volt > supply) {
      lines.push_back(fmt::format("{}: back-EMF, drop and dead time of {:.4g} V at {:.3g} m/s are "
                                  "above the {:.4g} V of a phase that plant.{}.dc_link_V = {:g} "
                                  "gives", axis, most[a].volt, std::abs(most[a].at_volt_m_s),
                                  supply, axis, plant.dc_link_v));
    }
    for (const std::string& loop : {stop_text(options, a, start_m[a]),
                                    dead_time_text(options, a, most[a]),
                                    speed_loop_text(options, a),
                                    turning_text(options, a, most[a].speed_m_s)}) {
      if (!loop.empty()) lines.push_back(loop);
    }
    const double still_N = plant.coulomb_n + plant.stribeck_n;
    if (!plant.brake && !plant.locked && std::abs(plant.external_force_n) > still_N) {
      lines.push_back(fmt::format("{0}: {1:g} N are above the friction of {2:g} N: they move the "
                                  "carriage before its drive is on, as plant.{0}.brake = false",
                                  axis, std::abs(plant.external_force_n), still_N));
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
