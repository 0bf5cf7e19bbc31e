// SPDX-License-Identifier: Apache-2.0
//
// Benchmark, not a test: clocks per second of the look-ahead SystemC platform with plant and
// firmware, against a bare loop over the same chip without either. Both evaluate every clock.
// The two alternate; quote the median ratio, because the speed of a computer drifts.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "lab/machine.hpp"
#include "machines/kung/chip/chip.hpp"
#include "machines/kung/options.hpp"
#include "machines/kung/tests/chips.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel;

namespace {

constexpr double kSimulatedS = 0.1;
constexpr cosim::Clk kClocks = 5'000'000;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double bare_clocks_per_s() {
  const auto chip = kung::make_verilated_chip(false);
  const test::NoPlant plant;
  return kClocks / seconds([&] {
           while (chip->now() < kClocks) chip->run(kClocks, plant);
         });
}

double platform_clocks_per_s() {
  kung::Options options;
  options.run.leap = false;
  options.run.max_s = kSimulatedS;
  return kClocks / seconds([&] { simulate(options); });
}

}  // namespace

int main() {
  std::vector<double> ratios;
  for (int pair = 0; pair < 5; ++pair) {
    const double bare = bare_clocks_per_s();
    const double platform = platform_clocks_per_s();
    ratios.push_back(platform / bare);
    fmt::print("bare {:.2f}  platform {:.2f} million clocks/s  ratio {:.3f}\n", bare / 1e6,
               platform / 1e6, ratios.back());
  }
  std::sort(ratios.begin(), ratios.end());
  fmt::print("median ratio {:.3f}\n", ratios[ratios.size() / 2]);
}
