// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "paths/gcode.hpp"

namespace {

using namespace trammel;

std::string message_of(const std::string& text, const paths::GcodeTable& table) {
  try {
    paths::read_gcode(text, "p.ngc", table);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing is refused";
}

std::string message_of(const std::string& text) {
  paths::GcodeTable table;
  table.start = table.home = {0.25, 0.25};
  return message_of(text, table);
}

struct Case {
  std::string text, message;  // behind p.ngc:
};

void check_all(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    CAPTURE(one.text);
    CHECK(message_of(one.text) == "p.ngc:" + one.message);
  }
}

}  // namespace

TEST_CASE("words that are not known are refused with those that are") {
  const std::string letters =
      " is not known; known: F G H I J M N P R S T X Y Z (numbers have no exponent)";
  const std::string codes =
      " is not known; known: G0 G1 G2 G3 G4 G17 G20 G21 G28 G61 G64 G90 G91 G94";
  const std::string ends = " is not known; known: M2 M30, ignored: M3 to M9";
  check_all({{"G5", "1: G5" + codes},
             {"\ng53 x1", "2: G53" + codes},
             {"G54", "1: G54" + codes},
             {"G61.1", "1: G61.1" + codes},
             {"G-1", "1: G-1" + codes},
             {"G1 5", "1: G15" + codes},  // blanks are free
             {"G1 X1e3", "1: E" + letters},
             {"G2 X1 K1", "1: K" + letters},
             {"O1000", "1: O" + letters},
             {"M0", "1: M0" + ends},
             {"M10", "1: M10" + ends},
             {"M3.5", "1: M3.5" + ends}});
}

TEST_CASE("what is no word is refused") {
  const std::string none = " is no word: a word is a letter and a number";
  check_all({{"5", "1: '5'" + none},
             {"G1 X1(a)0", "1: '0'" + none},
             {"X,1", "1: X has no number"},
             {"G1 X5, Y3", "1: ','" + none},
             {"X\xE2\x88\x92" "5", "1: X has no number"},
             {"\xE2\x88\x92" "5", "1: '\xE2\x88\x92'" + none},
             {"#1=5", "1: '#': parameters and expressions are not known"},
             {"[1]", "1: '[': parameters and expressions are not known"},
             {"G1 X#1", "1: '#': parameters and expressions are not known"},
             {"G1 X-[1+2]", "1: '[': parameters and expressions are not known"},
             {"G1 X5#1", "1: '#': parameters and expressions are not known"},
             {"G1 / X1", "1: '/' stands first in its line"},
             {std::string("G21\0", 4), "1: the byte 0x00 is no text"},
             {"G21\x1b[2J", "1: the byte 0x1b is no text"},
             {"G21\v", "1: the byte 0x0b is no text"},
             {"G21 % ", "1: % stands alone in its line"},
             {"%O1", "1: % stands alone in its line"},
             {"G21\rG1", "1: a carriage return inside the line; a line ends in LF or in CR LF"},
             {"(a\rG1 X1)", "1: a carriage return inside the line; a line ends in LF or in CR LF"},
             {std::string(257, ' '), "1: the line has 257 characters; permitted: 256"},
             {"(" + std::string(10'000'000, 'x') + ")",
              "1: the line has 10000002 characters; permitted: 256"},
             {std::string("\xFF\xFEG\0", 4), "1: UTF-16 text; save it as UTF-8 or ASCII"},
             {std::string("\xFE\xFF\0G", 4), "1: UTF-16 text; save it as UTF-8 or ASCII"}});
}

