// SPDX-License-Identifier: Apache-2.0
//
// Runs a built-in scenario and prints the figures it is judged by.
#include <cstdio>
#include <exception>

#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/table.hpp"

using namespace trammel;

int main() try {
  lab::take_machines(linked_machines);
  const auto settings = lab::load_scenario(lab::find_scenario("circle"));
  lab::apply_assignment(*settings, "run.engine=twin");  // leave it out for the verilated RTL
  lab::validate(*settings);

  const lab::Record record = lab::run(*settings);
  std::printf("%s: %s\n", settings->scenario.c_str(), record.verdict.c_str());
  for (const lab::Figure& figure : record.figures) {
    if (figure.tile.empty()) continue;
    std::printf("%-22s %9.3f %s\n", figure.tile.c_str(), figure.value, figure.unit.c_str());
  }
  for (const std::string& line : lab::outside(record.figures)) std::printf("%s\n", line.c_str());
  return lab::exit_code(record.result->end);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
