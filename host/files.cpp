// SPDX-License-Identifier: Apache-2.0
#include "host/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>

#include "host/text.hpp"

namespace trammel::host {
namespace fs = std::filesystem;
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void unwritable(const fs::path& file, int error) { throw WriteError(file, error); }

// What `print` gives to the function that it is given; mode: of fopen().
void write(const fs::path& file, const char* mode, const std::function<void(const Put&)>& print) {
  std::unique_ptr<std::FILE, Close> out(std::fopen(file.c_str(), mode));
  if (!out) unwritable(file, errno);
  print([&](const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), out.get()) != text.size()) unwritable(file, errno);
  });
  if (std::fclose(out.release()) != 0) unwritable(file, errno);
}

// All of a text, on the disk; else false, with the reason in errno.
bool put_all(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return fsync(descriptor) == 0;
}

// A file that gets its name when it is whole, so that a kill leaves nothing. False where the file
// system has no such files, or did not take this one.
bool write_unnamed(const fs::path& file, const std::string& text) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const int descriptor = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) return false;
  const std::string name = fmt::format("/proc/self/fd/{}", descriptor);
  const bool good = put_all(descriptor, text) && linkat(AT_FDCWD, name.c_str(), AT_FDCWD,
                                                        file.c_str(), AT_SYMLINK_FOLLOW) == 0;
  return close(descriptor) == 0 && good;
}

// A file that did not exist, not even as a link. 0, or the system's reason.
int write_new(const fs::path& file, const std::string& text) {
  const int descriptor = open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  const int error = put_all(descriptor, text) ? 0 : errno;
  const int late = close(descriptor) == 0 ? 0 : errno;
  if (error == 0 && late == 0) return 0;
  unlink(file.c_str());
  return error != 0 ? error : late;
}

// Of a file that is not there yet; processes of other computers may write into the same folder.
fs::path scratch_of(const fs::path& file) {
  std::random_device draw;
  const std::uint64_t digits = std::uint64_t{draw()} << 32 | draw();
  const std::string name = file.filename().string().substr(0, 200);  // of 255 with the rest
  return fs::path(file).replace_filename(fmt::format(".{}.{:016x}-{}", name, digits, getpid()));
}

}  // namespace

WriteError::WriteError(const fs::path& file, int error)
    : ConfigError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(error))),
      code(error) {}

std::string read_text(const fs::path& file, std::uintmax_t most) {
  return reading([&] { return read_file(file.string(), most); });
}

std::string read_standard_input(std::uintmax_t most) {
  return reading([&] { return InputFile::standard_input(most).rest(); });
}

void write_text(const fs::path& file, const std::string& text) {
  write(file, "wb", [&text](const Put& put) { put(text); });
}

void write_lines(const fs::path& file, const std::function<void(const Put&)>& print) {
  write(file, "wb", print);
}

fs::path target_of(const std::string& out, const std::string& scenario) {
  return out.empty() ? fs::path("out") / scenario : fs::path(out);
}

void replace_file(const fs::path& file, const std::string& text) {
  std::error_code failed;
  const fs::file_status there = fs::symlink_status(file, failed);
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    throw ConfigError(fmt::format("{}: cannot be written: not a regular file", file.string()));
  }
  const fs::path scratch = scratch_of(file);
  if (!write_unnamed(scratch, text)) {
    if (const int error = write_new(scratch, text)) unwritable(file, error);
  }
  if (std::rename(scratch.c_str(), file.c_str()) == 0) return;
  const int error = errno;
  fs::remove(scratch, failed);
  unwritable(file, error);
}

fs::path find_program(const std::string& name) {
  const char* const variable = std::getenv("PATH");
  std::string path = variable == nullptr ? "" : variable;
  path += ':';
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = path.find(':', begin);
    const fs::path file = fs::path(path.substr(begin, end - begin)) / name;
    std::error_code ignored;
    const bool named = end > begin;  // an empty name would be the current folder
    if (named && fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) return file;
    begin = end + 1;
  }
  return {};
}

std::string shell_word(const fs::path& path) {
  const std::string& text = path.native();
  const bool plain = printable(text) == text;
  std::string word;
  for (const char c : text) {
    if (c == '\'') {
      word += plain ? "'\\''" : "\\'";
    } else if (c == '\\' && !plain) {
      word += "\\\\";
    } else {
      word += c;
    }
  }
  return plain ? '\'' + word + '\'' : "$'" + printable(word) + '\'';
}

std::string shell_argument(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("._-+=/,:", c) != nullptr;
  });
  return plain ? text : shell_word(text);
}

}  // namespace trammel::host
