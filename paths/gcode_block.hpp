// SPDX-License-Identifier: Apache-2.0
//
// One block of a G-code program: a line of text as words, a letter with a number each. What RS274
// has of a line's form is known here; what words mean together is in gcode.cpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trammel::paths {

// The line that messages are about.
class GcodeLine {
 public:
  GcodeLine(const std::string& file, int number) : file_(file), number_(number) {}

  int number() const { return number_; }
  // Throws std::invalid_argument: FILE:LINE: text.
  [[noreturn]] void refuse(const std::string& text) const;

 private:
  const std::string& file_;
  int number_;
};

struct GcodeBlock {
  bool percent = false;      // '%' alone: begin or end of the program
  bool skipped = false;      // begins with '/': nothing else of it is read
  std::vector<double> g, m;  // in their order
  std::array<std::optional<double>, 26> words;  // the other letters

  const std::optional<double>& of(char letter) const {
    return words[static_cast<std::size_t>(letter - 'A')];
  }
  bool has(char letter) const { return of(letter).has_value(); }
  bool has_any(std::string_view letters) const {
    for (const char letter : letters) {
      if (has(letter)) return true;
    }
    return false;
  }
};

// `text` without the characters that end its line.
GcodeBlock read_gcode_block(std::string_view text, const GcodeLine& line);

}  // namespace trammel::paths
