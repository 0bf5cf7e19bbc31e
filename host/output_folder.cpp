// SPDX-License-Identifier: Apache-2.0
#include "host/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "host/parse.hpp"

namespace trammel::host {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr char kIdentity[] = "run.json";
constexpr char kPageFile[] = "report.html";  // `trammel report` makes it again at any time
constexpr char kMark[] = ".trammel-";         // in the names of scratch folders
constexpr std::size_t kSuffix = 6;            // characters behind it: of mkdtemp()
constexpr char kMarker[] = "trammel-scratch";  // the file in one that says so
constexpr char kFiles[] = "run";              // the folder in it that becomes the run's
constexpr char kAside[] = "run-old";          // what that replaces, while there is no other way

// For another run that puts its own folder in the place of the same one, some renames.
constexpr std::chrono::seconds kPatience{20};

constexpr const char* kRecordFiles[] = {"detail.json", "metrics.json", "run.toml",
                                        "script.lm628", "trace.csv", "waves.fst",
                                        "waves.gtkw", "waves.vcd"};

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw ConfigError(fmt::format("{}: --out: {}", folder.string(), why));
}

[[noreturn]] void cannot_write(const fs::path& folder, int error) {
  refuse(folder, fmt::format("cannot be written: {}", std::strerror(error)));
}

Json entry_of(const fs::path& file) {
  std::vector<char> block(1 << 16);
  std::uint64_t bytes = 0;
  uLong sum = 0;
  reading([&] {  // in blocks, however long the waves are
    InputFile in(file.string(), std::numeric_limits<std::uintmax_t>::max());
    while (const std::size_t size = in.read(block.data(), block.size())) {
      sum = crc32_z(sum, reinterpret_cast<const Bytef*>(block.data()), size);
      bytes += size;
    }
  });
  return {{"bytes", bytes}, {"crc32", fmt::format("{:08x}", sum)}};
}

// Both names change what they mean, at once where the file system can; else there is a moment in
// which `target` is missing.
int exchange(const fs::path& scratch, const fs::path& target) {
  const int code =
      renameat2(AT_FDCWD, scratch.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE);
  if (code == 0 || (errno != EINVAL && errno != ENOSYS)) return code;
  const fs::path aside = scratch.parent_path() / kAside;
  if (rename(target.c_str(), aside.c_str()) != 0) return -1;
  if (rename(scratch.c_str(), target.c_str()) == 0) return rename(aside.c_str(), scratch.c_str());
  const int error = errno;
  if (rename(aside.c_str(), target.c_str()) == 0) errno = error;
  return -1;
}

// Never onto something that is there.
int move_in(const fs::path& from, const fs::path& to) {
  const int code = renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE);
  if (code == 0 || (errno != EINVAL && errno != ENOSYS)) return code;
  if (fs::exists(fs::symlink_status(to))) {
    errno = EEXIST;
    return -1;
  }
  return rename(from.c_str(), to.c_str());
}

void write_identity(const fs::path& folder, const std::string& version) {
  Json files = Json::object();
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().filename().string()] = entry_of(entry.path());
  }
  write_text(folder / kIdentity, Json{{"trammel", version}, {"files", files}}.dump(2) + '\n');
}

// The files that the run in a folder wrote; null: it holds no run.
Json files_of(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_regular_file(folder / kIdentity, ignored)) return nullptr;
  const std::string text = read_text(folder / kIdentity);
  try {
    const Json identity = parse_object(text, folder / kIdentity);
    if (!identity.contains("trammel") || !identity.contains("files")) return nullptr;
    const Json& files = identity["files"];
    const bool good = files.is_object() && std::all_of(files.items().begin(), files.items().end(),
                                                       [](const auto& one) {
      return one.key().find_first_of(std::string("/\0", 2)) == std::string::npos;
    });
    return good ? files : Json(nullptr);
  } catch (const ConfigError&) {
    return nullptr;
  }
}

// Whether a file in the folder of a run is the run's, which wrote regular files only.
bool is_own(const fs::path& file, const Json& written) {
  const std::string name = file.filename().string();
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(file, ignored)) &&
         (name == kIdentity || name == kPageFile || written.contains(name));
}

bool is_record_name(const std::string& name) {
  return std::find(std::begin(kRecordFiles), std::end(kRecordFiles), name) !=
         std::end(kRecordFiles);
}

bool is_as_written(const fs::path& file, const Json& entry) {
  try {
    return entry_of(file) == entry;
  } catch (const ConfigError&) {  // it cannot be read
    return false;
  }
}