TEST_CASE("numbers that are none are refused") {
  check_all({{"G1 X", "1: X has no number"},
             {"G1 X Y5", "1: X has no number"},
             {"X(a)5", "1: X has no number"},
             {"X.", "1: X has no number"},
             {"X-", "1: X has no number"},
             {"X+-5", "1: X has no number: '+-' is none"},
             {"X--5", "1: X has no number: '--' is none"},
             {"X1.2.3", "1: X has no number: '1.2.' is none"},
             {"X1-2", "1: X has no number: '1-' is none"},
             {"G.1.", "1: G has no number: '.1.' is none"},
             {"Xinf", "1: X has no number"},
             {"X0x10", "1: X twice in a block"},
             {"N G1", "1: N has no number: it has digits only"},
             {"N-1", "1: N has no number: it has digits only"},
             {"N1.5", "1: N has no number: it has digits only"},
             {"G1 N5", "1: N stands first in its block"},
             {"N1 N2", "1: N stands first in its block"}});
}

TEST_CASE("comments are closed and stand in no other") {
  check_all({{"G21\n(a\n)", "2: comment is not closed"},
             {"(a ; b", "1: comment is not closed"},
             {"(a (b))", "1: comment is not closed before the next one begins"},
             {"G21)", "1: ')' without '('"}});
}

TEST_CASE("words that contradict each other in a block are refused") {
  check_all({{"G1 X1 X1", "1: X twice in a block"},
             {"G1 Z1 Z2", "1: Z twice in a block"},
             {"F1 F2", "1: F twice in a block"},
             {"G90 G90", "1: G90 twice in a block"},
             {"G1 G01", "1: G1 twice in a block"},
             {"G0 G1 X1", "1: two motions in a block: G0 and G1"},
             {"G2 G3", "1: two motions in a block: G2 and G3"},
             {"G28 G0", "1: two motions in a block: G28 and another"},
             {"G28 G4 P1", "1: two motions in a block: G4 and another"},
             {"G4 P1 X1", "1: two motions in a block: G4 and another"},
             {"G4 P1 G1", "1: two motions in a block: G4 and another"},
             {"G90 G91", "1: two of a kind in a block: G90 and G91"},
             {"G20 G21", "1: two of a kind in a block: G20 and G21"},
             {"G61 G64", "1: two of a kind in a block: G61 and G64"},
             {"G28 Z0", "1: Z with G28, which moves X and Y alone"},
             {"G28 X1", "1: G28 needs both X and Y, or neither"},
             {"G28 Y1", "1: G28 needs both X and Y, or neither"},
             {"G28 I1", "1: I, J and R belong to G2 and G3; the motion is G28"},
             {"M2 M30", "1: two ends in a block: M2 or M30 once"},
             {"G1 X1 P1", "1: P belongs to G4 or G64"},
             {"G61 P1", "1: P belongs to G4 or G64"},
             {"G4 G64 P1", "1: P with both G4 and G64"},
             {"G64 P-1", "1: P of G64 must be 0 or more"},
             {"G20 F10", "1: F in the block that changes the unit; give it in the next one"}});
}

TEST_CASE("a motion needs what it is made of") {
  const std::string speed =
      ": S with G4: a speed, or for some controllers the seconds of the rest; give P";
  const std::string milliseconds =
      ": P is in seconds here, in milliseconds for some controllers; permitted: below 500 s";
  std::string rests;
  for (int k = 0; k < 8; ++k) rests += "G4 P437.5\n";  // 3500 s
  check_all({{"X1", "1: no G0, G1, G2 or G3 yet"},
             {"I1", "1: no G0, G1, G2 or G3 yet"},
             {"G1 X1", "1: no F yet"},
             {"G0 X1\nG2 X3 R1", "2: no F yet"},
             {"F0", "1: F must be above 0"},
             {"F-100", "1: F must be above 0"},
             {"F5.9", "1: F = 5.9 is out of range 6..60000 mm/min"},
             {"G20\nF.2", "2: F = 0.2 is out of range 0.23622..2362.2 inch/min"},
             {"G1 F600 X1 I2", "1: I, J and R belong to G2 and G3; the motion is G1"},
             {"G0 R2", "1: I, J and R belong to G2 and G3; the motion is G0"},
             {"G4", "1: G4 needs P [s], 0 or more"},
             {"G4 P-1", "1: G4 needs P [s], 0 or more"},
             {"G4 F600", "1: G4 needs P [s], 0 or more"},
             {"G4 S2", "1" + speed},
             {"G4 P1 S2", "1" + speed},
             {"G4 P500", "1: G4 P500" + milliseconds},
             {"G4 P.5\nG4 P3601", "2: G4 P3601" + milliseconds},
             {rests + "G4 P101",
              "9: G4 P101: all rests of a program take 3601 s; permitted: 3600 s"},
             {"G4 P499.5\nG4 P500", "2: G4 P500" + milliseconds},
             {"", "1: no motion in the program"},
             {"%\n(nothing)\n%\nG0 X1", "3: no motion in the program"},
             {"G0 X250 Y250\n\n", "2: no motion in the program"},
             {"M2\nG0 X1", "1: no motion in the program"},
             {"G21\n%\nG0 X1\n%", "2: '%' ends a program that began with '%'; this one did not"}});
}

