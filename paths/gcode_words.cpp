// SPDX-License-Identifier: Apache-2.0
#include "paths/gcode_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace trammel::paths {
namespace {

constexpr std::array<int, 14> kKnownG{0, 1, 2, 3, 4, 17, 20, 21, 28, 61, 64, 90, 91, 94};

// Of each of its groups a block has one word.
void read_g(const GcodeBlock& block, const GcodeLine& line, GcodeCommands& to) {
  int home = -1, dwell = -1, plane = -1, feed_mode = -1;
  for (const double number : block.g) {
    const auto* const known = std::find(kKnownG.begin(), kKnownG.end(), number);
    if (known == kKnownG.end()) {
      line.refuse(fmt::format("G{:g} is not known; known: G{}", number, fmt::join(kKnownG, " G")));
    }
    const int code = *known;
    int& group = code <= 3    ? to.motion
                 : code == 4  ? dwell
                 : code == 17 ? plane
                 : code <= 21 ? to.unit
                 : code == 28 ? home
                 : code <= 64 ? to.path
                 : code <= 91 ? to.distance
                              : feed_mode;
    if (group == code) line.refuse(fmt::format("G{} twice in a block", code));
    if (group >= 0) {
      line.refuse(fmt::format("{} in a block: G{} and G{}",
                              code <= 3 ? "two motions" : "two of a kind", group, code));
    }
    group = code;
  }
  to.home = home >= 0;
  to.dwell = dwell >= 0;
}

void read_m(const GcodeBlock& block, const GcodeLine& line, GcodeCommands& to) {
  for (const double number : block.m) {
    const bool ends = number == 2 || number == 30;
    if (ends && to.end) line.refuse("two ends in a block: M2 or M30 once");
    to.end = to.end || ends;
    if (ends) continue;
    if (!(number >= 3 && number <= 9 && number == std::floor(number))) {
      line.refuse(fmt::format("M{:g} is not known; known: M2 M30, ignored: M3 to M9", number));
    }
    to.ignored.push_back(fmt::format("M{:g}", number));
  }
}

}  // namespace

GcodeCommands gcode_commands(const GcodeBlock& block, const GcodeLine& line) {
  GcodeCommands c;
  read_g(block, line, c);
  read_m(block, line, c);
  for (const char letter : std::string_view("ZSTH")) {
    if (block.has(letter)) c.ignored.emplace_back(1, letter);
  }
  const bool arc_words = block.has_any("IJR");
  const std::pair<bool, const char*> rules[] = {
      {c.home && c.motion >= 0, "two motions in a block: G28 and another"},
      {c.dwell && (c.home || c.motion >= 0 || arc_words || block.has_any("XY")),
       "two motions in a block: G4 and another"},
      // Some controllers move the axes that are named alone, some all of them.
      {c.home && block.has('Z'), "Z with G28, which moves X and Y alone"},
      {c.home && block.has('X') != block.has('Y'), "G28 needs both X and Y, or neither"},
      {c.home && arc_words, "I, J and R belong to G2 and G3; the motion is G28"},
      {c.dwell && block.has('S'), "S with G4: a speed, or for some controllers the seconds of the "
                                  "rest; give P"},
      {block.has('P') && c.dwell && c.path == 64, "P with both G4 and G64"},
      {block.has('P') && !c.dwell && c.path != 64, "P belongs to G4 or G64"},
      {c.dwell && !(block.of('P').value_or(-1) >= 0), "G4 needs P [s], 0 or more"},
      {block.has('P') && *block.of('P') < 0, "P of G64 must be 0 or more"}};
  for (const auto& [broken, message] : rules) {
    if (broken) line.refuse(message);
  }
  return c;
}

}  // namespace trammel::paths
