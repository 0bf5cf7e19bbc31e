// SPDX-License-Identifier: Apache-2.0
#include "paths/gcode_block.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <system_error>

namespace trammel::paths {
namespace {

constexpr std::size_t kLongestGcodeLine = 256;  // [bytes], as RS274/NGC has it
constexpr std::string_view kGcodeLetters = "FGHIJMNPRSTXYZ";

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_parameter(char c) { return c == '#' || c == '[' || c == '='; }
char upper_letter(char c) { return c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string letters_text() {
  std::string text;
  for (const char letter : kGcodeLetters) (text += text.empty() ? "" : " ") += letter;
  return text;
}

class BlockReader {
 public:
  BlockReader(std::string_view text, const GcodeLine& line) : text_(text), line_(line) {}

  GcodeBlock read() {
    if (text_.size() > kLongestGcodeLine) {
      line_.refuse(fmt::format("the line has {} characters; permitted: {}", text_.size(),
                               kLongestGcodeLine));
    }
    if (text_.find('\r') != std::string_view::npos) {
      line_.refuse("a carriage return inside the line; a line ends in LF or in CR LF");
    }
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == '/') {
      block_.skipped = true;
      return block_;
    }
    while (at_ < text_.size() && text_[at_] != ';') {
      item();
      skip_blanks();
    }
    return block_;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  void item() {
    const char c = text_[at_];
    if (c == '(') return comment();
    if (c == '%') return percent();
    if (!is_letter(c)) unknown();
    ++at_;
    word(upper_letter(c));
  }

  void comment() {
    const auto end = text_.find_first_of("()", at_ + 1);
    if (end == std::string_view::npos) line_.refuse("comment is not closed");
    if (text_[end] == '(') line_.refuse("comment is not closed before the next one begins");
    at_ = end + 1;
  }

  void percent() {
    const auto blank = [](std::string_view part) {
      return part.find_first_not_of(" \t") == std::string_view::npos;
    };
    if (!blank(text_.substr(0, at_)) || !blank(text_.substr(at_ + 1))) {
      line_.refuse("% stands alone in its line");
    }
    block_.percent = true;
    ++at_;
  }

  [[noreturn]] void unknown() const {
    const char c = text_[at_];
    if (c == ')') line_.refuse("')' without '('");
    if (is_parameter(c)) {
      line_.refuse(fmt::format("'{}': parameters and expressions are not known", c));
    }
    if (c == '/') line_.refuse("'/' stands first in its line");
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      line_.refuse(fmt::format("the byte {:#04x} is no text", static_cast<unsigned>(c)));
    }
    std::size_t end = at_ + 1;  // a character of UTF-8 is shown whole
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0u) == 0x80) ++end;
    line_.refuse(fmt::format("'{}' is no word: a word is a letter and a number",
                             text_.substr(at_, end - at_)));
  }

  // Blanks are free, so that they may stand in a number, too.
  double number(char letter) {
    std::string digits;
    bool point = false, any = false;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (is_blank(c)) continue;
      if (c == '+' || c == '-' || c == '.') {
        if (c == '.' ? point : !digits.empty()) break;
        point = c == '.';
      } else if (!is_digit(c)) {
        break;
      }
      any = any || is_digit(c);
      digits += c;
    }
    const bool more = at_ < text_.size() && std::string_view("+-.").find(text_[at_]) !=
                                                std::string_view::npos;
    if (more) digits += text_[at_];
    if (!any && at_ < text_.size() && is_parameter(text_[at_])) unknown();
    if (!any && !more) line_.refuse(fmt::format("{} has no number", letter));
    if (!any || more) line_.refuse(fmt::format("{} has no number: '{}' is none", letter, digits));
    const char* const begin = digits.data() + (digits.front() == '+' ? 1 : 0);
    double value = 0;
    const auto read = std::from_chars(begin, digits.data() + digits.size(), value);
    // Below the smallest double: as good as 0. A line is too short for what is above the largest.
    if (read.ec == std::errc::result_out_of_range) return 0;
    return value;
  }

  void line_number() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_blank(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const auto digits = text_.substr(begin, at_ - begin);
    const bool other = at_ < text_.size() && std::string_view("+-.").find(text_[at_]) !=
                                                 std::string_view::npos;
    if (other || digits.find_first_not_of(" \t") == std::string_view::npos) {
      line_.refuse("N has no number: it has digits only");
    }
    if (!first_) line_.refuse("N stands first in its block");
  }

  void word(char letter) {
    if (kGcodeLetters.find(letter) == std::string_view::npos) {
      line_.refuse(fmt::format("{} is not known; known: {} (numbers have no exponent)", letter,
                               letters_text()));
    }
    if (letter == 'N') {
      line_number();
    } else if (letter == 'G' || letter == 'M') {
      (letter == 'G' ? block_.g : block_.m).push_back(number(letter));
    } else {
      auto& place = block_.words[static_cast<std::size_t>(letter - 'A')];
      const double value = number(letter);
      if (place) line_.refuse(fmt::format("{} twice in a block", letter));
      place = value;
    }
    first_ = false;
  }

  std::string_view text_;
  const GcodeLine& line_;
  GcodeBlock block_;
  std::size_t at_ = 0;
  bool first_ = true;
};

}  // namespace

void GcodeLine::refuse(const std::string& text) const {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file_, number_, text));
}

GcodeBlock read_gcode_block(std::string_view text, const GcodeLine& line) {
  return BlockReader(text, line).read();
}

}  // namespace trammel::paths
