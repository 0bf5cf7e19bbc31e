// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/path.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <utility>

#include "cosim/run.hpp"
#include "models/plant/trig.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

constexpr double kCountMm = 4.0132 / 800;

PathOptions shape(PathKind kind, double side, double radius) {
  PathOptions o;
  o.kind = kind;
  o.side_mm = side;
  o.radius_mm = radius;
  return o;
}

Table table_of(const PathOptions& o) { return make_table(o, kCountMm); }

// Where the rows lead [count].
PointMm sum(const Table& table) {
  PointMm at;
  for (const sw::McafeeRow& row : table.rows) at += PointMm(row.dx, row.dy);
  return at;
}

struct PointsFile {
  std::string name = "track_points.csv";
  explicit PointsFile(const std::string& text) { std::ofstream(name) << text; }
  ~PointsFile() { std::remove(name.c_str()); }
};

}  // namespace

TEST_CASE("F-09 the corner changes C at once and CC ten rows ahead of it") {
  PathOptions o = shape(PathKind::kCorner, 102, 2);
  o.kappa_max_1_mm = 0.5;
  const Table table = table_of(o);
  REQUIRE(table.rows.size() == 406);  // 203.14 mm
  CHECK(table.warnings.empty());
  for (std::size_t k = 0; k < 200; ++k) {
    CAPTURE(k);
    REQUIRE(table.rows[k].c == 0);
    // The corner is 6.3 rows long: ten rows ahead of the last three it is over.
    REQUIRE(table.rows[k].cc == (k < 190 || k > 196 ? 0 : 255));
    REQUIRE(table.rows[k].vx == 255);
    REQUIRE(table.rows[k].dy == 0);
  }
  for (std::size_t k = 200; k < 207; ++k) REQUIRE(table.rows[k].c == 255);
  CHECK(table.rows[207].c == 0);
  CHECK(table.rows[405].cc == 0);  // beyond the end it stays as it ends
  CHECK(table.rows[405].vy == 255);
}

TEST_CASE("F-10 the rounded square has 463 rows and leads back to its start") {
  const PathOptions o = shape(PathKind::kSquare, 60, 5);
  const Table table = table_of(o);
  CHECK(table.rows.size() == 463);
  CHECK(table.row_mm == Approx((200 + 10 * 3.14159265) / 463));
  CHECK(sum(table) == 0.0);
  int curved = 0;
  for (const sw::McafeeRow& row : table.rows) {
    REQUIRE((row.c == 0 || row.c == 255));
    if (row.c == 255) ++curved;
  }
  CHECK(curved == Approx(10 * 3.14159 / table.row_mm).margin(4));
}

TEST_CASE("the preview of a closed path continues past its end") {
  PathOptions o = shape(PathKind::kSquare, 60, 5);
  o.preview_rows = 60;  // the first corner begins 25 mm behind the start
  const Table table = table_of(o);
  CHECK(table.rows[455].cc == 255);
  CHECK(table.rows[430].cc == 0);
}

TEST_CASE("a path of points is closed where it comes back on another way than it went") {
  const test::Scratch scratch("mcafee_table_test_out");
  std::filesystem::create_directories(scratch.path);
  PathOptions o = shape(PathKind::kPoints, 0, 0);
  o.points_file = scratch.path / "points.csv";
  for (const auto& [points, closed] : std::initializer_list<std::pair<const char*, bool>>{
           {"0,0\n20,0\n", false},
           {"0,0\n20,0\n0,0\n", false},  // there and back: two ends
           {"0,0\n20,0\n20,10\n", false},
           {"0,0\n20,0\n20,10\n0,0\n", true},
           {"0,0\n20,0\n20,10\n0,0.01\n", false}}) {
    CAPTURE(points);
    std::ofstream(o.points_file) << points;
    CHECK(Path(o).closed() == closed);
  }
}

