// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <sstream>

#include "paths/points.hpp"

namespace {

using trammel::paths::lines_through;
using trammel::paths::PointM;

std::vector<trammel::paths::PointM> read(const std::string& text) {
  std::istringstream stream(text);
  return trammel::paths::read_points_csv(stream, "p.csv", {0, 600});
}

}  // namespace

TEST_CASE("points are read in millimetres past a header, comments and empty lines") {
  const auto points = read("# a path\nx_mm,y_mm\n\n0, 600\r\n  # between\n250.5,1e2\n");
  REQUIRE(points.size() == 2);
  CHECK(points[0].x_m == 0);
  CHECK(points[0].y_m == Approx(0.6));
  CHECK(points[1].x_m == Approx(0.2505));
  CHECK(points[1].y_m == Approx(0.1));
  CHECK(read("1,2").size() == 1);
}

TEST_CASE("the line of each point is told to who asks") {
  std::istringstream text("x_mm,y_mm\n\n1,2\n# none\n3,4\n");
  std::vector<int> lines{7};
  CHECK(trammel::paths::read_points_csv(text, "p.csv", {0, 600}, &lines).size() == 2);
  CHECK(lines == std::vector<int>{3, 5});
}

TEST_CASE("a point off the table is refused with file, line and the permitted range") {
  CHECK_THROWS_WITH(read("x,y\n1,2\n601,3\n"),
                    "p.csv:3: x_mm = 601 is out of range 0..600 mm");
  CHECK_THROWS_WITH(read("1,-0.5\n"), "p.csv:1: y_mm = -0.5 is out of range 0..600 mm");
  CHECK_THROWS_AS(read("1,nan\n"), std::invalid_argument);
}

TEST_CASE("lines that are not two numbers are refused with their line number") {
  CHECK_THROWS_WITH(read("1,2\nx,y\n"), "p.csv:2: expected two numbers x_mm,y_mm, found 'x,y'");
  CHECK_THROWS_WITH(read("x,y\nx,y\n"), "p.csv:2: expected two numbers x_mm,y_mm, found 'x,y'");
  CHECK_THROWS_AS(read("1\n"), std::invalid_argument);
  CHECK_THROWS_AS(read("1,2,3\n"), std::invalid_argument);
  CHECK_THROWS_AS(read("1,2 mm\n"), std::invalid_argument);
  CHECK_THROWS_AS(read("# nothing\n"), std::invalid_argument);
  CHECK_THROWS_WITH(trammel::paths::read_points_csv("no/such.csv", {}),
                    "no/such.csv: cannot be read: No such file or directory");
  CHECK_THROWS_WITH(trammel::paths::read_points_csv(".", {}), ".: cannot be read: it is a folder");
}

TEST_CASE("a byte-order mark is not part of the first line") {
  const auto points = read("\xEF\xBB\xBF" "100,200\n101,200\n");
  REQUIRE(points.size() == 2);
  CHECK(points[0].x_m == Approx(0.1));
  CHECK_THROWS_WITH(read(std::string("\xFF\xFE") + "1\0,\0"),
                    "p.csv:1: UTF-16 text; save it as UTF-8 or ASCII");
  CHECK_THROWS_WITH(read(std::string("\xFE\xFF") + "1,2\n"),
                    "p.csv:1: UTF-16 text; save it as UTF-8 or ASCII");
}

TEST_CASE("one name or one number is no header, and of a long line 60 bytes are shown") {
  const auto refused = [](const std::string& line, const std::string& shown) {
    CHECK_THROWS_WITH(read(line + "\n1,2\n"),
                      "p.csv:1: expected two numbers x_mm,y_mm, found '" + shown + "'");
  };
  for (const char* line : {"points", "1,y", "x,2"}) refused(line, line);
  refused(std::string(60, 'a'), std::string(60, 'a'));
  refused(std::string(61, 'a'), std::string(60, 'a') + "...");
  // No character of two bytes is cut.
  refused(std::string(59, 'a') + "\xC3\xA9" + "b", std::string(59, 'a') + "...");
  refused(std::string(58, 'a') + "\xC3\xA9" + "b", std::string(58, 'a') + "\xC3\xA9" + "...");
}

TEST_CASE("a header that swaps the columns or names another unit is refused") {
  for (const char* header : {"y_mm,x_mm", "x_mm,x_mm", "Y, X", "x_m,y_m", "x [um],y [um]",
                             "y_mm,b", "a,x_mm", "x_m,y_mm", "x_mm,y_in"}) {
    CAPTURE(header);
    CHECK_THROWS_WITH(read(std::string(header) + "\n1,2\n"),
                      "p.csv:1: expected the columns x_mm,y_mm, found '" +
                          std::string(header) + "'");
  }
  for (const char* header : {"x,y", "X (mm),Y (mm)", "point x,point y", "x_mm,y_mm"}) {
    CAPTURE(header);
    CHECK(read(std::string(header) + "\n1,2\n").size() == 1);
  }
}

TEST_CASE("points are a path of lines, repeated ones are left out") {
  const std::vector<PointM> points{{0.1, 0.1}, {0.1, 0.1}, {0.2, 0.1}, {0.2, 0.1}, {0.2, 0}};
  const trammel::ideal::Moves all = lines_through(points, "p.csv", 0.3, true);
  CHECK(all.start.x == 0.1);
  REQUIRE(all.moves.size() == 2);
  CHECK(all.moves[0].to.x == 0.2);
  CHECK(all.moves[1].from.x == 0.2);
  CHECK(all.moves[1].to.y == 0);
  for (const trammel::ideal::Move& move : all.moves) {
    CHECK(move.feed == 0.3);
    CHECK(move.exact);
    CHECK_FALSE(move.stop);
  }
  CHECK_THROWS_WITH(lines_through({{0.1, 0.1}, {0.1, 0.1}}, "p.csv", 0.3, false),
                    "p.csv: a path needs 2 points that differ");
  std::vector<PointM> many;
  for (int k = 0; k < 4098; ++k) many.push_back({1e-4 * k, 0});
  CHECK_THROWS_WITH(lines_through(many, "p.csv", 0.3, false),
                    "p.csv: 4097 lines; permitted: 4096");
  many.pop_back();
  CHECK(lines_through(many, "p.csv", 0.3, false).moves.size() == 4096);
}

TEST_CASE("points nearer than a nanometre are one, and a path goes on from the first of them") {
  for (const double apart_m : {0.9e-9, 1.1e-9}) {
    const trammel::ideal::Moves all =
        lines_through({{0, 0}, {apart_m, 0}, {0.1, 0}}, "p.csv", 0.3, false);
    CAPTURE(apart_m);
    CHECK(all.moves.size() == (apart_m < 1e-9 ? 1 : 2));
    CHECK(all.moves.back().from.x == (apart_m < 1e-9 ? 0 : apart_m));
    CHECK_FALSE(all.moves.back().exact);
  }
}
