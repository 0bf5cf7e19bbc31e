// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine @name@: what a sample records, and when the run is over.
#pragma once

#include "cosim/sampled_session.hpp"
#include "machines/@name@/chip.hpp"
#include "machines/@name@/plant.hpp"
#include "machines/@name@/record.hpp"

namespace trammel::@name@ {

class Session final : public cosim::SampledSession {
 public:
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves)
      : SampledSession(hooks, options.run, cosim::Fault{}, options.processor, waves),
        app_(options.firmware()),
        duration_s_(options.duration_s),
        plant_(options.run.clocked(options.plant)),
        chip_(make_verilated_chip(options.run, waves.window)) {
    wire(*chip_, plant_);
  }

  sw::Firmware& firmware() override { return app_; }
  std::vector<cosim::Place> places() const override {
    return {{"", "rad", plant_.state(chip_->now()).theta}};
  }
  std::unique_ptr<cosim::RunResult> result() override {
    auto result = std::make_unique<Result>();
    result->end = end_;
    if (app_.mailbox().failure != 0) result->fault = "the motor does not turn";
    result->samples = std::move(samples_);
    complete(*result);
    return result;
  }

 private:
  std::int64_t read(std::size_t signal, int) const override {
    return static_cast<std::int32_t>(chip_->word(static_cast<std::uint32_t>(signal)));
  }
  void sampled(cosim::Clk edge, bool) override {
    const plant::DcMotorState s = plant_.state(edge);
    const auto word = [this](std::size_t n) { return static_cast<std::int32_t>(read(n, 0)); };
    const std::int32_t count = word(sw::@name@_words::kCount);
    samples_.push_back({edge, count, word(sw::@name@_words::kDuty), s.theta, s.omega, s.i});
    hash_.mix(static_cast<std::uint32_t>(count));
  }
  double progress() const override { return app_.mailbox().point * kInterruptS / duration_s_; }

  sw::@Name@App app_;
  double duration_s_;
  MotorPlant plant_;
  std::unique_ptr<cosim::PinnedChip> chip_;
  host::DiskVector<Sample> samples_;
};

}  // namespace trammel::@name@
