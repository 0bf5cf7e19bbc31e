// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine @name@: chip, motor, firmware and record, and when the run ends.
#pragma once

#include <chrono>
#include <memory>

#include "cosim/event_hash.hpp"
#include "cosim/session.hpp"
#include "machines/@name@/chip.hpp"
#include "machines/@name@/lines.hpp"
#include "machines/@name@/record.hpp"

namespace trammel::@name@ {

// The motor of models/ behind the interface of cosim/. Between pulses the bridge shorts it.
class MotorPlant final : public cosim::Plant {
 public:
  explicit MotorPlant(const plant::MotorAxisConfig& config) : axis_(config) {}

  cosim::Lines sense() const override {
    return cosim::Lines{axis_.a()} << kEncoderA | cosim::Lines{axis_.b()} << kEncoderB;
  }
  cosim::Clk next() const override { return axis_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    const double sign = (drive >> kDirection & 1) != 0 ? -1 : 1;
    axis_.commit(n, (drive >> kPwm & 1) != 0 ? sign : 0);
  }
  int sample(int, cosim::Clk) const override { return 0; }  // there is no converter

  plant::DcMotorState state(cosim::Clk n) const { return axis_.state(n); }

 private:
  plant::MotorAxis axis_;
};

class Session final : public cosim::Session, private cosim::Observer, private cosim::SignalReader {
 public:
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves);

  cosim::Loop& loop() override { return loop_; }
  sw::Firmware& firmware() override { return app_; }
  cosim::ProcessorTiming timing() const override {
    return {options_.processor.access_clk, options_.processor.interrupt_latency_clk};
  }
  std::int64_t period_ps() const override { return options_.plant.clock_ps; }
  cosim::Clk end() const override;
  bool finished() const override { return over_; }
  bool stopped() const override { return end_ == cosim::EndReason::kStopped; }
  std::vector<cosim::Place> places() const override;
  std::unique_ptr<cosim::RunResult> result() override;

 private:
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant& plant) override;
  std::int64_t read(std::size_t signal, int) const override;
  bool over();

  Options options_;
  cosim::Hooks hooks_;
  cosim::Waves waves_;
  sw::@Name@App app_;
  MotorPlant plant_;
  std::unique_ptr<cosim::PinnedChip> chip_;
  host::DiskVector<Sample> samples_;
  cosim::EventHash hash_;
  cosim::EndReason end_ = cosim::EndReason::kTimeout;
  bool over_ = false;
  cosim::Loop loop_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace trammel::@name@
