// SPDX-License-Identifier: Apache-2.0
#include "host/text.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace trammel::host {
namespace {

constexpr char kCut[] = "\xE2\x80\xA6";  // an ellipsis
constexpr std::size_t kLongestMessage = 2000;  // characters
constexpr std::size_t kLongestWord = 300;      // characters; the name of a file has at most 255
constexpr std::size_t kShownOfWord = 120;      // characters of a longer one

// Bytes of the UTF-8 character that the text begins with, and its code; 0: it is none.
std::pair<std::size_t, unsigned> character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return {1, first};
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return {0, first};
  unsigned code = first & (0xFFu >> (size + 1));
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(k) & 0xC0u) != 0x80) return {0, first};
    code = code << 6 | (byte(k) & 0x3Fu);
  }
  constexpr unsigned kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < kLeast[size] || surrogate || code > 0x10FFFF) return {0, first};
  return {size, code};
}

// What has no shape of its own: control characters, and what Unicode 15 calls format characters
// and separators of lines (Cc, Cf, Zl, Zp). Those that turn the direction of writing or join
// characters make one name look like another.
bool is_control(unsigned code) {
  constexpr std::pair<unsigned, unsigned> kRanges[] = {
      {0x00, 0x1F},       {0x7F, 0x9F},       {0xAD, 0xAD},       {0x600, 0x605},
      {0x61C, 0x61C},     {0x6DD, 0x6DD},     {0x70F, 0x70F},     {0x890, 0x891},
      {0x8E2, 0x8E2},     {0x180E, 0x180E},   {0x200B, 0x200F},   {0x2028, 0x202E},
      {0x2060, 0x2064},   {0x2066, 0x206F},   {0xFEFF, 0xFEFF},   {0xFFF9, 0xFFFB},
      {0x110BD, 0x110BD}, {0x110CD, 0x110CD}, {0x13430, 0x1343F}, {0x1BCA0, 0x1BCA3},
      {0x1D173, 0x1D17A}, {0xE0001, 0xE0001}, {0xE0020, 0xE007F}};
  return std::any_of(std::begin(kRanges), std::end(kRanges), [code](const auto& range) {
    return code >= range.first && code <= range.second;
  });
}

// What a terminal shows of each character; those in `kept` stay.
template <class Take>
void each_shown(std::string_view text, std::string_view kept, Take take) {
  while (!text.empty()) {
    const auto [size, code] = character(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(1, size));
    const bool stays = size == 1 && kept.find(text.front()) != std::string_view::npos;
    bool more = false;
    if (size == 0) {
      more = take(fmt::format("\\x{:02x}", code));
    } else if (is_control(code) && !stays) {
      more = take(code > 0xFFFF ? fmt::format("\\U{:08x}", code) : fmt::format("\\u{:04x}", code));
    } else {
      more = take(bytes);
    }
    if (!more) return;
    text.remove_prefix(bytes.size());
  }
}

std::string all_shown(const std::string& text, std::string_view kept) {
  const bool plain = std::all_of(text.begin(), text.end(), [kept](char c) {
    return (c >= 0x20 && c < 0x7F) || kept.find(c) != std::string_view::npos;
  });
  if (plain) return text;  // a table may be long
  std::string all;
  each_shown(text, kept, [&all](std::string_view one) {
    all += one;
    return true;
  });
  return all;
}

}  // namespace

std::string printable(const std::string& text) { return all_shown(text, ""); }

std::string printable_lines(const std::string& text) { return all_shown(text, "\n\t"); }

std::string shown(const std::string& text, std::size_t most) {
  std::string all;
  std::size_t count = 0;
  each_shown(text, "", [&](std::string_view one) {
    const bool fits = ++count <= most;
    all += fits ? one : std::string_view(kCut);
    return fits;
  });
  return all;
}

std::string one_line(const std::string& message) {
  std::string all;
  std::vector<std::size_t> begins;  // of the characters in `all`
  std::size_t word = 0;             // characters before the last word
  const auto cut_word = [&] {
    if (begins.size() - word <= kLongestWord) return;
    all.resize(begins[word + kShownOfWord]);
    begins.resize(word + kShownOfWord);
    begins.push_back(all.size());
    all += kCut;
  };
  each_shown(message, "", [&](std::string_view one) {
    if (one == " " || one == "/") cut_word();
    begins.push_back(all.size());
    all += one;
    if (one == " " || one == "/") word = begins.size();
    return true;
  });
  cut_word();
  if (begins.size() <= kLongestMessage) return all;
  const std::size_t half = kLongestMessage / 2;
  return all.substr(0, begins[half]) + kCut + all.substr(begins[begins.size() - half]);
}

std::string time_text(double s, int digits) {
  const double size = std::abs(s);
  if (size >= 1 || size == 0) return fmt::format("{:.{}g} s", s, digits);
  if (size >= 1e-3) return fmt::format("{:.{}g} ms", s * 1e3, digits);
  return fmt::format("{:.{}g} us", s * 1e6, digits);
}

std::string reason_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr) return error.what();
  const std::pair<decltype(RLIMIT_AS), const char*> limits[] = {{RLIMIT_AS, "ulimit -v"},
                                                                {RLIMIT_DATA, "ulimit -d"}};
  for (const auto& [resource, name] : limits) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) continue;
    return fmt::format("memory did not suffice: {} allows {} KiB", name, limit.rlim_cur / 1024);
  }
  return "memory did not suffice: the system gave no more";
}

}  // namespace trammel::host
