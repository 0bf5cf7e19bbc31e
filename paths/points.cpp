// SPDX-License-Identifier: Apache-2.0
#include "paths/points.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <istream>
#include <locale>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "host/input_file.hpp"
#include "paths/gcode.hpp"

namespace trammel::paths {
namespace {

std::string trimmed(const std::string& s) {
  const auto begin = s.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return s.substr(begin, s.find_last_not_of(" \t\r") - begin + 1);
}

std::optional<double> number(const std::string& field) {
  std::istringstream text(trimmed(field));
  text.imbue(std::locale::classic());
  double value = 0;
  if (!(text >> value) || text.peek() != std::istringstream::traits_type::eof()) return {};
  return value;
}

// The begin of a line, which may be anything: whoever tells it sees to what a terminal can show.
std::string shown(const std::string& line) {
  constexpr std::size_t kMost = 60;  // [bytes]
  if (line.size() <= kMost) return line;
  std::size_t end = kMost;  // no character of UTF-8 is cut
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0u) == 0x80) --end;
  return line.substr(0, end) + "...";
}

[[noreturn]] void refuse(const std::string& name, int line, const std::string& what) {
  throw std::invalid_argument(name + ":" + std::to_string(line) + ": " + what);
}

double checked(const std::string& name, int line, const char* column, double mm,
               const PointRange& range) {
  if (mm >= range.low_mm && mm <= range.high_mm) return mm * 1e-3;
  std::ostringstream text;
  text << column << " = " << mm << " is out of range " << range.low_mm << ".." << range.high_mm
       << " mm";
  refuse(name, line, text.str());
}

// A header may name its columns as it likes, but not the other way round, nor in another unit.
void check_header(const std::string& name, int line_number, const std::string& line) {
  std::string names;
  for (const char c : line) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ',') {
      names += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  const auto comma = names.find(',');
  const std::string x = names.substr(0, comma), y = names.substr(comma + 1);
  const auto other_unit = [](const std::string& column, char axis) {
    constexpr std::array<const char*, 5> kUnits{"m", "cm", "um", "in", "inch"};
    return std::any_of(kUnits.begin(), kUnits.end(),
                       [&](const char* unit) { return column == axis + std::string(unit); });
  };
  if (x.rfind('y', 0) == 0 || y.rfind('x', 0) == 0 || other_unit(x, 'x') || other_unit(y, 'y')) {
    refuse(name, line_number, "expected the columns x_mm,y_mm, found '" + shown(line) + "'");
  }
}

// Spreadsheets mark the encoding in the first bytes.
std::string without_mark(const std::string& line, const std::string& name) {
  if (line.rfind("\xFF\xFE", 0) == 0 || line.rfind("\xFE\xFF", 0) == 0) {
    refuse(name, 1, "UTF-16 text; save it as UTF-8 or ASCII");
  }
  return std::string(host::past_mark(line));
}

}  // namespace

std::vector<PointM> read_points_csv(std::istream& text, const std::string& name,
                                    const PointRange& range, std::vector<int>* lines) {
  std::vector<PointM> points;
  if (lines != nullptr) lines->clear();
  bool header_allowed = true;
  int line_number = 0;
  for (std::string line; std::getline(text, line);) {
    ++line_number;
    if (line_number == 1) line = without_mark(line, name);
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    const auto comma = line.find(',');
    const auto x = number(line.substr(0, comma));
    const auto y = comma == std::string::npos ? std::nullopt : number(line.substr(comma + 1));
    if (!x && !y && comma != std::string::npos && header_allowed) {
      header_allowed = false;
      check_header(name, line_number, line);
      continue;
    }
    header_allowed = false;
    if (!x || !y) {
      refuse(name, line_number, "expected two numbers x_mm,y_mm, found '" + shown(line) + "'");
    }
    points.push_back({checked(name, line_number, "x_mm", *x, range),
                      checked(name, line_number, "y_mm", *y, range)});
    if (lines != nullptr) lines->push_back(line_number);
  }
  if (points.empty()) {
    std::ostringstream what;
    what << "no points; expected lines x_mm,y_mm with values " << range.low_mm << ".."
         << range.high_mm << " mm";
    refuse(name, line_number, what.str());
  }
  return points;
}

ideal::Moves lines_through(const std::vector<PointM>& points, const std::string& name,
                           double feed_m_s, bool exact) {
  constexpr double kShortest = 1e-9;  // [m]
  ideal::Moves all;
  ideal::Move line;
  line.feed = feed_m_s;
  line.exact = exact;
  for (const PointM& point : points) {
    line.to = {point.x_m, point.y_m};
    if (&point == &points.front()) all.start = line.from = line.to;
    if (line.length() < kShortest) continue;
    all.moves.push_back(line);
    line.from = line.to;
  }
  if (all.moves.empty()) throw std::invalid_argument(name + ": a path needs 2 points that differ");
  if (all.moves.size() > kMostMoves) {
    throw std::invalid_argument(name + ": " + std::to_string(all.moves.size()) +
                                " lines; permitted: " + std::to_string(kMostMoves));
  }
  return all;
}

std::vector<PointM> read_points_csv(const std::string& file, const PointRange& range,
                                    std::vector<int>* lines) {
  constexpr std::uintmax_t kMost = 16 * host::kMiB;
  std::istringstream text(host::read_file(file, kMost));
  return read_points_csv(text, file, range, lines);
}

}  // namespace trammel::paths
