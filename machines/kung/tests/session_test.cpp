// SPDX-License-Identifier: Apache-2.0
//
// What a run of the X-Y table records, held against the table driven once more with the gates that
// the chip drove: whatever is of the other axis, of the other sense, or early differs.
#include <catch2/catch.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "lab/machine.hpp"
#include "machines/kung/run/session.hpp"
#include "tests/support/event_record.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr std::array<const char*, 2> kName{"X", "Y"};

using Run = test::Recorded<Result>;

// The first of a circle, by the twin; the axes are unlike in what they carry and in their motors.
Options unlike(double seconds) {
  Options options;
  options.run.engine = Engine::kTwin;
  options.run.platform = Platform::kDirect;
  options.run.max_s = seconds;
  options.plant.axis[0].payload_kg = 2;
  options.plant.axis[1].coulomb_n = 9;
  options.plant.axis[1].cogging_n = 6;
  options.plant.axis[0].external_force_n = 11;
  options.plant.axis[1].external_force_n = -17;
  return options;
}

// Calls after(event, table) behind each event of the run.
template <class After>
void replay(const Options& options, const Run& run, After after) {
  plant::XyTableConfig config = options.plant;
  const Sample first = run.result.samples[0];
  for (std::size_t k = 0; k < 2; ++k) {  // where the path begins
    config.axis[k].start_m = std::round(first.axis[k].x_true_m / config.axis[k].encoder_count_m) *
                             config.axis[k].encoder_count_m;
  }
  plant::XyTable table(config);
  cosim::Lines drive = 0;
  for (const test::Event& event : run.events) {
    while (table.next() < event.edge) table.commit(table.next(), drive);
    table.commit(event.edge, drive = event.drive);
    after(event, table);
  }
}

}  // namespace

TEST_CASE("the truth of each sample is that of its own axis, as its gates move it") {
  const Options options = unlike(0.06);
  const Run run = test::record_run<Session, Result>(options);
  REQUIRE(run.result.samples.size() > 80);
  CHECK(run.result.end == EndReason::kTimeout);
  std::size_t sample = 0;
  bool ticked = false;
  std::array<double, 2> least{}, most{};
  cosim::Clk tick = 0;
  std::array<plant::AxisState, 2> truth{};
  replay(options, run, [&](const test::Event& event, const plant::XyTable& table) {
    if ((event.why & cosim::kTick) != 0) {
      ticked = true;
      tick = event.edge;
      for (int k = 0; k < 2; ++k) truth[static_cast<std::size_t>(k)] = table.state(k, event.edge);
    }
    if ((event.why & cosim::kSample) == 0) return;
    REQUIRE(ticked);
    const Sample s = run.result.samples[sample++];
    INFO("tick " << s.tick << ", clock " << tick);
    REQUIRE(s.edge == tick);
    REQUIRE(s.tick == sample);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto check = [&](const char* what, double is, double asked) {
        INFO("axis " << kName[k] << ": " << what);
        REQUIRE(is == Approx(asked).margin(1e-9));
      };
      check("place", s.axis[k].x_true_m, truth[k].x_m);
      check("speed", s.axis[k].v_true_m_s, truth[k].v_m_s);
      check("d current", s.axis[k].i_d_true_A, truth[k].i_d_a);
      check("q current", s.axis[k].i_q_true_A, truth[k].i_q_a);
      check("force", s.axis[k].force_N, truth[k].force_n);
      check("link", s.axis[k].dc_link_V, truth[k].dc_link_v);
      least[k] = std::min(least[k], s.axis[k].force_N);
      most[k] = std::max(most[k], s.axis[k].force_N);
      if (s.tick < run.result.first_tick) continue;  // before it knows where it is
      const double count_m = options.plant.axis[k].encoder_count_m;
      INFO("axis " << kName[k] << ": encoder " << s.axis[k].x_p);
      REQUIRE(std::abs(s.axis[k].x_p * count_m - s.axis[k].x_true_m) < count_m);
    }
  });
  CHECK(sample == run.result.samples.size());
  CHECK(run.result.first_tick > 0);
  CHECK(run.result.first_tick < 60);
  CHECK(most[0] > 5);    // against 11 N
  CHECK(least[1] < -5);  // against -17 N
}

