// SPDX-License-Identifier: Apache-2.0
//
// The language of `trammel lm628`: commands of the data sheet (SNVS781C) by their mnemonics with
// their data as numbers, waits, and single accesses of the port. One command a line, in any case;
// comments begin with # or ;. A number is decimal, 0x1F or 1Fh; where it may be negative, its bit
// pattern does too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sw_nios/hal/lm628.hpp"

namespace trammel::an693 {

enum class Lm628Action {
  kCommand,  // of the part, by its code
  kRdstat,
  kStatus,
  kPins,
  kRst,
  kWait,
  kByte,     // one access of the port, without a look at busy
  kRead,
  kHelp,
  kQuit
};

struct Lm628Word {
  const char* name;
  Lm628Action action;
  sw::Lm628Command code;  // of kCommand
  const char* data;       // what follows it, for people
  const char* help;
  int reply_bits = 0;     // that the part answers: 0, 16 or 32
  const char* unit = "";  // of the answer
  bool is_signed = false;
  int fraction_bits = 0;
};

const std::vector<Lm628Word>& lm628_words();

struct Lm628Value {
  std::int64_t value = 0;
  int bits = 16;
};

enum class Lm628Until { kTime, kHost, kComplete };  // a span; the pin HI; status bit 2

struct Lm628Line {
  const Lm628Word* word = nullptr;
  std::vector<Lm628Value> values;        // data in the order in which the part takes them
  bool to_data = false;                  // kByte, kRead: PS high
  Lm628Until until = Lm628Until::kTime;  // kWait
  double seconds = 0;                    // kWait: the span, or the longest
  std::string topic;                     // kHelp: a mnemonic, or empty
  std::string text;                      // as it was written
  std::string where;                     // "file:line", for messages
};

inline constexpr double kLongestWait = 60;  // [s] simulated, where a script names no other

// One line; nothing where it holds no command. Throws lab::ConfigError, which begins with `where`.
std::optional<Lm628Line> parse_lm628_line(const std::string& text, const std::string& where);

// All lines of a script; those after `quit` are read too.
std::vector<Lm628Line> parse_lm628_script(const std::string& text, const std::string& source);

// A built-in script's name or a path. Throws lab::ConfigError.
std::filesystem::path find_lm628_script(const std::string& name);

// All words with their data, or the one of that name with what there is to know.
std::string lm628_help(const std::string& topic);

std::string lm628_hex(std::int64_t value, int bits);  // "00001F40h"

}  // namespace trammel::an693
