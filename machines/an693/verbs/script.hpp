// SPDX-License-Identifier: Apache-2.0
//
// The language of `trammel lm628`: commands of the data sheet (SNVS781C) by their mnemonics with
// their data as numbers, waits, loads, blocks that repeat, and single accesses of the port. One
// command a line, in any case; comments begin with # or ;. A number is decimal, 0x1F or 1Fh; where
// it may be negative, its bit pattern does too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sw_nios/hal/lm628.hpp"

namespace trammel::an693 {

enum class Action {
  kCommand,  // of the part, by its opcode
  kWrite,    // one access of the port, busy or not
  kRead,
  kReset,    // the pin RST
  kWait,
  kStatus,
  kPins,
  kTorque,  // of the load
  kRepeat,  // the lines up to kEnd, which are executed in their place
  kEnd,
  kHelp,
  kQuit
};

// A number that a command takes.
struct Field {
  const char* name;
  int bits;  // of its transfer
  std::int64_t low, high;
  std::int64_t asked_by = 0;       // bit of the control word that asks for it; 0: always there
  const char* relative = nullptr;  // its name if the bit below is set: then it may be negative
};

// What a command answers with: flags, or a number, which is signed if it has a unit.
struct Reply {
  int bits = 0;
  const char* unit = nullptr;  // of a number
  int fraction_bits = 0;
};

struct Command {
  const char* name;
  const char* help;
  sw::Lm628Command opcode{};  // of kCommand
  std::vector<Field> fields{};
  Reply reply{};
  const char* more = "";  // what `help NAME` adds
  Action action = Action::kCommand;
  std::vector<std::string> choices{};  // words of which one may come first
  const char* data = "";               // what follows the name, where fields do not say it
};

// All that the script, the shell, completion and help know.
const std::vector<Command>& commands();

inline constexpr std::int64_t kMostLines = 10000;  // that a script with blocks executes
inline constexpr double kLongestWait = 60;  // [s] simulated, unless a script says otherwise

struct Line {
  const Command* command = nullptr;
  std::string choice;                // one of the command's, or empty
  std::vector<std::uint32_t> words;  // data as the part takes them, of 16 bits each; or a byte
  double seconds = kLongestWait;     // kWait: how long, or how long at most; and as many
  double samples = 0;                // samples of the part
  double torque = 0;                 // kTorque [N m]
  const Command* topic = nullptr;    // kHelp: one command; none: all
  std::string text;                  // as it was written
  std::string where;                 // "file:line", for messages
};

// One line; nothing where it holds no command. Throws host::ConfigError, which begins with `where`.
std::optional<Line> parse_line(const std::string& text, const std::string& where);

// How many blocks are open behind a line. Throws host::ConfigError at an `end` too many.
int depth_after(int depth, const Line& line);

// All lines of a script as they are executed, those of blocks as often as these say; those after
// `quit` are read too.
std::vector<Line> parse_script(const std::string& text, const std::string& source);

// A built-in script's name or a path. Throws host::ConfigError.
std::filesystem::path find_script(const std::string& name);

// What may stand behind `before` and begins with `text`, in the case in which that was begun.
std::vector<std::string> completions(const std::string& before, const std::string& text);

std::string help_text(const Command* topic);

std::string hex(std::int64_t value, int bits);  // "00001F40h"

}  // namespace trammel::an693
