// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "host/errors.hpp"
#include "host/text.hpp"
#include "lab/scenarios.hpp"
#include "machines/an693/record.hpp"

namespace trammel::an693 {
namespace {

using host::ConfigError;

constexpr double kLongestTime = 3600;     // [s]
constexpr std::size_t kLongestWord = 40;  // characters that are shown
constexpr double kLargestTorque = 10;     // [N m], as of motor.external_torque_N_m

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
  // A unit may stand apart, digits may not: "1 5 ms" is no 15 ms.
  const bool one_number =
      data.size() == 1 ||
      (data.size() == 2 && std::isalpha(static_cast<unsigned char>(data[1][0])) != 0);
  const auto asked = one_number ? time_of(time) : std::nullopt;
  if (!asked) {
    throw ConfigError("wait: expects a time as 0.5 s, 10 ms, 300 us or 100 samples, or one of hi, "
                      "complete, breakpoint, index and error with the longest time to wait");
  }
  const double seconds = asked->seconds + asked->samples * Options().sample_s();
  if (!(seconds >= 0 && seconds <= kLongestTime)) {
    throw ConfigError(fmt::format("wait: {} is out of range 0..{} s", time, kLongestTime));
  }
  line.seconds = asked->seconds;
  line.samples = asked->samples;
}

void read_torque(Line& line, const std::vector<std::string>& data) {
  constexpr char kAsks[] = "torque: expects one number in N m, -10 to 10, as 0.01";
  if (data.size() != 1) throw ConfigError(kAsks);
  char* end = nullptr;
  line.torque = std::strtod(data[0].c_str(), &end);
  if (*end != '\0' || std::isnan(line.torque)) {
    throw ConfigError(fmt::format("{}, not {}", kAsks, data[0]));
  }
  if (std::abs(line.torque) > kLargestTorque) {
    throw ConfigError(fmt::format("torque: {} is out of range -{:g}..{:g} N m", data[0],
                                  kLargestTorque, kLargestTorque));
  }
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
  if (command.action == Action::kTorque) return read_torque(line, data);
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

// Lines from `first` on, which are there once, as often as `by` says.
void repeat(std::vector<Line>& script, std::size_t first, const Line& by) {
  const std::size_t count = by.words[0], length = script.size() - first;
  const std::size_t all = first + count * length;
  if (all > kMostLines) {
    throw ConfigError(fmt::format(
        "{}: {}: the script would execute {} lines up to its end; at most {} are allowed", by.where,
        by.text, all, kMostLines));
  }
  script.reserve(all);
  for (std::size_t n = first + length; n < all; ++n) script.push_back(script[n - length]);
}

}  // namespace

std::optional<Line> parse_line(const std::string& text, const std::string& where) {
  std::istringstream words(text.substr(0, text.find_first_of("#;")));
  std::vector<std::string> data;
  for (std::string word; words >> word;) data.push_back(host::shown(word, kLongestWord));
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

int depth_after(int depth, const Line& line) {
  if (line.command->action == Action::kRepeat) return depth + 1;
  if (line.command->action != Action::kEnd) return depth;
  if (depth == 0) throw ConfigError(line.where + ": end: there is no repeat before it");
  return depth - 1;
}

std::vector<Line> parse_script(const std::string& text, const std::string& source) {
  std::vector<Line> script;
  std::vector<std::pair<Line, std::size_t>> open;  // repeat, and where its lines begin
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    auto parsed = parse_line(line, fmt::format("{}:{}", source, number));
    if (!parsed) continue;
    depth_after(static_cast<int>(open.size()), *parsed);
    if (parsed->command->action == Action::kRepeat) {
      open.emplace_back(std::move(*parsed), script.size());
    } else if (parsed->command->action == Action::kEnd) {
      repeat(script, open.back().second, open.back().first);
      open.pop_back();
    } else {
      script.push_back(std::move(*parsed));
    }
  }
  if (!open.empty()) throw ConfigError(open.back().first.where + ": repeat: has no end");
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