TEST_CASE("nothing leaves the stroke") {
  const std::string leaves = ": the point leaves the stroke: ";
  check_all({{"G0 X600.001", "1" + leaves + "X = 600.001 mm; permitted: 0..600 mm"},
             {"G0 Y-.5", "1" + leaves + "Y = -0.5 mm; permitted: 0..600 mm"},
             {"G91 G0 X-250\nX-1", "2" + leaves + "X = -1 mm; permitted: 0..600 mm"},
             {"G20 G0 X24", "1" + leaves + "X = 609.6 mm; permitted: 0..600 mm"},
             {"G28 X700 Y0", "1" + leaves + "X = 700 mm; permitted: 0..600 mm"},
             {"G0 X" + std::string(200, '9'), "1" + leaves + "X = 1e+200 mm; permitted: 0..600 mm"},
             {"G91 G0 Y-" + std::string(12, '9'),
              "1" + leaves + "Y = -1e+12 mm; permitted: 0..600 mm"},
             {"F600 G2 I360", "1: the arc leaves the stroke: it reaches Y = -110 mm; permitted: "
                              "0..600 mm"},
             {"F600 G3 X350 Y250 R-250",
              "1: the arc leaves the stroke: it reaches Y = -244.949 mm; permitted: 0..600 mm"}});
}

TEST_CASE("the stroke of each axis is its own, for lines, for G28 and for arcs, at both ends") {
  paths::GcodeTable table;
  table.start = table.home = {0.25, 0.45};
  table.low = {0.1, 0.2};
  table.high = {0.4, 0.7};
  const struct {
    char axis, center;
    double from, low, high;  // [mm]
  } axes[] = {{'X', 'I', 250, 100, 400}, {'Y', 'J', 450, 200, 700}};
  for (const auto& one : axes) {
    for (const double end : {one.low, one.high}) {
      for (const double beyond : {0.0, end < one.from ? -0.01 : 0.01}) {
        const double to = end + beyond;
        const auto refused = [&](const std::string& what) {
          return fmt::format("p.ngc:1: the {} {} = {:g} mm; permitted: {:g}..{:g} mm", what,
                             one.axis, to, one.low, one.high);
        };
        const std::string place = fmt::format("X{} Y{}", one.axis == 'X' ? to : 250,
                                              one.axis == 'Y' ? to : 450);
        for (const char* word : {"G0", "F600 G1", "G28"}) {
          CAPTURE(word, place);
          CHECK(message_of(fmt::format("{} {}\nG0 X251", word, place), table) ==
                (beyond == 0 ? "nothing is refused" : refused("point leaves the stroke:")));
        }
        for (const char* word : {"G2", "G3"}) {  // a circle from the start to there and back
          const std::string circle = fmt::format("F600 {} {}{}", word, one.center,
                                                 (to - one.from) / 2);
          CAPTURE(circle);
          CHECK(message_of(circle, table) ==
                (beyond == 0 ? "nothing is refused"
                             : refused("arc leaves the stroke: it reaches")));
        }
      }
    }
  }
}

