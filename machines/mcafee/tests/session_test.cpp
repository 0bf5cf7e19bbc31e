// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine mcafee records, held against its stage driven once more with the codes
// that the chip drove: whatever is of the other axis, of the other sense, or early differs.
#include <catch2/catch.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "machines/mcafee/machine_members.hpp"
#include "machines/mcafee/session.hpp"
#include "tests/support/event_record.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

constexpr std::array<const char*, 2> kName{"X", "Y"};
constexpr cosim::Lines kOff = codes(kZeroCode, kZeroCode);

// Some rows around a small corner, by the twin.
Options small_corner() {
  Options options;
  options.run.engine = cosim::Engine::kTwin;
  options.run.platform = cosim::Platform::kDirect;
  options.path.kind = PathKind::kCorner;
  options.path.side_mm = 2;
  options.path.radius_mm = 1;
  options.path.kappa_max_1_mm = 1;
  options.path.preview_rows = 2;
  options.wait_s = 0.02;
  return options;
}

using Run = test::Recorded<Result>;

// Calls after(event, plant) behind each event of the run.
template <class After>
void replay(const Options& options, const Run& run, After after) {
  StagePlant plant({options.stage_axis, options.stage_axis});
  cosim::Lines drive = kOff;
  for (const test::Event& event : run.events) {
    while (plant.next() < event.edge) plant.commit(plant.next(), drive);
    plant.commit(event.edge, drive = event.drive);
    after(event, plant);
  }
}

double mm_of(const StagePlant& plant, std::size_t axis, cosim::Clk edge) {
  return 1e3 * plant.stage().axis(axis).position(edge);
}

}  // namespace

