// SPDX-License-Identifier: Apache-2.0
//
// From files, environment and command line to Options. Later layers win:
// defaults < scenario < file (-c) < environment TRAMMEL_<KEY> < -s key=value.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/kung/types.hpp"
#include "testbench/keys.hpp"

namespace trammel::testbench {

// The user's mistake; the text names file, line, key and permitted range. Exit code 2.
struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Applies a TOML file; relative paths in it are meant from its own folder.
void apply_file(kung::Options& options, const std::filesystem::path& file);
void apply_text(kung::Options& options, const std::string& toml, const std::string& source,
                const std::filesystem::path& folder);
// "plant.x.mass_kg=3"; a relative path is meant from the working folder.
void apply_assignment(kung::Options& options, const std::string& assignment);
// Pairs of variable and value; TRAMMEL_PLANT_X_MASS_KG is plant.x.mass_kg.
void apply_environment(kung::Options& options,
                       const std::vector<std::pair<std::string, std::string>>& variables);
std::vector<std::pair<std::string, std::string>> environment();

// Checks what concerns more than one key, and reads the file of points. Throws ConfigError.
void finish(kung::Options& options);

// CSV with two columns of metres, x_m,y_m; a header line and # comments may be there.
std::vector<kung::PointM> read_points(const std::filesystem::path& file);

// Everything needed to repeat the run, as TOML.
std::string run_toml(const kung::Options& options);

// A built-in scenario's name or a path to a .toml file.
std::filesystem::path find_scenario(const std::string& name);
std::vector<std::filesystem::path> scenarios();

// The nearest of `words` within a third of the length, or "".
std::string suggest(const std::string& word, const std::vector<std::string>& words);

}  // namespace trammel::testbench
