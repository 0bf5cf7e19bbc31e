// SPDX-License-Identifier: Apache-2.0
//
// The files that a path is read from: points, and programs in G-code. Throws std::invalid_argument
// that names the key, or the file with its line, and what is permitted.
#pragma once

#include <string>
#include <vector>

#include "machines/kung/options.hpp"
#include "models/ideal/moves.hpp"

namespace trammel::kung {

struct PathFile {
  std::vector<PointM> points;
  ideal::Moves moves;  // for the feed profile; none: points that have their own times
  std::vector<std::string> warnings;  // of the reader
};

// What the file of a path says; nothing of a path without one.
PathFile read_path_file(const Options& options);

}  // namespace trammel::kung