TEST_CASE("the preview of an open path stays at its end, with a corner within the first rows") {
  PathOptions o = shape(PathKind::kCorner, 12, 2);
  o.kappa_max_1_mm = 0.5;
  o.preview_rows = 30;  // 15 mm: a closed path would have its corner ahead of the last rows
  const Table table = table_of(o);
  bool corner = false;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    CAPTURE(k);
    corner = corner || table.rows[k].c == 255;
    if (!corner || table.rows[k].c == 255) continue;
    REQUIRE(table.rows[k].cc == 0);
  }
  CHECK(corner);
}

TEST_CASE("rows have equal length, directions of 255 and the curvature of their circle") {
  PathOptions o = shape(PathKind::kCircle, 0, 20);
  o.kappa_max_1_mm = 0.1;
  const Table table = table_of(o);
  CHECK(table.rows.size() == 251);
  for (const sw::McafeeRow& row : table.rows) {
    REQUIRE(row.c == 128);  // 0.05 of 0.1, 127.5 rounded
    REQUIRE(row.cc == 0);
    REQUIRE(std::hypot(row.dx, row.dy) == Approx(table.row_mm / kCountMm).margin(1.5));
    REQUIRE(std::hypot(row.vx, row.vy) == Approx(255).margin(1));
  }
  CHECK(table.rows[0].dx < 1);
  CHECK(table.rows[0].dy > 90);  // counterclockwise
}

TEST_CASE("a star's tips turn by 144 degrees within their radius") {
  PathOptions o = shape(PathKind::kStar, 100, 3);
  const Path path(o);
  CHECK(path.curvature(49) == 0);
  CHECK(path.curvature(50 - 3 * std::tan(0.4 * plant::kPi) + 0.1) == Approx(1.0 / 3));
  const double arcs = 5 * 0.8 * plant::kPi * 3, cuts = 10 * 3 * std::tan(0.4 * plant::kPi);
  CHECK(path.length() == Approx(500 - cuts + arcs));
  CHECK(sum(table_of(o)) == 0.0);
  CHECK(path.distance(path.at(77), 77, 1) == Approx(0).margin(1e-9));
  CHECK(path.distance(path.at(10) + PointMm{0, 0.25}, 10, 1) == Approx(0.25));
}

TEST_CASE("behind the end of an open path only what is beside its direction is distance") {
  PathOptions o = shape(PathKind::kCorner, 20, 3);
  const Path open(o);
  const PointMm end = open.at(open.length()), ahead = (end - open.at(open.length() - 1));
  const PointMm aside = ahead * PointMm{0, 1};
  CHECK(open.distance(end + 2.0 * ahead, open.length(), 10) == Approx(0).margin(1e-9));
  CHECK(open.distance(end + 2.0 * ahead - 0.3 * aside, open.length(), 10) == Approx(0.3));
  CHECK(open.behind_end(end + 2.0 * ahead + 0.3 * aside) == Approx(2));
  CHECK(open.behind_end(end - ahead) == 0);
  const PointMm start_ahead = open.at(1) - open.at(0);
  CHECK(open.distance(open.at(0) - 2.0 * start_ahead, 0, 10) == Approx(0).margin(1e-9));
  // In the middle of the path its ends are no excuse.
  CHECK(open.distance(end + 2.0 * ahead, 10, 5) > 5);
  const Path closed(shape(PathKind::kCircle, 0, 20));
  CHECK(closed.distance(closed.at(0) + PointMm{2, 0}, closed.length(), 10) == Approx(2));
  CHECK(closed.behind_end(closed.at(0) + PointMm{0, 2}) == 0);
}

