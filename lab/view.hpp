// SPDX-License-Identifier: Apache-2.0
//
// The view of a machine's waves, made from waves/<machine>.toml (docs/waves.md, "The view"): groups
// of signals, those of an axis once per axis, and values in the units of the plant.
#pragma once

#include <string>

#include "lab/settings.hpp"

namespace trammel::lab {

// The view for GTKWave, from the text of that file. With `filter`, a Python interpreter that scales
// values, signals with a unit show it. Throws ConfigError, which begins with `source`.
std::string view_text(const Settings& settings, const std::string& toml, const std::string& source,
                      const std::string& filter);

}  // namespace trammel::lab
