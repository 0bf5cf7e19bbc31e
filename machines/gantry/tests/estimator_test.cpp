// SPDX-License-Identifier: Apache-2.0
//
// Filters and models of the velocity of the machine gantry: the claims of Brochier 2006, 3.2, the
// identified model of the track, and G-15.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iomanip>
#include <random>
#include <string>
#include <vector>

#include "lab/record.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/tests/by_twin.hpp"
#include "machines/gantry/track.hpp"
#include "machines/gantry/units.hpp"
#include "models/ideal/butterworth.hpp"
#include "models/ideal/identify.hpp"
#include "models/plant/belt_axis.hpp"
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

constexpr std::int64_t kSample = 500'000;  // [clk], 10 ms
constexpr double kNoise = 20;              // [mm/s]

struct Run {
  std::vector<double> u, v;  // [count], [mm/s] of the cart
};

// A belt without ends, whose force changes each sample as `force` says.
template <class Force>
Run run(int samples, Force force) {
  plant::BeltAxisConfig c;
  c.stop_low = -100;
  c.stop_high = 100;
  c.zone_more = 0;
  plant::BeltAxis axis(c);
  Run r;
  for (int k = 0; k < samples; ++k) {
    r.v.push_back(1e3 * axis.state().v[plant::BeltState::kCart]);
    r.u.push_back(force(k));
    const double share = r.u.back() / c.full_counts;
    axis.drive(k * kSample, {share, share});
    axis.drive((k + 1) * kSample, {share, share});
  }
  return r;
}

// +-600 counts, held 20 ms to 0.3 s.
Run pseudo_random() {
  std::mt19937 bits(2006);
  int left = 0;
  double sign = 1;
  return run(3000, [&](int) {
    if (left-- == 0) {
      left = static_cast<int>(2 + bits() % 29);
      sign = -sign;
    }
    return 600 * sign;
  });
}

std::vector<double> noisy(const std::vector<double>& v) {
  std::mt19937 bits(15);
  std::vector<double> z = v;
  for (double& one : z) {
    double sum = -6;  // of twelve uniform numbers: variance 1
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(bits()) / 4294967296.0;
    one += kNoise * sum;
  }
  return z;
}

// Force to the left and to the right for a second each.
Run reversals() {
  return run(1000, [](int k) { return k / 100 % 2 == 0 ? 500.0 : -500.0; });
}

struct Judged {
  double rms = 0;    // [mm/s]
  double delay = 0;  // [sample] mean, from the truth's change of sign to the estimate's
};

