// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/precision/trace.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/precision/plan.hpp"
#include "models/exact/control/precision.hpp"
#include "models/plant/pmlsm.hpp"
#include "sw_nios/apps/kung/precision_values.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;
using exact::Precision;
using exact::PrecisionStore;

namespace {

constexpr std::int32_t kGainKm = 1068 | -3 * 65536, kGainKb = 1094 | -2 * 65536;

AxisLaw law_of(const Precision::State& s) {
  const auto word = [](std::int64_t of) { return static_cast<std::int32_t>(of); };
  return {word(s.d),    word(s.acc), word(s.aff), word(s.vff),
          word(s.iacc), s.km,        s.kb,        word(s.fc)};
}

}  // namespace

TEST_CASE("the parts of i_q* are its sum, tick by tick, until it is saturated") {
  using Word = PrecisionStore::Word;
  PrecisionStore window;
  for (const auto& [word, value] : {std::pair{Word::kKm, kGainKm}, {Word::kKb, kGainKb},
                                    {Word::kKmi, 1964 | 4 * 65536}, {Word::kFc, 4101},
                                    {Word::kL1, 1673 | -1 * 65536}, {Word::kL2, 1882 | -4 * 65536},
                                    {Word::kL3, 1267 | -9 * 65536}, {Word::kK1, 1475 | -11 * 65536},
                                    {Word::kK2, 1720 | -5 * 65536},
                                    {Word::kMisc, 6 | kKnee << 4 | 15 << 8 | 26 << 12 | 1 << 20}}) {
    window.put(0, word, value);
  }
  Precision law;
  Precision::In in;
  in.reset = true;
  law.step(in, window, 0);
  in.reset = false;
  const double full_A = 10, lsb_A = current_ref_lsb_A(full_A);
  int compared = 0, saturated = 0;
  for (std::int32_t t = 0; t < 640; ++t) {
    // Accelerates, with a current of the firmware in the middle.
    in.knot = t % 32 == 0 ? Precision::Knot::kCommit : Precision::Knot::kNone;
    const std::int32_t knot = t / 32;
    window.put(0, Word::kC, 256 * std::int64_t{knot} * knot);
    window.put(0, Word::kIff, knot > 4 && knot < 9 ? 12000 : 0);
    in.count = static_cast<std::int32_t>(law.state().p >> 23) - t / 16;
    const Precision::Out out = law.step(in, window, 0);
    const CurrentParts parts = parts_of(law_of(law.state()), full_A);
    const double sum_A = parts.accel_A + parts.speed_A + parts.friction_A + parts.force_A +
                         parts.feedback_A;
    CAPTURE(t, parts.accel_A, parts.speed_A, parts.friction_A, parts.force_A, parts.feedback_A);
    if (out.saturated) {
      ++saturated;
    } else {
      REQUIRE(sum_A / lsb_A == Approx(out.i_q_ref).margin(0.51));
      ++compared;
    }
  }
  CHECK(compared > 400);
  const CurrentParts parts = parts_of(law_of(law.state()), full_A);
  CHECK(parts.friction_A == Approx(4101 / 256.0 * lsb_A));
  CHECK(parts.force_A == 0);
}

TEST_CASE("what the chip was told is what the firmware estimated, within its words") {
  Options options;
  options.controller = Controller::kPrecision;
  for (const std::size_t a : {0u, 1u}) {
    for (const double count_m : {5e-6, 1e-6}) {
      CAPTURE(a, count_m);
      options.plant.axis[a].encoder_count_m = count_m;
      sw::KungSetup setup;
      setup.axis[a].stroke_max = 1 << 22;
      AxisPrecision& start = options.precision.axis[a];
      start = {};
      start.mass_kg = 12.5;
      start.viscous_n_s_m = 33;
      start.coulomb_n = 4.25;
      options.precision.identify = false;
      options.path.profile = Profile::kFeed;
      const sw::EstimatorSetup words = plan_precision(options, setup).axis[a].estimator;
      const sw::Estimator::Theta theta{words.mass, words.viscous, words.coulomb, 0, 0,
                                       2 * words.coulomb};
      const sw::KnotWords knot = sw::knot_words(theta, words);
      AxisLaw law;
      law.km = {knot.km.mant, knot.km.exp};
      law.kb = {knot.kb.mant, knot.kb.exp};
      law.fc = knot.fc;
      law.iacc = 32 * sw::force_current(theta, 0, 0, words.pitch);
      const AxisEstimate told = told_estimate(options, a, law);
      CHECK(told.mass_kg == Approx(12.5).epsilon(1e-3));
      CHECK(told.viscous_N_s_m == Approx(33).epsilon(1e-3));
      CHECK(told.coulomb_N == Approx(4.25).epsilon(1e-3));
      CHECK(told.force_N == Approx(8.5).epsilon(1e-3));
    }
  }
}

