// SPDX-License-Identifier: Apache-2.0
//
// Paths from files: programs in G-code, and points as lines.
#include "machines/kung/options.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/path_files.hpp"
#include "machines/kung/run/make_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "tests/support/message.hpp"
#include "tests/support/moves_check.hpp"
#include "tests/support/random_gcode.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;
using ideal::Move;
using kung::Options;

namespace {

struct Files : test::Scratch {
  test::WorkingFolder here{path};

  Files() : test::Scratch("path_files_test") {}

  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    return name;
  }
};

const std::string kGcode = "[path]\nkind = 'gcode'\nprofile = 'feed'\ngcode_file = 'a.ngc'\n";
const std::string kPoints = "[path]\nkind = 'points'\npoints_file = 'a.csv'\n";

std::string message_of(const std::string& toml) { return test::message_of<Options>(toml); }

Options valid(const std::string& toml) {
  Options options;
  lab::apply_text(options, toml, "some.toml", ".");
  lab::validate(options);
  return options;
}

}  // namespace

TEST_CASE("a mistake in a program is told with file and line, one in its keys with the key") {
  const Files files;
  files.put("a.ngc", "G0 X10\nG1 X20\n");
  const std::string folder = files.path.string();
  CHECK_THAT(message_of(kGcode), StartsWith(folder) && EndsWith("a.ngc:2: no F yet"));
  files.put("a.ngc", "G0 X10 Y601\n");
  CHECK_THAT(message_of(kGcode),
             EndsWith("a.ngc:1: the point leaves the stroke: Y = 601 mm; permitted: 0..600 mm"));
  files.put("a.ngc", "G0 X10\n");
  CHECK(message_of(kGcode).empty());
  CHECK(message_of("[path]\nkind = 'gcode'\nprofile = 'feed'\n") ==
        "path.gcode_file: is needed with path.kind = \"gcode\"");
  CHECK(message_of("[path]\nkind = 'gcode'\ngcode_file = 'a.ngc'\n").empty());
  CHECK(message_of("[path]\nkind = 'gcode'\ngcode_file = 'a.ngc'\nprofile = 'constant'\n") ==
        "path.kind: \"gcode\" needs path.profile = \"feed\"");
  CHECK_THAT(message_of("[path]\nkind = 'gcode'\nprofile = 'feed'\ngcode_file = 'none.ngc'\n"),
             Contains("path.gcode_file: ") && Contains("none.ngc: cannot be read: No such file"));
  CHECK_THAT(message_of("[path]\nkind = 'gcode'\nprofile = 'feed'\ngcode_file = '.'\n"),
             Contains("path.gcode_file: ") && Contains("cannot be read: it is a folder"));
  CHECK_THAT(message_of(kGcode + "start_x_m = 0.7\n"), Contains("path.start_x_m"));
}

TEST_CASE("a program stays in the stroke of the chip and within the hard stops") {
  const Files files;
  files.put("a.ngc", "G0 X250\nG0 Y290\n");
  const auto told = [](const std::string& more) { return message_of(kGcode + more); };
  CHECK(told("") == "");
  CHECK_THAT(told("[chip]\ny.stroke_max_m = 0.28\n"), Contains("Y = 290 mm; permitted: 0..280 mm"));
  CHECK_THAT(told("[plant]\ny.stroke_max_m = 0.28\n"),
             Contains("Y = 290 mm; permitted: 0..280 mm"));
  CHECK(told("[plant]\nhard_stops = false\ny.stroke_max_m = 0.28\n") == "");
  CHECK(told("[chip]\nx.stroke_min_m = 0.3\n") ==
        "path.start_x_m: value 0.25 is out of range 0.3..0.6 (chip.x.stroke_min_m)");
  CHECK(told("start_y_m = 0.4\n[plant]\ny.stroke_max_m = 0.3\n") ==
        "path.start_y_m: value 0.4 is out of range 0..0.3 (plant.y.stroke_max_m)");
  CHECK(told("home_y_m = 0.1\n[chip]\ny.stroke_min_m = 0.2\n") ==
        "path.home_y_m: value 0.1 is out of range 0.2..0.6 (chip.y.stroke_min_m)");
}