Judged judge(const std::vector<double>& truth, const std::vector<double>& estimate) {
  Judged j;
  int turns = 0;
  for (std::size_t k = 1; k < truth.size(); ++k) {
    j.rms += std::pow(truth[k] - estimate[k], 2) / static_cast<double>(truth.size());
    if (k < 50 || truth[k - 1] * truth[k] >= 0) continue;
    std::size_t n = k - 3;
    while (n + 1 < truth.size() && estimate[n] * truth[k] <= 0) ++n;
    j.delay += static_cast<double>(n) - static_cast<double>(k);
    ++turns;
  }
  j.rms = std::sqrt(j.rms);
  j.delay /= turns;
  return j;
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
  const ideal::LinearModel<3> stored = stored_track();
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
      const double t = options.run.seconds(s.edge), mm = 1e3 * s.x;
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

TEST_CASE("the track's model is the one that its run identifies, and explains most of it") {
  const Run r = pseudo_random();
  const ideal::LinearModel<3> made = ideal::identify<3>(r.u, r.v), kept = stored_track();
  for (int n = 0; n < 3; ++n) {
    INFO("phi(" << n << ", 0) " << std::setprecision(9) << made.phi(n, 0) << ", psi(" << n << ") "
                << made.psi(n));
    CHECK(kept.phi(n, 0) == Approx(made.phi(n, 0)).margin(1e-6));
    CHECK(kept.psi(n) == Approx(made.psi(n)).margin(1e-6));
  }
  CHECK(ideal::fit_percent(kept, r.u, r.v) > 53.49);  // of the thesis' own model
  // At rest a count gives the 0.511 mm/s of the feed-forward, less what friction takes of 600.
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - kept.phi;
  const double gain = (kept.c * rest.inverse() * kept.psi)(0);
  CHECK(gain == Approx(0.511 * (600 - 88) / 600).epsilon(0.05));
}

TEST_CASE("a known model is identified from its own run") {
  ideal::LinearModel<2> m;
  m.phi << 1.2, 1, -0.5, 0;
  m.psi << 0.3, 0.1;
  m.c << 1, 0;
  std::mt19937 bits(1);
  std::vector<double> u, y;
  Eigen::Vector2d x = Eigen::Vector2d::Zero();
  for (int k = 0; k < 200; ++k) {
    y.push_back(m.output(x));
    u.push_back(static_cast<double>(bits() % 100));
    x = m.next(x, u.back());
  }
  const auto found = ideal::identify<2>(u, y);
  CHECK(found.phi.isApprox(m.phi, 1e-9));
  CHECK(found.psi.isApprox(m.psi, 1e-9));
  CHECK(ideal::fit_percent(found, u, y) == Approx(100));
}

TEST_CASE("Butterworth: half the power at 5 Hz, 1 at rest, order 2 falls twice as steeply") {
  const auto gain = [](int order, double hz) {
    ideal::Butterworth filter(order, 5, 100);
    double most = 0;
    for (int k = 0; k < 2000; ++k) {
      const double out = filter.step(std::sin(6.283185307179586 * hz * k / 100));
      if (k > 1000) most = std::max(most, std::fabs(out));
    }
    return most;
  };
  for (const int order : {1, 2}) CHECK(gain(order, 4.97) == Approx(std::sqrt(0.5)).epsilon(0.01));
  // At 17.1 Hz the bilinear transform has it at 4 corners.
  const double at = std::atan(4 * std::tan(3.14159265358979 * 0.05)) / 3.14159265358979 * 100;
  CHECK(gain(1, at) == Approx(1 / std::sqrt(1 + 16.0)).epsilon(0.02));
  CHECK(gain(2, at) == Approx(1 / std::sqrt(1 + 256.0)).epsilon(0.02));
  ideal::Butterworth still(2, 5, 100);
  double out = 0;
  for (int k = 0; k < 200; ++k) out = still.step(3);
  CHECK(out == Approx(3));
}

TEST_CASE("Kalman: of a constant it is the mean, and its covariance falls as 1 / n") {
  ideal::LinearModel<1> m;
  m.phi << 1;
  m.c << 1;
  ideal::Kalman<1> filter(m, Eigen::Matrix<double, 1, 1>::Constant(0), 4);
  // P begins at w = 0: nothing can be learnt.
  CHECK(filter.step(0, 10) == 0);
  ideal::Kalman<1> open(m, Eigen::Matrix<double, 1, 1>::Constant(1), 4);
  double p = 1;
  double x = 0;
  for (int k = 1; k < 20; ++k) {
    const double ahead = p + 1, gain = ahead / (4 + ahead);
    x += gain * (k - x);
    p = ahead - gain * ahead;
    CHECK(open.step(0, k) == Approx(x));
    CHECK(open.covariance()(0) == Approx(p));
  }
}

TEST_CASE("G-15 Kalman's error is at most Butterworth's on the same noisy run, its delay smaller") {
  const Run r = reversals();
  const std::vector<double> z = noisy(r.v);
  const ideal::LinearModel<3> model = stored_track();
  // What the model leaves out is a force of the size of Coulomb friction.
  ideal::Kalman<3> kalman(model, 88.0 * 88.0 * model.psi * model.psi.transpose(), kNoise * kNoise);
  ideal::Butterworth butterworth(2, 5, 100);
  std::vector<double> by_kalman, by_butterworth;
  for (std::size_t k = 0; k < z.size(); ++k) {
    by_kalman.push_back(kalman.step(k == 0 ? 0 : r.u[k - 1], z[k]));
    by_butterworth.push_back(butterworth.step(z[k]));
  }
  const Judged one = judge(r.v, by_kalman), two = judge(r.v, by_butterworth);
  CAPTURE(one.rms, two.rms, one.delay, two.delay);
  CHECK(one.rms <= two.rms);
  CHECK(one.delay < two.delay);
  CHECK(two.delay > 1);  // Butterworth of 5 Hz is 45 ms late
}
