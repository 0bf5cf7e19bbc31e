// SPDX-License-Identifier: Apache-2.0
//
// Scripts and lists of moves: what they become, and what is said of those that cannot be.
#include "machines/larson/script.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <string>
#include <vector>

#include "lab/errors.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using larson::Call;
using sw::LarsonOp;

namespace {

constexpr std::int64_t kClockPs = 20'000;

std::vector<Call> script(const std::string& text) {
  return larson::parse_script(text, "s.table", kClockPs);
}

std::string refused(const std::string& text) {
  try {
    script(text);
  } catch (const lab::ConfigError& error) {
    return error.what();
  }
  return "";
}

std::string refused_moves(const std::string& text) {
  try {
    larson::parse_moves(text, "m.csv", {});
  } catch (const lab::ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a script is its calls, in any case, with comments") {
  const std::vector<Call> calls =
      script("# begin\ncaltbl\nVelTbl 400 59  # slow\nABSTBL -5 100\nwait 3\nMOV xstatus 036650\n");
  REQUIRE(calls.size() == 5);
  CHECK(calls[0].call.op == LarsonOp::kCaltbl);
  CHECK(calls[1].call.a == 400);
  CHECK(calls[1].call.b == 59);
  CHECK(calls[2].call.a == -5);
  CHECK(calls[3].call.a == 150'000);
  CHECK(calls[4].call.a == 1);
  CHECK(calls[4].call.b == 036650);
  CHECK(calls[4].line == 6);
  CHECK(calls[4].text == "MOV XSTATUS 036650");
}

TEST_CASE("blocks repeat, also in each other") {
  const std::vector<Call> calls =
      script("REPEAT 3\nRELTBL 1 0\nREPEAT 2\nWTTBL\nEND\nEND\nWHRTBL\n");
  CHECK(calls.size() == 3 * 3 + 1);
  CHECK(calls[4].call.op == LarsonOp::kWttbl);
}

TEST_CASE("a script that cannot be says file, line, what and what is permitted") {
  CHECK(refused("CALTBL\nABSTB 1 2\n") == "s.table:2: ABSTB is not a call; did you mean ABSTBL?");
  CHECK(refused("ABSTBL 1\n") == "s.table:1: ABSTBL takes x and y: 2 values, not 1");
  CHECK(refused("ABSTBL 1 2x\n") ==
        "s.table:1: ABSTBL y: 2x is not a number -100000..100000");
  CHECK(refused("VELTBL 58 100\n") ==
        "s.table:1: VELTBL x: 58 is out of range, allowed 59..4000");
  CHECK(refused("WAIT 0\n") == "s.table:1: WAIT: 0 is out of range, allowed 1..40000");
  CHECK(refused("MOV XCOUNT 8\n") ==
        "s.table:1: MOV XCOUNT: 8 is not a number 000000..177777, octal");
  CHECK(refused("BIS ZCOUNT 1\n") ==
        "s.table:1: BIS: ZCOUNT is not one of XCOUNT, XSTATUS, YCOUNT, YSTATUS");
  CHECK(refused("\nREPEAT 2\nWTTBL\n") == "s.table:2: REPEAT without an END");
  CHECK(refused("END\n") == "s.table:1: END without a REPEAT");
  CHECK(refused("REPEAT 0\nEND\n") ==
        "s.table:1: REPEAT: 0 is out of range, allowed 1..100000");
  CHECK(refused("WTTBL now\n") == "s.table:1: WTTBL takes nothing: 0 values, not 1");
  CHECK(refused("REPEAT 100000\nREPEAT 3\nWTTBL\nEND\nEND\n") ==
        "s.table:1: more than 200000 calls");
  std::string deep;
  for (int k = 0; k < 16; ++k) deep += "REPEAT 1\n";
  std::string ends = "WTTBL\n";
  for (int k = 0; k < 16; ++k) ends += "END\n";
  CHECK(script(deep + ends).size() == 1);
  CHECK(refused(deep + "REPEAT 1\n" + ends) ==
        "s.table:17: more than 16 REPEAT in each other");
  CHECK(refused("# nothing\n") == "s.table: has no call");
}

TEST_CASE("a list of moves calibrates, goes with the pen up and draws lines in pieces") {
  const std::vector<Call> calls =
      larson::parse_moves("x,y,pen\n100,0,0\n# a line\n220,60,1\n", "m.csv", {2000, 500});
  REQUIRE(calls.size() == 1 + 3 + 1 + 3 * 2);
  CHECK(calls[0].call.op == LarsonOp::kCaltbl);
  CHECK(calls[1].call.a == 2000);
  CHECK(calls[2].call.a == 100);
  CHECK(calls[4].call.op == LarsonOp::kVeltbl);  // both axes arrive together
  CHECK(calls[4].call.a == 500);
  CHECK(calls[4].call.b == 250);
  CHECK(calls[5].call.a == 140);
  CHECK(calls[5].call.b == 20);
  CHECK(calls.back().call.op == LarsonOp::kWttbl);
  CHECK(calls[calls.size() - 2].call.a == 220);
  CHECK(calls[calls.size() - 2].call.b == 60);
}

TEST_CASE("a file is a list of moves by its extension, in any case, else a script") {
  const test::Scratch scratch("larson_script");
  for (const char* const name : {"u.CSV", "u.csv", "u.Csv"}) {
    const std::string file = (scratch.path / name).string();
    std::ofstream(file) << "1,2,0\n";
    const std::vector<Call> calls = larson::read_calls(file, {}, kClockPs);
    REQUIRE(calls.size() == 4);
    CHECK(calls[2].call.op == LarsonOp::kAbstbl);
  }
  for (const char* const name : {"csv", "u.TABLE", "csv.table"}) {
    const std::string file = (scratch.path / name).string();
    std::ofstream(file) << "WHRTBL\n";
    REQUIRE(larson::read_calls(file, {}, kClockPs).size() == 1);
  }
  CHECK_THROWS_WITH(larson::read_calls("nowhere.CSV", {}, kClockPs),
                    Catch::Contains("nowhere.CSV"));
}

TEST_CASE("a line along one axis gives the other the least rate, not none") {
  for (const char* const text : {"0,100,1\n", "100,0,1\n"}) {
    for (const Call& one : larson::parse_moves(text, "m.csv", {2000, 500})) {
      if (one.call.op != LarsonOp::kVeltbl) continue;
      CHECK(std::min(one.call.a, one.call.b) == 59);
      CHECK(std::max(one.call.a, one.call.b) == 500);
    }
  }
}

TEST_CASE("a list of moves may come from a spreadsheet: byte order mark, CR LF, blanks") {
  const std::vector<Call> calls = larson::parse_moves(
      "\xEF\xBB\xBFx, y, pen\r\n  # a line\r\n 100 , 7 , 0 \r\n \r\n", "m.csv", {2000, 500});
  REQUIRE(calls.size() == 4);
  CHECK(calls[2].call.a == 100);
  CHECK(calls[2].call.b == 7);
  CHECK(calls[2].line == 3);
}

TEST_CASE("a list of moves may leave the soft range, and its next line begins at that end") {
  larson::PlotSetup setup{2000, 500, 300};
  const std::vector<Call> calls =
      larson::parse_moves("400,-5,0\n280,40,1\n", "m.csv", setup);
  REQUIRE(calls.size() == 4 + 3);
  CHECK(calls[2].call.a == 400);
  CHECK(calls[2].call.b == -5);
  CHECK(calls[4].call.a == 250);  // from (300, 0)
  CHECK(calls[4].call.b == 500);
  CHECK(calls[5].call.a == 280);
}

TEST_CASE("a list of moves that cannot be says file, line and what is permitted") {
  CHECK(refused_moves("x,y,pen\n1,2\n") == "m.csv:2: holds 2 fields, allowed 3: x,y,pen");
  CHECK(refused_moves("1,2,0,\n") == "m.csv:1: holds 4 fields, allowed 3: x,y,pen");
  CHECK(refused_moves("1;2;0\n") == "m.csv:1: holds 1 field, allowed 3: x,y,pen");
  CHECK(refused_moves(",,\n") ==
        "m.csv:1: x: nothing is not a whole number in -100000..100000");
  CHECK(refused_moves("1,2,0\nx,y,pen\n") ==
        "m.csv:2: x: x is not a whole number in -100000..100000");
  CHECK(refused_moves("x,y,pencil\n1,2,0\n") ==
        "m.csv:1: x: x is not a whole number in -100000..100000");
  CHECK(refused_moves("1,100001,0\n") ==
        "m.csv:1: y: 100001 is not a whole number in -100000..100000");
  CHECK(refused_moves("1,2,2\n") == "m.csv:1: pen: 2 is not a whole number in 0..1");
  CHECK(refused_moves("1,2.5,0\n") ==
        "m.csv:1: y: 2.5 is not a whole number in -100000..100000");
  CHECK(refused_moves("x,y,pen\n\n") == "m.csv: has no move");
}
