// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/hal/text_ring.hpp"

namespace trammel::sw {

TextLine& TextLine::text(const char* words) {
  for (; *words != 0; ++words) add(*words);
  return *this;
}

TextLine& TextLine::number(std::uint32_t value) {
  std::array<char, 10> digits{};
  std::uint32_t n = 0;
  do {
    const std::uint32_t tens = value / 10;  // one division: a small core takes 40 clocks for it
    digits[n++] = static_cast<char>('0' + (value - 10 * tens));
    value = tens;
  } while (value != 0);
  while (n != 0) add(digits[--n]);
  return *this;
}

TextLine& TextLine::number(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  if (value >= 0) return number(bits);
  add('-');
  return number(0u - bits);
}

TextLine& TextLine::hex(std::uint32_t value) {
  text("0x");
  for (std::uint32_t n = 8; n-- != 0;) {
    const std::uint32_t digit = value >> (4 * n) & 0xF;
    add(static_cast<char>(digit < 10 ? '0' + digit : 'a' + (digit - 10)));
  }
  return *this;
}

bool TextRing::put_part(const TextLine& line) {
  if (room() < line.size()) return false;
  for (std::uint32_t n = 0; n < line.size(); ++n) add(line[n]);
  return true;
}

bool TextRing::put(const TextLine& line) {
  if (room() < line.size() + 2) return false;
  put_part(line);
  add('\r');
  add('\n');
  return true;
}

}  // namespace trammel::sw
