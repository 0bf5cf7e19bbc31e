// SPDX-License-Identifier: Apache-2.0
//
// Text on its way to a slow serial port: written whole or not at all, taken byte by byte when the
// port is free. Freestanding.
#pragma once

#include <array>
#include <cstdint>

namespace trammel::sw {

// A line that is put together before it is written; what does not fit is left out.
class TextLine {
 public:
  static constexpr std::uint32_t kMax = 160;

  TextLine& text(const char* words);
  TextLine& number(std::uint32_t value);
  TextLine& number(std::int32_t value);
  TextLine& hex(std::uint32_t value);  // 0x and 8 digits

  std::uint32_t size() const { return size_; }
  char operator[](std::uint32_t n) const { return bytes_[n]; }

 private:
  void add(char c) {
    if (size_ < kMax) bytes_[size_++] = c;
  }

  std::array<char, kMax> bytes_{};
  std::uint32_t size_ = 0;
};

class TextRing {
 public:
  static constexpr std::uint32_t kSize = 512;  // a power of two

  bool empty() const { return in_ == out_; }
  std::uint32_t room() const { return kSize - (in_ - out_); }

  // With CR and LF behind it; false: there is no room, and nothing was written.
  bool put(const TextLine& line);
  bool put_part(const TextLine& line);  // without
  // Only while not empty.
  char take() { return bytes_[out_++ % kSize]; }

 private:
  void add(char c) { bytes_[in_++ % kSize] = c; }

  std::array<char, kSize> bytes_{};
  std::uint32_t in_ = 0, out_ = 0;  // counted, not wrapped
};

}  // namespace trammel::sw
