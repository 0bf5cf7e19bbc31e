// SPDX-License-Identifier: Apache-2.0
//
// The language of scripts for the table, one call a line, in any case, comments behind #:
//
//   CALTBL | WTTBL | WHRTBL
//   VELTBL x y            rates [pulse/s], 59 to 4000
//   ABSTBL x y            to a place [step];  RELTBL x y  by so much;  RELTBL  as the one before it
//   WAIT ms
//   MOV word octal        a word by hand: XCOUNT, XSTATUS, YCOUNT or YSTATUS; BIS, BIC word octal
//   MOVB byte octal       a byte: a word's name, or that and +1
//   POLL word octal       until these bits of it are 0
//   REPEAT n ... END      the lines between so often; blocks may be nested
//
// And a list of moves, as a plotter takes it: lines x,y,pen of a CSV file, in steps; with pen 0 the
// table goes there at the rate of moves, with pen 1 along a straight line at that of lines. Beyond
// the soft range it stops there, as of ABSTBL.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sw_nios/apps/larson/larson.hpp"

namespace trammel::larson {

struct Call {
  sw::LarsonCall call;
  std::string text;       // as it was written, for people
  std::size_t line = 0;   // of its file; 0: a list of moves has it not
};

struct PlotSetup {
  int move = 2000;      // [pulse/s]
  int draw = 500;
  int soft_end = 5980;  // [step] of the table
};

inline constexpr std::size_t kMostCalls = 200'000;

// Throw host::ConfigError that names source, line, what was found, and what is permitted. The
// first: of what is no text in UTF-8 with lines of its own.
void check_text(const std::string& text, const std::string& source);
std::vector<Call> parse_script(const std::string& text, const std::string& source,
                               std::int64_t clock_ps);
std::vector<Call> parse_moves(const std::string& text, const std::string& source,
                              const PlotSetup& setup);

// The file of a script: a built-in one by its name, or a path.
std::string script_file(const std::string& name);

// The calls of that file; one that ends in .csv is a list of moves.
std::vector<Call> read_calls(const std::string& name, const PlotSetup& setup,
                             std::int64_t clock_ps);

std::string name_of(sw::LarsonOp op);

}  // namespace trammel::larson
