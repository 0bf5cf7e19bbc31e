// SPDX-License-Identifier: Apache-2.0
//
// The one reader of input files: regular files only, so that no device or pipe is waited for or
// read without end; never more than a limit; and a read that fails is no end of the file. Throws
// InputError, one line that names the file and the reason.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace trammel::host {

struct InputError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

constexpr std::uintmax_t kMiB = std::uintmax_t{1} << 20;

class InputFile {
 public:
  InputFile(const std::string& file, std::uintmax_t most);  // [bytes]
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  // Standard input, whatever it is: it ends where the other side ends it.
  static InputFile standard_input(std::uintmax_t most);

  std::size_t read(char* to, std::size_t size);  // 0: the end
  std::string rest();

  enum class Line { kWhole, kUnended, kNone };
  // The next line without its end; kUnended: the file ends in it.
  Line line(std::string& text);

 private:
  InputFile(int descriptor, std::string name, std::uintmax_t most);
  [[noreturn]] void fail(const std::string& why) const;

  int descriptor_ = -1;
  std::string name_;
  std::uintmax_t most_ = 0;
  std::uintmax_t taken_ = 0;
  std::vector<char> block_;  // of line(): what is read ahead
  std::size_t begin_ = 0, end_ = 0;
};

// All of a file.
std::string read_file(const std::string& file, std::uintmax_t most);

// Without the mark of UTF-8 that programs which write text may put before it.
inline std::string_view past_mark(std::string_view text) {
  return text.substr(0, 3) == "\xEF\xBB\xBF" ? text.substr(3) : text;
}

}  // namespace trammel::host
