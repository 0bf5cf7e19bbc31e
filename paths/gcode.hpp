// SPDX-License-Identifier: Apache-2.0
//
// G-code as lines and arcs in the plane: the subset of RS274/NGC that docs/gcode.md describes. What
// is outside of it, and what programs that read G-code take in different ways, is refused.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "models/ideal/moves.hpp"

namespace trammel::paths {

constexpr std::size_t kMostMoves = 4096;

// What a program may ask of the table it runs on.
struct GcodeTable {
  ideal::Place start, home;        // where it rests before the program; where G28 goes
  ideal::Place low, high{0.6, 0.6};  // the stroke
  double feed_min = 1e-4;          // F below it is refused [m/s]
  double feed_max = 1;             // F above it is lowered [m/s]
  double rapid = 0.5;              // of G0 and G28 [m/s]
  double radius_min = 1e-6;        // of an arc [m]
  double radius_max = 5;           // [m]
  double shortest = 1e-7;          // what is shorter is no motion, nothing is lost [m]
  bool exact = false;              // G61 in place of G64 at the start
  std::string feed_max_name = "the largest feed";  // in the warning
};

struct GcodeProgram {
  ideal::Moves moves;
  std::vector<std::string> warnings;  // FILE:LINE: text
};

// Throws std::invalid_argument, FILE:LINE: text that names what is wrong and what is permitted.
GcodeProgram read_gcode(std::string_view text, const std::string& name, const GcodeTable& table);
// The same of a file; one that cannot be read is an InputError.
GcodeProgram read_gcode_file(const std::string& file, const GcodeTable& table);

}  // namespace trammel::paths
