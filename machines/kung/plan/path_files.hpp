// SPDX-License-Identifier: Apache-2.0
//
// The files that a path is read from: points, and programs in G-code. Throws std::invalid_argument
// that names the key, or the file with its line, and what is permitted.
#pragma once

#include "machines/kung/options.hpp"

namespace trammel::kung {

// Fills points, moves and warnings of options.path as its kind asks for.
void read_path_files(Options& options);

}  // namespace trammel::kung
