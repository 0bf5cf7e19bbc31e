// SPDX-License-Identifier: Apache-2.0
//
// What is told of a run of the machine mcafee: figures, verdicts, runs beside it, pictures, in each
// stage; what its session says of itself, its triggers, and what the verb `track` writes.
// docs/figures.md lists the figures.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cosim/direct.hpp"
#include "cosim/trigger.hpp"
#include "cosim/trigger_search.hpp"
#include "lab/record.hpp"
#include "machines/mcafee/machine_members.hpp"
#include "machines/mcafee/session.hpp"
#include "testbench/arguments.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::mcafee;
using Lines = std::vector<std::string>;
using Stage = sw::McafeeStage;

namespace {

Options quick_move(int counts) {
  Options options;
  options.run.engine = cosim::Engine::kTwin;
  options.run.platform = cosim::Platform::kDirect;
  options.stage = Stage::kMove;
  options.position = counts;
  options.acceleration = 0x1000;
  options.wait_s = 0.05;
  options.run.max_s = 1;
  return options;
}

int track(const testbench::Arguments& arguments) {
  const auto& verbs = testbench::machine_verbs();
  const auto verb = std::find_if(verbs.begin(), verbs.end(),
                                 [](const testbench::Verb& one) { return one.name == "track"; });
  REQUIRE(verb != verbs.end());
  std::atomic<bool> stop{false};
  return verb->perform(arguments, stop);
}

std::string printed(const testbench::Arguments& arguments) {
  return test::on_stdout([&] { CHECK(track(arguments) == 0); });
}

}  // namespace

TEST_CASE("mcafee: rows, contour errors and overshoot of a path are those of its samples") {
  Options options;
  options.path.kind = PathKind::kCorner;
  options.path.side_mm = 20;
  const Path path(options.path);
  Result result;
  result.table = make_table(options.path, options.count_mm());
  const auto rows = result.table.rows.size();
  for (std::size_t k = 0; k <= rows + 3; ++k) {
    const std::size_t row = std::min(rows, k);
    PointMm at = path.at(std::min(path.length(), result.table.row_mm * static_cast<double>(row))) -
                 path.at(0);
    if (k == 5) at += PointMm(0, -0.5);        // beside its first leg
    if (k == rows + 1) at += PointMm(0, 0.3);  // behind its end
    if (k == rows + 3) at += PointMm(0.2, 0);  // beside it at the end
    Sample s;
    s.row = static_cast<std::uint32_t>(row);
    s.axis[0].x_mm = at.real();
    s.axis[1].x_mm = at.imag();
    s.axis[0].words.position = static_cast<std::int64_t>(k) * 65536;
    result.samples.push_back(s);
  }
  const auto of = [&](const std::string& id) {
    return test::figure(options, result, "motion." + id);
  };
  CHECK(of("rows") == static_cast<double>(rows));
  CHECK(of("contour_max_mm") == Approx(0.5));
  CHECK(of("contour_max_s") == Approx(4 * options.sample_s()));  // from row 1 on
  CHECK(of("contour_end_mm") == Approx(0.2));
  CHECK(of("overshoot_mm") == Approx(0.3).margin(0.02));
  CHECK(of("time_s") == Approx(static_cast<double>(rows + 2) * options.sample_s()));
}

TEST_CASE("mcafee: beside a run that compares go its path at 254 and at the least speed, no more") {
  Options options;
  options.compare = true;
  options.least_speed = 33;
  options.run.wave = cosim::WaveFormat::kFst;
  options.wait_s = 0.125;
  const auto beside = machine().compared.companions(options);
  REQUIRE(beside.size() == 2);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const auto& other = static_cast<const Options&>(*beside[k].settings);
    CAPTURE(k);
    CHECK(beside[k].name == (k == 0 ? "v = 254" : "v = 33"));
    CHECK(other.speed == (k == 0 ? 254 : 33));
    CHECK(other.run.wave == cosim::WaveFormat::kNone);
    CHECK(other.wait_s == 0.125);
  }
  CHECK(machine().compared.run_name(options) == "self-paced");
  options.speed = 77;
  CHECK(machine().compared.run_name(options) == "v = 77");
  options.compare = false;
  CHECK(machine().compared.companions(options).empty());
  options.compare = true;
  for (const auto stage : {Stage::kRead, Stage::kMove}) {
    options.stage = stage;
    CHECK(machine().compared.companions(options).empty());
    CHECK(machine().compared.run_name(options) == "motion");
    CHECK(machine().texts.warnings(options).empty());
  }
}

