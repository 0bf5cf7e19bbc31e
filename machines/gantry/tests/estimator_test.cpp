// SPDX-License-Identifier: Apache-2.0
//
// Filters and models of the velocity in runs of the machine gantry: the claims of Brochier 2006,
// 3.2, and the texts of a model.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "lab/record.hpp"
#include "machines/gantry/machine.hpp"
#include "machines/gantry/tests/by_twin.hpp"
#include "machines/gantry/units.hpp"
#include "models/ideal/gantry_track.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::gantry;

namespace {

Options noisy(sw::OpenForce kind, double time_s, double dot_noise) {
  Options options = by_twin(time_s);
  options.sends = "";
  options.firmware.open = kind;
  options.firmware.open_force = kind == sw::OpenForce::kSteps ? -400 : 600;
  options.open_hold_ms = kind == sw::OpenForce::kSteps ? 1000 : 20;
  options.axis.start = kind == sw::OpenForce::kSteps ? 0.1 : 0.235;
  options.stripes.noise = 1;
  options.stripes.dot_noise = dot_noise;
  return options;
}

VelocityFigures filtered(Filter filter) {
  Options options = noisy(sw::OpenForce::kSteps, 6, 18);
  options.estimator.filter = filter;
  return velocity_figures(options, lab::simulate(options));
}

Identified identified(double delay_s, double dot_noise) {
  Options options = noisy(sw::OpenForce::kRandom, 12, dot_noise);
  options.axis.delay = delay_s;
  const Result result = lab::simulate(options);
  REQUIRE(result.identified);
  return *result.identified;
}

}  // namespace

// Figures 21, 28 and 29. Noise is that at constant speed, without the lag of a filter.
TEST_CASE("gantry: order 2 leaves less noise than order 1, Kalman no more, and is earlier") {
  const VelocityFigures one = filtered(Filter::kLowPass1), two = filtered(Filter::kLowPass2),
                        kalman = filtered(Filter::kKalman);
  CAPTURE(one.noise_mm_s, two.noise_mm_s, kalman.noise_mm_s, kalman.late_s, two.late_s);
  CHECK(one.raw_mm_s == Approx(20).epsilon(0.1));  // 18 codes, less steep away from cos = 1
  CHECK(one.noise_mm_s < one.raw_mm_s / 2);
  CHECK(two.noise_mm_s < one.noise_mm_s);
  CHECK(kalman.noise_mm_s <= two.noise_mm_s);
  CHECK(kalman.error_mm_s < two.error_mm_s);
  CHECK(kalman.late_s < two.late_s / 2);
  CHECK(kalman.changes <= two.changes);
}

TEST_CASE("gantry: noise is at constant speed and counts no lag, the error counts both") {
  const Options options;
  Result result;
  const auto put = [&result](double mm_s, double seen_mm_s, double raw_mm_s) {
    Look s;
    s.v = 1e-3 * mm_s;
    s.velocity = static_cast<std::int32_t>(std::lround(seen_mm_s / kVelocity_mm_s));
    s.words.velocity = static_cast<std::int32_t>(std::lround(raw_mm_s / kVelocity_mm_s));
    result.looks.push_back(s);
  };
  constexpr int kHold = 1000;  // looks of a second; the filtered velocity is 60 looks late
  for (int k = 0; k < 4 * kHold; ++k) {
    const double v = k / kHold % 2 == 0 ? 100 : -100, late = (k - 60) / kHold % 2 == 0 ? 90 : -90;
    put(v, late + (k % 2 == 0 ? 2 : -2), v + (k % 2 == 0 ? 7 : -7));
  }
  const VelocityFigures f = velocity_figures(options, result);
  CHECK(f.raw_mm_s == Approx(7).epsilon(0.01));
  CHECK(f.noise_mm_s == Approx(2).epsilon(0.01));
  CHECK(f.late_s == Approx(0.06));
  CHECK(f.changes == Approx(1));
  CHECK(f.error_mm_s > 30);  // 180 of 4000 looks are off by 190
}

// Figures 22 and 23: the source's 3 samples are those of a velocity that is a sample older.
TEST_CASE("gantry: dead time is 2 samples of 10 ms, with 10 ms more 3; a low order fits less") {
  const Identified here = identified(8e-3, 18), later = identified(18e-3, 18);
  CHECK(here.dead_samples == 2);
  CHECK(later.dead_samples == 3);
  REQUIRE(here.models.size() == 4);
  CHECK(here.models[2].fit > here.models[0].fit + 1);
  CHECK(here.models[3].fit == Approx(here.models[2].fit).margin(1));  // "doesn't give a better fit"
  CHECK(here.models[2].fit > 53.49);
  for (const IdentifiedModel& m : here.models) CHECK(m.fpe > m.loss);
}

