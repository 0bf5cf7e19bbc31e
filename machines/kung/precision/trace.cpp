// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/precision/trace.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "lab/record.hpp"
#include "lab/write.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/precision/figures.hpp"
#include "machines/kung/precision/plan.hpp"
#include "models/exact/control/precision.hpp"

namespace trammel::kung {
namespace {

constexpr double kTickS = 1.0 / 16000;

// One axis at one sample.
struct Row {
  double error_m = 0, speed_m_s = 0, accel_m_s2 = 0;  // of the command
  double d_m_s2 = 0;
  CurrentParts parts;
  AxisEstimate told;
  double held_N = 0;  // of the plant
};

struct RowColumn {
  lab::Column column;
  double (*get)(const Row& row);
};

const std::vector<RowColumn>& row_columns() {
  using lab::fixed;
  static const std::vector<RowColumn> all{
      {{"error_um", "um", 1e-3, fixed(3), "command less true position"},
       [](const Row& r) { return r.error_m * kUm; }},
      {{"command_m_s", "m/s", 1e-6, fixed(6), "speed of the command"},
       [](const Row& r) { return r.speed_m_s; }},
      {{"command_m_s2", "m/s2", 1e-3, fixed(4), "acceleration of the command"},
       [](const Row& r) { return r.accel_m_s2; }},
      {{"d_m_s2", "m/s2", 1e-3, fixed(4), "disturbance of the observer"},
       [](const Row& r) { return r.d_m_s2; }},
      {{"iq_accel_A", "A", 1e-5, fixed(5), "part of i_q*: acceleration of the command"},
       [](const Row& r) { return r.parts.accel_A; }},
      {{"iq_speed_A", "A", 1e-5, fixed(5), "its speed, viscous friction"},
       [](const Row& r) { return r.parts.speed_A; }},
      {{"iq_friction_A", "A", 1e-5, fixed(5), "Coulomb friction"},
       [](const Row& r) { return r.parts.friction_A; }},
      {{"iq_force_A", "A", 1e-5, fixed(5), "IFF: cogging and constant force"},
       [](const Row& r) { return r.parts.force_A; }},
      {{"iq_feedback_A", "A", 1e-5, fixed(5), "feedback, with d"},
       [](const Row& r) { return r.parts.feedback_A; }},
      {{"mass_kg", "kg", 1e-3, fixed(4), "as the chip was told"},
       [](const Row& r) { return r.told.mass_kg; }},
      {{"viscous_N_s_m", "N s/m", 1e-3, fixed(4), "as the chip was told"},
       [](const Row& r) { return r.told.viscous_N_s_m; }},
      {{"coulomb_N", "N", 1e-3, fixed(4), "as the chip was told"},
       [](const Row& r) { return r.told.coulomb_N; }},
      {{"iff_N", "N", 1e-3, fixed(4), "cogging and constant force, as the chip was told"},
       [](const Row& r) { return r.told.force_N; }},
      {{"held_N", "N", 1e-3, fixed(4), "cogging and forces of the plant"},
       [](const Row& r) { return r.held_N; }},
  };
  return all;
}

// The command in double precision, or none where the feed profile does not drive the path.
class Commands {
 public:
  Commands(const Plan& plan, const Result& result)
      : options_(plan.options), range_(counted(result)) {
    if (result.points == 0 || range_.first >= result.samples.size()) return;
    begin_ = result.samples[range_.first].edge;
    if (feeds(options_)) command_.emplace(ideal_command(options_, plan.moves()));
  }

