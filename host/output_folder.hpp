// SPDX-License-Identifier: Apache-2.0
//
// The folder of a run. Files are gathered in a hidden folder beside it, which takes its place in
// one rename: a folder holds the files of one run, whatever ends the program. run.json, its
// identity, lists them with size and checksum.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/errors.hpp"
#include "host/folder_lock.hpp"

namespace trammel::host {

// Names of the files of a run's record, apart from run.json and report.html: they keep their place
// where the list of them is missing.
std::vector<std::string> record_files();

// Throws ConfigError for a folder that a run must not replace.
void check_replaceable(const std::filesystem::path& target);

class OutputFolder {
 public:
  // Before the run, throws ConfigError for a target that cannot be written or must not be replaced:
  // a folder that is not empty and holds no run, or one that contains the current folder. Removes
  // what runs that were killed have left beside it.
  explicit OutputFolder(const std::filesystem::path& target);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& scratch() const { return scratch_; }
  const std::filesystem::path& target() const { return target_; }

  // The new folder takes the target's place, with the version of the program in its run.json. Files
  // of an earlier run go, those that its run.json does not list are carried over. Throws
  // ConfigError; the target is then as it was.
  void publish(const std::string& version);

 private:
  std::filesystem::path target_;
  std::filesystem::path scratch_;
  FolderLock lock_;  // of the scratch folder: it is in use
};

// Throws ConfigError that names the first file of a run's folder which is not as its run.json says.
// A folder without one is of an older version, or not complete yet.
void check_whole(const std::filesystem::path& folder);

// A file that a verb writes: whole or not at all, in a folder that is made where it is missing.
// Throws ConfigError for one of the record of a run and for all that is no regular file.
void check_result_file(const std::filesystem::path& file);
void write_result_file(const std::filesystem::path& file, const std::string& text);

}  // namespace trammel::host
