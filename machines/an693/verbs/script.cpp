// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>

#include "machines/an693/record.hpp"
#include "lab/errors.hpp"
#include "lab/scenarios.hpp"

namespace trammel::an693 {
namespace {

using sw::Lm628Command;

constexpr std::int64_t kCoefficient = 0x7FFF;
constexpr std::int64_t kWord = 0xFFFF;
constexpr std::int64_t kRate = 0x3FFFFFFF;  // of velocity and acceleration
constexpr std::int64_t kReach = std::int64_t{1} << 30;  // of positions
constexpr double kLongestTime = 3600;  // [s]

// A number that a command takes.
struct Field {
  std::string name;
  int bits;
  std::int64_t low, high;
};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// What a terminal can show of a word that may be anything.
std::string shown(const std::string& word) {
  constexpr std::size_t kMost = 40;
  std::string text;
  for (const char c : word.substr(0, kMost)) {
    text += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  }
  return word.size() > kMost ? text + "..." : text;
}

struct Number {
  std::int64_t value = 0;
  bool whole_pattern = false;  // hexadecimal without a sign
};

std::optional<Number> number(const std::string& text) {
  const bool negative = !text.empty() && text.front() == '-';
  std::string digits = lower(text.substr(negative ? 1 : 0));
  int base = 10;
  if (digits.rfind("0x", 0) == 0) {
    digits.erase(0, 2);
    base = 16;
  } else if (!digits.empty() && digits.back() == 'h') {
    digits.pop_back();
    base = 16;
  }
  std::uint64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, value, base);
  if (digits.empty() || stop != end || code == std::errc::invalid_argument) return {};
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (code != std::errc{} || value > kMost) value = kMost;  // out of every range
  const auto whole = static_cast<std::int64_t>(value);
  return Number{negative ? -whole : whole, base == 16 && !negative};
}

std::string range_of(const Field& f) {
  return f.low < 0 ? fmt::format("{}..{} ({}..{})", f.low, f.high, lm628_hex(f.low, f.bits),
                                 lm628_hex(f.high, f.bits))
                   : fmt::format("{}..{} ({})", f.low, f.high, lm628_hex(f.high, f.bits));
}

Lm628Value value_of(const Field& field, const std::string& text, const std::string& where) {
  const auto read = number(text);
  if (!read) {
    throw lab::ConfigError(fmt::format("{}: {}: {} is no number {}; write 31, 0x1F or 1Fh", where,
                                  field.name, shown(text), range_of(field)));
  }
  std::int64_t value = read->value;
  const std::int64_t span = std::int64_t{1} << field.bits;
  if (field.low < 0 && read->whole_pattern && value >= span / 2 && value < span) value -= span;
  if (value < field.low || value > field.high) {
    throw lab::ConfigError(fmt::format("{}: {}: {} is out of range {}", where, field.name,
                                       shown(text), range_of(field)));
  }
  return {value, field.bits};
}

// What follows a control word of LFIL, by its bits 3 to 0.
std::vector<Field> filter_fields(std::int64_t control) {
  std::vector<Field> fields;
  for (const auto& [bit, name] : {std::pair{8, "kp"}, {4, "ki"}, {2, "kd"}, {1, "il"}}) {
    if ((control & bit) != 0) fields.push_back({name, 16, 0, kCoefficient});
  }
  return fields;
}

// What follows a control word of LTRJ: bits 5, 3, 1 say that it does, the bit below each that it is
// relative.
std::vector<Field> trajectory_fields(std::int64_t control) {
  std::vector<Field> fields;
  for (const auto& [bit, name] : {std::pair{0x20, "acceleration"}, {0x08, "velocity"}}) {
    const bool relative = (control & bit >> 1) != 0;
    if ((control & bit) != 0) fields.push_back({name, 32, relative ? -kRate : 0, kRate});
  }
  if ((control & 2) != 0) {
    fields.push_back({(control & 1) != 0 ? "distance" : "position", 32, -kReach, kReach - 1});
  }
  return fields;
}

// The first number of a command that takes any.
std::vector<Field> first_field(const Lm628Word& word) {
  if (word.action == Lm628Action::kByte) return {{"byte", 8, 0, 0xFF}};
  if (word.action != Lm628Action::kCommand) return {};
  switch (word.code) {
    case Lm628Command::kLpes:
    case Lm628Command::kLpei: return {{"threshold", 16, 0, kCoefficient}};
    case Lm628Command::kMski:
    case Lm628Command::kRsti: return {{"mask", 16, 0, kWord}};
    case Lm628Command::kLfil:
    case Lm628Command::kLtrj: return {{"control word", 16, 0, kWord}};
    case Lm628Command::kSbpa: return {{"position", 32, -kReach, kReach - 1}};
    case Lm628Command::kSbpr: return {{"distance", 32, -kReach, kReach - 1}};
    default: return {};
  }
}

std::string names_of(const std::vector<Field>& fields) {
  std::string text;
  for (const Field& f : fields) text += (text.empty() ? "" : ", ") + f.name + ' ' + range_of(f);
  return text.empty() ? "nothing" : text;
}

void read_data(Lm628Line& line, const std::vector<std::string>& data) {
  const std::string name = line.word->name;
  const std::string where = line.where + ": " + name;
  std::vector<Field> fields = first_field(*line.word);
  std::string asks = name;
  if (!fields.empty() && data.empty()) {
    throw lab::ConfigError(fmt::format("{}: {} {} is missing", where, fields[0].name,
                                  range_of(fields[0])));
  }
  if (!fields.empty()) {
    const Lm628Value first = value_of(fields[0], data[0], where);
    const bool is_filter = line.word->code == Lm628Command::kLfil;
    if (line.word->action == Lm628Action::kCommand &&
        (is_filter || line.word->code == Lm628Command::kLtrj)) {
      asks += ' ' + lm628_hex(first.value, 16);
      const auto more = is_filter ? filter_fields(first.value) : trajectory_fields(first.value);
      fields.insert(fields.end(), more.begin(), more.end());
    }
  }
  if (data.size() != fields.size()) {
    const bool controlled = asks != name;
    const std::size_t fixed = controlled ? 1 : 0;
    const std::vector<Field> wanted(fields.begin() + static_cast<std::ptrdiff_t>(fixed),
                                    fields.end());
    throw lab::ConfigError(fmt::format("{}: {} asks for {}: {} value{}, not {}", line.where, asks,
                                  names_of(wanted), wanted.size(), wanted.size() == 1 ? "" : "s",
                                  data.size() - fixed));
  }
  for (std::size_t n = 0; n < data.size(); ++n) {
    line.values.push_back(value_of(fields[n], data[n], where));
  }
}

// "0.5 s", "10ms", "100 samples" in seconds.
std::optional<double> seconds_of(const std::string& text) {
  char* stop = nullptr;
  if (text.empty() || (std::isdigit(static_cast<unsigned char>(text[0])) == 0 && text[0] != '.')) {
    return {};
  }
  const double count = std::strtod(text.c_str(), &stop);
  const std::string unit = lower(stop);
  for (const auto& [name, scale] :
       {std::pair{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"samples", kSampleS},
        {"sample", kSampleS}}) {
    if (unit == name) return count * scale;
  }
  return {};
}

void read_wait(Lm628Line& line, std::vector<std::string> data) {
  const std::string event = data.empty() ? "" : lower(data[0]);
  if (event == "hi" || event == "complete") {
    line.until = event == "hi" ? Lm628Until::kHost : Lm628Until::kComplete;
    data.erase(data.begin());
    line.seconds = kLongestWait;
    if (data.empty()) return;
  }
  std::string joined;
  for (const std::string& part : data) joined += part;
  const auto seconds = seconds_of(joined);
  if (!seconds) {
    throw lab::ConfigError(
        fmt::format("{}: wait: expects a time as 0.5 s, 10 ms, 300 us or 100 samples,"
                    " or hi or complete with the longest time to wait",
                    line.where));
  }
  if (!(*seconds >= 0 && *seconds <= kLongestTime)) {
    throw lab::ConfigError(fmt::format("{}: wait: {} is out of range 0..{} s", line.where,
                                  shown(joined), kLongestTime));
  }
  line.seconds = *seconds;
}

// "c" or "d", which is taken away.
void read_port(Lm628Line& line, std::vector<std::string>& data) {
  const std::string port = data.empty() ? "" : lower(data[0]);
  if (port != "c" && port != "d") {
    throw lab::ConfigError(fmt::format("{}: {}: expects c (PS low: command, status) or d (PS high: "
                                  "data)", line.where, line.word->name));
  }
  line.to_data = port == "d";
  data.erase(data.begin());
}

const Lm628Word& find_word(const std::string& name, const std::string& where) {
  const auto& all = lm628_words();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Lm628Word& word) {
    return lower(word.name) == lower(name);
  });
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Lm628Word& word : all) names.emplace_back(word.name);
  const std::string near = lab::suggest(name, names);
  throw lab::ConfigError(fmt::format("{}: {}: unknown command{}; `help` names them all", where,
                                shown(name),
                                near.empty() ? "" : fmt::format(", did you mean {}?", near)));
}

}  // namespace

