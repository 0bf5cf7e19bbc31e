// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine mcafee: what a sample records, and when the run is over.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cosim/machine_session.hpp"
#include "machines/mcafee/machine_members.hpp"
#include "machines/mcafee/plant.hpp"
#include "machines/mcafee/setup.hpp"
#include "machines/mcafee/signals.hpp"
#include "machines/mcafee/twin.hpp"
#include "parts/lm628/coast.hpp"

namespace trammel::mcafee {

class Session final : public cosim::MachineSession<Options, StagePlant, McafeeChip, Result> {
 public:
  // Throws cosim::OptionsError or std::invalid_argument for a path that cannot be followed.
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {})
      : MachineSession(
            options, hooks, waves, 0, "mm",
            [&run = options.run, &axis = options.stage_axis] {
              return StagePlant({run.clocked(axis), run.clocked(axis)});
            },
            make_verilated_chip, make_twin_chip, options.clock_MHz),
        table_(followed_table(options)),
        app_(setup_of(options, table_)) {}

  sw::Firmware& firmware() override { return app_; }
  std::vector<cosim::Place> places() const override {
    const cosim::Clk now = chip_->now();
    const plant::XyStage& stage = plant_.stage();
    return {{"x", "mm", 1e3 * stage.axis(0).position(now)},
            {"y", "mm", 1e3 * stage.axis(1).position(now)}};
  }

 private:
  bool drives_off() const override { return chip_->drive() == codes(kZeroCode, kZeroCode); }
  std::string detected_by() const override { return what_failed(app_.mailbox()); }
  cosim::FaultTruth truth(cosim::Clk edge) const override {
    cosim::FaultTruth now;
    for (std::size_t k = 0; k < 2; ++k) {
      const plant::LeadscrewAxis& axis = plant_.stage().axis(k);
      const plant::DcMotorState state = axis.state(edge);
      now.at.push_back(1e3 * state.theta / axis.sensor().radians_per_m());
      now.current_A = std::max(now.current_A, std::abs(state.i));
    }
    now.at_stop = plant_.limits() != 0;
    return now;
  }
  std::int64_t read(std::size_t signal, int axis) const override {
    const std::size_t own = lm628::signals().size();
    if (signal < own) return lm628::word(chip_->words(axis), signal);
    switch (static_cast<OwnSignal>(signal - own)) {
      case OwnSignal::kRow: return rows();
      case OwnSignal::kSpeed: return app_.mailbox().speed;
      case OwnSignal::kLimits: return plant_.limits();
    }
    return 0;
  }

  Sample sample_at(cosim::Clk edge) const override {
    Sample sample = sample_of(edge, *chip_, plant_);
    sample.row = rows();
    sample.v = app_.mailbox().speed;
    return sample;
  }
  void mix(const Sample& sample) override {
    for (const AxisSample& axis : sample.axis) {
      hash_.mix(static_cast<std::uint64_t>(axis.words.position));
      hash_.mix(static_cast<std::uint32_t>(axis.words.actual));
    }
  }
  double progress() const override {
    return share_done(options_, table_, app_.mailbox().point, chip_->words(0).actual);
  }
  std::optional<cosim::EndReason> ending(cosim::Clk) override {
    constexpr double kAtRest_mm_s = 0.1;
    const Sample& sample = samples_.back();
    if (app_.mailbox().failure != 0) {
      end_ = cosim::EndReason::kFault;  // also where the run ends before the way to rest does
      const double speed = std::hypot(sample.axis[0].mm_s, sample.axis[1].mm_s);
      if (options_.fault.any() && !coast_.over(speed < kAtRest_mm_s)) return {};
      return end_;
    }
    for (const AxisSample& axis : sample.axis) {
      if (std::abs(axis.words.error) > options_.diverged_counts) return cosim::EndReason::kDiverged;
    }
    if (app_.mailbox().done != 0) return cosim::EndReason::kDone;
    return {};
  }
  std::unique_ptr<Result> result_now() const override {
    auto result = std::make_unique<Result>();
    const sw::Mailbox& mailbox = app_.mailbox();
    result->fault = what_failed(mailbox);
    if (options_.stage == sw::McafeeStage::kRead) result->readings = mailbox.point;
    result->real = {mailbox.real[0], mailbox.real[1]};
    result->table = table_;
    return result;
  }
  void conclude(Result& result, bool) override {
    if (end_ != cosim::EndReason::kDone && !result.samples.empty()) {  // it did not ask
      const Sample& last = result.samples.back();
      result.real = {last.axis[0].words.actual, last.axis[1].words.actual};
    }
    find_contour(options_, result);
  }
  std::string missed(const Result& result) const override { return what_missed(options_, result); }

  std::uint32_t rows() const { return options_.tracks() ? app_.mailbox().point : 0; }

  Table table_;
  sw::McafeeApp app_;
  lm628::Coast coast_;
};

}  // namespace trammel::mcafee
