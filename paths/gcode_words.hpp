// SPDX-License-Identifier: Apache-2.0
//
// What the words of one block ask for, and which of them may stand together.
#pragma once

#include <string>
#include <vector>

#include "paths/gcode_block.hpp"

namespace trammel::paths {

// A group of which a block has one word at most is -1 where it has none.
struct GcodeCommands {
  int motion = -1;    // 0 to 3
  int unit = -1;      // 20, 21
  int path = -1;      // 61, 64
  int distance = -1;  // 90, 91
  bool dwell = false, home = false;  // G4, G28
  bool end = false;                  // M2, M30
  std::vector<std::string> ignored;  // such as Z, M3

  bool moves(const GcodeBlock& block) const {
    return !home && (motion >= 2 || block.has_any("XYIJR"));
  }
};

GcodeCommands gcode_commands(const GcodeBlock& block, const GcodeLine& line);

}  // namespace trammel::paths