TEST_CASE("what became of a trip is told of either axis, from its clocks, currents and places") {
  for (int axis = 0; axis < 2; ++axis) {
    Options options = unlike(0.3);
    options.fault.kind = cosim::FaultKind::kConverterSaturated;
    options.fault.axis = axis;
    options.fault.line = axis;
    options.fault.value = axis == 0 ? 1 : -1;
    options.fault.begin_s = 0.05;
    const Run run = test::record_run<Session, Result>(options);
    const cosim::FaultReport& report = run.result.fault_report;
    const char* const name = kName[static_cast<std::size_t>(axis)];
    CAPTURE(name, run.result.fault_text(), report.by, report.detected);
    REQUIRE(run.result.end == EndReason::kFault);
    CHECK(run.result.fault.axis == axis);
    CHECK_THAT(report.by, Catch::Contains(std::string("axis ") + name));
    CHECK(report.by.find(std::string("axis ") + kName[1 - static_cast<std::size_t>(axis)]) ==
          std::string::npos);
    CHECK(report.begin == 2'500'000);
    double peak_A = 0;
    cosim::Clk off = cosim::kNever;
    std::array<double, 2> off_at{}, end_at{};
    replay(options, run, [&](const test::Event& event, const plant::XyTable& table) {
      if (event.edge < report.begin) return;
      for (std::size_t k = 0; k < 2; ++k) {
        const plant::AxisState s = table.state(static_cast<int>(k), event.edge);
        peak_A = std::max({peak_A, std::abs(s.i_a_a), std::abs(s.i_b_a),
                           std::abs(s.i_a_a + s.i_b_a)});
        end_at[k] = 1e3 * s.x_m;
      }
      if (event.edge >= report.detected && event.drive == 0 && off == cosim::kNever) {
        off = event.edge;
        off_at = end_at;
      }
    });
    CHECK(report.off == off);
    CHECK(report.peak_A == Approx(peak_A));
    CHECK(report.stopping ==
          Approx(std::hypot(end_at[0] - off_at[0], end_at[1] - off_at[1])).margin(1e-6));
  }
}

TEST_CASE("a whole run ends with its settling after its last point, whose ticks it tells") {
  for (const double settle_s : {0.0, 0.01}) {
    Options options = unlike(2);
    options.path.kind = PathKind::kLine;
    options.path.line_end_x_m = 0.101;
    options.path.line_end_y_m = 0.1;
    options.path.line_ticks = 20;
    options.settle_s = settle_s;
    options.diverged_m = 0.1;
    options.reached_m = 0.05;
    std::vector<double> told;
    cosim::Hooks hooks;
    hooks.progress = [&told](double share) { told.push_back(share); };
    const Result result = simulate(options, hooks);
    CAPTURE(settle_s, result.missed, result.fault_text());
    REQUIRE(result.end == EndReason::kDone);
    CHECK(result.points == 21);
    CHECK(result.first_tick > 0);
    CHECK(result.end_tick == result.first_tick + 21 * 4);  // a point lasts four position samples
    CHECK(result.samples.back().tick == result.end_tick - 1 + (settle_s > 0 ? 20 : 0));
    CHECK(result.samples.size() == result.samples.back().tick);
    const Sample last = result.samples.back();
    CHECK(result.from_last_m == Approx(std::hypot(last.axis[0].x_true_m - 0.101,
                                                  last.axis[1].x_true_m - 0.1)).margin(1e-7));
    REQUIRE(told.size() > 2);
    for (std::size_t k = 1; k < told.size(); ++k) CHECK(told[k] > told[k - 1]);
    CHECK(told.back() <= 1);
    CHECK(told.back() > 0.7);
  }
}
