// SPDX-License-Identifier: Apache-2.0
#include "parts/lm628/signals.hpp"

#include <iterator>

#include "models/exact/motion/lm628_opcode.hpp"

namespace trammel::lm628 {
namespace {

using cosim::Signal;

constexpr struct {
  const char* name;
  const char* help;
  int bits;
  bool is_signed;
  std::int64_t (*read)(const Words&);
} kRows[] = {
    {"desired_count", "trajectory generator, counts", 32, true,
     [](const Words& w) { return w.position >> 16; }},
    {"desired_speed", "trajectory generator, 2^-16 counts a sample", 32, true,
     [](const Words& w) { return std::int64_t{w.speed}; }},
    {"real_count", "what the part counted at the sample", 32, true,
     [](const Words& w) { return std::int64_t{w.actual}; }},
    {"e", "position error, counts", 16, true, [](const Words& w) { return std::int64_t{w.error}; }},
    {"p", "kp e, before its limit of 16 bits", 32, true,
     [](const Words& w) { return std::int64_t{w.proportional}; }},
    {"i", "integral term", 16, true, [](const Words& w) { return std::int64_t{w.integral}; }},
    {"d", "derivative term", 32, true, [](const Words& w) { return std::int64_t{w.derivative}; }},
    {"output", "of the filter", 16, true, [](const Words& w) { return std::int64_t{w.output}; }},
    {"status", "status byte", 8, false, [](const Words& w) { return std::int64_t{w.status}; }},
};

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

constexpr std::size_t kRowCount = std::size(kRows);

}  // namespace

std::vector<Signal> signals_of_part(bool of_axis) {
  std::vector<Signal> all;
  for (const auto& row : kRows) {
    all.push_back({row.name, row.help, row.bits, row.is_signed, of_axis});
  }
  for (const auto& bit : kBits) {
    all.push_back({bit.name, "bit of the status byte", 1, false, of_axis});
  }
  return all;
}

const std::vector<Signal>& signals() {
  static const std::vector<Signal> all = signals_of_part(false);
  return all;
}

std::int64_t word(const Words& words, std::size_t signal) {
  if (signal < kRowCount) return kRows[signal].read(words);
  return words.status >> kBits[signal - kRowCount].bit & 1;
}

}  // namespace trammel::lm628
