// SPDX-License-Identifier: Apache-2.0
//
// Files in and out. What cannot be read or written is a ConfigError that names the file and the
// system's reason.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "host/errors.hpp"
#include "host/input_file.hpp"

namespace trammel::host {

// Where a run goes: `out` as it was asked for, or the scenario's own folder.
std::filesystem::path target_of(const std::string& out, const std::string& scenario);

// Most that is read of a file; docs/files.md has them all. [bytes]
constexpr std::uintmax_t kMostWritten = 4 * kMiB;  // by a person: a scenario, a script
constexpr std::uintmax_t kMostRecord = 256 * kMiB;
constexpr std::uintmax_t kMostTrace = 16 * 1024 * kMiB;

// What the system refused to write; the text names the file and the reason.
struct WriteError : ConfigError {
  WriteError(const std::filesystem::path& file, int error);
  int code;  // of the system
};

// What `read` returns; errors of the files that it reads are ConfigErrors.
template <class Read>
auto reading(Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw ConfigError(error.what());
  }
}

// All of a file; one that cannot be read is a ConfigError.
std::string read_text(const std::filesystem::path& file, std::uintmax_t most = kMostRecord);
std::string read_standard_input(std::uintmax_t most);

void write_text(const std::filesystem::path& file, const std::string& text);

// Whole or not at all, even when the disk is full or the power fails; onto nothing but a regular
// file. Until then it has no name, or .NAME.<16 digits>-<process>.
void replace_file(const std::filesystem::path& file, const std::string& text);

// A file as long as the run, written as `print` gives its text.
using Put = std::function<void(const std::string& text)>;
void write_lines(const std::filesystem::path& file, const std::function<void(const Put&)>& print);

// First program of that name in PATH, or empty.
std::filesystem::path find_program(const std::string& name);

// Quoted as one word of the shell; what a terminal does not show as in $'\xff', which bash knows.
std::string shell_word(const std::filesystem::path& path);

// The same, but quoted only where that is needed.
std::string shell_argument(const std::string& text);

}  // namespace trammel::host