TEST_CASE("the distance from a path is that from its nearest place within reach, in any shape") {
  for (const PathOptions& o :
       {shape(PathKind::kSquare, 60, 9), shape(PathKind::kCircle, 0, 20),
        shape(PathKind::kStar, 100, 3), shape(PathKind::kCorner, 60, 8)}) {
    const Path path(o);
    const double length = path.length();
    const auto at = [&](double w) {
      return path.at(path.closed() ? std::fmod(w + length, length) : w);
    };
    for (int k = 0; k < 40; ++k) {
      const double s = length * k / 40, reach = k % 3 == 0 ? 2 : k % 3 == 1 ? 9 : 25;
      if (!path.closed() && (s <= reach || s >= length - reach)) continue;  // its ends are below
      for (const double share : {-0.95, -0.3, 0.0, 0.6, 1.2}) {
        for (const double off : {-3.0, 1.5}) {
          const double w = s + share * reach;
          if (!path.closed() && (w < 0 || w > length - 0.01)) continue;
          const PointMm step = at(w + 1e-3) - at(w);
          const PointMm p = at(w) + off / std::abs(step) * step * PointMm{0, 1};
          double nearest = 1e9;
          for (int n = 0; n <= 1000; ++n) {
            nearest = std::min(nearest, std::abs(p - at(s + reach * (n - 500) / 500)));
          }
          CAPTURE(static_cast<int>(o.kind), s, reach, share, off);
          CHECK(path.distance(p, s, reach) == Approx(nearest).margin(1e-3));  // of 0.05 mm apart
        }
      }
    }
  }
}

TEST_CASE("beside an open path its start is no excuse, nor is its end far from there") {
  PathOptions o = shape(PathKind::kPoints, 0, 0);
  const auto path_of = [&o](const std::string& points) {
    const PointsFile file(points);
    o.points_file = file.name;
    return Path(o);
  };
  // Round a corner the line through the first row is none of the path.
  const Path corner = path_of("0,0\n2,0\n2,10\n");
  CHECK(corner.distance(corner.at(0) + PointMm{4, 0}, 1, 5) == Approx(2));
  const Path back = path_of("2,10\n2,0\n0,0\n");
  CHECK(back.distance(back.at(back.length()) + PointMm{4, 0}, back.length() - 1, 5) == Approx(2));
  for (const double side : {0.5, -0.5}) {
    const double off = side > 0 ? 8 : std::hypot(8, side);  // from the leg at x = 2
    const PointMm before = corner.at(0) + PointMm{-6, side};
    CHECK(corner.distance(before, 1, 5) == Approx(0.5));
    CHECK(corner.distance(before, 5, 5) == Approx(0.5));  // within reach just so
    CHECK(corner.distance(before, 7, 5) == Approx(off));
    const PointMm behind = back.at(back.length()) + PointMm{-6, side};
    CHECK(back.distance(behind, back.length() - 1, 5) == Approx(0.5));
    CHECK(back.distance(behind, back.length() - 5, 5) == Approx(0.5));
    CHECK(back.distance(behind, back.length() - 7, 5) == Approx(off));
  }
  // Its end comes near its start: that is another lap of a closed path alone.
  const Path turn = path_of("0,0\n10,0\n10,1\n0,1\n");
  CHECK(turn.distance(turn.at(0) + PointMm{0.2, 1}, 0.5, 2) == Approx(1));
  CHECK(turn.distance(turn.at(turn.length()) + PointMm{0.2, -1}, turn.length() - 0.5, 2) ==
        Approx(1));
}

TEST_CASE("points are resampled, their curvature is that of the circle through three") {
  std::string text = "x_mm,y_mm\n";
  for (int k = 0; k <= 360; ++k) {
    text += std::to_string(10 * std::cos(k * plant::kPi / 180)) + ',' +
            std::to_string(k == 360 ? 0 : 10 * std::sin(k * plant::kPi / 180)) + '\n';
  }
  const PointsFile file(text);
  PathOptions o;
  o.kind = PathKind::kPoints;
  o.points_file = file.name;
  const Table table = table_of(o);
  CHECK(table.rows.size() == 126);
  for (const sw::McafeeRow& row : table.rows) REQUIRE(row.c == Approx(127).margin(5));
}

