// SPDX-License-Identifier: Apache-2.0
#include "lab/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

constexpr const char* kOwnFiles[] = {"metrics.json", "trace.csv",  "detail.json", "run.toml",
                                     "report.html",  "path.svg",   "error.svg",   "motion.svg",
                                     "waves.vcd",    "waves.fst",  "waves.gtkw",  "script.lm628",
                                     "table.csv",    "contour.svg",  "contours.csv"};

}  // namespace

OutputFolder::OutputFolder(const fs::path& target) : target_(fs::absolute(target)) {
  if (!target_.has_filename()) target_ = target_.parent_path();  // "out/" is "out"
  std::error_code error;
  if (fs::exists(target_, error) && !fs::is_directory(target_, error)) {
    throw ConfigError(fmt::format("{}: --out: is not a folder", target_.string()));
  }
  if (fs::is_directory(target_, error) && access(target_.c_str(), W_OK | X_OK) != 0) {
    throw ConfigError(fmt::format("{}: --out: cannot be written: {}", target_.string(),
                                  std::strerror(errno)));
  }
  fs::create_directories(target_.parent_path(), error);
  std::string pattern =
      (target_.parent_path() / fmt::format(".{}.XXXXXX", target_.filename().string())).string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw ConfigError(fmt::format("{}: --out: cannot be written: {}",
                                  target_.parent_path().string(), std::strerror(errno)));
  }
  scratch_ = pattern;
  fs::permissions(scratch_, fs::perms::group_read | fs::perms::group_exec |
                                fs::perms::others_read | fs::perms::others_exec,
                  fs::perm_options::add, error);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
}

void OutputFolder::publish() {
  std::error_code fresh;
  if (!fs::exists(target_)) {
    fs::rename(scratch_, target_, fresh);
    if (!fresh) return;
  }
  for (const char* name : kOwnFiles) {
    if (fs::exists(scratch_ / name)) {
      fs::rename(scratch_ / name, target_ / name);
    } else {
      fs::remove(target_ / name);
    }
  }
}

std::ifstream open_text(const fs::path& file) {
  std::error_code ignored;
  std::ifstream in(file);
  if (!in || fs::is_directory(file, ignored)) {
    throw ConfigError(fmt::format("{}: cannot be read: {}", file.string(),
                                  in ? "it is a folder" : std::strerror(errno)));
  }
  return in;
}

std::string read_text(const fs::path& file) {
  std::stringstream text;
  text << open_text(file).rdbuf();
  return text.str();
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw ConfigError(fmt::format("{}: cannot be written", file.string()));
}

fs::path target_of(const std::string& out, const std::string& scenario) {
  return out.empty() ? fs::path("out") / scenario : fs::path(out);
}

void replace_file(const fs::path& file, const std::string& text) {
  const fs::path scratch = fs::path(file).concat(".new");
  std::error_code failed;
  try {
    write_text(scratch, text);
    fs::rename(scratch, file);
  } catch (const fs::filesystem_error& error) {
    fs::remove(scratch, failed);
    throw ConfigError(fmt::format("{}: cannot be written: {}", file.string(),
                                  error.code().message()));
  } catch (...) {
    fs::remove(scratch, failed);
    throw;
  }
}

void write_lines(const fs::path& file, const std::function<void(fmt::ostream&)>& print) {
  try {
    auto out = fmt::output_file(file.string());
    print(out);
    out.close();
  } catch (const std::system_error&) {
    throw ConfigError(fmt::format("{}: cannot be written", file.string()));
  }
}

fs::path find_program(const std::string& name) {
  const char* const variable = std::getenv("PATH");
  std::string path = variable == nullptr ? "" : variable;
  path += ':';
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = path.find(':', begin);
    const fs::path file = fs::path(path.substr(begin, end - begin)) / name;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) return file;
    begin = end + 1;
  }
  return {};
}

std::string shell_word(const fs::path& path) {
  std::string text = "'";
  for (const char c : path.string()) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      text += c;
    }
  }
  return text + "'";
}

std::string shell_argument(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("._-+=/,:", c) != nullptr;
  });
  return plain ? text : shell_word(text);
}

}  // namespace trammel::lab
