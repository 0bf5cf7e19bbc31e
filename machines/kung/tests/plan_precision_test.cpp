// SPDX-License-Identifier: Apache-2.0
//
// The words of the precision controller from poles, encoder, motor and sensors, and what is
// refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <string>

#include "machines/kung/precision/plan.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "tests/support/message.hpp"

namespace {

using namespace trammel;
using namespace trammel::kung;

Options options() {
  Options o;
  o.controller = Controller::kPrecision;
  return o;
}

sw::PrecisionSetup plan(const Options& o) {
  return make_plan(o)->setup.precision;
}

double value(sw::Gain g) { return std::ldexp(g.mant / 2048.0, g.exp); }

// A circle of the same counts with any encoder.
Options counting(double count_m) {
  Options o = options();
  o.path.feed_m_s = 4000 * count_m;
  for (std::size_t a = 0; a < 2; ++a) {
    plant::AxisConfig& plant = o.plant.axis[a];
    plant.encoder_count_m = count_m;
    plant.pole_pitch_m = 0.02;
    plant.hard_stops = false;
    o.gains[a].kv = 1e-3;  // words of the fuzzy controller are none here
    o.gains[a].current_kp_V_A = 1;
    o.chip.axis[a].stroke_max_m = 120000 * count_m;
    o.path.circle_center_x_m = o.path.circle_center_y_m = 60000 * count_m;
    o.path.circle_radius_m = 20000 * count_m;
  }
  return o;
}

// The message of a refusal.
std::string refusal(const Options& o) {
  return test::refusal_of<std::invalid_argument>([&] { plan(o); });
}

}  // namespace

TEST_CASE("the default options give the words of the specification for precision") {
  const sw::PrecisionSetup s = plan(options());
  const sw::PrecisionAxisSetup specified;
  CHECK(s.on);
  CHECK(s.identify);
  CHECK(s.adapt);
  CHECK_FALSE(s.learn);
  CHECK(s.learn_gain == 52429);
  for (const sw::PrecisionAxisSetup& axis : s.axis) {
    for (std::size_t n = 0; n < 5; ++n) {
      CAPTURE(n);
      CHECK(axis.full[n].mant == specified.full[n].mant);
      CHECK(axis.full[n].exp == specified.full[n].exp);
      CHECK(axis.soft[n].mant == specified.soft[n].mant);
      CHECK(axis.soft[n].exp == specified.soft[n].exp);
    }
    CHECK(axis.misc == specified.misc);
    CHECK(axis.wave == 40960);
    CHECK(axis.estimator.pitch == 48800);
    CHECK(axis.estimator.viscous == 559940);
    CHECK(axis.estimator.slowest == 16384);
    CHECK(axis.estimator.accel_shift == 3);
    CHECK(axis.estimator.speed_shift == 12);
  }
  const sw::EstimatorSetup &x = s.axis[0].estimator, &y = s.axis[1].estimator;
  CHECK(x.mass == 431985);
  CHECK(y.mass == 853034);
  CHECK(x.coulomb == 131236);
  CHECK(y.coulomb == 209978);
  CHECK(x.mass_min == 109363);   // 2 kg
  CHECK(x.mass_max == 1749814);  // 32 kg
  CHECK(y.mass_min == 328090);   // 6 kg
  CHECK(y.mass_max == 2187267);  // 40 kg
  CHECK(s.axis[0].heavy == x.mass_max);
  CHECK(s.axis[1].heavy == y.mass_max);
}

TEST_CASE("heavy is what the largest current accelerates by path.accel_m_s2, at most the range") {
  Options o = options();
  o.path.axis[0].accel_m_s2 = 20;
  o.path.axis[1].accel_m_s2 = 25;
  const sw::PrecisionSetup s = plan(o);
  // 79.9 N/A, 4.8 A less its last step, 54681.6 a kg
  CHECK(s.axis[0].heavy == Approx(79.9 * 4.8 * 2047 / 2048 / 20 * 54681.6).epsilon(1e-4));
  CHECK(s.axis[1].heavy == Approx(79.9 * 4.8 * 2047 / 2048 / 25 * 54681.6).epsilon(1e-4));
}

