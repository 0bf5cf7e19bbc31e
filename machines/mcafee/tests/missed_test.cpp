// SPDX-License-Identifier: Apache-2.0
//
// Runs of the machine mcafee that end, but not where they were to go.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "machines/mcafee/machine.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

// Stage II by 1000 counts; the table is at `x` counts in sample n of 60.
template <class X>
std::string moved(const Options& options, X x) {
  Result result;
  for (int n = 0; n < 60; ++n) {
    Sample s;
    s.axis[0].x_mm = x(n) * options.count_mm();
    result.samples.push_back(s);
  }
  return what_missed(options, result);
}

Options move_of(int counts) {
  Options options;
  options.stage = sw::McafeeStage::kMove;
  options.position = counts;
  options.wait_s = 40 * options.sample_s();  // of which the last 10 samples count
  return options;
}

// A corner of 20 mm legs, or a file of points; the table is `beside_mm` off it in a row, and ends
// `short_mm` too early.
std::string tracked(Options options, double beside_mm, double short_mm = 0, int rows_left = 0) {
  if (options.path.points_file.empty()) {
    options.path.kind = PathKind::kCorner;
    options.path.side_mm = 20;
  }
  const Path path(options.path);
  Result result;
  result.table = make_table(options.path, options.count_mm());
  const auto rows = static_cast<int>(result.table.rows.size());
  for (int row = 0; row <= rows - rows_left; ++row) {
    Sample s;
    s.row = static_cast<std::uint32_t>(row);
    PointMm at = path.at(std::min(path.length(), result.table.row_mm * row)) - path.at(0);
    if (row == 10) at += PointMm(0, -beside_mm);
    if (row == rows) at -= PointMm(0, short_mm);
    s.axis[0].x_mm = at.real();
    s.axis[1].x_mm = at.imag();
    result.samples.push_back(s);
  }
  options.wait_s = 0;
  find_contour(options, result);
  return what_missed(options, result);
}

// Stage III in closed loop, by the twins.
Options small_corner() {
  Options options;
  options.run.engine = cosim::Engine::kTwin;
  options.run.platform = cosim::Platform::kDirect;
  options.path.kind = PathKind::kCorner;
  options.path.side_mm = 10;
  options.wait_s = 1;  // it arrives at full speed, and swings for 0.7 s
  options.diverged_counts = 32767;
  return options;
}

}  // namespace

TEST_CASE("mcafee: a table that is not at the target of its move, or swings there, has missed it") {
  Options options = move_of(1000);
  CHECK(moved(options, [](int n) { return n < 45 ? n * 20.0 : 1000.0; }) == "");
  CHECK(moved(options, [](int) { return 0.0; }) == "X ended 1000 counts from its target of 1000");
  CHECK(moved(options, [](int) { return 951.0; }) == "");
  CHECK(moved(options, [](int) { return 949.0; }) == "X ended 51 counts from its target of 1000");
  CHECK(moved(options, [](int n) { return n % 2 == 0 ? 974.0 : 1026.0; }) ==
        "X still moves by 52 counts at the end; trajectory.wait_s gives it time");
  options.reached_counts = 60;
  CHECK(moved(options, [](int n) { return n % 2 == 0 ? 974.0 : 1026.0; }) == "");
  CHECK(moved(move_of(8), [](int) { return 4.0; }) == "X ended 4 counts from its target of 8");
  options = move_of(1000);
  options.stage = sw::McafeeStage::kRead;
  CHECK(moved(options, [](int) { return 0.0; }) == "");
}

TEST_CASE("mcafee: a table beside its path, or not at its end, has missed it") {
  Options options;
  CHECK(tracked(options, 0) == "");
  CHECK(tracked(options, 6.9) == "");  // a quarter of a diagonal of 28.3 mm is 7.07 mm
  CHECK(tracked(options, 7.2) ==
        "the table was 1435 counts beside its path, above 1410 (run.reached_counts)");
  CHECK(tracked(options, 0, 0.2) == "");
  CHECK(tracked(options, 0, 0.3) == "Y ended 60 counts from its target of 3987");
  CHECK(tracked(options, 0, 0, 2) == "stopped after 74 of 76 rows");
  options.reached_counts = 100;
  CHECK(tracked(options, 0.6) ==
        "the table was 120 counts beside its path, above 100 (run.reached_counts)");
  CHECK(tracked(options, 0, 0.3) == "");
}

TEST_CASE("mcafee: each axis is held against its own target") {
  const test::Scratch scratch("mcafee_missed_test_out");
  std::filesystem::create_directories(scratch.path);
  Options options;
  options.path.kind = PathKind::kPoints;
  options.path.points_file = scratch.path / "points.csv";
  std::ofstream(options.path.points_file) << "0,0\n20,0\n20,10\n";
  CHECK(tracked(options, 0) == "");
  CHECK(tracked(options, 0, 0.3) == "Y ended 60 counts from its target of 1993");
  std::ofstream(options.path.points_file) << "0,0\n10,0\n10,20\n";
  CHECK(tracked(options, 0) == "");
  CHECK(tracked(options, 0, 0.3) == "Y ended 60 counts from its target of 3987");
}

TEST_CASE("mcafee: a part too far from its trajectory ends the run as diverged, either alone") {
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    Options options = small_corner();
    options.diverged_counts = 500;
    options.fault.kind = cosim::FaultKind::kPhaseOpen;
    options.fault.axis = axis;
    const Result result = simulate(options, {});
    CHECK(result.end == cosim::EndReason::kDiverged);
    const Sample last = result.samples.back();
    for (const int k : {0, 1}) {
      const int error = last.axis[static_cast<std::size_t>(k)].words.error;
      CAPTURE(k, error);
      CHECK((std::abs(error) > options.diverged_counts) == (k == axis));
    }
  }
}

TEST_CASE("mcafee: a table that cannot move has missed, one that can is done") {
  Options options = small_corner();
  CHECK(simulate(options, {}).end == cosim::EndReason::kDone);
  SECTION("along a path, held by friction") { options.stage_axis.motor.coulomb = 0.5; }
  SECTION("along a path, without a current") { options.stage_axis.motor.current_limit = 0.01; }
  SECTION("by Stage II") {
    options.stage = sw::McafeeStage::kMove;
    options.position = 2000;
    options.velocity = 0x20000;
    options.acceleration = 100;
    options.stage_axis.motor.coulomb = 0.5;
  }
  const Result result = simulate(options, {});
  CHECK(result.end == cosim::EndReason::kMissed);
  CHECK(machine().verdict(options, result) == "missed: " + result.fault);
  CHECK_FALSE(result.fault.empty());
}