TEST_CASE("keys of a path place a program, limit its feed and choose its corners") {
  const Files files;
  files.put("a.ngc", "G0 X100\nG28\nG1 X120 F90000\nG64 X130\nZ1\n");
  const Options options = valid(kGcode +
                                "start_x_m = 0.2\nstart_y_m = 0.3\nhome_x_m = 0.4\nhome_y_m = "
                                "0.5\nrapid_m_s = 0.6\nfeed_max_m_s = 0.8\ncorner = 'stop'\n");
  const auto plan = kung::plan_of(options);
  const ideal::Moves& moves = plan->moves();
  CHECK(moves.start.x == 0.2);
  CHECK(moves.start.y == 0.3);
  REQUIRE(moves.moves.size() == 4);
  CHECK(moves.moves[0].feed == 0.6);
  CHECK(moves.moves[1].to.x == 0.4);
  CHECK(moves.moves[1].to.y == 0.5);
  CHECK(moves.moves[2].feed == 0.8);
  CHECK(moves.moves[2].exact);
  CHECK_FALSE(moves.moves[3].exact);
  const std::vector<std::string> warnings = kung::machine().texts.warnings(options);
  const auto is_told = [&](const std::string& text) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
      return warning.find(text) != std::string::npos;
    });
  };
  CHECK(is_told("a.ngc:3: F = 90000 is lowered to 48000 mm/min, path.feed_max_m_s"));
  CHECK(is_told("a.ngc: ignored: Z (line 5)"));
}

TEST_CASE("points are lines that are followed, if they are asked to be") {
  const Files files;
  files.put("a.csv", "100,200\n120,200\n120,200\n120,230\n");
  const std::string feed = "profile = 'feed'\npoints_mode = 'path'\n";
  CHECK(message_of(kPoints + "points_mode = 'path'\nprofile = 'constant'\n") ==
        "path.points_mode: \"path\" needs path.profile = \"feed\"");
  CHECK(kung::feeds(valid(kPoints + "points_mode = 'path'\n")));
  CHECK(message_of(kPoints + "profile = 'feed'\n").empty());
  CHECK_FALSE(kung::feeds(valid(kPoints + "profile = 'feed'\n")));
  Options options = valid(kPoints + feed);
  CHECK(kung::feeds(options));
  ideal::Moves moves = kung::plan_of(options)->moves();
  REQUIRE(moves.moves.size() == 2);
  CHECK(moves.start.y == 0.2);
  CHECK(moves.moves[1].to.y == 0.23);
  CHECK(moves.moves[0].feed == 0.3);
  CHECK_FALSE(moves.moves[0].exact);
  moves = kung::plan_of(valid(kPoints + feed + "corner = 'stop'\nfeed_m_s = 0.2\n"))->moves();
  CHECK(moves.moves[0].exact);
  CHECK(moves.moves[0].feed == 0.2);
  files.put("a.csv", "100,200\n");
  CHECK_THAT(message_of(kPoints + feed), Contains("path.points_file: ") &&
                                             Contains("a.csv: a path needs 2 points that differ"));
}