TEST_CASE("mcafee: the program is told every option, none of which has its default") {
  Options options;
  options.stage = sw::McafeeStage::kMove;
  options.filter = {11, 12, 13, 14, 15};
  options.clock_MHz = 8;
  options.acceleration = 21;
  options.velocity = 22;
  options.position = -23;
  options.readings = 24;
  options.speed = 25;
  options.least_speed = 26;
  options.velocity_shift = 7;
  options.wait_s = 0.125;
  options.error_limit = 28;
  options.stage_axis.encoder.lines = 29;
  options.run.clock_ps = 40'000;
  Table table;
  table.rows.resize(31);
  for (const bool check : {false, true}) {
    options.index_check = check;
    const sw::McafeeSetup setup = setup_of(options, table);
    const std::map<std::string, std::pair<std::int64_t, std::int64_t>> told{
        {"stage", {static_cast<int>(setup.stage), static_cast<int>(options.stage)}},
        {"filter.kp", {setup.filter.kp, 11}},
        {"filter.ki", {setup.filter.ki, 12}},
        {"filter.kd", {setup.filter.kd, 13}},
        {"filter.il", {setup.filter.il, 14}},
        {"filter.interval", {setup.filter.interval, 15}},
        {"wait_clk", {setup.wait_clk, 3'125'000}},
        {"sample_clk", {setup.sample_clk, 6'400}},  // 2048 ticks of 8 MHz
        {"readings", {setup.readings, 24}},
        {"acceleration", {setup.acceleration, 21}},
        {"velocity", {setup.velocity, 22}},
        {"position", {setup.position, -23}},
        {"row_count", {setup.row_count, 31}},
        {"speed", {setup.speed, 25}},
        {"least_speed", {setup.least_speed, 26}},
        {"velocity_shift", {setup.velocity_shift, 7}},
        {"error_limit", {setup.error_limit, 28}},
        {"index_counts", {setup.index_counts, check ? 4 * 29 : 0}}};
    for (const auto& [name, pair] : told) {
      INFO(name << " of setup_of");
      CHECK(pair.first == pair.second);
    }
    CHECK(setup.rows == table.rows.data());
  }
}

TEST_CASE("mcafee: each sample is of its own axis, as its codes move it") {
  Options options = small_corner();
  const Run run = test::record_run<Session, Result>(options);
  REQUIRE(run.result.end == cosim::EndReason::kDone);
  std::size_t sample = 0;
  std::array<double, 2> forward{}, back{}, current{};
  replay(options, run, [&](const test::Event& event, const StagePlant& plant) {
    if ((event.why & cosim::kSample) == 0) return;
    REQUIRE(sample < run.result.samples.size());
    const Sample s = run.result.samples[sample++];
    INFO("sample " << sample - 1 << ", clock " << event.edge);
    REQUIRE(s.edge == event.edge);
    REQUIRE(s.limits == plant.limits());
    for (std::size_t k = 0; k < 2; ++k) {
      const plant::LeadscrewAxis& axis = plant.stage().axis(k);
      const plant::DcMotorState state = axis.state(event.edge);
      const AxisSample& is = s.axis[k];
      INFO("axis " << kName[k] << ": x_mm " << is.x_mm << ", mm_s " << is.mm_s << ", i " << is.i
                   << ", volt " << is.volt << "; replayed theta " << state.theta << ", omega "
                   << state.omega << ", i " << state.i << ", volt " << axis.voltage());
      const double mm = 1e3 * options.stage_axis.pitch / (2 * plant::kPi);
      REQUIRE(is.x_mm == Approx(mm * state.theta).margin(1e-9));
      REQUIRE(is.mm_s == Approx(mm * state.omega).margin(1e-9));
      REQUIRE(is.i == Approx(state.i).margin(1e-9));
      const double code = static_cast<double>(mcafee::code(event.drive, static_cast<int>(k)));
      REQUIRE(is.volt == Approx((code - 128) / 128 * options.stage_axis.motor.supply));
      // The parts count in the sense in which the table moves.
      REQUIRE(is.words.actual == Approx(is.x_mm / options.count_mm()).margin(1.5));
      forward[k] = std::max(forward[k], is.mm_s);
      back[k] = std::min(back[k], is.i);
      current[k] = std::max(current[k], is.i);
    }
  });
  CHECK(sample == run.result.samples.size());
  for (std::size_t k = 0; k < 2; ++k) {
    INFO("axis " << kName[k]);
    CHECK(forward[k] > 1);     // it moved, and was
    CHECK(back[k] < -0.1);     // pushed in both senses
    CHECK(current[k] > 0.1);
  }
}

// A run with a fault whose report is what the replayed stage and the codes say.
void check_report(const Options& options, bool into_switch = false) {
  const Run run = test::record_run<Session, Result>(options);
  const cosim::FaultReport& report = run.result.fault_report;
  CAPTURE(kName[static_cast<std::size_t>(options.fault.axis)], run.result.fault, report.by,
          run.result.seconds(run.events.back().edge));
  REQUIRE(run.result.end == cosim::EndReason::kFault);
  CHECK(report.by == run.result.fault);
  CHECK(report.begin == std::llround(options.fault.begin_s / 20e-9));
  CHECK(report.detected > report.begin);
  double peak_A = 0;
  bool at_stop = false;
  cosim::Clk off = cosim::kNever;
  std::array<double, 2> off_at{}, end_at{};
  replay(options, run, [&](const test::Event& event, const StagePlant& plant) {
    if (event.edge < report.begin) return;
    at_stop = at_stop || plant.limits() != 0;
    for (std::size_t k = 0; k < 2; ++k) {
      peak_A = std::max(peak_A, std::abs(plant.stage().axis(k).state(event.edge).i));
      end_at[k] = mm_of(plant, k, event.edge);
    }
    if (event.edge >= report.detected && event.drive == kOff && off == cosim::kNever) {
      off = event.edge;
      off_at = end_at;
    }
  });
  // It is recorded until it stands, but for two samples and for no longer than 2000.
  int since = 0;
  for (const Sample& s : run.result.samples) {
    if (s.edge < report.detected) continue;
    const bool last = s.edge == run.result.samples.back().edge;
    const bool stands = std::hypot(s.axis[0].mm_s, s.axis[1].mm_s) < 0.1;
    INFO("sample " << since << " behind the failure, the last one: " << last);
    if (++since > 2 && since <= 2000) CHECK(stands == last);
  }
  CHECK(since > 2);
  CHECK(report.off == off);
  CHECK(report.peak_A == Approx(peak_A));
  CHECK(report.at_stop == at_stop);
  CHECK(report.at_stop == into_switch);
  CHECK(report.unit == "mm");
  CHECK(report.stopping ==
        Approx(std::hypot(end_at[0] - off_at[0], end_at[1] - off_at[1])).margin(1e-6));
}

TEST_CASE("mcafee: what became of a fault is told of either axis, from its clocks and places") {
  for (int axis = 0; axis < 2; ++axis) {
    Options options = small_corner();
    options.error_limit = 200;
    options.fault.kind = cosim::FaultKind::kEncoderStuck;
    options.fault.axis = axis;
    options.fault.begin_s = axis == 0 ? 0.06 : 0.25;
    check_report(options);
  }
}

Options move(int counts) {
  Options options = small_corner();
  options.stage = sw::McafeeStage::kMove;
  options.position = counts;
  options.acceleration = 0x1000;
  options.wait_s = 0.1;
  options.run.max_s = 1;
  return options;
}

TEST_CASE("mcafee: what became of a fault is told in either sense, into a switch or not") {
  for (const int counts : {1500, -1500}) {
    for (const bool into_switch : {false, true}) {
      CAPTURE(counts, into_switch);
      Options options = move(counts);
      options.error_limit = into_switch ? 0 : 200;
      options.diverged_counts = 32767;
      options.stage_axis.switch_low = into_switch ? -2e-3 : -0.1;
      options.stage_axis.switch_high = into_switch ? 2e-3 : 0.1;
      options.fault.kind = cosim::FaultKind::kEncoderStuck;
      options.fault.begin_s = 0.03;
      check_report(options, into_switch);
    }
  }
}

TEST_CASE("mcafee: Stage II moves X to its position, and its progress is the share of the way") {
  for (const int counts : {1500, -1500}) {
    const Options options = move(counts);
    std::vector<double> told;
    cosim::Hooks hooks;
    hooks.progress = [&told](double share) { told.push_back(share); };
    const Result result = simulate(options, hooks);
    CAPTURE(counts, result.fault, result.real[0], result.real[1]);
    CHECK(std::abs(result.real[0] - counts) < 60);
    CHECK(result.real[1] == 0);
    REQUIRE(told.size() > 5);
    CHECK(told.front() < 0.1);
    CHECK(told.back() == Approx(1).margin(0.05));
    for (const double share : told) CHECK((share >= 0 && share <= 1));
  }
}

TEST_CASE("mcafee: a run that ends early tells the places of both axes where it ended") {
  Options options = small_corner();
  const auto ended = [](const Options& asked) {
    return test::record_run<Session, Result>(asked).result;
  };
  const Result whole = ended(options);
  REQUIRE(whole.end == cosim::EndReason::kDone);
  const Sample rest = whole.samples.back();
  std::int64_t apart = 0;
  for (const double share : {0.2, 0.4, 0.6}) {
    options.run.max_s = share * options.run.seconds(rest.edge);
    const Result result = ended(options);
    CAPTURE(share, result.real[0], result.real[1]);
    CHECK(result.end == cosim::EndReason::kTimeout);
    const Sample last = result.samples.back();
    for (std::size_t k = 0; k < 2; ++k) {
      CAPTURE(kName[k]);
      CHECK(result.real[k] == last.axis[k].words.actual);
      // A count is behind by the encoder's hysteresis and by a sample's motion.
      CHECK(static_cast<double>(result.real[k]) ==
            Approx(last.axis[k].x_mm / options.count_mm()).margin(2));
    }
    apart = std::max<std::int64_t>(apart, std::abs(result.real[0] - result.real[1]));
  }
  CHECK(apart > 100);
}
