// SPDX-License-Identifier: Apache-2.0
//
// The identified model of the track, and G-15: what a Kalman filter of it and Butterworth's filter
// make of the same noisy velocity.
#include <catch2/catch.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <random>
#include <vector>

#include "models/ideal/butterworth.hpp"
#include "models/ideal/gantry_track.hpp"
#include "models/ideal/identify.hpp"
#include "models/plant/belt_axis.hpp"

using namespace trammel;

namespace {

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

TEST_CASE("the track's model is the one that its run identifies, and explains most of it") {
  const Run r = pseudo_random();
  const ideal::LinearModel<3> made = ideal::identify<3>(r.u, r.v), kept = ideal::gantry_track();
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
  const ideal::LinearModel<3> model = ideal::gantry_track();
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
