// SPDX-License-Identifier: Apache-2.0
#include "lab/figure.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace trammel::lab {
namespace {

using Json = nlohmann::ordered_json;
using List = std::vector<Figure>;

constexpr std::size_t kTable = 3;  // columns from which on rows make a table

Json number(const Figure& f) {
  if (f.digits == Figure::kWhole) return static_cast<std::int64_t>(std::llround(f.value));
  return f.value;
}

Json::json_pointer place(const std::string& id) {
  std::string path = '/' + id;
  std::replace(path.begin(), path.end(), '.', '/');
  return Json::json_pointer(path);
}

using Rows = std::vector<List>;  // figures of one row each

Rows rows_of(const List& figures) {
  Rows rows;
  for (const Figure& f : figures) {
    if (!f.shown) continue;
    if (rows.empty() || rows.back().front().row != f.row) rows.emplace_back();
    rows.back().push_back(f);
  }
  return rows;
}

bool same_columns(const List& a, const List& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Figure& x, const Figure& y) {
    return x.column == y.column && x.unit == y.unit;
  });
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

// "  largest speed         12.00 mm/s, desired 11.90 mm/s"
std::string line(const List& row) {
  std::string text = fmt::format("  {:<25}", row.front().row);
  for (const Figure& f : row) {
    text += fmt::format("{}{}{}{}", &f == &row.front() ? " " : ", ",
                        f.column.empty() ? "" : f.column + ' ', figure_text(f.value, f.digits),
                        f.unit.empty() ? "" : ' ' + f.unit);
  }
  return text + '\n';
}

// Lines of cells, the first of each `first` wide, the others set to the right in their columns.
std::string aligned(const std::vector<std::vector<std::string>>& lines, std::size_t first) {
  std::string text;
  for (const auto& cells : lines) {
    text += fmt::format("  {:<{}}", cells.front(), first);
    for (std::size_t n = 1; n < cells.size(); ++n) {
      std::size_t width = 0;
      for (const auto& other : lines) width = std::max(width, other[n].size());
      text += fmt::format("  {:>{}}", cells[n], width);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

// Rows with the same columns, the unit in the heading where they have but one.
std::string table(Rows::const_iterator begin, Rows::const_iterator end) {
  const std::string& unit = begin->front().unit;
  const bool one_unit = std::all_of(begin->begin(), begin->end(),
                                    [&](const Figure& f) { return f.unit == unit; });
  std::vector<std::vector<std::string>> lines{
      {one_unit && !unit.empty() ? fmt::format("({})", unit) : ""}};
  for (const Figure& f : *begin) {
    lines.front().push_back(one_unit ? f.column : with_unit(f.column, f.unit));
  }
  for (auto row = begin; row != end; ++row) {
    lines.push_back({row->front().row});
    for (const Figure& f : *row) lines.back().push_back(figure_text(f.value, f.digits));
  }
  return '\n' + aligned(lines, 25);
}

// Ours beside what the source prints and what is expected.
std::string comparison(const List& figures) {
  std::vector<std::vector<std::string>> lines{{"", "ours", "printed", "expected", ""}};
  std::string sources;
  for (const Figure& f : figures) {
    if (!f.printed && !f.expected) continue;
    lines.push_back({with_unit(f.name(), f.unit), figure_text(f.value, 2),
                     figure_text(f.printed, 2), figure_text(f.expected, 2),
                     f.good() ? "" : "outside its tolerance"});
    if (!f.source.empty() && sources.find(f.source) == std::string::npos) {
      sources += (sources.empty() ? "  " : "; ") + f.source;
    }
  }
  if (lines.size() == 1) return "";
  return '\n' + aligned(lines, 42) + sources + (sources.empty() ? "" : "\n");
}

}  // namespace

std::string Figure::name() const {
  if (column.empty()) return row;
  const bool number = std::all_of(column.begin(), column.end(),
                                  [](unsigned char c) { return std::isdigit(c) != 0; });
  return row + (number ? " " : ", ") + column;  // "period 3"
}

bool Figure::good() const { return !expected || std::abs(value - *expected) <= tolerance; }

Figure figure(std::string id, std::string row, std::string column, double value, std::string unit,
              int digits) {
  Figure f;
  f.id = std::move(id);
  f.row = std::move(row);
  f.column = std::move(column);
  f.value = value;
  f.unit = std::move(unit);
  f.digits = digits;
  return f;
}

Figure count(std::string id, std::string row, std::string column, double value,
             std::string unit) {
  return figure(std::move(id), std::move(row), std::move(column), value, std::move(unit),
                Figure::kWhole);
}

const Figure* find_figure(const List& figures, std::string_view id) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const Figure& f) { return f.id == id; });
  return found != figures.end() ? &*found : nullptr;
}

void put_figures(Json& json, const List& figures) {
  for (const Figure& f : figures) json[place(f.id)] = number(f);
  Json all = Json::array();
  for (const Figure& f : figures) {
    Json one{{"id", f.id}, {"name", f.name()}, {"value", number(f)}, {"unit", f.unit}};
    if (!f.column.empty()) one["column"] = f.column;
    if (f.digits != Figure::kWhole) one["digits"] = f.digits;
    if (f.printed) one["printed"] = *f.printed;
    if (f.expected) {
      one["expected"] = *f.expected;
      one["tolerance"] = f.tolerance;
      one["within"] = f.good();
    }
    if (!f.source.empty()) one["source"] = f.source;
    if (!f.tile.empty()) one["tile"] = f.tile;
    if (!f.shown) one["shown"] = false;
    all.push_back(one);
  }
  json["figures"] = all;
}

std::string figure_text(const std::optional<double>& value, int digits) {
  if (!value) return "-";
  return digits == Figure::kWhole ? fmt::format("{}", std::llround(*value))
                                  : fmt::format("{:.{}f}", *value, digits);
}

std::string figures_text(const List& figures) {
  const Rows rows = rows_of(figures);
  std::string text;
  bool after_table = false;
  for (auto at = rows.begin(); at != rows.end();) {
    const auto end = std::find_if(
        at, rows.end(), [&](const List& row) { return !same_columns(row, *at); });
    const bool is_table = at->size() >= kTable && end - at > 1;
    if (after_table && !is_table) text += '\n';
    after_table = is_table;
    if (is_table) text += table(at, end);
    for (; at != end; ++at) {
      if (!is_table) text += line(*at);
    }
  }
  return text + comparison(figures);
}

std::vector<std::string> outside(const List& figures) {
  std::vector<std::string> lines;
  for (const Figure& f : figures) {
    if (f.good()) continue;
    lines.push_back(fmt::format("{} {:.3f} {} is outside {:.3f} +- {:.3f}", f.name(), f.value,
                                f.unit, *f.expected, f.tolerance));
  }
  return lines;
}

bool any_expected(const List& figures) {
  return std::any_of(figures.begin(), figures.end(),
                     [](const Figure& f) { return f.expected.has_value(); });
}

}  // namespace trammel::lab
