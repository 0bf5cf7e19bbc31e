// SPDX-License-Identifier: Apache-2.0
//
// From files, environment and command line to Settings. Later layers win:
// defaults < scenario < file (-c) < environment TRAMMEL_<KEY> < -s key=value.
// All of these throw ConfigError.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "lab/settings.hpp"

namespace trammel::lab {

// Applies a TOML file; relative paths in it start at its own folder.
void apply_file(Settings& settings, const std::filesystem::path& file);
void apply_text(Settings& settings, const std::string& toml, const std::string& source,
                const std::filesystem::path& folder);
// "plant.x.mass_kg=3"; a relative path starts at the working folder. `where` begins messages.
void apply_assignment(Settings& settings, const std::string& assignment,
                      const std::string& where = "-s");
// Pairs of variable and value; TRAMMEL_PLANT_X_MASS_KG is plant.x.mass_kg.
void apply_environment(Settings& settings,
                       const std::vector<std::pair<std::string, std::string>>& variables);
std::vector<std::pair<std::string, std::string>> environment();

// Everything needed to repeat the run by `command`, as TOML, except keys that are `left_out`.
std::string run_toml(const Settings& settings,
                     const std::string& command = "trammel run run.toml",
                     bool (*left_out)(const Key&) = nullptr);

// Checks the rules of every machine, then those of this one. Called once all layers are in.
void validate(Settings& settings);

}  // namespace trammel::lab
