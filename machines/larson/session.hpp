// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine larson: what a sample records, and when the run is over.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cosim/machine_session.hpp"
#include "machines/larson/calls.hpp"
#include "machines/larson/events.hpp"
#include "machines/larson/machine_members.hpp"
#include "machines/larson/signals.hpp"

namespace trammel::larson {

class Session final : public cosim::MachineSession<Options, TablePlant, LarsonChip, Result> {
 public:
  // Throws host::ConfigError for a script that cannot be read.
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {})
      : MachineSession(
            options, hooks, waves, 1e-3 * options.record_ms, "step",
            [&o = options] {
              return TablePlant(axis_of(o, o.start_x), axis_of(o, o.start_y));
            },
            make_verilated_chip, make_twin_chip,
            ChipSetup{options.run.clocks(1e-3 * options.record_ms)}),
        calls_(options, *chip_, plant_),
        app_(calls_.app()),
        events_(*chip_, plant_, period_ps()),
        last_at_{plant_.at(0, 0), plant_.at(1, 0)} {}

  sw::Firmware& firmware() override { return app_; }
  std::vector<cosim::Place> places() const override {
    const cosim::Clk now = chip_->now();
    return {{"x", "step", plant_.at(0, now)}, {"y", "step", plant_.at(1, now)}};
  }

 private:
  bool drives_off() const override { return calls_.resting(); }
  // What the program has seen of a fault: a failure, or an error return.
  std::string detected_by() const override {
    if (app_.mailbox().failure != 0) return "CALTBL";
    const cosim::FaultSpan span(options_.fault, period_ps());
    return calls_.late(span.begin) ? "WTTBL" : "";
  }
  cosim::FaultTruth truth(cosim::Clk edge) const override {
    return {{plant_.at(0, edge), plant_.at(1, edge)},
            0,
            plant_.axis(0).hit_stop() || plant_.axis(1).hit_stop()};
  }
  std::int64_t read(std::size_t signal, int axis) const override {
    const auto k = static_cast<std::size_t>(axis);
    switch (static_cast<SignalOf>(signal)) {
      case SignalOf::kCount: return chip_->words(axis) & 0xFFFF;
      case SignalOf::kStatus: return chip_->words(axis) >> 16;
      case SignalOf::kWaiting: return plant_.axis(k).waiting();
      case SignalOf::kCall: return app_.mailbox().point;
      case SignalOf::kSwitches: return plant_.switches();
    }
    return 0;
  }

  // Calls that have ended since the last stop ended when the processor last heard of the chip,
  // which is the same in every wiring; a stop is where the look-ahead happens to end.
  void passed() override { calls_.note(app_.mailbox()); }
  void noted(const cosim::Stop& stop) override {
    if ((stop.why & (cosim::kBusDone | cosim::kIrq)) != 0) calls_.hear(stop.edge);
    events_.on(stop);
  }
  Sample sample_at(cosim::Clk edge) const override {
    Sample sample = sample_of(edge, *chip_, plant_, calls_.platform(edge));
    for (std::size_t k = 0; k < 2; ++k) {
      sample.axis[k].asked = static_cast<std::int32_t>(events_.asked(k));
    }
    sample.call = app_.mailbox().point;
    return sample;
  }
  // Up to the last one within record.settle_s of the last call; the record ends with its own
  // sample.
  void look(const Sample& now) override {
    if ((now.edge + 1) % kLook != 0) return;
    looks_.push_back(now);
    for (std::size_t k = 0; k < 2; ++k) {
      travel_[k] += std::fabs(now.axis[k].at - last_at_[k]);
      last_at_[k] = now.axis[k].at;
    }
    if (app_.mailbox().done == 0) return;
    const double since = cosim::seconds_of(now.edge + kLook - calls_.ended(), period_ps());
    if (since <= options_.settle_s || (!calls_.resting() && since <= kLongest_s)) return;
    events_.note_plant();  // up to here
    at_end_ = result_now();
  }
  void mix(const Sample& sample) override {
    for (const AxisSample& axis : sample.axis) hash_.mix(axis.words);
  }
  double progress() const override {
    return app_.mailbox().point / static_cast<double>(calls_.size());
  }
  std::optional<cosim::EndReason> ending(cosim::Clk edge) override {
    if (app_.mailbox().done == 0) return {};
    if (done_at_ == cosim::kNever) done_at_ = edge;
    const double since = cosim::seconds_of(edge - done_at_, period_ps());
    if (since < options_.settle_s || (!calls_.resting() && since < kLongest_s)) return {};
    return SampledSession::ending(edge);
  }
  std::unique_ptr<Result> result_now() const override {
    auto result = std::make_unique<Result>();
    const auto& mailbox = app_.mailbox();
    if (mailbox.failure != 0) result->fault = "CALTBL found no switch, or could not leave it";
    calls_.give(*result);
    events_.give(*result);
    note_plant(*result, plant_, looks_.empty() ? 0 : looks_.back().edge);
    result->travel = travel_;
    result->end_at = last_at_;
    result->known = mailbox.known;
    result->calibrated = mailbox.calibrated != 0;
    result->stopped = mailbox.stopped;
    result->err_byte = chip_->err_byte();
    return result;
  }
  void conclude(Result& result, bool whole) override {
    using End = cosim::EndReason;
    result.looks = std::move(looks_);
    if (whole && !result.fault.empty()) result.end = End::kFault;
    if (result.end == End::kFault) miss(result);
    if (result.end == End::kTimeout) result.fault = what_was_running(options_, result);
  }
  std::string missed(const Result& result) const override { return what_missed(options_, result); }

  static constexpr double kLongest_s = 5;  // of buffers that still hold pulses

  Calls calls_;
  sw::LarsonApp app_;
  Events events_;
  host::DiskVector<Sample> looks_;
  cosim::Clk done_at_ = cosim::kNever;  // the first sample of the record with all calls ended
  std::array<double, 2> travel_{}, last_at_{};
};

}  // namespace trammel::larson
