// SPDX-License-Identifier: Apache-2.0
//
// The controllers of the chip in closed loop against their twins fed with the same inputs.
#include <catch2/catch.hpp>

#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/session.hpp"
#include "models/exact/chips/kung_axis.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

fixed::Gain gain(const sw::Gain& g) { return {g.mant, g.exp}; }

exact::Afc::Config afc_config(const sw::AxisSetup& s) {
  return {gain(s.kp),
          gain(s.ki),
          gain(s.kv),
          gain(s.eta),
          s.shift_e,
          s.shift_de,
          static_cast<std::int32_t>(s.a0),
          static_cast<int>(s.a0_scale),
          static_cast<std::int32_t>(s.b2),
          s.adapt,
          s.feedforward};
}

}  // namespace

TEST_CASE("whole circle: every word of both controllers equals the twin's at every sample") {
  Options options;
  options.run.platform = Platform::kDirect;
  Session session(options, {});
  const sw::KungSetup setup = make_plan(options)->setup;

  test::run_through(session);
  std::array<std::array<std::int32_t, 49>, 2> rules{};
  for (int axis = 0; axis < 2; ++axis) {
    for (int rule = 0; rule < 49; ++rule) {
      rules[static_cast<std::size_t>(axis)][static_cast<std::size_t>(rule)] =
          session.chip().rule(axis, rule);
    }
  }
  const auto record = session.result();
  const auto& result = static_cast<const Result&>(*record);
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

// Whole-controller twins beside the chip: fed with its converter codes, counts and commands only,
// they close position and current loop themselves and must load the same compare values.
class AxisCheck final : public cosim::Observer {
 public:
  AxisCheck(const KungChip& chip, const sw::KungSetup& setup) : chip_(chip) {
    for (std::size_t k = 0; k < 2; ++k) {
      const sw::AxisSetup& s = setup.axis[k];
      config_[k].position = afc_config(s);
      config_[k].kp_cur = gain(s.kp_cur);
      config_[k].ki_cur = gain(s.ki_cur);
      config_[k].angle_step = s.angle_step;
      config_[k].theta_ofs = s.theta_ofs;
    }
  }

  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override {
    for (int axis = 0; axis < 2; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const CurrentWords words = chip_.current(axis);
      if ((stop.why & cosim::kSample) != 0) {
        chip_.read_words(axis, sample_[k]);
        pending_[k] = true;
      }
      if (busy_[k] && !words.busy) period(axis, words, stop.edge);
      busy_[k] = words.busy;
    }
  }

  int compared = 0;

 private:
  // The position controller is done before the current loop of its tick, which takes the old i_q*.
  void period(int axis, const CurrentWords& words, cosim::Clk edge) {
    const auto k = static_cast<std::size_t>(axis);
    config_[k].close_current = !words.clear;
    const exact::CurrentLoop::Out out =
        twin_[k].step16k(config_[k], {words.code_a, words.code_b}, words.count);
    CAPTURE(axis, edge);
    REQUIRE(words.i_d == out.i_d);
    REQUIRE(words.i_q == out.i_q);
    REQUIRE(words.v_d == out.v_d);
    REQUIRE(words.v_q == out.v_q);
    REQUIRE(words.cmp_a == out.cmp_a);
    REQUIRE(words.cmp_b == out.cmp_b);
    REQUIRE(words.cmp_c == out.cmp_c);
    if (!words.clear) ++compared;
    if (!pending_[k]) return;
    pending_[k] = false;
    if (words.clear) {  // the firmware holds the model in reset until it enables the axis
      twin_[k].position().reset(sample_[k].x_p);
      return;
    }
    const exact::Afc::Out position = twin_[k].step2k(config_[k], sample_[k].r, sample_[k].x_p);
    REQUIRE(sample_[k].i_q_ref == position.i_q_ref);
  }

  const KungChip& chip_;
  std::array<exact::KungAxis, 2> twin_;
  std::array<exact::KungAxis::Config, 2> config_;
  std::array<AxisSample, 2> sample_;
  std::array<bool, 2> busy_{}, pending_{};
};

}  // namespace

TEST_CASE("whole controllers equal their twins at every PWM period of a line") {
  Options options;
  options.run.platform = Platform::kDirect;
  options.run.window_clk = 32;  // shorter than a run of the loop, so that none is missed
  options.path.kind = PathKind::kLine;
  options.path.line_end_x_m = 0.11;
  options.path.line_end_y_m = 0.12;
  options.path.line_ticks = 40;
  Session session(options, {});
  AxisCheck check(session.chip(), make_plan(options)->setup);
  session.loop().watch(check);
  test::run_through(session);
  CHECK(check.compared > 2 * 1280);
}