TEST_CASE("what pushes an axis back is what its motor model has") {
  plant::AxisConfig axis;
  axis.cogging_n = 3;
  axis.cogging_harmonic_n = 2;
  axis.cogging_harmonic = 6;
  axis.cable_n_m = 100;
  axis.cable_rest_m = 0.2;
  axis.external_force_n = -20;
  plant::PmlsmConfig motor;
  motor.pole_pitch = axis.pole_pitch_m;
  motor.cogging = axis.cogging_n;
  motor.harmonic_force = axis.cogging_harmonic_n;
  motor.harmonic = axis.cogging_harmonic;
  motor.cable = axis.cable_n_m;
  motor.cable_rest = axis.cable_rest_m;
  motor.external_force = axis.external_force_n;
  const plant::Pmlsm model(motor);
  for (double x_m = 0.1; x_m < 0.2; x_m += 0.0037) {
    plant::MotorState at_rest;
    at_rest.x = x_m;
    CAPTURE(x_m);
    CHECK(pushed_back_N(axis, x_m, 0) == Approx(-model.push(at_rest)).margin(1e-9));
  }
}

TEST_CASE("a load pushes back from its begin to its end") {
  plant::AxisConfig axis;
  axis.load_n = 7;
  axis.load_begin_s = 0.5;
  CHECK(pushed_back_N(axis, 0, 0.4) == 0);
  CHECK(pushed_back_N(axis, 0, 0.5) == 7);
  CHECK(pushed_back_N(axis, 0, 100) == 7);
  axis.load_end_s = 0.6;
  CHECK(pushed_back_N(axis, 0, 0.6) == 0);
}

TEST_CASE("precision.csv holds each axis in its own units, and which samples are counted") {
  Options options;
  options.controller = Controller::kPrecision;
  options.path.kind = PathKind::kPoints;  // each in its own time
  const std::array<double, 2> count_m{5e-6, 2e-6};
  Result result;
  result.first_tick = 11;
  result.end_tick = 13;
  result.points = 2;
  for (std::uint32_t tick = 10; tick < 15; ++tick) {
    Sample sample;
    sample.tick = tick;
    sample.edge = 25'000 * (tick - 10);
    AxisLaws laws{};
    for (std::size_t a = 0; a < 2; ++a) {
      options.plant.axis[a].encoder_count_m = count_m[a];
      const auto word = static_cast<std::int32_t>(1000 * tick + 100 * a);
      sample.axis[a].set_point = 256 * word;
      sample.axis[a].x_true_m = word * count_m[a] - (a == 0 ? 3e-6 : -7e-6);
      sample.axis[a].v_true_m_s = 0.5;
      options.plant.axis[a].cable_n_m = 2000;
      options.plant.axis[a].cable_rest_m = 0.001;
      options.plant.axis[a].cogging_n = options.plant.axis[a].cogging_harmonic_n = 0;
      laws[a].d = 3000 * word;
      laws[a].aff = 5000 * word;
      laws[a].vff = 7 * word;
    }
    result.samples.push_back(sample);
    result.laws.push_back(laws);
  }
  REQUIRE_FALSE(feeds(options));
  Plan plan;
  plan.options = options;
  const test::Scratch scratch("precision_trace");
  const auto file = scratch.path / "precision.csv";
  write_precision(file, plan, result);
  std::ifstream in(file);
  std::string line;
  std::vector<std::string> names;
  for (std::uint32_t tick = 9; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> fields;
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    if (tick++ == 9) {
      names = fields;
      continue;
    }
    const std::uint32_t now = tick - 1;
    REQUIRE(fields.size() == names.size());
    std::map<std::string, double> row;
    for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = std::stod(fields[k]);
    INFO("tick " << now << " of " << line);
    CHECK(row.at("counted") == (now == 11 || now == 12 ? 1 : 0));
    for (std::size_t a = 0; a < 2; ++a) {
      const std::string axis = a == 0 ? "x_" : "y_";
      const double word = 1000.0 * now + 100.0 * static_cast<double>(a), per_s = 16000;
      INFO(axis);
      CHECK(row.at(axis + "error_um") == Approx(a == 0 ? 3 : -7).margin(1e-3));
      CHECK(row.at(axis + "held_N") ==
            Approx(2000 * (word * count_m[a] - (a == 0 ? 3e-6 : -7e-6) - 0.001)).margin(1e-3));
      CHECK(row.at(axis + "command_m_s") ==
            Approx(7 * word / 16384 * count_m[a] * per_s).margin(1e-6));
      CHECK(row.at(axis + "command_m_s2") ==
            Approx(5000 * word / 67108864 * count_m[a] * per_s * per_s).margin(1e-4));
      CHECK(row.at(axis + "d_m_s2") ==
            Approx(3000 * word / 67108864 * count_m[a] * per_s * per_s).margin(1e-4));
    }
  }
  CHECK(!names.empty());
}
