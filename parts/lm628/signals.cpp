// SPDX-License-Identifier: Apache-2.0
#include "parts/lm628/signals.hpp"

#include <iterator>
#include <string>

#include "models/exact/motion/lm628_opcode.hpp"

namespace trammel::lm628 {
namespace {

using cosim::Signal;

constexpr struct {
  const char* name;
  int bit;
} kBits[] = {{"status.command_error", exact::kCommandError},
             {"status.complete", exact::kTrajectoryComplete},
             {"status.index", exact::kIndex},
             {"status.wraparound", exact::kWraparound},
             {"status.position_error", exact::kPositionError},
             {"status.breakpoint", exact::kBreakpoint},
             {"status.motor_off", 7}};

}  // namespace

std::vector<Signal> signals_of_part(bool of_axis) {
  static const std::string fine = std::string("2^-16 ") + kWords[1].unit;  // as triggers see it
  std::vector<Signal> all;
  for (const auto& word : kWords) all.push_back({word, of_axis});
  all[1].unit = fine.c_str();
  for (const auto& bit : kBits) {
    all.push_back({{bit.name, "", "bit of the status byte", 1, false}, of_axis});
  }
  return all;
}

const std::vector<Signal>& signals() {
  static const std::vector<Signal> all = signals_of_part(false);
  return all;
}

std::int64_t word(const Words& words, std::size_t signal) {
  constexpr std::size_t kCount = std::size(kWords);
  if (signal < kCount) return kWords[signal].read(words) >> kWords[signal].hidden;
  return words.status >> kBits[signal - kCount].bit & 1;
}

}  // namespace trammel::lm628
