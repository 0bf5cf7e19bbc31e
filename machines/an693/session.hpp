// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine an693, ready to be driven by a wiring: chip, plant, loop and record, with
// firmware and the decision when the run is over, or with somebody else at the port.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "cosim/sampled_session.hpp"
#include "machines/an693/recorder.hpp"
#include "parts/lm628/coast.hpp"
#include "parts/lm628/signals.hpp"
#include "machines/an693/record.hpp"

namespace trammel::an693 {

// The motor of models/ behind the interface of cosim/.
class MotorPlant final : public cosim::FalliblePlant {
 public:
  MotorPlant(const plant::MotorAxisConfig& config, const lm628::PartOptions& part)
      : axis_(config, part.pulses() ? plant::Amplifier::kBridge : plant::Amplifier::kLinear),
        pulses_(part.pulses()) {}

  cosim::Lines sense() const override {
    return cosim::Lines{axis_.a()} << lm628::kEncoderA |
           cosim::Lines{axis_.b()} << lm628::kEncoderB |
           cosim::Lines{axis_.index()} << lm628::kIndex;
  }
  cosim::Clk next() const override { return axis_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    pass(n);
    axis_.commit(n, pulses_ ? lm628::share_of_pulse(drive) : lm628::share_of_code(drive));
  }
  int sample(int, cosim::Clk) const override { return 0; }  // there is no converter

  void open_phase(cosim::Clk n, int, int, bool open) override { axis_.open(n, open); }
  void supply(cosim::Clk n, double share) override {
    pass(n);
    axis_.supply(n, share);
  }

  std::optional<double> supplied(cosim::Clk n) const override { return axis_.supplied(n); }

  void load(cosim::Clk n, double torque) { axis_.load(n, torque); }

  const plant::MotorAxis& axis() const { return axis_; }

  // At the motor [V]: from edge n on, the last commit being before; of an H-bridge its mean since
  // the last call.
  double voltage(cosim::Clk n) {
    if (!pulses_ || n == from_) return axis_.voltage();
    pass(n);
    const double mean = volt_clk_ / static_cast<double>(n - from_);
    volt_clk_ = 0;
    from_ = n;
    return mean;
  }

 private:
  void pass(cosim::Clk n) {
    volt_clk_ += axis_.voltage() * static_cast<double>(n - to_);
    to_ = n;
  }

  plant::MotorAxis axis_;
  bool pulses_;
  double volt_clk_ = 0;              // [V clk] integral of the voltage from from_ to to_
  cosim::Clk from_ = 0, to_ = 0;
};

// Chip, motor, loop and record: what every run of the machine has, whoever is at the port.
class Bench : public cosim::Rig, private cosim::SignalReader {
 public:
  // `finished` is asked after each sample, and after it said so nothing more is recorded.
  Bench(const Options& options, std::function<bool(const Sample&)> finished,
        const cosim::Waves& waves = {});

  virtual ~Bench() = default;

  const lm628::Lm628Chip& chip() const { return *chip_; }
  const MotorPlant& plant() const { return plant_; }
  bool finished() const { return recorder_.done(); }

  void load(double torque);  // of the shaft from now on [N m], against positive motion

  Result result();  // all but how it ended, which only who is at the port can tell

 protected:
  const Options& options() const { return options_; }
  bool found() const { return waves_.found(); }
  std::string detected_by() const override { return {}; }  // a fault, by who is at the port

 private:
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant& plant) override {
    if (waves_.search != nullptr) waves_.search->on(stop, *chip_, *this);
    recorder_.on(stop, chip, plant);
    if ((stop.why & cosim::kSample) != 0) output_ = chip_->words().output;
    if (stop.why != cosim::kLimit) watch_fault(stop);
  }
  bool drives_off() const override;
  cosim::FaultTruth truth(cosim::Clk edge) const override;

  std::int64_t read(std::size_t signal, int) const override {
    return lm628::word(chip_->words(), signal);
  }

  Options options_;
  MotorPlant plant_;
  std::unique_ptr<lm628::Lm628Chip> chip_;
  Recorder recorder_;
  int output_ = 0;  // of the filter, as the last sample left it
};

// With the firmware at the port.
class Session final : public cosim::SessionOf<Bench> {
 public:
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {});

  sw::Firmware& firmware() override { return app_; }
  bool finished() const override { return Bench::finished(); }
  std::vector<cosim::Place> places() const override;
  std::unique_ptr<cosim::RunResult> result() override;

 private:
  bool over(const Sample& sample);
  std::string detected_by() const override;

  sw::An693App app_;
  double expected_s_;
  std::size_t samples_ = 0;
  std::uint32_t steps_ = 0;             // begun
  lm628::Coast coast_;
  std::vector<std::size_t> step_ends_;
};

}  // namespace trammel::an693
