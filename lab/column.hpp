// SPDX-License-Identifier: Apache-2.0
//
// What a machine records in every sample, declared once: from these columns come trace.csv, the
// series of the report page and the tables of the documentation.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cosim/run.hpp"
#include "lab/settings.hpp"

namespace trammel::lab {

// How trace.csv prints a value: as a whole number, or with digits behind the point or in all.
struct Format {
  enum class Kind { kWhole, kFixed, kGeneral } kind = Kind::kWhole;
  int digits = 0;
};
constexpr Format whole() { return {}; }
constexpr Format fixed(int digits) { return {Format::Kind::kFixed, digits}; }
constexpr Format general(int digits) { return {Format::Kind::kGeneral, digits}; }

struct Column {
  std::string name;       // in trace.csv; ends in its unit: x_position_m, t_s
  std::string unit;       // "" for a word of a chip without one
  double resolution = 1;  // [unit] of the series on the report page
  Format format;
  std::string help;
  bool compared = false;  // also on a page of several runs
  bool bits = false;      // flags: where samples are passed over, their bits are kept
};

// The columns of a run, and their values in one of its samples.
struct ColumnTable {
  std::vector<Column> columns;
  std::function<void(const Settings&, const cosim::RunResult&, std::size_t sample,
                     std::vector<double>& values)> read;
};

// Builds the table of a machine whose result holds `samples`, a sequence of its Sample.
template <class Options, class Result>
class Columns {
 public:
  using Sample = typename decltype(Result::samples)::value_type;
  struct At {
    const Options& options;
    const Result& result;
    const Sample& sample;
    std::size_t index;
  };
  using Get = std::function<double(const At&)>;

  void add(Column column, Get get) {
    columns_.push_back(std::move(column));
    getters_.push_back(std::move(get));
  }

  ColumnTable table() && {
    return {std::move(columns_),
            [getters = std::move(getters_)](const Settings& settings,
                                            const cosim::RunResult& result, std::size_t k,
                                            std::vector<double>& values) {
              const auto& own = static_cast<const Result&>(result);
              const Sample sample = own.samples[k];
              const At at{static_cast<const Options&>(settings), own, sample, k};
              values.resize(getters.size());
              for (std::size_t n = 0; n < getters.size(); ++n) values[n] = getters[n](at);
            }};
  }

 private:
  std::vector<Column> columns_;
  std::vector<Get> getters_;
};

}  // namespace trammel::lab