TEST_CASE("with another controller nothing of it is on, and nothing is refused") {
  for (const Controller controller : {Controller::kFc, Controller::kAfc}) {
    Options o;
    o.controller = controller;
    o.chip.carrier_Hz = 8000;
    o.precision.axis[0].w2_rad_s = 100;
    CHECK_FALSE(plan(o).on);
  }
}

TEST_CASE("the gains put the poles of observer and feedback where they were asked") {
  using Complex = std::complex<double>;
  constexpr double kT = 1.0 / 16000;
  for (const double w2 : {500.0, 4000.0, 8000.0}) {
    for (const double w3 : {50.0, 400.0, 2000.0}) {
      for (const double zeta : {0.3, 0.7, 3.0}) {
        CAPTURE(w2, w3, zeta);
        const double w1 = 300;
        const sw::LawGains g = law_gains("", w1, zeta, w2, w3);
        const double l1 = value(g[0]), l2 = value(g[1]), l3 = value(g[2]);
        // Observer of position, way and acceleration a tick: corrected, then predicted.
        const auto characteristic = [&](Complex p) {
          const Complex m = p - 1.0;
          return m * m * m + m * m * (l1 + l2 + l3) + m * (l2 + 2 * l3) + l3;
        };
        const double z = std::exp(-w2 * kT), y = std::exp(-w3 * kT);
        const auto wanted = [&](Complex p) { return (p - z) * (p - z) * (p - y); };
        for (const Complex p : {Complex(0.3, 0.2), Complex(-0.5, 0.4), Complex(0.9, 0.1)}) {
          CHECK(std::abs(characteristic(p) - wanted(p)) < 3e-3);
        }
        CHECK(value(g[3]) == Approx(w1 * w1 * kT * kT).epsilon(5e-4));
        CHECK(value(g[4]) == Approx(2 * zeta * w1 * kT).epsilon(5e-4));
      }
    }
  }
}

TEST_CASE("any encoder, motor and sensor: the words mean the same newtons and kilograms") {
  for (const double count_m : {0.2e-6, 1e-6, 5e-6, 20e-6}) {
    for (const double force_N_A : {20.0, 79.9, 300.0}) {
      for (const double full_scale_A : {4.8, 9.6, 40.0}) {
        CAPTURE(count_m, force_N_A, full_scale_A);
        Options o = counting(count_m);
        for (plant::AxisConfig& plant : o.plant.axis) {
          plant.force_constant_n_a = force_N_A;
          plant.current_full_scale_a = full_scale_A;
        }
        o.chip.current_limit_A = full_scale_A / 2;
        const sw::PrecisionSetup s = plan(o);
        const sw::PrecisionAxisSetup& x = s.axis[0];
        const sw::EstimatorSetup& e = x.estimator;
        const double lsb_N = force_N_A * full_scale_A / 4096;  // of i_q*
        const sw::KnotWords words =
            sw::knot_words({e.mass, e.viscous, e.coulomb, 0, 0, 0}, e);
        // KM: current [2^-8 LSB] per acceleration [2^-26 count per tick^2].
        const double accel_m_s2 = std::ldexp(count_m, -26) * 16000 * 16000;
        CHECK(value(words.km) == Approx(7.9 * accel_m_s2 / lsb_N * 256).epsilon(1e-3));
        CHECK(value(words.kmi) * value(words.km) == Approx(1).epsilon(2e-3));
        const double speed_m_s = std::ldexp(count_m, -14) * 16000;
        CHECK(value(words.kb) == Approx(20 * speed_m_s / lsb_N * 256).epsilon(1e-3));
        CHECK(words.fc == Approx(3 / lsb_N * 256).margin(1));
        CHECK(x.wave * count_m / 256 == Approx(0.8e-3).epsilon(1e-3));
        CHECK(e.pitch * count_m / 8 == Approx(0.02).epsilon(1e-3));
        const AxisEstimate back = estimate_of(o, 0, {e.mass, e.viscous, e.coulomb, e.coulomb, 0,
                                                     -e.coulomb});
        CHECK(back.mass_kg == Approx(7.9).epsilon(1e-3));
        CHECK(back.viscous_N_s_m == Approx(20).epsilon(1e-3));
        CHECK(back.coulomb_N == Approx(3).epsilon(1e-3));
        CHECK(back.cogging_N() == Approx(3).epsilon(1e-3));
        CHECK(back.force_N == Approx(-3).epsilon(1e-3));
        // 8 m/s^2 and 0.25 m/s leave room in the regressors.
        CHECK(8 * 4e-6 / count_m * std::ldexp(1, 13 - static_cast<int>(e.accel_shift)) < 16384);
        CHECK(e.mass_min < e.mass);
        CHECK(e.mass < e.mass_max);
      }
    }
  }
}

