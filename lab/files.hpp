// SPDX-License-Identifier: Apache-2.0
//
// Files in and out. One run, one directory: files are written into a hidden folder beside it and
// moved in at the end, so that a run that fails leaves nothing half written and an older result
// stays whole until then.
#pragma once

#include <fmt/os.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "lab/errors.hpp"

namespace trammel::lab {

class OutputFolder {
 public:
  // Throws ConfigError when the folder cannot be written: before the run, not after it.
  explicit OutputFolder(const std::filesystem::path& target);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& scratch() const { return scratch_; }
  const std::filesystem::path& target() const { return target_; }

  // Moves the files in. Files of an earlier run that this one did not write are removed; what
  // trammel did not write is left alone.
  void publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path scratch_;
};

// Where a run goes: `out` as it was asked for, or the scenario's own folder.
std::filesystem::path target_of(const std::string& out, const std::string& scenario);

// A file, or all of it; one that cannot be read is a ConfigError.
std::ifstream open_text(const std::filesystem::path& file);
std::string read_text(const std::filesystem::path& file);

void write_text(const std::filesystem::path& file, const std::string& text);

// Whole or not at all, even when the disk is full.
void replace_file(const std::filesystem::path& file, const std::string& text);

// A file as long as the run, printed as it goes; throws ConfigError when it cannot be written.
void write_lines(const std::filesystem::path& file,
                 const std::function<void(fmt::ostream&)>& print);

// First program of that name in PATH, or empty.
std::filesystem::path find_program(const std::string& name);

// Quoted as one word of the shell.
std::string shell_word(const std::filesystem::path& path);

// The same, but quoted only where that is needed.
std::string shell_argument(const std::string& text);

}  // namespace trammel::lab
