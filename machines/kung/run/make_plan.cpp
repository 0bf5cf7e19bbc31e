// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/make_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "host/errors.hpp"
#include "machines/kung/plan/axis.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/precision/plan.hpp"
#include "machines/kung/run/cpu.hpp"
#include "models/exact/drive/carrier.hpp"

namespace trammel::kung {
namespace {

constexpr std::array<std::uint32_t, 3> kPositionHz{1000, 2000, 4000};  // by RATES.position

// The index of that rate in a field of RATES.
template <std::size_t N>
std::uint32_t nearest_rate(const char* key, int value, const std::array<std::uint32_t, N>& rates) {
  std::uint32_t best = 0;
  const auto away = [&](std::uint32_t n) { return std::abs(value - static_cast<int>(rates[n])); };
  for (std::uint32_t n = 1; n < N; ++n) {
    if (away(n) < away(best)) best = n;
  }
  require(away(best) == 0,
          fmt::format("{}: value {} is no rate of the chip; the nearest is {}, a whole number of "
                      "clocks and of position samples", key, value, rates[best]));
  return best;
}

}  // namespace

std::shared_ptr<const Plan> make_plan(const Options& options, PathFile file) {
  const auto plan = std::make_shared<Plan>();
  plan->options = options;
  plan->options.prepared.reset();
  plan->file = std::move(file);
  sw::KungSetup& s = plan->setup;
  const ChipOptions& chip = options.chip;
  s.carrier = nearest_rate("chip.carrier_Hz", chip.carrier_Hz, exact::kCarrierHz);
  s.position_rate = nearest_rate("chip.position_Hz", chip.position_Hz, kPositionHz);
  const double count_m = options.plant.axis[0].encoder_count_m;
  require(count_m == options.plant.axis[1].encoder_count_m,
          fmt::format("plant.y.encoder_count_m: value {:g} must equal plant.x.encoder_count_m = "
                      "{:g}: the processor draws the path in counts",
                      options.plant.axis[1].encoder_count_m, count_m));
  static_cast<sw::PathSetup&>(s) =
      plan_path(options, plan->file, Encoder{count_m, chip.sample_s()}, plan->store);
  require(options.cpu == Cpu::kNative || !options.fault.of_processor(),
          "inject.fault: those of the processor and its bus need run.cpu = \"native\"; "
          "processor_hung is a fault of the core");
  require(options.cpu == Cpu::kNative || options.fault.for_s == 0 ||
              options.fault.kind != cosim::FaultKind::kProcessorHung,
          fmt::format("inject.for_s: value {:g} must be 0: with run.cpu = \"rtl\" processor_hung "
                      "is an illegal instruction, which stops the core for good",
                      options.fault.for_s));
  s.current_command = options.path.open_position();
  for (std::size_t a = 0; a < 2; ++a) s.axis[a] = plan_axis(options, a);
  s.irq_period = word(ticks_per_point(options));
  s.watchdog_ticks = word(chip.watchdog_ticks);
  if (s.watchdog_ticks != 0) {
    in_range("chip.watchdog_ticks", s.watchdog_ticks, s.irq_period + 1, 65535,
             "or 0; COMMITs come once per chip.irq_period_ticks");
  }
  const double full_scale_A = options.plant.axis[0].current_full_scale_a;
  require(full_scale_A == options.plant.axis[1].current_full_scale_a,
          fmt::format("plant.y.current_full_scale_A: value {:g} must equal "
                      "plant.x.current_full_scale_A = {:g}: CURRENT_LIMIT is that of both axes",
                      options.plant.axis[1].current_full_scale_a, full_scale_A));
  const double lsb_A = current_lsb_A(full_scale_A);
  in_range("chip.current_limit_A", chip.current_limit_A, lsb_A, 2047 * lsb_A,
           fmt::format("at plant.x.current_full_scale_A = {:g}", full_scale_A));
  s.current_limit = static_cast<std::uint32_t>(std::lround(chip.current_limit_A / lsb_A));
  s.offset_samples = word(chip.offset_samples);
  s.following_limit = static_cast<std::int32_t>(
      std::ceil(chip.following_error_m / options.plant.axis[0].encoder_count_m));
  if (chip.d_current_A != 0) {
    in_range("chip.d_current_A", chip.d_current_A, lsb_A, 2047 * lsb_A,
             fmt::format("or 0, at plant.x.current_full_scale_A = {:g}", full_scale_A));
  }
  s.d_current_limit = static_cast<std::int32_t>(std::lround(chip.d_current_A / lsb_A));
  s.dead_time_min = clocks(chip.dead_time_min_ns, options.run.clock_ps);
  plan->walk = walk_path(options, s);
  check_extent(options, plan->walk.low, plan->walk.high);
  check_sweep(options);
  s.precision = plan_precision(options, s);
  return plan;
}

std::shared_ptr<const Plan> make_plan(const Options& options) {
  return make_plan(options, read_path_file(options));
}

std::shared_ptr<const Plan> plan_of(const Options& options) {
  auto plan = std::static_pointer_cast<const Plan>(options.prepared);
  const bool fits = plan && std::all_of(keys().begin(), keys().end(), [&](const lab::Key& key) {
    return key.get(options) == key.get(plan->options);
  });
  return fits ? plan : make_plan(options);
}

void validate(lab::Settings& settings) {
  auto& options = static_cast<Options&>(settings);
  try {
    options.prepared = make_plan(options);
    check_cpu(options);
  } catch (const std::invalid_argument& error) {
    throw host::ConfigError(error.what());
  }
}

}  // namespace trammel::kung
