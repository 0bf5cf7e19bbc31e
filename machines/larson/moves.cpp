// SPDX-License-Identifier: Apache-2.0
//
// A list of moves as calls. A straight line needs both axes to arrive together: each runs at its
// share of the rate, which is rounded to a rate code; so that neither error nor a rate below the
// least one shows, a line is drawn in pieces of which each ends at a whole step near it.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "host/errors.hpp"
#include "host/input_file.hpp"
#include "host/text.hpp"
#include "machines/larson/script.hpp"

namespace trammel::larson {
namespace {

using host::ConfigError;

constexpr int kPiece = 40;     // [step] of the longer axis
constexpr int kLeastRate = 59;
constexpr int kFar = 100'000;  // [step]

struct Row {
  int x = 0, y = 0, pen = 0;
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// Between commas, without blanks around them; an empty last one, too.
std::vector<std::string> fields_of(const std::string& text) {
  std::vector<std::string> fields;
  std::size_t from = 0;
  for (std::size_t comma; (comma = text.find(',', from)) != std::string::npos; from = comma + 1) {
    fields.push_back(trimmed(text.substr(from, comma - from)));
  }
  fields.push_back(trimmed(text.substr(from)));
  return fields;
}

// A word that begins as no number does.
bool is_header(const std::string& word) {
  return !word.empty() && word.find_first_of("0123456789+-.") != 0;
}

int number_of(const std::string& word, const char* name, int low, int high,
              const std::string& where) {
  int value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, code] = std::from_chars(word.data(), end, value);
  if (stop != end || code != std::errc{} || value < low || value > high) {
    throw ConfigError(fmt::format("{}: {}: {} is not a whole number in {}..{}", where, name,
                                  word.empty() ? "nothing" : host::shown(word), low, high));
  }
  return value;
}

Row row_of(const std::vector<std::string>& fields, const std::string& where) {
  if (fields.size() != 3) {
    throw ConfigError(fmt::format("{}: holds {} field{}, allowed 3, separated by commas: x,y,pen",
                                  where, fields.size(), fields.size() == 1 ? "" : "s"));
  }
  return {number_of(fields[0], "x", -kFar, kFar, where),
          number_of(fields[1], "y", -kFar, kFar, where), number_of(fields[2], "pen", 0, 1, where)};
}

class Plot {
 public:
  Plot(const PlotSetup& setup, std::string source) : setup_(setup), source_(std::move(source)) {
    add(sw::LarsonOp::kCaltbl, 0, 0, 0);
  }

  void go(const Row& to, std::size_t line) {
    if (to.pen == 0) {
      velocity(setup_.move, setup_.move, line);
      piece(to.x, to.y, line);
    } else {
      draw(to, line);
    }
    const auto clipped = [this](int place) { return std::clamp(place, 0, setup_.soft_end); };
    at_ = {clipped(to.x), clipped(to.y), to.pen};
  }

  std::vector<Call> calls;

 private:
  void add(sw::LarsonOp op, int a, int b, std::size_t line) {
    Call one;
    one.call.op = op;
    one.call.a = a;
    one.call.b = b;
    one.line = line;
    one.text = name_of(op);
    if (op == sw::LarsonOp::kVeltbl || op == sw::LarsonOp::kAbstbl) {
      one.text += fmt::format(" {} {}", a, b);
    }
    if (calls.size() >= kMostCalls) {
      throw ConfigError(fmt::format("{}:{}: more than {} calls", source_, line, kMostCalls));
    }
    calls.push_back(one);
  }

  void velocity(int x, int y, std::size_t line) {
    if (x == x_rate_ && y == y_rate_) return;
    add(sw::LarsonOp::kVeltbl, x_rate_ = x, y_rate_ = y, line);
  }

  void piece(int x, int y, std::size_t line) {
    add(sw::LarsonOp::kAbstbl, x, y, line);
    add(sw::LarsonOp::kWttbl, 0, 0, line);
  }

  void draw(const Row& to, std::size_t line) {
    const int dx = to.x - at_.x, dy = to.y - at_.y;
    const int longer = std::max(std::abs(dx), std::abs(dy));
    const int pieces = std::max(1, (longer + kPiece - 1) / kPiece);
    int x = at_.x, y = at_.y;
    for (int k = 1; k <= pieces; ++k) {
      const auto part = [&](int from, int d) {
        return from + static_cast<int>(std::lround(static_cast<double>(d) * k / pieces));
      };
      const int next_x = part(at_.x, dx), next_y = part(at_.y, dy);
      const int ax = std::abs(next_x - x), ay = std::abs(next_y - y), most = std::max({1, ax, ay});
      const auto share = [&](int steps) {
        const double rate = static_cast<double>(setup_.draw) * steps / most;
        return std::max(kLeastRate, static_cast<int>(std::lround(rate)));
      };
      velocity(share(ax), share(ay), line);
      piece(next_x, next_y, line);
      x = next_x;
      y = next_y;
    }
  }

  PlotSetup setup_;
  std::string source_;
  Row at_;
  int x_rate_ = 0, y_rate_ = 0;
};

}  // namespace

std::vector<Call> parse_moves(const std::string& text, const std::string& source,
                              const PlotSetup& setup) {
  check_text(text, source);
  const std::vector<std::string> header{"x", "y", "pen"};
  Plot plot(setup, source);
  std::istringstream in{std::string(host::past_mark(text))};
  std::size_t number = 0, rows = 0;
  bool headed = false;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line = trimmed(line);
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> fields = fields_of(line);
    const std::string where = fmt::format("{}:{}", source, number);
    if (rows == 0 && !headed && is_header(fields[0])) {
      if (fields != header) {
        throw ConfigError(fmt::format(
            "{}: found {}, allowed as a header: x,y,pen; else three whole numbers", where,
            host::shown(line)));
      }
      headed = true;
      continue;
    }
    plot.go(row_of(fields, where), number);
    ++rows;
  }
  if (rows == 0) throw ConfigError(source + ": has no move");
  return plot.calls;
}

}  // namespace trammel::larson
