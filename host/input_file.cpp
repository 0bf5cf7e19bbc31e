// SPDX-License-Identifier: Apache-2.0
#include "host/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace trammel::host {
namespace {

constexpr std::size_t kBlock = 1 << 16;        // [bytes]
constexpr std::size_t kLongestLine = 1 << 20;  // [bytes] of line()

std::string size_text(std::uintmax_t bytes) {
  if (bytes % (1024 * kMiB) == 0) return std::to_string(bytes / (1024 * kMiB)) + " GiB";
  if (bytes % kMiB == 0) return std::to_string(bytes / kMiB) + " MiB";
  return std::to_string(bytes) + " bytes";
}

// Why what is there is not read; "" where it is.
std::string unreadable(const struct stat& there) {
  if (S_ISDIR(there.st_mode)) return "it is a folder";
  return S_ISREG(there.st_mode) ? "" : "it is not a regular file";
}

}  // namespace

void InputFile::fail(const std::string& why) const {
  throw InputError(name_ + ": cannot be read: " + why);
}

InputFile::InputFile(int descriptor, std::string name, std::uintmax_t most)
    : descriptor_(descriptor), name_(std::move(name)), most_(most) {}

InputFile::InputFile(const std::string& file, std::uintmax_t most) : name_(file), most_(most) {
  struct stat there {};
  if (stat(file.c_str(), &there) != 0) fail(std::strerror(errno));
  std::string why = unreadable(there);  // to open some devices has an effect
  if (!why.empty()) fail(why);
  descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor_ < 0) fail(std::strerror(errno));
  why = fstat(descriptor_, &there) == 0 ? unreadable(there) : std::strerror(errno);
  if (why.empty()) return;
  close(descriptor_);
  fail(why);
}

InputFile::~InputFile() {
  if (descriptor_ != STDIN_FILENO) close(descriptor_);
}

InputFile InputFile::standard_input(std::uintmax_t most) {
  return {STDIN_FILENO, "standard input", most};
}

std::size_t InputFile::read(char* to, std::size_t size) {
  ssize_t count = 0;
  do {
    count = ::read(descriptor_, to, size);
  } while (count < 0 && errno == EINTR);
  if (count < 0) fail(std::strerror(errno));
  taken_ += static_cast<std::size_t>(count);
  if (taken_ > most_) fail("it is larger than " + size_text(most_));
  return static_cast<std::size_t>(count);
}

std::string InputFile::rest() {
  std::string text;
  std::vector<char> block(kBlock);
  while (const std::size_t count = read(block.data(), block.size())) {
    text.append(block.data(), count);
  }
  return text;
}

InputFile::Line InputFile::line(std::string& text) {
  text.clear();
  for (;;) {
    if (begin_ == end_) {
      block_.resize(kBlock);
      begin_ = 0;
      end_ = read(block_.data(), block_.size());
      if (end_ == 0) return text.empty() ? Line::kNone : Line::kUnended;
    }
    const auto first = block_.begin() + static_cast<std::ptrdiff_t>(begin_);
    const auto last = block_.begin() + static_cast<std::ptrdiff_t>(end_);
    const auto stop = std::find(first, last, '\n');
    text.append(first, stop);
    if (text.size() > kLongestLine) fail("a line is longer than " + size_text(kLongestLine));
    begin_ = static_cast<std::size_t>(stop - block_.begin()) + (stop == last ? 0 : 1);
    if (stop != last) return Line::kWhole;
  }
}

std::string read_file(const std::string& file, std::uintmax_t most) {
  return InputFile(file, most).rest();
}

}  // namespace trammel::host
