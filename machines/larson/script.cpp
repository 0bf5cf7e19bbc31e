// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "cosim/run.hpp"
#include "host/errors.hpp"
#include "host/input_file.hpp"
#include "host/text.hpp"
#include "lab/scenarios.hpp"
#include "lab/settings.hpp"

namespace trammel::larson {
namespace {

using host::ConfigError;
using sw::LarsonOp;

constexpr int kFar = 100'000;          // [step] of a place or a distance
constexpr int kLeastRate = 59;         // [pulse/s]: 240 kHz / 4096
constexpr int kMostRate = 4000;
constexpr int kLongestWait = 40'000;   // [ms]
constexpr int kMostRepeats = 100'000;
constexpr std::size_t kDeepest = 16;   // REPEAT in REPEAT

enum class Data { kNone, kRates, kPlace, kOffset, kTime, kWord, kByte };

struct Form {
  const char* name;
  LarsonOp op;
  Data data;
};

constexpr Form kForms[] = {
    {"CALTBL", LarsonOp::kCaltbl, Data::kNone}, {"VELTBL", LarsonOp::kVeltbl, Data::kRates},
    {"ABSTBL", LarsonOp::kAbstbl, Data::kPlace}, {"RELTBL", LarsonOp::kReltbl, Data::kOffset},
    {"WTTBL", LarsonOp::kWttbl, Data::kNone},    {"WHRTBL", LarsonOp::kWhrtbl, Data::kNone},
    {"WAIT", LarsonOp::kWait, Data::kTime},      {"MOV", LarsonOp::kMov, Data::kWord},
    {"BIS", LarsonOp::kBis, Data::kWord},        {"BIC", LarsonOp::kBic, Data::kWord},
    {"MOVB", LarsonOp::kMovb, Data::kByte},      {"POLL", LarsonOp::kPoll, Data::kWord}};

constexpr const char* kWords[] = {"XCOUNT", "XSTATUS", "YCOUNT", "YSTATUS"};
constexpr const char* kBytes[] = {"XCOUNT",   "XCOUNT+1", "XSTATUS", "XSTATUS+1",
                                  "YCOUNT",   "YCOUNT+1", "YSTATUS", "YSTATUS+1"};

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::int32_t number(const std::string& what, const std::string& text, std::int64_t low,
                    std::int64_t high, int base = 10) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value, base);
  const std::string range = base == 8 ? fmt::format("{:06o}..{:06o}, octal", low, high)
                                      : fmt::format("{}..{}", low, high);
  if (stop != end || code == std::errc::invalid_argument) {
    throw ConfigError(fmt::format("{}: {} is not a number {}", what, host::shown(text), range));
  }
  if (code != std::errc{} || value < low || value > high) {
    throw ConfigError(fmt::format("{}: {} is out of range, allowed {}", what, host::shown(text),
                                  range));
  }
  return static_cast<std::int32_t>(value);
}

void expect(const std::string& name, const std::vector<std::string>& words, std::size_t count,
            const char* what) {
  if (words.size() == count + 1) return;
  throw ConfigError(fmt::format("{} takes {}: {} value{}, not {}", name, what, count,
                                count == 1 ? "" : "s", words.size() - 1));
}

// Word or byte, and its value in octal.
template <std::size_t kCount>
void set_place(sw::LarsonCall& call, const std::string& name, const std::vector<std::string>& words,
               const char* const (&places)[kCount], const char* what, std::int64_t high) {
  expect(name, words, 2, what);
  const auto* const at = std::find(std::begin(places), std::end(places), upper(words[1]));
  if (at == std::end(places)) {
    throw ConfigError(fmt::format("{}: {} is not one of {}", name, host::shown(words[1]),
                                  fmt::join(places, ", ")));
  }
  call.a = static_cast<std::int32_t>(at - std::begin(places));
  call.b = number(name + " " + *at, words[2], 0, high, 8);
}

