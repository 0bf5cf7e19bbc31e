// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "lab/machine.hpp"
#include "lab/record.hpp"

namespace trammel::test {

// A figure of a result, by its id.
template <class Options>
double figure(const Options& options, cosim::RunResult& result, const std::string& id) {
  const auto list = options.machine().figures(options, result);
  const lab::Figure* const found = lab::find_figure(list, id);
  INFO("figure " << id);
  REQUIRE(found != nullptr);
  return found->value;
}

inline double figure(const lab::Record& record, const std::string& id) {
  const lab::Figure* const found = lab::find_figure(record.figures, id);
  INFO("figure " << id);
  REQUIRE(found != nullptr);
  return found->value;
}

// How a figure is told, but for its value: "step.rest_mm: step, overshoot [mm] 3 {Rest}", its tile
// in braces; one that is not shown begins with "-".
inline std::string shape(const lab::Figure& f) {
  std::string text = (f.shown ? "" : "-") + f.id + ": " + f.row;
  if (!f.column.empty()) text += ", " + f.column;
  if (!f.unit.empty()) text += " [" + f.unit + "]";
  text += f.digits == lab::Figure::kWhole ? " whole" : " " + std::to_string(f.digits);
  return f.tile.empty() ? text : text + " {" + f.tile + "}";
}

// Figures in their order; tells the first that is another.
inline void check_shapes(const std::vector<lab::Figure>& figures,
                         const std::vector<std::string>& expected) {
  for (std::size_t n = 0; n < std::min(figures.size(), expected.size()); ++n) {
    INFO("figure " << n << " of the list");
    REQUIRE(shape(figures[n]) == expected[n]);
  }
  CHECK(figures.size() == expected.size());
}

// What trace.csv holds of a sample: each column of the machine, named, with its value.
template <class Options>
std::map<std::string, double> row(const Options& options, const cosim::RunResult& result,
                                  std::size_t sample) {
  const lab::ColumnTable& table = options.machine().columns();
  std::vector<double> values;
  table.read(options, result, sample, values);
  REQUIRE(values.size() == table.columns.size());
  std::map<std::string, double> all;
  for (std::size_t n = 0; n < values.size(); ++n) all[table.columns[n].name] = values[n];
  return all;
}

// Tells the column that differs.
inline void check_row(const std::map<std::string, double>& row,
                      const std::map<std::string, double>& expected) {
  for (const auto& [name, value] : row) {
    INFO("column " << name);
    REQUIRE(expected.count(name) == 1);
    CHECK(value == Approx(expected.at(name)));
  }
  CHECK(row.size() == expected.size());
}

}  // namespace trammel::test
