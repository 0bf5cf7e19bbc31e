// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "lab/errors.hpp"
#include "lab/scenarios.hpp"
#include "lab/text.hpp"
#include "machines/an693/record.hpp"

namespace trammel::an693 {
namespace {

using lab::ConfigError;

constexpr double kLongestTime = 3600;     // [s]
constexpr std::size_t kLongestWord = 40;  // characters that are shown

constexpr char kFilterHelp[] =
    "control word: bits 15..8 n, the derivative is formed every n + 1 samples;\n"
    "bit 3 kp, 2 ki, 1 kd, 0 il follow, in this order, each 0..32767.\n"
    "  LFIL 030Ah 50 1000    kp = 50, kd = 1000, every 4 samples; UDF activates them\n";
constexpr char kTrajectoryHelp[] =
    "control word: bit 5 acceleration, 3 velocity, 1 position follow, in this order; the bit\n"
    "below each (4, 2, 0): it is relative. Bit 11 velocity mode, 12 forward in it;\n"
    "10 stop smoothly, 9 stop abruptly, 8 motor off.\n"
    "Acceleration in 2^-16 count/sample^2, velocity in 2^-16 count/sample, position in counts.\n"
    "  LTRJ 002Ah 2 346Eh 8000    all three, absolute; STT starts the move\n"
    "  LTRJ 1828h 11h 20C4Ah      velocity mode, forward\n"
    "  LTRJ 0400h                 stop smoothly\n";
constexpr char kStatusHelp[] =
    "bit 7 motor off, 6 breakpoint, 5 position error, 4 wraparound, 3 index pulse,\n"
    "2 trajectory complete, 1 command error, 0 busy; 1 to 6 hold until RSTI clears them.\n";
constexpr char kConverterHelp[] =
    "The converter of this machine latches 12 bits by their strobes: the motor needs PORT12.\n";
constexpr char kWaitHelp[] =
    "  wait 0.5 s           also ms, us, and samples of 256 us\n"
    "  wait hi              until the pin HI is high\n"
    "  wait complete        until status bit 2 is set, read every sample; a bit that is still set\n"
    "                       from before counts: RSTI 0 clears it\n"
    "  wait complete 5 s    for at most 5 s; the default is 60 s\n";
constexpr char kPortHelp[] =
    "One access of the port, whether the part is busy or not: c is PS low, d is PS high.\n";

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// "0..32767 (7FFFh)"
std::string range_of(const Field& f) {
  const std::string low = f.low < 0 ? hex(f.low, f.bits) + ".." : "";
  return fmt::format("{}..{} ({}{})", f.low, f.high, low, hex(f.high, f.bits));
}

std::int64_t value_of(const Command& command, const Field& field, const std::string& text) {
  const bool negative = text.front() == '-';
  std::string digits = lower(text.substr(negative ? 1 : 0));
  int base = 10;
  if (digits.rfind("0x", 0) == 0) {
    digits.erase(0, 2);
    base = 16;
  } else if (!digits.empty() && digits.back() == 'h') {
    digits.pop_back();
    base = 16;
  }
  std::uint64_t bits = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, bits, base);
  if (stop != end || code == std::errc::invalid_argument) {
    throw ConfigError(fmt::format("{}: {}: {} is not a number {}; write 31, 0x1F or 1Fh",
                                  command.name, field.name, text, range_of(field)));
  }
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  const bool fits = code == std::errc{} && bits <= static_cast<std::uint64_t>(kMost);
  std::int64_t value = fits ? static_cast<std::int64_t>(bits) : kMost;
  const std::int64_t span = std::int64_t{1} << field.bits;
  if (negative) {
    value = -value;
  } else if (base == 16 && field.low < 0 && value >= span / 2 && value < span) {
    value -= span;
  }
  if (value < field.low || value > field.high) {
    throw ConfigError(fmt::format("{}: {}: {} is out of range {}", command.name, field.name, text,
                                  range_of(field)));
  }
  return value;
}

// What a control word asks for, itself included.
std::vector<Field> asked_for(const std::vector<Field>& fields, std::int64_t control) {
  std::vector<Field> asked;
  for (Field f : fields) {
    if (f.asked_by != 0 && (control & f.asked_by) == 0) continue;
    if (f.relative != nullptr && (control & f.asked_by >> 1) != 0) {
      f.name = f.relative;
      f.low = std::min(f.low, -f.high);
    }
    asked.push_back(f);
  }
  return asked;
}

void read_data(Line& line, const std::vector<std::string>& data) {
  const Command& command = *line.command;
  std::vector<Field> fields = command.fields;
  std::string asks = command.name;
  if (!fields.empty() && data.empty()) {
    throw ConfigError(fmt::format("{}: {} {} is missing", asks, fields[0].name,
                                  range_of(fields[0])));
  }
  std::size_t first = 0;  // behind the control word
  if (fields.size() > 1) {
    const std::int64_t control = value_of(command, fields[0], data[0]);
    asks += ' ' + hex(control, 16);
    fields = asked_for(fields, control);
    first = 1;
  }
  if (data.size() != fields.size()) {
    std::string wanted;
    for (std::size_t k = first; k < fields.size(); ++k) {
      wanted += fmt::format("{}{} {}", k > first ? ", " : "", fields[k].name, range_of(fields[k]));
    }
    const std::size_t count = fields.size() - first;
    throw ConfigError(fmt::format("{} asks for {}: {} value{}, not {}", asks,
                                  count == 0 ? "nothing" : wanted, count, count == 1 ? "" : "s",
                                  data.size() - first));
  }
  for (std::size_t k = 0; k < data.size(); ++k) {
    const auto value = static_cast<std::uint32_t>(value_of(command, fields[k], data[k]));
    if (fields[k].bits == 32) line.words.push_back(value >> 16);
    line.words.push_back(value & 0xFFFF);
  }
}

// "0.5s", "10ms", "100samples".
struct Time {
  double seconds = 0, samples = 0;
};
std::optional<Time> time_of(const std::string& text) {
  if (text.empty() || (std::isdigit(static_cast<unsigned char>(text[0])) == 0 && text[0] != '.')) {
    return {};
  }
  char* unit = nullptr;
  const double count = std::strtod(text.c_str(), &unit);
  const std::string name = lower(unit);
  if (name == "sample" || name == "samples") return Time{0, count};
  for (const auto& [one, scale] : {std::pair{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}}) {
    if (name == one) return Time{count * scale, 0};
  }
  return {};
}

void read_wait(Line& line, const std::vector<std::string>& data) {
  if (!line.choice.empty() && data.empty()) return;
  const std::string time = fmt::format("{}", fmt::join(data, ""));
  const auto asked = time_of(time);
  if (!asked) {
    throw ConfigError("wait: expects a time as 0.5 s, 10 ms, 300 us or 100 samples, or hi or "
                      "complete with the longest time to wait");
  }
  const double seconds = asked->seconds + asked->samples * Options().sample_s();
  if (!(seconds >= 0 && seconds <= kLongestTime)) {
    throw ConfigError(fmt::format("wait: {} is out of range 0..{} s", time, kLongestTime));
  }
  line.seconds = asked->seconds;
  line.samples = asked->samples;
}

const Command& find_command(const std::string& name) {
  std::vector<std::string> names;
  for (const Command& command : commands()) {
    if (lower(command.name) == lower(name)) return command;
    names.emplace_back(command.name);
  }
  throw ConfigError(fmt::format("{}: unknown command{}", name,
                                lab::hint(name, names, "; `help` names them all")));
}

// The command, its choice, and what its action asks for.
void read_line(Line& line, std::vector<std::string> data) {
  const Command& command = find_command(data[0]);
  line.command = &command;
  data.erase(data.begin());
  const std::vector<std::string>& choices = command.choices;
  const std::string first = data.empty() ? "" : lower(data[0]);
  if (std::find(choices.begin(), choices.end(), first) != choices.end()) {
    line.choice = first;
    data.erase(data.begin());
  }
  if (command.action == Action::kWait) return read_wait(line, data);
  if (command.action == Action::kHelp) {
    if (data.size() > 1) throw ConfigError("help: expects one mnemonic, or nothing");
    if (!data.empty()) line.topic = &find_command(data[0]);
    return;
  }
  if (!choices.empty() && line.choice.empty()) {
    throw ConfigError(fmt::format("{}: expects c (PS low: command, status) or d (PS high: data)",
                                  command.name));
  }
  read_data(line, data);
}

}  // namespace

