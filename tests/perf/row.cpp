// SPDX-License-Identifier: Apache-2.0
#include "tests/perf/row.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "testbench/config.hpp"

namespace trammel::perf {

Arguments read_arguments(int argc, char** argv) {
  if (argc < 2) throw testbench::ConfigError("which row?");
  Arguments arguments;
  arguments.row = argv[1];
  testbench::apply_file(arguments.options, testbench::find_scenario("circle"));
  for (int i = 2; i < argc; ++i) {
    const std::string text = argv[i];
    if (text.rfind("pins=", 0) == 0) {
      arguments.pins = text.substr(5);
    } else {
      testbench::apply_assignment(arguments.options, text);
    }
  }
  testbench::finish(arguments.options);
  return arguments;
}

int report(int argc, char** argv, const std::function<Outcome(const Arguments&)>& run) {
  try {
    const Arguments arguments = read_arguments(argc, argv);
    const auto start = std::chrono::steady_clock::now();
    const double user = user_s();
    const Outcome outcome = run(arguments);
    const double used = user_s() - user;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    fmt::print("{{\"clocks\": {}, \"evaluated\": {}, \"event_hash\": \"{:016x}\", "
               "\"wall_s\": {:.6f}, \"user_s\": {:.6f}}}\n",
               outcome.clocks, outcome.evaluated, outcome.event_hash, wall.count(), used);
    return 0;
  } catch (const testbench::ConfigError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

}  // namespace trammel::perf