TEST_CASE("gantry: a filter follows a constant velocity, sampled each 10 ms") {
  for (const Filter filter : {Filter::kMean, Filter::kLowPass1, Filter::kLowPass2,
                              Filter::kKalman}) {
    EstimatorConfig c;
    c.filter = filter;
    c.noise = 0.01;  // of the measurement, which Kalman then believes
    Estimator estimator(c, 2.5, false);
    std::int32_t now = 0;
    int changes = 0;
    for (int pass = 0; pass < 2000; ++pass) {
      const std::int32_t next = estimator.step(4000, {});
      changes += next != now && pass % 4 != 0 ? 1 : 0;
      now = next;
    }
    CAPTURE(static_cast<int>(filter));
    CHECK(now == Approx(4000).margin(1));
    CHECK((changes == 0) == (filter != Filter::kMean));
    estimator.restart();
    CHECK(estimator.step(0, {}) == 0);
  }
}

TEST_CASE("gantry: a model is read as it is printed, the stored one where there is no text") {
  const ideal::LinearModel<3> stored = ideal::gantry_track();
  const std::vector<double> a{stored.phi(0, 0), stored.phi(1, 0), stored.phi(2, 0)},
      b{stored.psi(0), stored.psi(1), stored.psi(2)};
  const TrackModel none = read_model(""), same = read_model(model_text(a, b));
  CHECK(same.phi.isApprox(none.phi, 1e-5));
  CHECK(same.psi.isApprox(none.psi, 1e-5));
  TrackModel::Column x = TrackModel::Column::Zero();
  ideal::LinearModel<3>::Column y = ideal::LinearModel<3>::Column::Zero();
  for (int k = 0; k < 50; ++k) {
    x = none.next(x, k % 7);
    y = stored.next(y, k % 7);
    CHECK(none.output(x) == Approx(stored.output(y)));
  }
}

TEST_CASE("gantry: settings that filters and open runs exclude are refused by their key") {
  const auto told = [](const std::string& toml) { return test::message_of<Options>(toml); };
  for (const std::string model : {"0.5", "0.5 0.1 0.2", "0.5 x", "1.1 0.1", "nan 0.1",
                                  "0.1 0 0 0 0 1 1 1 1 1"}) {
    CHECK_THAT(told("[velocity]\nmodel = \"" + model + "\"\n"),
               Catch::Contains("velocity.model: \"" + model + "\""));
  }
  CHECK(told("[velocity]\nfilter = \"kalman\"\nmodel = \"0.5 0.1\"\n") == "");
  CHECK(told("[control]\npass_ms = 3\n") == "");
  CHECK(told("[control]\npass_ms = 2.5\n[velocity]\nfilter = \"kalman\"\n") == "");
  for (const std::string takes :
       {"open = \"random\"\n", "[velocity]\nfilter = \"low_pass_1\"\n"}) {
    CHECK_THAT(told("[control]\npass_ms = 3\n" + takes), Catch::Contains("control.pass_ms: 3 "));
  }
  CHECK_THAT(told("[control]\nopen = \"steps\"\nopen_force = 0\n"),
             Catch::Contains("control.open_force: 0 "));
  CHECK_THAT(told("[control]\ncascade = true\ncompensate = true\nmotors = \"motor_1\"\n"),
             Catch::Contains("control.compensate: true "));
}

// Figure 57: what the motors differ by is ours, that they then behave as published is not.
TEST_CASE("gantry: of unlike motors each is the better one in its own sense") {
  struct Step {
    double over_left = 0, over_right = 0, left_s = 9, right_s = 9;
  };
  const auto of = [](sw::Motors motors) {
    Options options = by_twin(6);
    options.sends = "0.1:21=50 3:21=10";
    options.firmware.position.gain = 2;
    options.firmware.position.least = 250;
    options.firmware.motors = motors;
    options.axis.left[0] = options.axis.right[1] = 0.93;
    Step step;
    for (const Sample& s : lab::simulate(options).samples) {
      const double t = cosim::seconds_of(s.edge, options.axis.clock_ps), mm = 1e3 * s.x;
      if (t < 3) {
        step.over_left = std::max(step.over_left, mm - 50);
        if (mm > 49) step.left_s = std::min(step.left_s, t);
      } else {
        step.over_right = std::max(step.over_right, 10 - mm);
        if (mm < 11) step.right_s = std::min(step.right_s, t);
      }
    }
    return step;
  };
  const Step one = of(sw::Motors::kFirst), two = of(sw::Motors::kSecond);
  CHECK(two.over_left > one.over_left);
  CHECK(two.left_s < one.left_s);
  CHECK(one.right_s < two.right_s);
}
