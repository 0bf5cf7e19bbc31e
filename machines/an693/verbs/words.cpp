// SPDX-License-Identifier: Apache-2.0
//
// The words of `trammel lm628` and what `help` says of them.
#include <fmt/format.h>

#include <cstring>

#include "lab/errors.hpp"
#include "machines/an693/verbs/script.hpp"

namespace trammel::an693 {
namespace {

using sw::Lm628Command;
using Action = Lm628Action;

constexpr char kFilter[] =
    "control word: bits 15..8 n, the derivative is formed every n + 1 samples;\n"
    "bit 3 kp, 2 ki, 1 kd, 0 il follow, in this order, each 0..32767.\n"
    "  LFIL 030Ah 50 1000    kp = 50, kd = 1000, every 4 samples; UDF makes them work\n";
constexpr char kTrajectory[] =
    "control word: bit 5 acceleration, 3 velocity, 1 position follow, in this order; the bit\n"
    "below each (4, 2, 0): it is relative. Bit 11 velocity mode, 12 forward in it;\n"
    "10 stop smoothly, 9 stop abruptly, 8 motor off.\n"
    "Acceleration in 2^-16 count/sample^2, velocity in 2^-16 count/sample, position in counts.\n"
    "  LTRJ 002Ah 2 346Eh 8000    all three, absolute; STT makes them work\n"
    "  LTRJ 1828h 11h 20C4Ah      velocity mode, forward\n"
    "  LTRJ 0400h                 stop smoothly\n";
constexpr char kStatusHelp[] =
    "bit 7 motor off, 6 breakpoint, 5 position error, 4 wraparound, 3 index pulse,\n"
    "2 trajectory complete, 1 command error, 0 busy; 1 to 6 hold until RSTI clears them.\n";
constexpr char kWaitMore[] =
    "  wait 0.5 s           also ms, us, and samples of 256 us\n"
    "  wait hi              until the pin HI is high\n"
    "  wait complete        until status bit 2 is set, read every sample; a bit that is still set\n"
    "                       from before counts: RSTI 0 clears it\n"
    "  wait complete 5 s    for at most 5 s; 60 s where nothing is said\n";
constexpr char kRaw[] =
    "One access of the port, whether the part is busy or not: c is PS low, d is PS high.\n";

const char* more_of(const Lm628Word& word) {
  if (word.action == Action::kWait) return kWaitMore;
  if (word.action == Action::kRdstat || word.action == Action::kStatus) return kStatusHelp;
  if (word.action == Action::kByte || word.action == Action::kRead) return kRaw;
  if (word.action != Action::kCommand) return "";
  switch (word.code) {
    case Lm628Command::kLfil: return kFilter;
    case Lm628Command::kLtrj: return kTrajectory;
    case Lm628Command::kMski:
    case Lm628Command::kRsti: return kStatusHelp;
    case Lm628Command::kPort12: return "The converter of this machine has 12 bits and takes them "
                                       "by their strobes: the motor needs PORT12.\n";
    default: return "";
  }
}

}  // namespace

const std::vector<Lm628Word>& lm628_words() {
  constexpr Action kPart = Action::kCommand;
  static const std::vector<Lm628Word> all{
      {"RESET", kPart, Lm628Command::kReset, "", "as a low RST; then waits 1.5 ms"},
      {"PORT8", kPart, Lm628Command::kPort8, "", "output of 8 bits"},
      {"PORT12", kPart, Lm628Command::kPort12, "", "output of 12 bits"},
      {"DFH", kPart, Lm628Command::kDfh, "", "here is position 0"},
      {"SIP", kPart, Lm628Command::kSip, "", "take the position at the next index pulse"},
      {"LPEI", kPart, Lm628Command::kLpei, "threshold", "position error that interrupts"},
      {"LPES", kPart, Lm628Command::kLpes, "threshold", "position error that stops the motor"},
      {"SBPA", kPart, Lm628Command::kSbpa, "position", "breakpoint"},
      {"SBPR", kPart, Lm628Command::kSbpr, "distance", "breakpoint, from the target"},
      {"MSKI", kPart, Lm628Command::kMski, "mask", "1: this status bit may interrupt"},
      {"RSTI", kPart, Lm628Command::kRsti, "mask", "0: clear this status bit; HI goes low"},
      {"LFIL", kPart, Lm628Command::kLfil, "control [kp] [ki] [kd] [il]", "load the filter"},
      {"UDF", kPart, Lm628Command::kUdf, "", "use the filter that was loaded"},
      {"LTRJ", kPart, Lm628Command::kLtrj, "control [acceleration] [velocity] [position]",
       "load a trajectory"},
      {"STT", kPart, Lm628Command::kStt, "", "start what was loaded"},
      {"RDSTAT", Action::kRdstat, {}, "", "status byte", 8},
      {"RDSIGS", kPart, Lm628Command::kRdsigs, "", "signals register", 16},
      {"RDIP", kPart, Lm628Command::kRdip, "", "index position", 32, "counts", true},
      {"RDDP", kPart, Lm628Command::kRddp, "", "desired position", 32, "counts", true},
      {"RDRP", kPart, Lm628Command::kRdrp, "", "real position", 32, "counts", true},
      {"RDDV", kPart, Lm628Command::kRddv, "", "desired velocity", 32, "counts/sample", true, 16},
      {"RDRV", kPart, Lm628Command::kRdrv, "", "real velocity", 16, "counts/sample", true},
      {"RDSUM", kPart, Lm628Command::kRdsum, "", "sum of the errors", 16, "256 counts", true},
      {"byte", Action::kByte, {}, "c|d byte", "write one byte at the port, busy or not"},
      {"read", Action::kRead, {}, "c|d", "read one byte at the port, busy or not", 8},
      {"rst", Action::kRst, {}, "", "strobe the pin RST; then wait 1.5 ms"},
      {"wait", Action::kWait, {}, "time | hi [time] | complete [time]", "let simulated time pass"},
      {"status", Action::kStatus, {}, "", "status byte and signals, by name"},
      {"pins", Action::kPins, {}, "", "HI, encoder, converter, and the motor behind them"},
      {"help", Action::kHelp, {}, "[mnemonic]", "this, or all of one"},
      {"quit", Action::kQuit, {}, "", "end"},
      {"exit", Action::kQuit, {}, "", "end"}};
  return all;
}

std::string lm628_help(const std::string& topic) {
  std::string text;
  for (const Lm628Word& word : lm628_words()) {
    if (!topic.empty() && topic != word.name) continue;
    const std::string head = fmt::format("{} {}", word.name, word.data);
    const bool is_part = word.action == Action::kCommand;
    const std::string code =
        is_part ? lm628_hex(static_cast<std::int64_t>(word.code), 8) : "";
    text += fmt::format("{:<4} {:<51} {}\n", code, head, word.help);
    if (!topic.empty()) text += more_of(word);
  }
  if (topic.empty()) text += "Numbers: 31, 0x1F or 1Fh. Comments: # or ;. More: help LTRJ.\n";
  return text;
}

}  // namespace trammel::an693
