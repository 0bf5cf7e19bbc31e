// SPDX-License-Identifier: Apache-2.0
//
// What the verb `track` writes: the table of a path as CSV, as bytes of McAfee's listing or as
// JSON, to standard output or into a file.
#include <catch2/catch.hpp>
#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>
#include <string>

#include "machines/mcafee/machine.hpp"
#include "testbench/arguments.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/told.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

int track(const testbench::Arguments& arguments) {
  const auto& verbs = testbench::machine_verbs();
  const auto verb = std::find_if(verbs.begin(), verbs.end(),
                                 [](const testbench::Verb& one) { return one.name == "track"; });
  REQUIRE(verb != verbs.end());
  std::atomic<bool> stop{false};
  return verb->perform(arguments, stop);
}

std::string printed(const testbench::Arguments& arguments) {
  return test::printed([&] { CHECK(track(arguments) == 0); });
}

}  // namespace

TEST_CASE("track prints a table or writes it into a file, in the form that was asked for") {
  const test::Scratch scratch("mcafee_track_test_out");
  testbench::Arguments arguments;
  arguments.scenario = "mcafee-circle";
  arguments.assignments = {"path.radius_mm=5", "path.kappa_max_1_mm=0.5"};
  const std::string csv = printed(arguments);
  Options options;
  options.path.kind = PathKind::kCircle;
  options.path.radius_mm = 5;
  options.path.kappa_max_1_mm = 0.5;
  const Table table = make_table(options.path, options.count_mm());
  REQUIRE(table.rows.size() == 63);
  for (const bool listing : {false, true}) {
    const std::string wanted = listing ? listing_text(table) : table_csv(table);
    CAPTURE(listing);
    if (listing) arguments.flags.insert("--listing");
    arguments.out = "";
    CHECK(printed(arguments) == wanted);
    arguments.out = (scratch.path / (listing ? "rows.txt" : "rows.csv")).string();
    CHECK(printed(arguments) == arguments.out + ": 63 rows of 0.49867 mm\n");
    CHECK(test::content(arguments.out) == wanted);
  }
  arguments.json = true;
  CHECK(test::refusal_of([&] { track(arguments); }) == "track: --listing: not with --json");
  arguments.flags.clear();
  const auto json = nlohmann::json::parse(printed(arguments));
  CHECK(test::content(arguments.out) == csv);
  CHECK(json["row_mm"].get<double>() == Approx(table.row_mm));
  REQUIRE(json["rows"].size() == 63);
  const sw::McafeeRow& row = table.rows[10];
  CHECK(json["rows"][10] == nlohmann::json({{"c", row.c}, {"cc", row.cc}, {"vx", row.vx},
                                            {"vy", row.vy}, {"dx", row.dx}, {"dy", row.dy}}));
}

TEST_CASE("track takes mcafee-stage3 where no scenario is named") {
  testbench::Arguments arguments;
  CHECK_THAT(printed(arguments), Catch::StartsWith("c,cc,vx,vy,dx,dy\n0,0,255,0,100,0\n"));
}