// Whether a file is as the run wrote it, or has a successor, or would be read as one of its record.
bool is_over(const fs::path& file, const Json& written, const fs::path& to) {
  if (!is_own(file, written)) return false;
  const std::string name = file.filename().string();
  return !written.contains(name) || is_record_name(name) ||
         fs::exists(fs::symlink_status(to / name)) || is_as_written(file, written[name]);
}

// Moves what no run wrote from one folder to another; false where something cannot be moved.
bool carry_over(const fs::path& from, const Json& written, const fs::path& to) {
  bool all = true;
  for (const auto& entry : fs::directory_iterator(from)) {
    if (is_over(entry.path(), written, to)) continue;
    all = move_in(entry.path(), to / entry.path().filename()) == 0 && all;
  }
  return all;
}

// A folder of this name is a scratch folder, and no copy of one: its own name is in it.
std::string marker_of(const fs::path& scratch) {
  return fmt::format("scratch folder of trammel: {}\n", scratch.filename().string());
}

bool is_marked(const fs::path& scratch) {
  std::error_code ignored;
  const fs::path marker = scratch / kMarker;
  if (!fs::is_regular_file(fs::symlink_status(marker, ignored))) return false;
  try {
    return read_text(marker, 4096) == marker_of(scratch);
  } catch (const ConfigError&) {
    return false;
  }
}

// Whether a run was killed as it marked the folder: it has a marker without text, and nothing else.
bool is_begun(const fs::path& scratch) {
  std::error_code none;
  const fs::path marker = scratch / kMarker;
  return fs::is_regular_file(fs::symlink_status(marker, none)) && fs::is_empty(marker, none) &&
         std::distance(fs::directory_iterator(scratch, none), {}) == 1;
}

// The marker last: what is left of a removal is still known as a scratch folder, or empty. A
// folder with files of somebody else stays.
void remove_scratch(const fs::path& scratch) {
  std::error_code failed;
  for (const char* const name : {kFiles, kAside}) {
    fs::remove_all(scratch / name, failed);
    if (failed) return;
  }
  fs::remove(scratch / kMarker, failed);
  rmdir(scratch.c_str());
}

// What killed runs have left beside `target`: unfinished folders, and one that a run has replaced
// and whose other files it did not come to carry over.
void remove_stale(const fs::path& target) {
  const std::string begin = '.' + target.filename().string() + kMark;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(target.parent_path(), ignored)) {
    const fs::path scratch = entry.path();
    const std::string name = scratch.filename().string();
    if (name.rfind(begin, 0) != 0 || name.size() != begin.size() + kSuffix) continue;
    const FolderLock lock(scratch);
    if (!lock.held()) continue;
    if (!is_marked(scratch)) {
      if (is_begun(scratch)) fs::remove(scratch / kMarker, ignored);
      rmdir(scratch.c_str());  // of a run that was killed before it marked it: it is empty
      continue;
    }
    // No run has made them as links, which would lead to what is none of theirs.
    for (const char* const part : {kFiles, kAside}) {
      if (fs::is_symlink(fs::symlink_status(scratch / part))) unlink((scratch / part).c_str());
    }
    // Without a way to exchange two folders the target may be the one that was put aside.
    move_in(scratch / kAside, target);
    bool kept = false;
    for (const char* const part : {kFiles, kAside}) {
      const Json written = files_of(scratch / part);
      kept = (!written.is_null() && !carry_over(scratch / part, written, target)) || kept;
    }
    if (!kept) remove_scratch(scratch);
  }
}

bool contains(const fs::path& folder, const fs::path& inner) {
  const fs::path relative = inner.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

// A file of the user's must not lose its place to one of the same name.
void check_names(const fs::path& scratch, const fs::path& target) {
  const Json before = files_of(target);
  for (const auto& entry : fs::directory_iterator(scratch)) {
    const std::string name = entry.path().filename().string();
    if (!is_own(target / name, before) && fs::exists(fs::symlink_status(target / name))) {
      refuse(target, fmt::format("{} there is not of the run that it holds; move it away", name));
    }
  }
}

}  // namespace

std::vector<std::string> record_files() {
  return {std::begin(kRecordFiles), std::end(kRecordFiles)};
}

