// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine gantry: what a sample records, and when the run is over.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "cosim/machine_session.hpp"
#include "machines/gantry/lost_count.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/plant.hpp"
#include "machines/gantry/setup.hpp"
#include "machines/gantry/signals.hpp"

namespace trammel::gantry {

class Session final : public cosim::MachineSession<Options, TrackPlant, GantryChip, Result> {
 public:
  // Throws host::ConfigError for what the host cannot send.
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {})
      : MachineSession(
            options, hooks, waves, 1e-3 * options.record_ms, "mm",
            [&o = options] {
              return TrackPlant(o.run.clocked(o.axis), o.stripes,
                                read_sends(o.sends, o.firmware.checked), o.serial, o.line);
            },
            make_verilated_chip, make_twin_chip,
            ChipSetup{options.run.clocks(1e-3 * options.record_ms), ideal_store()}),
        estimator_(estimator_of(options)),
        app_(setup_of(options), estimator_.get()) {}

  sw::Firmware& firmware() override { return app_; }
  std::vector<cosim::Place> places() const override {
    return {{"", "mm", 1e3 * plant_.axis().cart(chip_->now())}};
  }

 private:
  bool drives_off() const override {
    const Words words = chip_->words();
    return words.force[0] == 0 && words.force[1] == 0;
  }
  std::string detected_by() const override { return what_noticed(app_.mailbox(), chip_->words()); }
  cosim::FaultTruth truth(cosim::Clk) const override {
    const double cart = plant_.axis().state().x[plant::BeltState::kCart];
    const bool at_stop = cart < options_.axis.stop_low || cart > options_.axis.stop_high;
    return {{1e3 * cart}, 0, at_stop};
  }
  std::int64_t read(std::size_t signal, int) const override {
    switch (static_cast<SignalOf>(signal)) {
      case SignalOf::kPosition: return chip_->words().position;
      case SignalOf::kVelocity: return chip_->words().velocity;
      case SignalOf::kForce: return chip_->words().force[0];
      case SignalOf::kError: return app_.mailbox().error;
      case SignalOf::kRegion: return chip_->words().region;
    }
    return 0;
  }

  Sample sample_at(cosim::Clk edge) const override {
    return sample_of(edge, *chip_, plant_, app_.mailbox());
  }
  // Up to the end of the experiment; the record ends with its own next sample.
  void look(const Sample& now) override {
    if ((now.edge + 1) % kLook != 0) return;
    looks_.push_back(now);
    count_.follow(now, plant_, options_.stripes.period, app_.mailbox().restarts, period_ps());
    const cosim::Clk time = cosim::clocks_of(options_.time_s, period_ps());
    if (now.edge + 1 > time - kLook) at_end_ = result_now();
  }
  void mix(const Sample& sample) override {
    hash_.mix(static_cast<std::uint32_t>(sample.words.position));
    hash_.mix(static_cast<std::uint32_t>(sample.words.velocity));
  }
  double progress() const override {
    return cosim::seconds_of(samples_.back().edge, period_ps()) / options_.time_s;
  }
  std::optional<cosim::EndReason> ending(cosim::Clk edge) override {
    const double now = cosim::seconds_of(edge, period_ps());
    if (app_.mailbox().failure != 0) {  // the way to rest is of the record
      if (!failed_s_) failed_s_ = now;
      constexpr double kAtRest = 1e-4, kLongest = 1;  // [m/s], [s]
      const bool at_rest = std::fabs(samples_.back().v) < kAtRest;
      if (at_rest || now > *failed_s_ + kLongest) return cosim::EndReason::kFault;
    }
    if (now < options_.time_s) return {};
    return cosim::EndReason::kDone;
  }
  std::unique_ptr<Result> result_now() const override {
    auto result = std::make_unique<Result>();
    note_program(*result, app_.mailbox());
    const Words words = chip_->words();
    result->heard = plant_.heard();
    result->malformed = words.malformed;
    result->lost = words.lost;
    result->store = chip_->store();
    if (identifies(options_)) {
      result->identified = identification(estimator_->samples(), options_.estimator.dead_samples);
    }
    return result;
  }
  void conclude(Result& result, bool) override {
    result.looks = std::move(looks_);
    if (!result.fault.empty()) result.end = cosim::EndReason::kFault;
  }
  std::string missed(const Result& result) const override {
    const std::string lost = count_.lost();
    return lost.empty() ? what_missed(options_, result) : lost;
  }

  std::unique_ptr<Estimator> estimator_;  // null: the firmware has its own filter
  sw::GantryApp app_;
  host::DiskVector<Look> looks_;
  std::optional<double> failed_s_;
  LostCount count_;
};

}  // namespace trammel::gantry