TEST_CASE("mcafee: metrics and pictures begin where the path does, of other stages at the start") {
  for (const auto stage : {Stage::kMove, Stage::kTrack}) {
    Options options;
    options.stage = stage;
    Result result;
    for (int n = 0; n < 6; ++n) {
      Sample s;
      s.row = n < 3 ? 0 : 1;
      s.axis[1].words.position = n < 2 ? 0 : 65536;
      result.samples.push_back(s);
    }
    const lab::Record record =
        lab::judged(options.clone(), std::make_unique<Result>(std::move(result)));
    nlohmann::ordered_json json;
    add_metrics(record, json);
    CAPTURE(static_cast<int>(stage));
    CHECK(json["run"]["first_sample"] == (stage == Stage::kTrack ? 3 : 0));
    CHECK(json["events"].empty());
    CHECK(machine().files.drawn(record).first == (stage == Stage::kTrack ? 3u : 2u));
    CHECK(machine().files.drawn(record).last == 6);
    CHECK(tracking_json(record).is_null() == (stage == Stage::kMove));
  }
}

TEST_CASE("mcafee: a session tells its clock, its processor, its end and the place of each axis") {
  Options options = quick_move(1500);
  test::set_timing(options);
  const std::unique_ptr<cosim::Session> session = machine().session(options, {}, {});
  test::check_timing(*session, 20'000);
}

TEST_CASE("mcafee: a run ends where its trigger is found, at the place of its own axis") {
  for (const int counts : {1500, -1500}) {
    const Options options = quick_move(counts);
    const char* const text = counts > 0 ? "x.real_count > 1000" : "x.real_count < -1000";
    cosim::TriggerSearch search(cosim::parse_trigger(text, triggers(), 20'000));
    cosim::Waves waves;
    waves.search = &search;
    Session session(options, {}, waves);
    test::run_through(session);
    REQUIRE(search.found());
    const auto places = session.places();
    REQUIRE(places.size() == 2);
    CHECK(places[0].axis == "x");
    CHECK(places[1].axis == "y");
    CHECK(places[0].unit == "mm");
    CHECK(places[1].unit == "mm");
    const double at_mm = (counts > 0 ? 1000 : -1000) * options.count_mm();
    CHECK(places[0].value == Approx(at_mm).margin(0.1));
    CHECK(places[1].value == Approx(0).margin(1e-9));
    const auto run = session.result();
    const auto& result = static_cast<const Result&>(*run);
    CHECK(result.end == cosim::EndReason::kDone);
    CHECK(result.fault == "");  // it is not asked whether it arrived
    CHECK(result.samples.back().edge == *search.found());
    CHECK(std::abs(result.samples[result.samples.size() - 2].axis[0].words.actual) <= 1000);
  }
}

TEST_CASE("mcafee: a run can be stopped, and tells its readings in Stage I alone") {
  std::atomic<bool> stop{false};
  cosim::Hooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&stop](double) { stop = true; };  // told after 64 samples
  const Result stopped = simulate(quick_move(1500), hooks);
  CHECK(stopped.end == cosim::EndReason::kStopped);
  CHECK(stopped.samples.size() == 64);
  CHECK(stopped.readings == 0);
  Options reading = quick_move(0);
  reading.stage = Stage::kRead;
  reading.readings = 5;
  reading.wait_s = 5e-3;
  Result read = simulate(reading, {});
  CHECK(read.end == cosim::EndReason::kDone);
  CHECK(read.readings == 5);
  CHECK(test::figure(reading, read, "readings") == 5);
}

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