void check_replaceable(const fs::path& target) {
  std::error_code error;
  const fs::file_status there = fs::symlink_status(target);
  if (!fs::exists(there)) return;
  if (!fs::is_directory(there)) refuse(target, "is not a folder");
  if (contains(target, fs::canonical(fs::current_path()))) {
    refuse(target, "is the current folder or contains it");
  }
  if (access(target.c_str(), R_OK | W_OK | X_OK) != 0) cannot_write(target, errno);
  if (fs::is_empty(target, error) || !files_of(target).is_null()) return;
  refuse(target, fmt::format("is not empty and holds no run (no {} that lists its files): name "
                             "another folder, or remove this one",
                             kIdentity));
}

OutputFolder::OutputFolder(const fs::path& target) : target_(fs::absolute(target)) {
  std::error_code error;
  target_ = target_.lexically_normal();
  if (!target_.has_filename()) target_ = target_.parent_path();  // "out/" is "out"
  if (fs::exists(target_, error)) target_ = fs::canonical(target_);
  check_replaceable(target_);
  const fs::path parent = target_.parent_path();
  fs::create_directories(parent, error);
  remove_stale(target_);
  fs::path outer;
  do {  // until nobody takes the new folder, which is still empty, for a stale one
    std::string pattern =
        (parent / fmt::format(".{}{}XXXXXX", target_.filename().string(), kMark)).string();
    if (mkdtemp(pattern.data()) == nullptr) cannot_write(parent, errno);
    outer = pattern;
    lock_ = FolderLock(outer);
  } while (lock_.busy() || !fs::exists(outer, error));
  try {
    write_text(outer / kMarker, marker_of(outer));
    if (mkdir((outer / kFiles).c_str(), 0777) != 0) cannot_write(parent, errno);
  } catch (...) {
    remove_scratch(outer);
    throw;
  }
  scratch_ = outer / kFiles;
}

OutputFolder::~OutputFolder() {
  if (!scratch_.empty()) remove_scratch(scratch_.parent_path());
}

void OutputFolder::publish(const std::string& version) {
  write_identity(scratch_, version);
  for (;;) {
    if (move_in(scratch_, target_) == 0) break;
    if (errno != EEXIST) cannot_write(target_, errno);
    const FolderLock before(target_, kPatience);
    if (before.busy()) refuse(target_, "is locked by another program");
    if (!before.held()) check_replaceable(target_);  // a file or link that came during the run
    if (!before.is_of(target_)) continue;            // another run has just replaced it
    check_replaceable(target_);
    check_names(scratch_, target_);
    if (exchange(scratch_, target_) != 0) {
      if (errno == ENOENT) continue;
      cannot_write(target_, errno);
    }
    const Json written = files_of(scratch_);  // what was there
    if (!carry_over(scratch_, written, target_)) {
      const fs::path old = std::exchange(scratch_, {});
      refuse(target_, fmt::format("the run is there, but other files could not be carried over; "
                                  "they are in {}", old.string()));
    }
    break;
  }
  remove_scratch(std::exchange(scratch_, {}).parent_path());
  lock_ = {};
}

void check_result_file(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) {
    throw ConfigError(fmt::format("{}: --out: is a folder; name a file", file.string()));
  }
  const std::string name = file.filename().string();
  const Json files = files_of(fs::absolute(file).parent_path());
  if (name == kPageFile) return;
  // A record that older versions wrote, or a part of one, has no list.
  const bool of_record =
      files.is_null() ? fs::exists(fs::symlink_status(file, ignored)) && is_record_name(name)
                      : name == kIdentity || files.contains(name);
  if (!of_record) return;
  throw ConfigError(fmt::format("{}: --out: is a file of a run's record", file.string()));
}

void write_result_file(const fs::path& file, const std::string& text) {
  check_result_file(file);
  std::error_code ignored;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  replace_file(file, text);
}

void check_whole(const fs::path& folder) {
  const Json files = files_of(folder);
  std::error_code none;
  if (files.is_null() && fs::exists(fs::symlink_status(folder / kIdentity, none))) {
    throw ConfigError(fmt::format("{}: is not the list of a run's files",
                                  (folder / kIdentity).string()));
  }
  if (files.is_null()) return;
  for (const auto& [name, expected] : files.items()) {
    if (name == kPageFile) continue;
    std::error_code ignored;
    if (!fs::is_regular_file(folder / name, ignored)) {
      throw ConfigError(fmt::format("{}: is missing, though {} lists it",
                                    (folder / name).string(), kIdentity));
    }
    if (entry_of(folder / name) != expected) {
      throw ConfigError(fmt::format("{}: is not what the run wrote ({}): changed since, or of "
                                    "another run", (folder / name).string(), kIdentity));
    }
  }
}

}  // namespace trammel::host
