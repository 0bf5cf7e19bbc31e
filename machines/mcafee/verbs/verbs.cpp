// SPDX-License-Identifier: Apache-2.0
//
// The verb `track`: the table of a path, as CSV to standard output or into a file.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/output_folder.hpp"
#include "host/text.hpp"
#include "lab/scenarios.hpp"
#include "machines/mcafee/machine_members.hpp"
#include "testbench/run.hpp"

namespace trammel::mcafee {
namespace {

nlohmann::ordered_json table_json(const Table& table) {
  auto rows = nlohmann::ordered_json::array();
  for (const sw::McafeeRow& row : table.rows) {
    rows.push_back({{"c", row.c}, {"cc", row.cc}, {"vx", row.vx}, {"vy", row.vy},
                    {"dx", row.dx}, {"dy", row.dy}});
  }
  return {{"row_mm", table.row_mm}, {"rows", rows}};
}

int track(const testbench::Arguments& arguments, std::atomic<bool>&) {
  const bool listing = arguments.flags.count("--listing") > 0;
  const std::string name = arguments.scenario.empty() ? "mcafee-stage3" : arguments.scenario;
  if (!arguments.out.empty()) host::check_result_file(arguments.out);
  const auto file = lab::find_scenario(name);
  if (&lab::machine_of(file) != &machine()) {
    throw host::ConfigError(fmt::format("track: {} is a scenario of the machine {}, not of {}",
                                        host::shown(name), lab::machine_of(file).name,
                                        machine().name));
  }
  if (listing && arguments.json) throw host::ConfigError("track: --listing: not with --json");
  const auto settings = testbench::layered(file, arguments);
  const Table table = table_of(static_cast<const Options&>(*settings));
  testbench::tell_warnings("track", table.warnings);
  const std::string text = listing ? listing_text(table) : table_csv(table);
  if (!arguments.out.empty()) host::write_result_file(arguments.out, text);
  if (arguments.json) {
    testbench::print_json(table_json(table));
  } else if (arguments.out.empty()) {
    testbench::print(text);
  } else {
    testbench::print(fmt::format("{}: {} rows of {:.5f} mm\n", arguments.out, table.rows.size(),
                                 table.row_mm));
  }
  return 0;
}

}  // namespace

std::vector<testbench::Verb> verbs() {
  testbench::Verb verb;
  verb.name = "track";
  verb.help = "write the table of a path of the machine mcafee, as CSV";
  verb.argument = "scenario";
  verb.argument_help = "scenario that has the path, default mcafee-stage3";
  verb.out_help = "file of the table; default: standard output";
  verb.flags = {
      {"--listing", "rows as bytes in the order of McAfee's listing: C CC Vx Vy dY dX"}};
  verb.perform = track;
  return {verb};
}

}  // namespace trammel::mcafee
