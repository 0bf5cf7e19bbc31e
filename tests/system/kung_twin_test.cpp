// SPDX-License-Identifier: Apache-2.0
//
// The controllers of the chip in closed loop against their twins fed with the same inputs.
#include <catch2/catch.hpp>

#include "cosim/kung/plan.hpp"
#include "cosim/kung/session.hpp"
#include "models/exact/control/afc.hpp"
#include "models/exact/drive/current_loop.hpp"
#include "systemc/machines/kung.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

fixed::Gain gain(const sw::Gain& g) { return {g.mant, g.exp}; }

exact::Afc::Config afc_config(const sw::AxisSetup& s) {
  return {gain(s.kp),
          gain(s.ki),
          gain(s.kv),
          gain(s.eta),
          static_cast<int>(s.shift_e),
          static_cast<int>(s.shift_de),
          static_cast<std::int32_t>(s.a0),
          static_cast<std::int32_t>(s.b2),
          s.adapt,
          s.feedforward};
}

}  // namespace

TEST_CASE("whole circle: every word of both controllers equals the twin's at every sample") {
  Options options;
  options.run.platform = Platform::kDirect;
  Session session(options, {});
  std::vector<sw::Point> points;
  const sw::KungSetup setup = plan_firmware(options, points);

  cosim::run_direct(session.loop(), session.firmware(), session.timing(), session.end(),
                    [&session] { return session.finished(); });
  std::array<std::array<std::int32_t, 49>, 2> rules{};
  for (int axis = 0; axis < 2; ++axis) {
    for (int rule = 0; rule < 49; ++rule) {
      rules[static_cast<std::size_t>(axis)][static_cast<std::size_t>(rule)] =
          session.chip().rule(axis, rule);
    }
  }
  const Result result = session.result();
  REQUIRE(result.end == EndReason::kDone);
  REQUIRE(result.samples.size() >= 2516);

  for (std::size_t axis = 0; axis < 2; ++axis) {
    exact::Afc twin;
    const exact::Afc::Config config = afc_config(setup.axis[axis]);
    bool started = false;
    std::size_t compared = 0;
    for (const Sample& sample : result.samples) {
      const AxisSample& rtl = sample.axis[axis];
      // The firmware holds the model in reset until it enables the axes, one sample before point 0.
      if (sample.tick + 4 < result.first_tick) continue;
      if (!started) {
        twin.reset(rtl.x_p);
        started = true;
      }
      const exact::Afc::Out out = twin.step(config, {rtl.r, rtl.x_p});
      CAPTURE(axis, sample.tick);
      REQUIRE(rtl.x_m == out.x_m);
      REQUIRE(rtl.x_r == out.x_r);
      REQUIRE(rtl.dx == out.dx);
      REQUIRE(rtl.e == out.e);
      REQUIRE(rtl.de == out.de);
      REQUIRE(rtl.u == out.u);
      REQUIRE(rtl.v_star == out.v_star);
      REQUIRE(rtl.v == out.v);
      REQUIRE(rtl.i_q_ref == out.i_q_ref);
      ++compared;
    }
    CHECK(compared >= 2516);
    for (int rule = 0; rule < 49; ++rule) {
      CAPTURE(axis, rule);
      CHECK(rules[axis][static_cast<std::size_t>(rule)] == twin.rule(rule));
    }
  }
}

namespace {

// Feeds the current loop twins with what the chip's loops took, at each of their runs.
class CurrentCheck final : public cosim::Observer {
 public:
  CurrentCheck(const KungChip& chip, const sw::KungSetup& setup) : chip_(chip), setup_(setup) {}

  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override {
    for (int axis = 0; axis < 2; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const CurrentWords words = chip_.current(axis);
      if (busy_[k] && !words.busy) compare(axis, words, stop.edge);
      busy_[k] = words.busy;
    }
  }

  int compared = 0;

 private:
  void compare(int axis, const CurrentWords& words, cosim::Clk edge) {
    const auto k = static_cast<std::size_t>(axis);
    const sw::AxisSetup& s = setup_.axis[k];
    if (words.clear) {
      twin_[k].reset();
      return;
    }
    const exact::CurrentLoop::Out out =
        twin_[k].step({false, words.code_a, words.code_b, words.count, s.theta_ofs, words.i_q_ref,
                       0, gain(s.kp_cur), gain(s.ki_cur)});
    CAPTURE(axis, edge);
    REQUIRE(words.i_d == out.i_d);
    REQUIRE(words.i_q == out.i_q);
    REQUIRE(words.v_d == out.v_d);
    REQUIRE(words.v_q == out.v_q);
    REQUIRE(words.cmp_a == out.cmp_a);
    REQUIRE(words.cmp_b == out.cmp_b);
    REQUIRE(words.cmp_c == out.cmp_c);
    ++compared;
  }

  const KungChip& chip_;
  sw::KungSetup setup_;
  std::array<exact::CurrentLoop, 2> twin_;
  std::array<bool, 2> busy_{};
};

}  // namespace

TEST_CASE("current loops equal their twins at every period of a line") {
  Options options;
  options.run.platform = Platform::kDirect;
  options.run.window_clk = 32;  // shorter than a run of the loop, so that none is missed
  options.path.kind = PathKind::kLine;
  options.path.line_end_x_m = 0.11;
  options.path.line_end_y_m = 0.12;
  options.path.line_ticks = 40;
  Session session(options, {});
  std::vector<sw::Point> points;
  CurrentCheck check(session.chip(), plan_firmware(options, points));
  session.watch(check);
  cosim::run_direct(session.loop(), session.firmware(), session.timing(), session.end(),
                    [&session] { return session.finished(); });
  CHECK(check.compared > 2 * 1280);
}
