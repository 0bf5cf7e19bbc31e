// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
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

// All that a record says: verdict, figures, remarks, metrics.
inline std::string record_text(const lab::Record& record) {
  const lab::Machine& machine = record.settings->machine();
  std::string all = record.verdict;
  for (const lab::Figure& f : record.figures) all += fmt::format(" {}={}", f.id, f.value);
  for (const std::string& line : machine.texts.remarks(record)) all += line;
  nlohmann::ordered_json json;
  machine.files.metrics(record, json);
  return all + json.dump();
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