sw::LarsonCall call_of(const Form& form, const std::vector<std::string>& words,
                       std::int64_t clock_ps) {
  sw::LarsonCall call;
  call.op = form.op;
  const std::string name = form.name;
  switch (form.data) {
    case Data::kNone: expect(name, words, 0, "nothing"); break;
    case Data::kRates:
      expect(name, words, 2, "the rates of x and y");
      call.a = number(name + " x", words[1], kLeastRate, kMostRate);
      call.b = number(name + " y", words[2], kLeastRate, kMostRate);
      break;
    case Data::kOffset:
      if (words.size() == 1) break;  // those of the one before it
      [[fallthrough]];
    case Data::kPlace:
      expect(name, words, 2, "x and y");
      call.a = number(name + " x", words[1], -kFar, kFar);
      call.b = number(name + " y", words[2], -kFar, kFar);
      break;
    case Data::kTime: {
      expect(name, words, 1, "milliseconds");
      const std::int32_t ms = number(name, words[1], 1, kLongestWait);
      call.a = static_cast<std::int32_t>(cosim::clocks_of(1e-3 * ms, clock_ps));
      break;
    }
    case Data::kWord:
      set_place(call, name, words, kWords, "a word and its bits in octal", 0177777);
      break;
    case Data::kByte: set_place(call, name, words, kBytes, "a byte and its bits in octal", 0377);
  }
  return call;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// Lines one after the other, as they are executed.
class Parser {
 public:
  Parser(const std::string& text, std::string source, std::int64_t clock_ps)
      : in_(std::string(host::past_mark(text))), source_(std::move(source)), clock_ps_(clock_ps) {
    check_text(text, source_);
  }

  std::vector<Call> all() {
    std::vector<Call> calls = block(0);
    if (calls.empty()) throw ConfigError(source_ + ": has no call");
    keep_offsets(calls);
    return calls;
  }

 private:
  [[noreturn]] void fail(const std::string& why, std::size_t line) const {
    throw ConfigError(fmt::format("{}:{}: {}", source_, line, why));
  }

  // R0 and R1 "are preserved so that successive calls of RELTBL will reference them".
  void keep_offsets(std::vector<Call>& calls) const {
    const Call* last = nullptr;
    for (Call& one : calls) {
      if (one.call.op != LarsonOp::kReltbl) continue;
      if (one.text == "RELTBL") {
        if (last == nullptr) {
          fail("RELTBL takes x and y: 2 values, as there is no RELTBL before it", one.line);
        }
        one.call = last->call;
      }
      last = &one;
    }
  }

  // Up to the END of the block that began in line `begun`, or the end of the file for 0.
  std::vector<Call> block(std::size_t begun) {
    std::vector<Call> calls;
    for (std::string text; std::getline(in_, text);) {
      ++line_;
      const std::vector<std::string> words = words_of(text);
      if (words.empty()) continue;
      const std::string name = upper(words[0]);
      const std::size_t here = line_;
      try {
        if (name == "END") {
          expect(name, words, 0, "nothing");
          if (begun == 0) throw ConfigError("END without a REPEAT");
          return calls;
        }
        if (name == "REPEAT") {
          expect(name, words, 1, "how often");
          repeat(calls, number(name, words[1], 1, kMostRepeats), here);
        } else {
          calls.push_back({call_of(form(name), words, clock_ps_), join(words), here});
        }
        if (calls.size() > kMostCalls) {
          throw ConfigError(fmt::format("more than {} calls", kMostCalls));
        }
      } catch (const ConfigError& error) {
        const std::string what = error.what();
        if (what.rfind(source_ + ":", 0) == 0) throw;
        fail(what, here);
      }
    }
    if (begun != 0) fail("REPEAT without an END", begun);
    return calls;
  }

  void repeat(std::vector<Call>& calls, std::int32_t times, std::size_t here) {
    if (depth_ == kDeepest) {
      throw ConfigError(fmt::format("more than {} REPEAT in each other", kDeepest));
    }
    ++depth_;
    const std::vector<Call> inner = block(here);
    --depth_;
    if (inner.size() * static_cast<std::size_t>(times) > kMostCalls) {
      throw ConfigError(fmt::format("more than {} calls", kMostCalls));
    }
    for (; times > 0; --times) calls.insert(calls.end(), inner.begin(), inner.end());
  }

  static const Form& form(const std::string& name) {
    for (const Form& one : kForms) {
      if (name == one.name) return one;
    }
    std::vector<std::string> names{"REPEAT", "END"};
    for (const Form& one : kForms) names.emplace_back(one.name);
    const std::string moves =
        name.find(',') == std::string::npos ? "" : "; a list of moves x,y,pen is a .csv file";
    throw ConfigError(host::shown(name) + " is not a call" +
                      lab::hint(name, names,
                                fmt::format(", allowed: {}{}", fmt::join(names, ", "), moves)));
  }

  static std::string join(const std::vector<std::string>& words) {
    std::string text = upper(words[0]);
    for (std::size_t k = 1; k < words.size(); ++k) text += ' ' + upper(words[k]);
    return text;
  }

  std::istringstream in_;
  std::string source_;
  std::int64_t clock_ps_;
  std::size_t line_ = 0;
  std::size_t depth_ = 0;
};

}  // namespace

void check_text(const std::string& text, const std::string& source) {
  const auto fail = [&](std::size_t at, const std::string& found, const char* allowed) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    throw ConfigError(fmt::format("{}:{}: found {}, allowed: {}", source,
                                  1 + std::count(text.begin(), end, '\n'), found, allowed));
  };
  constexpr const char* kEncoding = "text in UTF-8 or ASCII; save it as that";
  const std::string begin = text.substr(0, 2);
  if (begin == "\xFF\xFE" || begin == "\xFE\xFF") {
    fail(0, "the byte order mark of UTF-16", kEncoding);
  }
  if (const auto at = text.find('\0'); at != std::string::npos) {
    fail(at, "a zero byte, as of UTF-16", kEncoding);
  }
  if (const auto at = text.find("\xEF\xBB\xBF", 1); at != std::string::npos) {
    fail(at, "a byte order mark", "one at the beginning of the file");
  }
  for (std::size_t at = 0; (at = text.find('\r', at)) != std::string::npos; ++at) {
    if (at + 1 < text.size() && text[at + 1] != '\n') {
      fail(at, "a carriage return within a line", "lines that end in LF or CR LF");
    }
  }
}

std::string name_of(LarsonOp op) {
  for (const Form& one : kForms) {
    if (one.op == op) return one.name;
  }
  return "";
}

std::vector<Call> parse_script(const std::string& text, const std::string& source,
                               std::int64_t clock_ps) {
  return Parser(text, source, clock_ps).all();
}

std::string script_file(const std::string& name) {
  const std::string extension = std::filesystem::path(name).extension().string();
  const bool whole = upper(extension) == ".CSV" || upper(extension) == ".TABLE";
  return lab::find_built_in(name, whole ? extension : ".table", "script").string();
}

std::vector<Call> read_calls(const std::string& name, const PlotSetup& setup,
                             std::int64_t clock_ps) {
  const std::string file = script_file(name);
  const bool moves = upper(std::filesystem::path(file).extension().string()) == ".CSV";
  try {
    const std::string text = host::read_file(file, host::kMiB);
    return moves ? parse_moves(text, file, setup) : parse_script(text, file, clock_ps);
  } catch (const host::InputError& error) {
    throw ConfigError(error.what());
  }
}

}  // namespace trammel::larson