TEST_CASE("the friction of an axis is taken up to its last word, and refused one beyond") {
  for (const std::size_t axis : {0u, 1u}) {
    Options o = options();
    plant::AxisConfig& plant = o.plant.axis[axis];
    plant.force_constant_n_a = axis == 0 ? 60 : 90;
    const double lsb_N = plant.force_constant_n_a * plant.current_full_scale_a / 4096;
    const double word_N = lsb_N / 256;  // of FC, which has 16 bits
    const std::string key = std::string("precision.") + "xy"[axis] + ".coulomb_N";
    for (const int words : {65535, 65536}) {
      o.precision.axis[axis].coulomb_n = words * word_N * (1 - 1e-12);
      CAPTURE(key, words, o.precision.axis[axis].coulomb_n);
      if (words == 65535) {
        REQUIRE(refusal(o) == "");
        CHECK(plan(o).axis[axis].estimator.coulomb == 65535 * 32);
      } else {
        CHECK_THAT(refusal(o), Catch::StartsWith(key + ": value "));
      }
    }
  }
}

TEST_CASE("the regressors of the finest and of the coarsest encoders have a shift that there is") {
  const struct {
    double count_m;
    unsigned accel, speed;
  } cases[] = {{1e-7, 9, 18}, {5e-6, 3, 12}, {20e-6, 1, 10}, {40e-6, 1, 9}, {80e-6, 1, 8}};
  for (const auto& one : cases) {
    CAPTURE(one.count_m);
    for (const std::size_t axis : {0u, 1u}) {
      const sw::EstimatorSetup words = plan(counting(one.count_m)).axis[axis].estimator;
      CHECK(words.accel_shift == one.accel);
      CHECK(words.speed_shift == one.speed);
    }
  }
}

TEST_CASE("each key of the precision controller is in its own word") {
  Options o = options();
  o.precision.identify = o.precision.adapt = o.precision.subcount = false;
  o.precision.learn = true;
  o.precision.learn_gain = 0.25;
  o.path.repeats = 3;
  AxisPrecision& y = o.precision.axis[1];
  y.lead_ticks = 15;
  y.hysteresis_counts = 0.9;
  y.mass_kg = 100;
  const sw::PrecisionSetup s = plan(o);
  CHECK_FALSE(s.identify);
  CHECK_FALSE(s.adapt);
  CHECK(s.learn);
  CHECK(s.learn_gain == 16384);
  CHECK(s.axis[0].misc == (6u | 4u << 4 | 26u << 12 | 1u << 20));
  CHECK(s.axis[1].misc == (15u | 4u << 4 | 115u << 12 | 1u << 20));
  CHECK(s.axis[1].estimator.mass_max == Approx(2.5 * s.axis[1].estimator.mass).epsilon(1e-6));
  CHECK(s.axis[0].estimator.mass == 431985);
  o.precision.axis[0].w1_rad_s = 60;  // softer than the gains to identify with
  const sw::PrecisionSetup soft = plan(o);
  CHECK(value(soft.axis[0].soft[3]) == Approx(value(soft.axis[0].full[3])));
}
