// SPDX-License-Identifier: Apache-2.0
//
// Scripts and lists of moves: what they become, and what is said of those that cannot be.
#include "machines/larson/script.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "machines/larson/machine_members.hpp"
#include "tests/support/message.hpp"
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
  return test::refusal_of([&] { script(text); });
}

std::string refused_moves(const std::string& text) {
  return test::refusal_of([&] { larson::parse_moves(text, "m.csv", {}); });
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

TEST_CASE("RELTBL without operands takes those of the one before it, as the calls run") {
  const std::vector<Call> calls =
      script("RELTBL 5 -6\nREPEAT 2\nreltbl\nRELTBL 7 8\nABSTBL 1 2\nEND\nRELTBL\n");
  std::vector<int> x;
  for (const Call& one : calls) {
    if (one.call.op == LarsonOp::kReltbl) x.push_back(one.call.a * 10 + one.call.b);
  }
  CHECK(x == std::vector<int>{44, 44, 78, 78, 78, 78});
  CHECK_THAT(refused("CALTBL\nRELTBL\nRELTBL 1 2\n"), Catch::StartsWith("s.table:2: RELTBL"));
  CHECK_THAT(refused("RELTBL 1\n"), Catch::Contains("takes x and y: 2 values, not 1"));
}

TEST_CASE("bytes are those of the words, low and high, and have eight bits") {
  const std::vector<Call> calls =
      script("MOVB xcount 377\nMOVB YSTATUS+1 20\nBIC XSTATUS 020000\nPOLL YSTATUS 010000\n");
  CHECK(calls[0].call.a == 0);
  CHECK(calls[1].call.a == 7);
  CHECK(calls[1].call.b == 020);
  CHECK(calls[2].call.op == LarsonOp::kBic);
  CHECK(calls[3].call.op == LarsonOp::kPoll);
  CHECK(calls[3].call.a == 3);
  CHECK_THAT(refused("MOVB XCOUNT 400\n"), Catch::Contains("allowed 000000..000377, octal"));
  CHECK_THAT(refused("MOV XCOUNT+1 3\n"), Catch::Contains("is not one of XCOUNT, XSTATUS"));
}

TEST_CASE("a script may begin with the byte order mark of UTF-8") {
  const std::vector<Call> calls = script("\xEF\xBB\xBF" "caltbl\r\nWTTBL\r\n");
  REQUIRE(calls.size() == 2);
  CHECK(calls[0].text == "CALTBL");
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

TEST_CASE("a call with a value too few or too many is refused, and one beyond a bound") {
  const struct {
    const char* name;
    std::vector<std::string> values;
  } calls[] = {{"CALTBL", {}},           {"VELTBL", {"59", "4000"}},
               {"WTTBL", {}},            {"ABSTBL", {"-100000", "100000"}},
               {"WHRTBL", {}},           {"RELTBL", {"100000", "-100000"}},
               {"WAIT", {"40000"}},      {"MOV", {"YSTATUS", "177777"}},
               {"BIS", {"XCOUNT", "0"}}};
  for (const auto& call : calls) {
    std::string text = call.name;
    for (const std::string& value : call.values) {
      INFO("short of a value: " << text);
      CHECK_THAT(refused(text),
                 Catch::StartsWith(std::string("s.table:1: ") + call.name + " takes "));
      text += " " + value;
    }
    INFO("whole: " << text);
    CHECK(refused(text).empty());
    CHECK(script(text)[0].text == text);
    CHECK(larson::name_of(script(text)[0].call.op) == call.name);
    CHECK_THAT(refused(text + " 1"),
               Catch::StartsWith(std::string("s.table:1: ") + call.name + " takes "));
  }
  for (const char* const text :
       {"VELTBL 58 59", "VELTBL 59 58", "VELTBL 4001 59", "VELTBL 59 4001", "ABSTBL -100001 0",
        "ABSTBL 0 -100001", "RELTBL 100001 0", "RELTBL 0 100001", "WAIT 40001", "MOV XCOUNT 200000",
        "BIS YCOUNT 200000", "BIS YCOUNT -1", "REPEAT 100001\nEND", "ABSTBL 0 99999999999999999999",
        "ABSTBL -99999999999999999999 0"}) {
    INFO(text);
    CHECK_THAT(refused(text), Catch::Contains(" is out of range, allowed "));
  }
  CHECK_THAT(refused("REPEAT\nWTTBL\nEND\n"),
             Catch::StartsWith("s.table:1: REPEAT takes how often: 1 value, "));
  CHECK_THAT(refused("REPEAT 2 3\nWTTBL\nEND\n"), Catch::StartsWith("s.table:1: REPEAT takes "));
  CHECK_THAT(refused("REPEAT 2\nWTTBL\nEND now\n"),
             Catch::StartsWith("s.table:3: END takes nothing: "));
}

TEST_CASE("blocks one behind the other are as many as one likes") {
  std::string text;
  for (int k = 0; k < 40; ++k) text += "REPEAT 1\nREPEAT 1\nWTTBL\nEND\nEND\n";
  CHECK(script(text).size() == 40);
}

TEST_CASE("a list of moves has at most 200000 calls, too") {
  std::string text;  // CALTBL, VELTBL once, and two calls a move
  for (int k = 0; k < 99'999; ++k) text += "1,0,0\n";
  CHECK(larson::parse_moves(text, "m.csv", {}).size() == 200'000);
  CHECK(refused_moves(text + "0,0,0\n") == "m.csv:100000: more than 200000 calls");
  text.resize(text.size() - 6);
  CHECK(refused_moves(text + "21,0,1\n") == "m.csv:99999: more than 200000 calls");  // one more
}

TEST_CASE("200000 calls are a script, one more is none") {
  const std::string most = "REPEAT 100000\nREPEAT 2\nWTTBL\nEND\nEND\n";
  CHECK(script(most).size() == 200'000);
  CHECK(refused(most + "WTTBL\n") == "s.table:6: more than 200000 calls");
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

TEST_CASE("a line is cut into pieces of 40 steps of its longer axis, each with its rates") {
  const struct {
    int x, y;      // from (200, 200)
    std::size_t pieces;
    int rate_x, rate_y;
  } lines[] = {{240, 200, 1, 500, 59}, {241, 200, 2, 500, 59},  {159, 200, 2, 500, 59},
               {200, 240, 1, 59, 500}, {200, 241, 2, 59, 500},  {190, 159, 2, 122, 500},
               {220, 160, 1, 250, 500}, {180, 240, 1, 250, 500}, {200, 200, 1, 59, 59}};
  for (const auto& line : lines) {
    const std::string to = std::to_string(line.x) + "," + std::to_string(line.y);
    const std::vector<Call> calls =
        larson::parse_moves("200,200,0\n" + to + ",1\n", "m.csv", {2000, 500, 1000});
    INFO("a line from 200,200 to " << to);
    std::vector<Call> rates, places;
    for (std::size_t k = 4; k < calls.size(); ++k) {
      if (calls[k].call.op == LarsonOp::kVeltbl) rates.push_back(calls[k]);
      if (calls[k].call.op == LarsonOp::kAbstbl) places.push_back(calls[k]);
    }
    CHECK(places.size() == line.pieces);
    REQUIRE(!rates.empty());
    REQUIRE(!places.empty());
    CHECK(std::abs(rates[0].call.a - line.rate_x) <= 3);  // whole steps of the first piece
    CHECK(std::abs(rates[0].call.b - line.rate_y) <= 3);
    CHECK(rates[0].text == "VELTBL " + std::to_string(rates[0].call.a) + " " +
                               std::to_string(rates[0].call.b));
    CHECK(places.back().text == "ABSTBL " + std::to_string(line.x) + " " + std::to_string(line.y));
    CHECK(places.back().line == 2);
  }
}

TEST_CASE("the rates are told again when that of one axis alone is another") {
  const std::vector<Call> calls = larson::parse_moves(
      "0,0,0\n20,40,1\n30,80,1\n70,90,1\n110,110,1\n", "m.csv", {2000, 500, 1000});
  std::vector<std::string> rates;
  for (const Call& one : calls) {
    if (one.call.op == LarsonOp::kVeltbl) rates.push_back(one.text);
  }
  CHECK(rates == std::vector<std::string>{"VELTBL 2000 2000", "VELTBL 250 500", "VELTBL 125 500",
                                          "VELTBL 500 125", "VELTBL 500 250"});
}

TEST_CASE("the soft range of the options is that of the lines of a list of moves") {
  const test::Scratch scratch("larson_soft");
  larson::Options options;
  options.script = (scratch.path / "m.csv").string();
  std::ofstream(options.script) << "400,-5,0\n280,40,1\n";
  options.plot.soft_end = 1000;  // is that of the table
  options.table.soft_end = 300;
  const std::vector<Call> calls = larson::calls_of(options);
  REQUIRE(calls.size() == 4 + 3);
  CHECK(calls[4].call.a == 250);  // from (300, 0)
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
  const std::string three = ", allowed 3, separated by commas: x,y,pen";
  CHECK(refused_moves("x,y,pen\n1,2\n") == "m.csv:2: holds 2 fields" + three);
  CHECK(refused_moves("1,2,0,\n") == "m.csv:1: holds 4 fields" + three);
  CHECK(refused_moves("1;2;0\n") == "m.csv:1: holds 1 field" + three);
  CHECK(refused_moves(",,\n") ==
        "m.csv:1: x: nothing is not a whole number in -100000..100000");
  CHECK(refused_moves("1,2,0\nx,y,pen\n") ==
        "m.csv:2: x: x is not a whole number in -100000..100000");
  for (const std::string header : {"x,y,pencil", "X,Y,PEN", "x;y;pen", "\"x\",\"y\",\"pen\""}) {
    CHECK(refused_moves("# moves\n" + header + "\n1,2,0\n") ==
          "m.csv:2: found " + header + ", allowed as a header: x,y,pen; else three whole numbers");
  }
  CHECK(refused_moves("x,y,pen\nx,y,pen\n1,2,0\n") ==
        "m.csv:2: x: x is not a whole number in -100000..100000");
  CHECK(refused_moves("1,100001,0\n") ==
        "m.csv:1: y: 100001 is not a whole number in -100000..100000");
  CHECK(refused_moves("1,2,2\n") == "m.csv:1: pen: 2 is not a whole number in 0..1");
  CHECK(refused_moves("1,2.5,0\n") ==
        "m.csv:1: y: 2.5 is not a whole number in -100000..100000");
  CHECK(refused_moves("x,y,pen\n\n") == "m.csv: has no move");
}

TEST_CASE("a script or list of moves that is no plain text says so, with its line") {
  using std::string_literals::operator""s;
  const struct {
    std::string text, told;
  } cases[] = {
      {"\xFF\xFE" "C\0A\0"s, "1: found the byte order mark of UTF-16, allowed: text in UTF-8 or "
                              "ASCII; save it as that"},
      {"\xFE\xFF\0C\0A"s, "1: found the byte order mark of UTF-16, allowed: text in UTF-8 or "
                           "ASCII; save it as that"},
      {"# a\n1\0,\0"s, "2: found a zero byte, as of UTF-16, allowed: text in UTF-8 or ASCII; save "
                       "it as that"},
      {"# a\n# b\n\xEF\xBB\xBF# c\n",
       "3: found a byte order mark, allowed: one at the beginning of the file"},
      {"# a\r# b\r", "1: found a carriage return within a line, allowed: lines that end in LF or "
                     "CR LF"}};
  for (const auto& one : cases) {
    CHECK(refused(one.text) == "s.table:" + one.told);
    CHECK(refused_moves(one.text) == "m.csv:" + one.told);
  }
  CHECK(refused("x,y,pen\n100,200,1\n") ==
        "s.table:1: X,Y,PEN is not a call, allowed: REPEAT, END, CALTBL, VELTBL, ABSTBL, RELTBL, "
        "WTTBL, WHRTBL, WAIT, MOV, BIS, BIC, MOVB, POLL; a list of moves x,y,pen is a .csv file");
  CHECK(refused("\xEF\xBB\xBF# \xC3\xA9 \xE9\r\ncaltbl\r\n") == "");
}