TEST_CASE("rows in their own times that jump are told with the first one") {
  const Files files;
  const std::string precise = "controller = 'precision'\n" + kPoints;
  const auto told = [](const std::string& toml) {
    const std::vector<std::string> all = kung::plan_of(valid(toml))->file.warnings;
    return all.empty() ? "" : all.size() == 1 ? all[0] : "more than one";
  };
  std::string table = "x_mm,y_mm\n# from rest with 4 m/s^2\n";
  for (int k = 0; k < 40; ++k) table += fmt::format("{},{}\n", 100, 200 + 0.008 * k * k);
  files.put("a.csv", table);
  CHECK(told(kPoints).empty());
  CHECK_THAT(told(precise), Contains("a.csv:42: 0.308 m/s that the speed of Y changes by in 2 ms "
                                     "are 154 m/s^2; path.y.accel_m_s2 = 8"));  // its end
  files.put("a.csv", "100,200\n100,200\n300,200\n300,300\n300,300\n300,300\n");
  CHECK_THAT(told(kPoints), StartsWith(files.path.string()) &&
                                EndsWith("a.csv:3: 200 mm of X since the row before, in 2 ms, are "
                                         "100 m/s; feed at most 1.28 m/s at "
                                         "plant.encoder_count_m = 5e-06; 1 row more like it"));
  CHECK(told(precise) == told(kPoints));
  CHECK(told(kPoints + "points_mode = 'path'\n").empty());
  files.put("a.csv", "100,200\n100.1,200\n100.2,200\n");  // 0.05 m/s at once
  CHECK(told(kPoints).empty());
  CHECK_THAT(told(precise), Contains("a.csv:1: 0.05 m/s that the speed of X changes by in 2 ms are "
                                     "25 m/s^2; path.x.accel_m_s2 = 8; 1 row more like it"));
  CHECK(told(precise + "x.accel_m_s2 = 26\n").empty());
}

TEST_CASE("a program repeats if it ends where it begins") {
  const Files files;
  files.put("a.ngc", "G0 X260\nG0 X250\n");
  CHECK(message_of(kGcode + "repeats = 3\n").empty());
  files.put("a.ngc", "G0 X260\n");
  CHECK_THAT(message_of(kGcode + "repeats = 3\n"), Contains("path.repeats: value 3 must be 1"));
}

TEST_CASE("the smallest and largest arcs and steps of a program are those of the firmware") {
  const Files files;
  for (const std::string text :
       {"G3 I.0051 F600", "G3 I.004", "G91\nG3 X.01 Y.01 R.0075\nG2 X-.01 R.006",
        "G3 X300 R4990 F6000", "G3 X300 R5000", "G3 X300.0004 I25.01 J4900", "G1 X250.00008",
        "G1 X250.00007\nX251", "G3 X250.02 I.005\nX251", "G3 X250.0006 R.005"}) {
    CAPTURE(text);
    files.put("a.ngc", "F600\n" + text + "\n");
    const std::string told = message_of(kGcode);
    CHECK((told.empty() || told.find("a.ngc:") != std::string::npos));
  }
}

TEST_CASE("random programs are planned, however they are") {
  const Files files;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    files.put("a.ngc", test::RandomGcode(seed, 60).text);
    CHECK(message_of(kGcode).empty());
  }
}

TEST_CASE("the built-in part has what a part has, in 200 x 200 mm around the middle") {
  const auto settings = lab::load_scenario(lab::find_scenario("part"));
  lab::validate(*settings);
  const auto& options = static_cast<const Options&>(*settings);
  const auto plan = kung::plan_of(options);
  const ideal::Moves& moves = plan->moves();
  CHECK(test::moves_problem(moves, {0.15, 0.15}, {0.35, 0.35}).empty());
  const std::vector<Move>& all = moves.moves;
  const auto count = [&](auto is) { return std::count_if(all.begin(), all.end(), is); };
  const auto arc = [](const Move& m) { return m.kind == Move::Kind::kArc; };
  CHECK(all.size() >= 40);
  CHECK(count(arc) >= 20);
  CHECK(count([&](const Move& m) { return arc(m) && m.sweep < 0; }) >= 4);
  CHECK(count([&](const Move& m) { return arc(m) && std::abs(m.sweep) > 6.28; }) == 5);
  CHECK(count([](const Move& m) { return m.dwell > 0; }) >= 1);
  CHECK(count([](const Move& m) { return m.exact && !m.stop; }) >= 6);
  CHECK(count([](const Move& m) { return std::abs(m.length() - 0.5e-3) < 2e-6; }) >= 100);
  double smallest = 1, largest = 0;
  for (const Move& m : all) {
    if (!arc(m)) continue;
    smallest = std::min(smallest, m.radius());
    largest = std::max(largest, m.radius());
  }
  CHECK(smallest == Approx(1e-3));
  CHECK(largest == Approx(50e-3));
  CHECK(kung::machine().texts.warnings(options).empty());
}
