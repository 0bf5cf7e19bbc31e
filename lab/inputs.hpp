// SPDX-License-Identifier: Apache-2.0
//
// The files that keys name, kept beside the record of a run, so that run.toml repeats it whatever
// becomes of them.
#pragma once

#include <filesystem>
#include <memory>

#include "lab/settings.hpp"

namespace trammel::lab {

// Copies of them as they are now, each by the name of its key, into the folder of a run; those that
// are there already stay. A file that cannot be read has none.
void copy_inputs(const Settings& settings, const std::filesystem::path& folder);

// These settings with the copies in that folder in place of their files.
std::unique_ptr<Settings> with_copies(const Settings& settings,
                                      const std::filesystem::path& folder);

}  // namespace trammel::lab
