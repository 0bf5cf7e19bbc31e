// SPDX-License-Identifier: Apache-2.0
#include "lab/figure.hpp"

#include <fmt/format.h>

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

// The figures of one row, first and end.
struct Row {
  List::const_iterator first, end;

  std::size_t size() const { return static_cast<std::size_t>(end - first); }
  bool like(const Row& other) const {
    return size() == other.size() &&
           std::equal(first, end, other.first, [](const Figure& a, const Figure& b) {
             return a.column == b.column && a.unit == b.unit;
           });
  }
  bool one_unit() const {
    return std::all_of(first, end, [this](const Figure& f) { return f.unit == first->unit; });
  }
};

std::vector<Row> rows_of(const List& shown) {
  std::vector<Row> rows;
  for (auto at = shown.begin(); at != shown.end();) {
    const auto end =
        std::find_if(at, shown.end(), [&](const Figure& f) { return f.row != at->row; });
    rows.push_back({at, end});
    at = end;
  }
  return rows;
}

std::string with_unit(const Figure& f) {
  return figure_text(f.value, f.digits) + (f.unit.empty() ? "" : ' ' + f.unit);
}

// "  largest speed         12.00 mm/s, desired 11.90 mm/s"
std::string line(const Row& row) {
  std::string text = fmt::format("  {:<25}", row.first->row);
  for (auto f = row.first; f != row.end; ++f) {
    text += fmt::format("{}{}{}", f == row.first ? " " : ", ",
                        f->column.empty() ? "" : f->column + ' ', with_unit(*f));
  }
  return text + '\n';
}

// Rows with the same columns, the unit in the heading where they have but one.
std::string table(const std::vector<Row>& rows) {
  const Row& head = rows.front();
  const bool one_unit = head.one_unit() && !head.first->unit.empty();
  std::string text =
      fmt::format("\n  {:<25}", one_unit ? fmt::format("({})", head.first->unit) : "");
  const auto heading = [&](const Figure& f) {
    return one_unit || f.unit.empty() ? f.column : fmt::format("{} ({})", f.column, f.unit);
  };
  const auto width = [&](const Figure& f) {
    std::size_t most = heading(f).size();
    for (const Row& row : rows) {
      const auto& same = *(row.first + (&f - &*head.first));
      most = std::max(most, figure_text(same.value, same.digits).size());
    }
    return most;
  };
  for (auto f = head.first; f != head.end; ++f) {
    text += fmt::format("  {:>{}}", heading(*f), width(*f));
  }
  text += '\n';
  for (const Row& row : rows) {
    text += fmt::format("  {:<25}", row.first->row);
    for (auto f = head.first; f != head.end; ++f) {
      const Figure& same = *(row.first + (f - head.first));
      text += fmt::format("  {:>{}}", figure_text(same.value, same.digits), width(*f));
    }
    text += '\n';
  }
  return text;
}

// Ours beside what the source prints and what is expected.
std::string comparison(const List& figures) {
  std::string text;
  std::string sources;
  for (const Figure& f : figures) {
    if (!f.printed && !f.expected) continue;
    if (text.empty()) {
      text = fmt::format("\n  {:<42} {:>8} {:>8} {:>9}\n", "", "ours", "printed", "expected");
    }
    const std::string name = f.unit.empty() ? f.name() : fmt::format("{} ({})", f.name(), f.unit);
    text += fmt::format("  {:<42} {:>8} {:>8} {:>9}{}\n", name, figure_text(f.value, 2),
                        figure_text(f.printed, 2), figure_text(f.expected, 2),
                        f.good() ? "" : "  outside its tolerance");
    if (!f.source.empty() && sources.find(f.source) == std::string::npos) {
      sources += (sources.empty() ? "" : "; ") + f.source;
    }
  }
  if (!sources.empty()) text += fmt::format("  {}\n", sources);
  return text;
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
  List shown;
  std::copy_if(figures.begin(), figures.end(), std::back_inserter(shown),
               [](const Figure& f) { return f.shown; });
  const std::vector<Row> rows = rows_of(shown);
  std::string text;
  bool after_table = false;
  for (auto at = rows.begin(); at != rows.end();) {
    const auto end = std::find_if(at, rows.end(), [&](const Row& row) { return !row.like(*at); });
    if (at->size() >= kTable && end - at > 1) {
      text += table({at, end});
      after_table = true;
    } else {
      if (after_table) text += '\n';
      after_table = false;
      for (auto row = at; row != end; ++row) text += line(*row);
    }
    at = end;
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