TEST_CASE("an arc's words fit each other") {
  const std::string at = "G0 X200 Y200 F600\n";
  check_all({{at + "G2", "2: an arc needs I and J, or R"},
             {at + "G2 X210", "2: an arc needs I and J, or R"},
             {at + "G2 X210 Y200 R5\nX220", "3: an arc needs I and J, or R"},
             {at + "G2 X210 R5 J0", "2: R and I or J in one block"},
             {at + "G3 X210 R4.99", "2: R is too small for the end point: 4.99 mm; permitted: 5 mm "
                                    "and more, or as much below 0"},
             {at + "G3 X210 R-4", "2: R is too small for the end point: -4 mm; permitted: 5 mm and "
                                  "more, or as much below 0"},
             {at + "G3 X210 R0", "2: R is too small for the end point: 0 mm; permitted: 5 mm and "
                                 "more, or as much below 0"},
             {at + "G2 R5", "2: an arc with R needs another end point"},
             {at + "G2 X200 Y200 R5", "2: an arc with R needs another end point"},
             {at + "G2 X210 I5.02", "2: start and end differ in radius by 0.04 mm; permitted: 0.02 "
                                    "mm or 0.1 %"},
             {at + "G2 X300 I50.06", "2: start and end differ in radius by 0.12 mm; permitted: "
                                     "0.02 mm or 0.1 %"},
             {at + "G2 X200.0004 I5", "2: the end is the start but for 0.0004 mm: a full circle "
                                      "ends where it begins"},
             {at + "G2 I0 J0", "2: the arc's radius of 0 mm is out of range 0.001..5000 mm"},
             {at + "G2 X210 I1 J9999",
              "2: the arc's radius of 9999 mm is out of range 0.001..5000 mm"},
             {at + "G2 I1" + std::string(200, '0'),
              "2: the arc's radius of 1e+200 mm is out of range 0.001..5000 mm"},
             {at + "G2 X210 R5001",
              "2: the arc's radius of 5001 mm is out of range 0.001..5000 mm"}});
}

TEST_CASE("ends may differ in radius by 0.02 mm or by 0.1 %, whichever is more") {
  // The end of a half circle, nearer to the centre than the start by twice of what I is too long.
  for (const char* arc : {"X210 I5.009", "X201 I0.509", "X300 I50.02", "X500 I150.07"}) {
    CAPTURE(arc);
    CHECK(message_of(std::string("G0 X200 Y200 F600\nG2 ") + arc) == "nothing is refused");
  }
}

TEST_CASE("the number of lines and arcs is bounded") {
  std::string text = "G91 G1 F600\n";
  for (int k = 0; k < 4096; ++k) text += k % 2 == 0 ? "X1\n" : "X-1\n";
  CHECK(message_of(text) == "nothing is refused");
  CHECK(message_of(text + "G4 P1\nX0\n") == "nothing is refused");
  CHECK(message_of(text + "X1\n") == "p.ngc:4098: more than 4096 lines and arcs");
}

TEST_CASE("rests are taken up to an hour in all, the last with it") {
  std::string rests;
  for (int k = 0; k < 8; ++k) rests += "G4 P450\n";
  CHECK(message_of(rests + "G0 X1") == "nothing is refused");
  CHECK(message_of(rests + "G4 P.5") ==
        "p.ngc:9: G4 P0.5: all rests of a program take 3600.5 s; permitted: 3600 s");
}

TEST_CASE("what is no file is refused with its name") {
  CHECK_THROWS_WITH(paths::read_gcode_file("no/such.ngc", {}),
                    "no/such.ngc: cannot be read: No such file or directory");
  CHECK_THROWS_WITH(paths::read_gcode_file(".", {}), ".: cannot be read: it is a folder");
  CHECK_THROWS_WITH(paths::read_gcode_file("/dev/zero", {}),
                    "/dev/zero: cannot be read: it is not a regular file");
}
