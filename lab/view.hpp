// SPDX-License-Identifier: Apache-2.0
//
// The view of a machine's waves, made from waves/<machine>.toml (docs/waves.md, "The view"): groups
// of signals, those of an axis once per axis, and values in the units of the plant.
#pragma once

#include <string>

#include "lab/settings.hpp"

namespace trammel::lab {

struct Views {
  std::string gtkwave;  // a save file
  std::string surfer;   // a command file
};

// Both, from the text of that file. With `filter`, a Python interpreter that scales values, signals
// with a unit show it in GTKWave. Throws ConfigError, which begins with `source`.
Views make_views(const Settings& settings, const std::string& toml, const std::string& source,
                 const std::string& filter);

}  // namespace trammel::lab