TEST_CASE("a closed path of points has its curvatures wherever it begins, an open one its ends") {
  const auto curvatures = [](const std::string& text) {
    const PointsFile file(text);
    PathOptions o;
    o.kind = PathKind::kPoints;
    o.points_file = file.name;
    std::vector<int> c;
    for (const sw::McafeeRow& row : table_of(o).rows) c.push_back(row.c);
    return c;
  };
  // A rectangle of rows of 0.5 mm, from a corner and from a row before one: 20, 10, 20, 10 rows.
  const std::vector<int> corner = curvatures("0,0\n10,0\n10,5\n0,5\n0,0\n");
  const std::vector<int> before = curvatures("0,0.5\n0,0\n10,0\n10,5\n0,5\n0,0.5\n");
  REQUIRE(corner.size() == 60);
  REQUIRE(before.size() == 60);
  for (std::size_t k = 0; k < 60; ++k) {
    CAPTURE(k);
    CHECK(corner[k] == (k == 0 || k == 20 || k == 30 || k == 50 ? 255 : 0));
    CHECK(before[(k + 1) % 60] == corner[k]);
  }
  // Of an open one the first and the last row know no further than the three points there.
  const std::vector<int> open = curvatures("0,0\n0.5,0\n0.5,10\n0,10\n");
  REQUIRE(open.size() == 22);
  for (std::size_t k = 0; k < 22; ++k) {
    CAPTURE(k);
    CHECK(open[k] == (k < 2 || k == 21 ? 255 : 0));
  }
}

TEST_CASE("a curvature above kappa_max saturates with a warning that names its row") {
  const PointsFile file("0,0\n10,0\n10,10\n");
  PathOptions o;
  o.kind = PathKind::kPoints;
  o.points_file = file.name;
  const Table table = table_of(o);
  REQUIRE(table.warnings.size() == 1);
  CHECK(table.warnings[0] ==
        "row 20: curvature 2.828 1/mm is above path.kappa_max_1_mm = 0.2; C = 255");
  CHECK(table.rows[20].c == 255);
}

TEST_CASE("a path that turns back on itself saturates there, wherever its rows begin") {
  const auto with = [](const std::string& text) {
    const PointsFile file(text);
    PathOptions o;
    o.kind = PathKind::kPoints;
    o.points_file = file.name;
    return table_of(o);
  };
  const Table spike = with("0,0\n20,0\n20,10\n20,0\n40,0\n");
  REQUIRE(spike.warnings.size() == 3);  // two corners, and the tip between them
  CHECK(spike.warnings[1] == "row 60: the path turns back on itself; C = 255");
  CHECK(spike.rows[60].c == 255);
  CHECK(spike.rows[50].cc == 255);
  CHECK(with("0,0\n10,0\n0,0\n").rows[20].c == 255);
  CHECK(with("0,0\n7,7\n-7,-7\n").warnings.size() == 1);
  // Within a row, which is shorter for it: the rows at both its ends see it.
  const Table inside = with("0,0\n10.1,0\n-20,0\n");
  CHECK(std::max(inside.rows[20].c, inside.rows[21].c) == 255);
  CHECK_THROWS_WITH(with("0,0\n10.25,0\n0,0\n"),
                    Catch::Contains("row 20: the path turns back in the middle of the row"));
}

TEST_CASE("the first row that leads to a limit switch has a warning, wherever the path lies") {
  const auto warned = [](double x, double travel) {
    const PointsFile file(std::to_string(x) + ",0\n" + std::to_string(x - 20) + ",0\n");
    PathOptions o;
    o.kind = PathKind::kPoints;
    o.points_file = file.name;
    return make_table(o, kCountMm, {-travel, travel}).warnings;
  };
  CHECK(warned(0, 20.1).empty());
  CHECK(warned(1000, 20.1).empty());
  REQUIRE(warned(1000, 9.9).size() == 1);
  CHECK(warned(1000, 9.9)[0] == "row 19: x = -9.998 mm from the start is at a limit switch or "
                                "beyond, out of range -9.9..9.9 mm; the program ends there");
}

