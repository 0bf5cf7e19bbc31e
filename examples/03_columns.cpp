// SPDX-License-Identifier: Apache-2.0
//
// Reads the record of any scenario sample by sample, by the names of its columns:
// 03_columns SCENARIO COLUMN prints a column's range; without a name, what columns there are.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/table.hpp"

using namespace trammel;

int main(int argc, char** argv) try {
  lab::take_machines(linked_machines);
  const std::string scenario = argc > 1 ? argv[1] : "circle";
  const auto settings = lab::load_scenario(lab::find_scenario(scenario));
  lab::apply_assignment(*settings, "run.max_s=0.1");
  lab::validate(*settings);
  const lab::ColumnTable& table = settings->machine().columns();
  for (const lab::Column& column : table.columns) {
    if (argc > 2) break;
    std::printf("%-18s %-24s %s\n", column.name.c_str(), column.unit.c_str(), column.help.c_str());
  }
  const auto found =
      std::find_if(table.columns.begin(), table.columns.end(),
                   [&](const lab::Column& c) { return argc > 2 && c.name == argv[2]; });
  if (found == table.columns.end()) return argc > 2 ? 2 : 0;
  const auto n = static_cast<std::size_t>(found - table.columns.begin());

  const lab::Record record = lab::run(*settings);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::vector<double> values;
  for (std::size_t k = 0; k < record.result->sample_count(); ++k) {
    table.read(*settings, *record.result, k, values);
    low = std::min(low, values[n]);
    high = std::max(high, values[n]);
  }
  std::printf("%s: %g..%g %s\n", found->name.c_str(), low, high, found->unit.c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
