// SPDX-License-Identifier: Apache-2.0
//
// Benchmark, not a test: CPU seconds of one piece of the circle with the twin engine, with the RTL
// that leaps and with the RTL that evaluates every clock, all wired directly. They alternate; quote
// the median ratios, because the speed of a computer drifts.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "lab/machine.hpp"
#include "machines/kung/chip/record.hpp"

using namespace trammel;

namespace {

// Millions of simulated clocks per CPU second.
double speed(kung::Engine engine, bool leap, double simulated_s) {
  kung::Options options;
  options.run.engine = engine;
  options.run.platform = kung::Platform::kDirect;
  options.run.leap = leap;
  options.run.max_s = simulated_s;
  const std::clock_t start = std::clock();
  const kung::Result result = simulate(options);
  const double cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return static_cast<double>(result.clocks) / cpu_s / 1e6;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main() {
  std::vector<double> to_plain, to_leaping;
  for (int pair = 0; pair < 7; ++pair) {
    const double plain = speed(kung::Engine::kRtl, false, 0.05);
    const double leaping = speed(kung::Engine::kRtl, true, 0.5);
    const double twin = speed(kung::Engine::kTwin, true, 1.2);
    to_plain.push_back(twin / plain);
    to_leaping.push_back(twin / leaping);
    fmt::print("every clock {:.2f}  leaping {:.2f}  twin {:.1f} million clocks/s, ", plain,
               leaping, twin);
    fmt::print("ratio {:.1f} and {:.1f}\n", to_plain.back(), to_leaping.back());
  }
  fmt::print("median ratio: to every clock {:.1f}, to leaping {:.1f}\n", median(to_plain),
             median(to_leaping));
  return 0;
}