TEST_CASE("an impossible row is refused with its number and the range") {
  PathOptions o = shape(PathKind::kSquare, 60, 5);
  o.row_mm = 0.7;
  CHECK_THROWS_WITH(table_of(o),
                    Catch::Contains("row 0: increments 139, 0 are out of range -127..127"));
  o.row_mm = 0.002;
  CHECK_THROWS_WITH(table_of(o), Catch::Contains("row 0: both increments are 0 counts"));
  CHECK_THROWS_WITH(Path(shape(PathKind::kSquare, 60, 31)),
                    "path.radius_mm: value 31 is out of range 0..30 at path.side_mm = 60");
}

TEST_CASE("a row of 127 counts is the longest, in each axis and sense") {
  for (const double most : {127.0, 128.0}) {
    PathOptions o = shape(PathKind::kCorner, 20 * most * kCountMm, 0);
    o.row_mm = most * kCountMm;
    CAPTURE(most);
    if (most > 127) {
      CHECK_THROWS_WITH(table_of(o), Catch::Contains("increments 128, 0 are out of range"));
      continue;
    }
    const Table table = table_of(o);
    REQUIRE(table.rows.size() == 40);
    for (std::size_t k = 0; k < 40; ++k) {
      CHECK(table.rows[k].dx == (k < 20 ? 127 : 0));
      CHECK(table.rows[k].dy == (k < 20 ? 0 : 127));
    }
  }
}

TEST_CASE("each shape begins along X, the circle along Y, and turns to the left") {
  for (const PathKind kind :
       {PathKind::kSquare, PathKind::kStar, PathKind::kCorner, PathKind::kCircle}) {
    const Path path(shape(kind, 100, kind == PathKind::kCircle ? 20 : 3));
    const PointMm first = path.at(1) - path.at(0);
    CAPTURE(static_cast<int>(kind), first.real(), first.imag());
    CHECK(std::arg(first) == Approx(kind == PathKind::kCircle ? plant::kPi / 2 + 0.025 : 0)
                                 .margin(1e-9));
    double turned = 0;
    for (double s = 1; s + 1 <= path.length(); ++s) {
      const PointMm was = path.at(s) - path.at(s - 1), is = path.at(s + 1) - path.at(s);
      turned += std::arg(is * std::conj(was));
      CHECK(std::arg(is * std::conj(was)) > -1e-6);
    }
    // In whole turns of their ends, but for the last mm: a star goes round twice.
    const double turns = kind == PathKind::kCorner ? 0.25 : kind == PathKind::kStar ? 2 : 1;
    CHECK(turned / (2 * plant::kPi) == Approx(turns).margin(0.02));
  }
}

TEST_CASE("the table is written with one line per row") {
  Table table;
  table.rows = {{1, 2, 255, 4, 99, -5}};
  CHECK(table_csv(table) == "c,cc,vx,vy,dx,dy\n1,2,255,4,99,-5\n");
  CHECK(listing_text(table) == "01 02 FF 04 FB 63\n");
}

TEST_CASE("a radius is taken up to the largest that its shape has room for, and no further") {
  const double side = 60;
  const std::pair<PathKind, double> shapes[] = {
      {PathKind::kSquare, side / 2},  // its lines are gone
      {PathKind::kStar, side / 2 / std::tan(0.4 * plant::kPi)},
      {PathKind::kCorner, side}};
  for (const auto& [kind, largest] : shapes) {
    CAPTURE(static_cast<int>(kind), largest);
    CHECK_NOTHROW(Path(shape(kind, side, 0.9999 * largest)));
    CHECK_THROWS_WITH(Path(shape(kind, side, 1.0001 * largest)),
                      fmt::format("path.radius_mm: value {:g} is out of range 0..{:.6g} at "
                                  "path.side_mm = 60", 1.0001 * largest, largest));
  }
  CHECK(Path(shape(PathKind::kCorner, side, side)).length() == Approx(side * plant::kPi / 2));
  CHECK_NOTHROW(Path(shape(PathKind::kCircle, side, 10 * side)));
}
