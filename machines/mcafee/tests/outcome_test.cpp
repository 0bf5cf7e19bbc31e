// SPDX-License-Identifier: Apache-2.0
//
// Figures, events and misses of the machine mcafee in each axis and of each sign; runs that end,
// but not where they were to go.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "machines/mcafee/machine_members.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

Options moving() {
  Options options;
  options.stage = sw::McafeeStage::kMove;
  return options;
}

Result still(int samples) {
  Result result;
  result.end = cosim::EndReason::kDone;
  for (int n = 0; n < samples; ++n) {
    Sample s;
    s.edge = 50'000 * (n + 1);
    result.samples.push_back(s);
  }
  return result;
}

// The samples again, with one that is changed.
template <class Change>
void change(Result& result, std::size_t at, Change change) {
  host::DiskVector<Sample> all;
  for (std::size_t n = 0; n < result.samples.size(); ++n) {
    Sample s = result.samples[n];
    if (n == at) change(s);
    all.push_back(s);
  }
  result.samples = std::move(all);
}

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

// A corner of 20 mm legs; the table is `beside_mm` off it in a row, and ends
// `short_mm` too early.
std::string tracked(Options options, double beside_mm, double short_mm = 0, int rows_left = 0) {
  options.path.kind = PathKind::kCorner;
  options.path.side_mm = 20;
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

TEST_CASE("mcafee: each largest value is that of either axis and either sign, in any sample") {
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    for (const int sign : {1, -1}) {
      for (const std::size_t at : {std::size_t{0}, std::size_t{4}}) {
        CAPTURE(axis, sign, at);
        Result result = still(5);
        change(result, at, [&](Sample& s) {
          AxisSample& a = s.axis[axis];
          a.words.error = 17 * sign;
          a.words.speed = 3 * 65536 * sign;
          a.mm_s = 12.5 * sign;
          a.i = 2.25 * sign;
          a.volt = 99;
          a.x_mm = 88;
        });
        result.real = {111, 222};
        const auto of = [&](const char* id) { return test::figure(moving(), result, id); };
        CHECK(of("motion.max_error_counts") == 17);
        CHECK(of("motion.max_speed_mm_s") == 12.5);
        CHECK(of("motion.max_desired_mm_s") == Approx(3 * 4.0132 / 800 / (2048 / 6e6)));
        CHECK(of("motion.max_current_A") == 2.25);
        CHECK(of("real_count.0") == 111);
        CHECK(of("real_count.1") == 222);
      }
    }
  }
}

TEST_CASE("mcafee: a motion is that of either axis, from its first sample to its last") {
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    CAPTURE(axis);
    Result result = still(0);
    for (int n = 0; n < 12; ++n) {
      Sample s;
      s.axis[axis].words.position = std::int64_t{n < 3 ? 0 : n < 8 ? n : 8} << 16;
      result.samples.push_back(s);
    }
    CHECK(test::figure(moving(), result, "motion.time_s") == Approx(5 * 2048 / 6e6));
    CHECK(result.first == 3);
  }
}

TEST_CASE("mcafee: an event is told of its axis, at the sample where it begins, with its words") {
  struct Case {
    const char* what;
    void (*make)(Sample&, std::size_t);
  };
  const Case cases[] = {
      {"interrupt", [](Sample& s, std::size_t a) { s.axis[a].host_irq = true; }},
      {"motor off", [](Sample& s, std::size_t a) { s.axis[a].words.status |= 0x80; }},
      {"low switch open", [](Sample& s, std::size_t a) { s.limits |= 1u << 2 * a; }},
      {"high switch open", [](Sample& s, std::size_t a) { s.limits |= 2u << 2 * a; }}};
  for (const Case& one : cases) {
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      CAPTURE(one.what, axis);
      Result result = still(5);
      change(result, 3, [&](Sample& s) {
        for (std::size_t k = 0; k < 2; ++k) {
          const int n = k == axis ? 0 : 50;
          s.axis[k].words.position = std::int64_t{-7 - n} * 65536;
          s.axis[k].words.actual = 11 + n;
          s.axis[k].words.status = 0x04;
        }
        one.make(s, axis);
      });
      figures(moving(), result);
      REQUIRE_FALSE(result.events.empty());
      const Event& e = result.events.front();
      CHECK(e.what == one.what);
      CHECK(e.axis == static_cast<int>(axis));
      CHECK(e.sample == 3);
      CHECK(e.time_s == Approx(4e-3));
      CHECK(e.desired == -7);
      CHECK(e.real == 11);
      CHECK(e.status == (one.what == std::string("motor off") ? 0x84u : 0x04u));
      const bool closes = result.events.size() == 2;
      CHECK(closes == (one.what[0] == 'l' || one.what[0] == 'h'));
      if (closes) CHECK(result.events[1].sample == 4);
      nlohmann::ordered_json json;
      const auto record =
          lab::judged(moving().clone(), std::make_unique<Result>(std::move(result)));
      add_metrics(record, json);
      CHECK(json["events"][0].dump() ==
            std::string(R"({"sample":3,"time_s":0.004,"axis":")") + (axis == 0 ? "x" : "y") +
                R"(","what":")" + one.what + R"(","desired_count":-7,"real_count":11,"status":)" +
                (one.what == std::string("motor off") ? "132}" : "4}"));
    }
  }
}