const std::vector<Command>& commands() {
  using Op = sw::Lm628Command;
  constexpr std::int64_t kCoefficient = 0x7FFF;
  constexpr std::int64_t kRate = 0x3FFFFFFF;
  constexpr std::int64_t kReach = std::int64_t{1} << 30;
  static const Field control{"control", 16, 0, 0xFFFF};
  static const Field mask{"mask", 16, 0, 0xFFFF};
  static const Field threshold{"threshold", 16, 0, kCoefficient};
  static const Field position{"position", 32, -kReach, kReach - 1};
  static const Field distance{"distance", 32, -kReach, kReach - 1};
  static const Reply counts{32, "counts"};
  static const std::vector<Command> all{
      {"RESET", "like a low RST; then waits 1.5 ms", Op::kReset},
      {"PORT8", "output of 8 bits", Op::kPort8},
      {"PORT12", "output of 12 bits", Op::kPort12, {}, {}, kConverterHelp},
      {"DFH", "define the present position as 0", Op::kDfh},
      {"SIP", "take the position at the next index pulse", Op::kSip},
      {"LPEI", "position error that interrupts", Op::kLpei, {threshold}},
      {"LPES", "position error that stops the motor", Op::kLpes, {threshold}},
      {"SBPA", "breakpoint", Op::kSbpa, {position}},
      {"SBPR", "breakpoint, relative to the target", Op::kSbpr, {distance}},
      {"MSKI", "1: this status bit may interrupt", Op::kMski, {mask}, {}, kStatusHelp},
      {"RSTI", "0: clear this status bit; HI goes low", Op::kRsti, {mask}, {}, kStatusHelp},
      {"LFIL", "load the filter", Op::kLfil,
       {control, {"kp", 16, 0, kCoefficient, 8}, {"ki", 16, 0, kCoefficient, 4},
        {"kd", 16, 0, kCoefficient, 2}, {"il", 16, 0, kCoefficient, 1}}, {}, kFilterHelp},
      {"UDF", "use the loaded filter", Op::kUdf},
      {"LTRJ", "load a trajectory", Op::kLtrj,
       {control, {"acceleration", 32, 0, kRate, 0x20, "acceleration"},
        {"velocity", 32, 0, kRate, 0x08, "velocity"},
        {"position", 32, -kReach, kReach - 1, 0x02, "distance"}}, {}, kTrajectoryHelp},
      {"STT", "start the loaded trajectory", Op::kStt},
      {"RDSTAT", "status byte", {}, {}, {8}, kStatusHelp, Action::kRead},
      {"RDSIGS", "signals register", Op::kRdsigs, {}, {16}},
      {"RDIP", "index position", Op::kRdip, {}, counts},
      {"RDDP", "desired position", Op::kRddp, {}, counts},
      {"RDRP", "real position", Op::kRdrp, {}, counts},
      {"RDDV", "desired velocity", Op::kRddv, {}, {32, "counts/sample", 16}},
      {"RDRV", "real velocity", Op::kRdrv, {}, {16, "counts/sample"}},
      {"RDSUM", "sum of the errors", Op::kRdsum, {}, {16, "256 counts"}},
      {"byte", "write one byte at the port, busy or not", {}, {{"byte", 8, 0, 0xFF}}, {}, kPortHelp,
       Action::kWrite, {"c", "d"}, "c|d byte"},
      {"read", "read one byte at the port, busy or not", {}, {}, {8, ""}, kPortHelp, Action::kRead,
       {"c", "d"}, "c|d"},
      {"rst", "strobe the pin RST; then wait 1.5 ms", {}, {}, {}, "", Action::kReset},
      {"wait", "let simulated time pass", {}, {}, {}, kWaitHelp, Action::kWait, {"hi", "complete"},
       "time | hi [time] | complete [time]"},
      {"status", "status byte and signals, by name", {}, {}, {}, kStatusHelp, Action::kStatus},
      {"pins", "HI, encoder, converter, and the motor behind them", {}, {}, {}, "", Action::kPins},
      {"help", "all commands, or one in detail", {}, {}, {}, "", Action::kHelp, {}, "[mnemonic]"},
      {"quit", "end", {}, {}, {}, "", Action::kQuit},
      {"exit", "end", {}, {}, {}, "", Action::kQuit}};
  return all;
}

