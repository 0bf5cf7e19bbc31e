// SPDX-License-Identifier: Apache-2.0
//
// McAfee's Stage III in closed loop with the leadscrew stage: firmware, port picture, twins of the
// two LM628, plant. F-09, F-10 and F-11 of the specification.

#include <catch2/catch.hpp>
#include <algorithm>
#include <vector>

#include "cosim/direct.hpp"
#include "machines/mcafee/session.hpp"
#include "machines/mcafee/twin.hpp"

using namespace trammel;
using namespace trammel::mcafee;

namespace {

constexpr double kClockS = 20e-9;
constexpr double kCountMm = 4.0132 / 800;

struct Tracked {
  std::vector<unsigned> speeds;  // v of each row
  double seconds = 0;            // from the first STT to the end of the trajectory
  double contour_mm = 0;         // largest distance of the table from the path
  double end_mm = 0;             // at the end
  cosim::Clk cut = 0;            // first edge that saw the limit switch of X
  cosim::Clk powered = 0;        // last one that saw a current toward it
  sw::McafeeFailure failure = sw::McafeeFailure::kNone;
};

// Looks at the table in every sample.
struct Follow final : cosim::Observer {
  const StagePlant& plant;
  const sw::McafeeApp& app;
  const Path& path;
  double row_mm;
  Tracked result;
  cosim::Clk begin = 0;

  Follow(const StagePlant& p, const sw::McafeeApp& a, const Path& way, double row)
      : plant(p), app(a), path(way), row_mm(row) {}

  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override {
    const plant::LeadscrewAxis& x = plant.stage().axis(0);
    if (x.sensor().at_high() && result.cut == 0) result.cut = stop.edge;
    if (result.cut != 0 && x.state(stop.edge).i > 0) result.powered = stop.edge;
    if ((stop.why & cosim::kSample) == 0 || app.mailbox().point == 0) return;
    if (begin == 0) begin = stop.edge;
    if (app.mailbox().point > result.speeds.size()) result.speeds.push_back(app.mailbox().speed);
    const PointMm moved{x.position(stop.edge), plant.stage().axis(1).position(stop.edge)};
    const PointMm at = path.at(0) + 1e3 * moved;
    result.end_mm = path.distance(at, row_mm * app.mailbox().point, 10);
    result.contour_mm = std::max(result.contour_mm, result.end_mm);
    if (!app.ending()) result.seconds = static_cast<double>(stop.edge - begin) * kClockS;
  }
};

Tracked track(const PathOptions& options, sw::McafeeSetup setup,
              const plant::XyStageConfig& stage = {}) {
  const Path path(options);
  const Table table = make_table(options, kCountMm);
  setup.rows = table.rows.data();
  setup.row_count = static_cast<std::uint32_t>(table.rows.size());
  TwinChip chip;
  StagePlant plant(stage);
  sw::McafeeApp app(setup);
  Follow follow(plant, app, path, table.row_mm);
  cosim::Loop loop(chip, plant, follow);
  cosim::run_direct(loop, app, {}, static_cast<cosim::Clk>(100 / kClockS),
                    [&] { return app.mailbox().done != 0; });
  follow.result.failure = static_cast<sw::McafeeFailure>(app.mailbox().failure);
  REQUIRE(app.mailbox().done);
  return follow.result;
}

sw::McafeeSetup square_setup(std::uint32_t speed) {
  sw::McafeeSetup setup;
  setup.filter = {255, 0, 3000, 0, 1};
  setup.least_speed = 40;
  setup.velocity_shift = 2;
  setup.speed = speed;
  return setup;
}

}  // namespace

TEST_CASE("F-09 ten rows ahead of a corner the speed falls to the least one") {
  PathOptions options;
  options.kind = PathKind::kCorner;
  options.side_mm = 102;
  options.radius_mm = 2;
  options.kappa_max_1_mm = 0.5;
  sw::McafeeSetup setup = square_setup(0);
  setup.least_speed = 8;
  const Tracked run = track(options, setup);
  CHECK(run.failure == sw::McafeeFailure::kNone);
  REQUIRE(run.speeds.size() == 406);
  for (std::size_t k = 0; k < 406; ++k) {
    CAPTURE(k);
    if (k < 190 || k > 206) REQUIRE(run.speeds[k] == 254);
    if (k == 190) REQUIRE(run.speeds[k] == 8);
    if (k >= 200 && k <= 206) REQUIRE(run.speeds[k] <= 40);
  }
}

TEST_CASE("F-10 self-paced, the square is followed more closely than fast, sooner than slow") {
  const PathOptions options;  // side 60, corners of 5 mm, rows of 0.5 mm, preview 10
  const Tracked fast = track(options, square_setup(254));
  const Tracked paced = track(options, square_setup(0));
  const Tracked slow = track(options, square_setup(40));
  CAPTURE(fast.contour_mm, paced.contour_mm, slow.contour_mm);
  CAPTURE(fast.seconds, paced.seconds, slow.seconds);
  CHECK(paced.contour_mm <= 0.6 * fast.contour_mm);
  CHECK(paced.seconds <= 0.6 * slow.seconds);
  CHECK(paced.end_mm < 0.1);
}

// DECOMP rounds velocities down, by up to one count in 40 here: were a row due when the axis with
// the longer distance arrives, the other would fall behind in every row of an oblique line, to
// 0.13 mm.
TEST_CASE("no axis is left behind: a slow circle is followed within 8 counts") {
  PathOptions options;
  options.kind = PathKind::kCircle;
  options.radius_mm = 20;
  const Tracked slow = track(options, square_setup(40));
  CHECK(slow.contour_mm < 8 * kCountMm);
}

TEST_CASE("F-11 a limit switch cuts the motor within a sample, and the program ends with it") {
  PathOptions options;
  options.kind = PathKind::kCorner;
  options.side_mm = 60;
  plant::XyStageConfig stage;
  stage[0].switch_high = 20.2e-3;  // amid a row, while the firmware sleeps
  const Tracked run = track(options, square_setup(40), stage);
  CHECK(run.failure == sw::McafeeFailure::kLimit);
  CHECK(run.speeds.size() < 45);  // 40.4 rows to the switch
  REQUIRE(run.cut > 0);
  CHECK(run.powered < run.cut + sw::McafeeSetup().sample_clk);
}