std::string lm628_hex(std::int64_t value, int bits) {
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  return fmt::format("{:0{}X}h", static_cast<std::uint64_t>(value) & mask, bits / 4);
}

std::optional<Lm628Line> parse_lm628_line(const std::string& text, const std::string& where) {
  std::istringstream words(text.substr(0, text.find_first_of("#;")));
  std::vector<std::string> data;
  for (std::string word; words >> word;) data.push_back(word);
  if (data.empty()) return {};
  Lm628Line line;
  line.where = where;
  line.word = &find_word(data[0], where);
  for (const std::string& word : data) line.text += (line.text.empty() ? "" : " ") + word;
  data.erase(data.begin());
  switch (line.word->action) {
    case Lm628Action::kWait: read_wait(line, data); break;
    case Lm628Action::kHelp:
      if (data.size() > 1)
        throw lab::ConfigError(where + ": help: expects one mnemonic, or nothing");
      if (!data.empty()) line.topic = find_word(data[0], where).name;
      break;
    case Lm628Action::kByte:
    case Lm628Action::kRead:
      read_port(line, data);
      [[fallthrough]];
    default: read_data(line, data);
  }
  return line;
}

std::vector<Lm628Line> parse_lm628_script(const std::string& text, const std::string& source) {
  std::vector<Lm628Line> script;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (auto parsed = parse_lm628_line(line, fmt::format("{}:{}", source, number))) {
      script.push_back(std::move(*parsed));
    }
  }
  return script;
}

std::filesystem::path find_lm628_script(const std::string& name) {
  return lab::find_built_in(name, ".lm628", "script");
}

}  // namespace trammel::an693
