// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine an693, ready to be driven by a wiring: chip, plant, firmware, loop and
// record, and the decision when the run is over.
#pragma once

#include <chrono>

#include "cosim/direct.hpp"
#include "cosim/lm628/recorder.hpp"
#include "cosim/lm628/types.hpp"

namespace trammel::lm628 {

// The motor of models/ behind the interface of cosim/.
class MotorPlant final : public cosim::Plant {
 public:
  explicit MotorPlant(const plant::MotorAxisConfig& config) : axis_(config) {}

  cosim::Lines sense() const override {
    return cosim::Lines{axis_.a()} << kEncoderA | cosim::Lines{axis_.b()} << kEncoderB |
           cosim::Lines{axis_.index()} << kIndex;
  }
  cosim::Clk next() const override { return axis_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    axis_.commit(n, (static_cast<double>(drive) - static_cast<double>(kZeroCode)) / 2048);
  }
  int sample(int, cosim::Clk) const override { return 0; }  // there is no converter

  const plant::MotorAxis& axis() const { return axis_; }

 private:
  plant::MotorAxis axis_;
};

class Session {
 public:
  Session(const Options& options, const cosim::Hooks& hooks);

  cosim::Loop& loop() { return loop_; }
  sw::Firmware& firmware() { return app_; }
  cosim::ProcessorTiming timing() const {
    return {options_.processor.access_clk, options_.processor.interrupt_latency_clk};
  }
  std::int64_t period_ps() const { return options_.plant.clock_ps; }
  cosim::Clk end() const;  // edge at which the run ends at the latest
  bool finished() const { return recorder_.done(); }

  Result result();

 private:
  bool over(const Sample& sample);

  Options options_;
  cosim::Hooks hooks_;
  MotorPlant plant_;
  std::unique_ptr<Lm628Chip> chip_;
  sw::An693App app_;
  Recorder recorder_;
  cosim::Loop loop_;
  double expected_s_;
  std::int64_t samples_ = 0;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  cosim::EndReason end_ = cosim::EndReason::kTimeout;
};

}  // namespace trammel::lm628
