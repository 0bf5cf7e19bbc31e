// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>

#include "models/exact/motion/lm628_opcode.hpp"
#include "tests/support/bits.hpp"

namespace trammel::test {

using exact::Opcode;

// Commands and words through the host port of a Bench, which has write(ps, byte), read(ps) and
// clocks(n).
template <class Bench>
class Lm628Commands {
 public:
  std::uint8_t status() { return self().read(false); }
  void ready() {
    while ((status() & 1) != 0) self().clocks(100);
  }

  static std::uint8_t code(Opcode opcode) { return static_cast<std::uint8_t>(opcode); }

  void command(Opcode opcode) {
    self().write(false, code(opcode));
    ready();
  }
  void word(unsigned value) {
    self().write(true, static_cast<std::uint8_t>(value >> 8));
    self().write(true, static_cast<std::uint8_t>(value));
    ready();
  }
  void command(Opcode opcode, std::initializer_list<unsigned> words) {
    command(opcode);
    for (const unsigned value : words) word(value);
  }
  std::uint16_t read_word() {
    const unsigned high = self().read(true);
    const unsigned low = self().read(true);
    ready();
    return static_cast<std::uint16_t>(high << 8 | low);
  }
  std::int64_t ask(Opcode opcode) {
    command(opcode);
    const std::int64_t high = read_word();
    if (exact::words_replied(static_cast<std::uint8_t>(opcode)) == 1) return high;
    return as_signed(static_cast<std::uint64_t>(high << 16 | read_word()), 32);
  }
  void clear_status() { command(Opcode::kRsti, {0}); }

  // LTRJ: control word, then acceleration, speed and position as far as it says.
  void trajectory(unsigned control, std::initializer_list<std::int64_t> values) {
    command(Opcode::kLtrj);
    word(control);
    for (const std::int64_t value : values) {
      const std::uint32_t bits = as_bits(value, 32);
      word(bits >> 16);
      word(bits & 0xFFFF);
    }
  }

 private:
  Bench& self() { return static_cast<Bench&>(*this); }
};

}  // namespace trammel::test
