// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/cpu.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/errors.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"

namespace trammel::kung {

void check_cpu(const Options& options) {
  const bool rtl = options.cpu == Cpu::kRtl;
  require(rtl || options.uart.empty(),
          "run.uart: native firmware has no serial port; --cpu rtl has one");
  if (!rtl) return;
  require(!options.fault.of_processor(),
          "inject.fault: faults of the processor are of native firmware (run.cpu = \"native\"); "
          "processor_hung gives its RTL an illegal instruction");
  require(!options.path.open_position(),
          "path.sweep_of: \"current\" needs a command within a period of the carrier, which only "
          "run.cpu = \"native\" gives");
}

namespace {

struct Shown {
  double first, mean;
  cosim::Clk worst;
};

// What the routines of a run would take by processor.*: as many transfers, each as long.
Shown native_of(const Options& options, const cosim::CoreTimes& core) {
  const double access = options.processor.access_clk;
  const double latency = options.processor.interrupt_latency_clk;
  const auto routine = [&](double transfers) {
    return latency + options.point_clk + transfers * (access + core.answer.mean());
  };
  // The core's counts begin a clock behind the line's edge.
  return {latency + access - 1, routine(core.transfers.mean()),
          static_cast<cosim::Clk>(routine(static_cast<double>(core.transfers.worst)))};
}

double period_clk(const Options& options) {
  return ticks_per_point(options) * options.chip.sample_s() * 1e12 /
         static_cast<double>(options.run.clock_ps);
}

}  // namespace

std::vector<std::string> cpu_lines(const Options& options, const Result& result) {
  std::vector<std::string> lines;
  if (!result.core || result.core->routine.count == 0) return lines;
  const cosim::CoreTimes& core = *result.core;
  const Shown native = native_of(options, core);
  const double period = period_clk(options);
  const auto line = [&](const char* name, double first, double mean, cosim::Clk worst) {
    return fmt::format("{:<22}{:10.0f}{:14}{:8.2f} %{:12.0f}{:8.2f} %", name, first, worst,
                       100 * static_cast<double>(worst) / period, mean, 100 * mean / period);
  };
  lines.push_back(fmt::format("{:<22}{:>10}{:>14}{:>10}{:>12}{:>10}", "service routine (clk)",
                              "first", "worst", "", "mean", ""));
  lines.push_back(
      line("  the core's RTL", core.first.mean(), core.routine.mean(), core.routine.worst));
  lines.push_back(line("  native, by keys", native.first, native.mean, native.worst));
  lines.push_back(fmt::format("first: interrupt to first access; %: of the {:.0f} clocks between "
                              "interrupts; {:.0f} clocks from an answer to the next access",
                              period, core.between.mean()));
  return lines;
}

void add_cpu(const Options& options, const Result& result, nlohmann::ordered_json& json) {
  if (!result.core) return;
  const cosim::CoreTimes& core = *result.core;
  const auto spread = [](const cosim::Spread& s) {
    return nlohmann::ordered_json{{"count", s.count}, {"worst", s.worst}, {"mean", s.mean()}};
  };
  json["processor"] = {{"first_access_clk", spread(core.first)},
                       {"routine_clk", spread(core.routine)},
                       {"transfers", spread(core.transfers)},
                       {"answer_clk", spread(core.answer)},
                       {"between_clk", spread(core.between)},
                       {"interrupt_period_clk", period_clk(options)},
                       {"awake_clk", result.core_awake}};
}

std::unique_ptr<SocCore> core_of(const Options& options, const sw::KungSetup& setup) {
  if (core_image().empty()) {
    throw host::ToolMissing(
        "run.cpu: \"rtl\" needs what was missing when this program was built: the core's RTL "
        "(pythondata-cpu-picorv32 in .venv) or riscv64-unknown-elf-g++; ./trammel run with --cpu "
        "rtl installs both");
  }
  return make_core(core_memory(setup, true), options.run.audit);
}

}  // namespace trammel::kung