TEST_CASE("mcafee: the target of a move is missed on both sides of it, and of zero") {
  for (const int target : {1000, -1000}) {
    for (const int off : {49, -49, 51, -51}) {
      CAPTURE(target, off);
      Options options = moving();
      options.position = target;
      Result result = still(0);
      for (int n = 0; n < 60; ++n) {
        Sample s;
        s.axis[0].x_mm = (target + off) * options.count_mm();
        s.axis[1].x_mm = 1234;  // not of this stage
        result.samples.push_back(s);
      }
      CHECK(what_missed(options, result) ==
            (std::abs(off) <= 50 ? ""
                                 : "X ended 51 counts from its target of " +
                                       std::to_string(target)));
    }
  }
}

TEST_CASE("mcafee: each axis is held against its target, the table against its path, by sides") {
  Options options;
  options.path.kind = PathKind::kCorner;
  options.path.side_mm = 20;
  options.reached_counts = 100;
  options.wait_s = 0;
  const Path path(options.path);
  const Table table = make_table(options.path, options.count_mm());
  const auto rows = table.rows.size();
  double sum[2] = {};
  for (const sw::McafeeRow& row : table.rows) sum[0] += row.dx, sum[1] += row.dy;
  const auto missed = [&](std::size_t axis, double at_end, double on_way) {
    Result result = still(0);
    result.table = table;
    for (std::size_t row = 0; row <= rows; ++row) {
      Sample s;
      s.row = static_cast<std::uint32_t>(row);
      const PointMm at =
          path.at(std::min(path.length(), table.row_mm * static_cast<double>(row))) - path.at(0);
      double counts[2] = {at.real() / options.count_mm(), at.imag() / options.count_mm()};
      if (row == rows) counts[0] = sum[0], counts[1] = sum[1];
      if (row == rows) counts[axis] += at_end;
      if (row == (axis == 1 ? rows / 4 : 3 * rows / 4)) counts[axis] += on_way;
      s.axis[0].x_mm = counts[0] * options.count_mm();
      s.axis[1].x_mm = counts[1] * options.count_mm();
      result.samples.push_back(s);
    }
    find_contour(options, result);
    return what_missed(options, result);
  };
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    for (const double sign : {1.0, -1.0}) {
      CAPTURE(axis, sign);
      CHECK(missed(axis, 99 * sign, 0) == "");
      CHECK(missed(axis, 101 * sign, 0) ==
            std::string(axis == 0 ? "X" : "Y") + " ended 101 counts from its target of " +
                std::to_string(std::lround(sum[axis])));
      CHECK(missed(axis, 0, 95 * sign) == "");
      CHECK(missed(axis, 0, 105 * sign).find("counts beside its path, above 100") !=
            std::string::npos);
    }
  }
}

TEST_CASE("mcafee: a table that is not at the target of its move, or swings there, has missed it") {
  Options options = move_of(1000);
  CHECK(moved(options, [](int n) { return n < 45 ? n * 20.0 : 1000.0; }) == "");
  CHECK(moved(options, [](int) { return 0.0; }) == "X ended 1000 counts from its target of 1000");
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
  CHECK(tracked(options, 1.4) == "");  // a twentieth of a diagonal of 28.3 mm is 1.41 mm
  CHECK(tracked(options, 1.5) ==
        "the table was 299 counts beside its path, above 282 (run.reached_counts)");
  CHECK(tracked(options, 0, 0.2) == "");
  CHECK(tracked(options, 0, 0.3) == "Y ended 60 counts from its target of 3987");
  CHECK(tracked(options, 0, 0, 2) == "stopped after 74 of 76 rows");
  options.reached_counts = 100;
  CHECK(tracked(options, 0.6) ==
        "the table was 120 counts beside its path, above 100 (run.reached_counts)");
  CHECK(tracked(options, 0, 0.3) == "");
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
