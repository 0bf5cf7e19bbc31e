// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/tests/perf/row.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <stdexcept>

#include "lab/layers.hpp"
#include "lab/scenarios.hpp"

namespace trammel::perf {
namespace {

Arguments read_arguments(int argc, char** argv) {
  if (argc < 2) throw host::ConfigError("which row?");
  Arguments arguments;
  arguments.row = argv[1];
  lab::apply_file(arguments.options, lab::find_scenario("circle"));
  for (int i = 2; i < argc; ++i) {
    const std::string text = argv[i];
    const std::string value = text.substr(text.find('=') + 1);
    if (text.rfind("pins=", 0) == 0) {
      arguments.pins = value;
    } else if (text.rfind("speed=", 0) == 0) {
      arguments.speed_m_s = std::stod(value);
    } else if (text.rfind("waves=", 0) == 0) {
      arguments.options.run.wave_file = value;
    } else {
      lab::apply_assignment(arguments.options, text);
    }
  }
  lab::validate(arguments.options);
  return arguments;
}

double cpu_s() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// getrusage() would report the parent's peak, which exec() hands on.
long peak_kib() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long kib = 0;
    if (word == "VmHWM:" && status >> kib) return kib;
  }
  return 0;
}

}  // namespace

int report(int argc, char** argv, const std::function<Outcome(const Arguments&)>& run) {
  try {
    const Arguments arguments = read_arguments(argc, argv);
    const auto start = std::chrono::steady_clock::now();
    const double before = cpu_s();
    const Outcome outcome = run(arguments);
    const double used = cpu_s() - before;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    fmt::print("{{\"clocks\": {}, \"evaluated\": {}, \"event_hash\": \"{:016x}\", "
               "\"wall_s\": {:.6f}, \"cpu_s\": {:.6f}, \"peak_kib\": {}, \"record_kib\": {}}}\n",
               outcome.clocks, outcome.evaluated, outcome.event_hash, wall.count(), used,
               peak_kib(), outcome.samples * sizeof(kung::Sample) / 1024);
    return 0;
  } catch (const host::ConfigError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

}  // namespace trammel::perf
