// SPDX-License-Identifier: Apache-2.0
//
// TOML and JSON that others wrote: what is too deep or too wide for the libraries that read them is
// refused before it ends the program or takes minutes.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace trammel::host {

// Parts in parts beyond this are in no scenario, and in no file of a run.
constexpr int kDeepest = 64;
// Members of one object of a run's files.
constexpr std::size_t kMostMembers = 4096;

// Throws ConfigError that names source and line where tables, arrays or the parts of one key are
// nested deeper.
void check_depth(const std::string& toml, const std::string& source);

// An object. Throws ConfigError that names the file and what is corrupt.
nlohmann::ordered_json parse_object(const std::string& text, const std::filesystem::path& file);

}  // namespace trammel::host