std::optional<Line> parse_line(const std::string& text, const std::string& where) {
  std::istringstream words(text.substr(0, text.find_first_of("#;")));
  std::vector<std::string> data;
  for (std::string word; words >> word;) data.push_back(lab::shown(word, kLongestWord));
  if (data.empty()) return {};
  Line line;
  line.where = where;
  line.text = fmt::format("{}", fmt::join(data, " "));
  try {
    read_line(line, std::move(data));
  } catch (const ConfigError& error) {
    throw ConfigError(where + ": " + error.what());
  }
  return line;
}

std::vector<Line> parse_script(const std::string& text, const std::string& source) {
  std::vector<Line> script;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (auto parsed = parse_line(line, fmt::format("{}:{}", source, number))) {
      script.push_back(std::move(*parsed));
    }
  }
  return script;
}

std::filesystem::path find_script(const std::string& name) {
  return lab::find_built_in(name, ".lm628", "script");
}

std::vector<std::string> completions(const std::string& before, const std::string& text) {
  const bool at_name = before.empty() || lower(before) == "help ";
  std::vector<std::string> words;
  for (const Command& command : commands()) {
    if (at_name) {
      words.emplace_back(command.name);
    } else if (lower(before) == lower(command.name) + ' ') {
      words = command.choices;
    }
  }
  const bool small = !text.empty() && std::islower(static_cast<unsigned char>(text[0])) != 0;
  std::vector<std::string> fitting;
  for (const std::string& word : words) {
    if (lower(word).rfind(lower(text), 0) == 0) fitting.push_back(small ? lower(word) : word);
  }
  return fitting;
}

std::string help_text(const Command* topic) {
  std::string text;
  for (const Command& command : commands()) {
    if (topic != nullptr && topic != &command) continue;
    std::string usage = fmt::format("{} {}", command.name, command.data);
    for (std::size_t k = 0; k < command.fields.size() && *command.data == '\0'; ++k) {
      const Field& field = command.fields[k];
      usage += fmt::format(field.asked_by == 0 ? "{}" : " [{}]", field.name);
    }
    const bool is_part = command.action == Action::kCommand;
    const std::string code = is_part ? hex(static_cast<std::int64_t>(command.opcode), 8) : "";
    text += fmt::format("{:<4} {:<51} {}\n", code, usage, command.help);
    if (topic != nullptr) text += command.more;
  }
  if (topic == nullptr) text += "Numbers: 31, 0x1F or 1Fh. Comments: # or ;. More: help LTRJ.\n";
  return text;
}

std::string hex(std::int64_t value, int bits) {
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  return fmt::format("{:0{}X}h", static_cast<std::uint64_t>(value) & mask, bits / 4);
}

}  // namespace trammel::an693
