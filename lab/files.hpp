// SPDX-License-Identifier: Apache-2.0
//
// Files in and out. What cannot be read or written is a ConfigError that names the file and the
// system's reason.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "lab/errors.hpp"

namespace trammel::lab {

// Where a run goes: `out` as it was asked for, or the scenario's own folder.
std::filesystem::path target_of(const std::string& out, const std::string& scenario);

// A file, or all of it; one that cannot be read is a ConfigError.
std::ifstream open_text(const std::filesystem::path& file);
std::string read_text(const std::filesystem::path& file);

void write_text(const std::filesystem::path& file, const std::string& text);

// Whole or not at all, even when the disk is full; onto nothing but a regular file.
void replace_file(const std::filesystem::path& file, const std::string& text);

// A file as long as the run, written as `print` gives its text.
using Put = std::function<void(const std::string& text)>;
void write_lines(const std::filesystem::path& file, const std::function<void(const Put&)>& print);

// First program of that name in PATH, or empty.
std::filesystem::path find_program(const std::string& name);

// Quoted as one word of the shell.
std::string shell_word(const std::filesystem::path& path);

// The same, but quoted only where that is needed.
std::string shell_argument(const std::string& text);

}  // namespace trammel::lab
