// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/judge/baseline.hpp"

#include <array>
#include <cmath>
#include <memory>

#include "machines/kung/judge/paper.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "models/ideal/cascade.hpp"
#include "models/ideal/pid.hpp"
#include "models/ideal/reference_model.hpp"
#include "models/plant/current_source.hpp"

namespace trammel::kung {
namespace {

// One axis under one law: sampled, then driven until the next sample.
class ServoAxis {
 public:
  ServoAxis(const Options& options, std::size_t a, double start_m, Law law)
      : law_(law),
        period_(options.chip.sample_s()),
        plant_(options.plant.axis[a]),
        drive_(started(plant_, start_m)),
        model_({options.gains[a].omega_n_rad_s, options.gains[a].zeta, period_}),
        x_model_(start_m),
        x_read_(read()) {
    model_.reset(start_m);
    const double mass = plant_.mass_kg + plant_.payload_kg;
    // The range of i_q*, half that of the sensors.
    const double limit = plant_.force_constant_n_a * plant_.current_full_scale_a / 2;
    cascade_ = ideal::Cascade::for_mass(mass, kCascadePole, limit, period_);
    pid_ = ideal::Pid::for_mass(mass, kPidPole, limit, period_);
  }

  // The reference model's output [m] for this sample's command.
  double sample(double command_m) {
    const double x = read();
    const double x_model = model_.step(command_m);
    const double v_model = (x_model - x_model_) / period_;
    force_ = law_ == Law::kPid
                 ? ideal::Pid::step(pid_, pid_state_, x_model, x)
                 : ideal::Cascade::step(cascade_, cascade_state_,
                                        {x_model, v_model, x, (x - x_read_) / period_});
    x_model_ = x_model;
    x_read_ = x;
    return x_model;
  }

  void drive() { drive_.drive(force_ / plant_.force_constant_n_a, period_); }

  double x() const { return drive_.x(); }

 private:
  static plant::AxisConfig started(plant::AxisConfig config, double start_m) {
    config.start_m = start_m;
    return config;
  }

  double read() const {
    return std::round(drive_.x() / plant_.encoder_count_m) * plant_.encoder_count_m;
  }

  Law law_;
  double period_;
  plant::AxisConfig plant_;
  plant::CurrentSource drive_;
  ideal::ReferenceModel model_;
  ideal::Cascade::Config cascade_;
  ideal::Cascade::State cascade_state_;
  ideal::Pid::Config pid_;
  ideal::Pid::State pid_state_;
  double x_model_, x_read_;
  double force_ = 0;
};

}  // namespace

Tracks baseline_tracks(const Plan& plan, Law law) {
  const Options& options = plan.options;
  const sw::KungSetup& setup = plan.setup;
  sw::Trajectory path(setup);
  const double count_m = options.plant.axis[0].encoder_count_m;
  const sw::Point start = path.start();
  std::array<ServoAxis, 2> axes{ServoAxis(options, 0, start.x * count_m, law),
                                ServoAxis(options, 1, start.y * count_m, law)};
  Tracks tracks;
  for (std::uint32_t left = path.size(); left > 0; --left) {
    const sw::Point point = path.next();
    const PointM command{point.x * count_m, point.y * count_m};
    for (std::uint32_t held = setup.irq_period; held > 0; --held) {
      tracks.command.push_back(command);
      tracks.table.push_back({axes[0].x(), axes[1].x()});
      tracks.model.push_back({axes[0].sample(command.x_m), axes[1].sample(command.y_m)});
      for (ServoAxis& axis : axes) axis.drive();
    }
  }
  return tracks;
}

void add_tracking(std::vector<lab::Figure>& list, const std::string& id, const std::string& row,
                  const Series& to_model_mm, const Series& contour_mm) {
  const Spread tracking = spread(to_model_mm);
  const auto add = [&](const char* name, const char* column, double value, const char* unit) {
    list.push_back(lab::figure(id + name, row, column, value, unit, 4));
  };
  add(".model.mean_mm", "mean of T(k)", tracking.mean, "mm");
  add(".model.variance_mm2", "its var", tracking.variance, "mm2");
  add(".contour.mean_mm", "mean contour error", spread(contour_mm).mean, "mm");
}

void add_baselines(const Options& options, std::vector<lab::Figure>& list) {
  if (options.path.kind == PathKind::kSquare) return;
  if (paper_experiment(options) != Reading::kAssumed) return;
  const std::size_t reach = contour_reach(options.lag_s(), options.chip.sample_s());
  const std::shared_ptr<const Plan> plan = plan_of(options);
  for (const Law law : {Law::kCascade, Law::kPid}) {
    const Tracks tracks = baseline_tracks(*plan, law);
    Series to_model_mm, contour_mm;
    for (std::size_t k = 0; k < tracks.table.size(); ++k) {
      to_model_mm.push_back(tracking_error(tracks.model[k], tracks.table[k]) * kMm);
    }
    for (const double error : contour_error(tracks.table, tracks.command, reach)) {
      contour_mm.push_back(error * kMm);
    }
    const bool pid = law == Law::kPid;
    add_tracking(list, pid ? "baseline.pid" : "baseline.cascade",
                 pid ? "baseline PID" : "baseline P-PI", to_model_mm, contour_mm);
  }
}

}  // namespace trammel::kung