  // Of a sample: the place of each axis [m], its speed and acceleration; whether figures count it.
  bool at(std::size_t k, const Sample& sample, const AxisLaws& law,
          std::array<Row, 2>& rows) const {
    std::optional<ideal::FeedProfile::Command> command;
    const double t_s = command_time_s(options_, begin_, sample);
    if (command_) command = command_->at(t_s);
    for (std::size_t a = 0; a < 2; ++a) {
      const AxisSample& axis = sample.axis[a];
      const double count_m = options_.plant.axis[a].encoder_count_m;
      Row& row = rows[a];
      if (command) {
        const auto of = [a](const ideal::Place& p) { return a == 0 ? p.x : p.y; };
        row.error_m = of(command->p) - axis.x_true_m;
        row.speed_m_s = of(command->v);
        row.accel_m_s2 = of(command->a);
      } else if (axis.set_point != kNoSetPoint) {
        row.error_m = axis.set_point * count_m / 256 - axis.x_true_m;
        row.speed_m_s = std::ldexp(law[a].vff, -14) * count_m / kTickS;
        row.accel_m_s2 = std::ldexp(law[a].aff, -26) * count_m / (kTickS * kTickS);
      }
    }
    const bool counts = k >= range_.first && k < range_.last;
    return counts && (!command_ || (t_s >= 0 && t_s <= command_->seconds()));
  }

 private:
  const Options& options_;
  const lab::Range range_;
  cosim::Clk begin_ = 0;
  std::optional<ideal::FeedProfile> command_;
};

}  // namespace

CurrentParts parts_of(const AxisLaw& law, double current_full_scale_A) {
  using exact::Precision;
  const double lsb_A = current_ref_lsb_A(current_full_scale_A) / 256;
  const auto ampere = [lsb_A](std::int64_t word) { return static_cast<double>(word) * lsb_A; };
  const std::int64_t all = Precision::mul(law.km, fixed::sat(std::int64_t{law.acc} + law.aff, 24),
                                          11);
  const std::int64_t accel = Precision::mul(law.km, law.aff, 11);
  const std::int64_t ramp = fixed::sat(fixed::shift_left(law.vff, kKnee), 24);
  return {ampere(accel), ampere(Precision::mul(law.kb, law.vff, 11)),
          ampere(fixed::clip(ramp, -law.fc, law.fc)), ampere(fixed::rs(law.iacc, 5)),
          ampere(all - accel)};
}

double pushed_back_N(const plant::AxisConfig& plant, double x_m, double t_s) {
  const double angle = 2 * kPi * x_m / plant.pole_pitch_m;
  const bool ended = plant.load_end_s > 0 && t_s >= plant.load_end_s;
  const bool loaded = t_s >= plant.load_begin_s && !ended;
  return plant.cogging_n * std::sin(angle) +
         plant.cogging_harmonic_n * std::sin(plant.cogging_harmonic * angle + 1) +
         plant.cable_n_m * (x_m - plant.cable_rest_m) + plant.external_force_n +
         (loaded ? plant.load_n : 0);
}

const std::vector<lab::Column>& precision_columns() {
  static const std::vector<lab::Column> all = [] {
    std::vector<lab::Column> columns{
        {"counted", "", 1, lab::whole(), "1: one of the samples of the path, which figures count"}};
    for (const std::string axis : {"x_", "y_"}) {
      for (const RowColumn& one : row_columns()) {
        columns.push_back(one.column);
        columns.back().name = axis + one.column.name;
      }
    }
    return columns;
  }();
  return all;
}

void write_precision(const std::filesystem::path& file, const Plan& plan, const Result& result) {
  const Options& options = plan.options;
  const Commands commands(plan, result);
  const bool lawful = result.laws.size() == result.samples.size();
  const auto read = [&](std::size_t k, std::vector<double>& values) {
    const Sample sample = result.samples[k];
    const AxisLaws law = lawful ? result.laws[k] : AxisLaws{};
    std::array<Row, 2> rows;
    values.assign(1, commands.at(k, sample, law, rows) ? 1 : 0);
    for (std::size_t a = 0; a < 2; ++a) {
      const plant::AxisConfig& plant = options.plant.axis[a];
      Row& row = rows[a];
      row.d_m_s2 = std::ldexp(law[a].d, -26) * plant.encoder_count_m / (kTickS * kTickS);
      row.parts = parts_of(law[a], plant.current_full_scale_a);
      row.told = told_estimate(options, a, law[a]);
      row.held_N = pushed_back_N(plant, sample.axis[a].x_true_m, result.seconds(sample.edge));
      for (const RowColumn& one : row_columns()) values.push_back(one.get(row));
    }
  };
  lab::write_table(file, precision_columns(), result.samples.size(), read);
}

}  // namespace trammel::kung
