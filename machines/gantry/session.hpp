// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine gantry, ready to be driven by a wiring: chip, plant, firmware, loop and
// record, and the decision when the run is over.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "cosim/event_hash.hpp"
#include "cosim/fault_plant.hpp"
#include "cosim/fault_watch.hpp"
#include "cosim/session.hpp"
#include "machines/gantry/plant.hpp"
#include "machines/gantry/record.hpp"

namespace trammel::gantry {

class Session final : public cosim::Session, private cosim::Observer, public cosim::SignalReader {
 public:
  // Throws host::ConfigError for what the host cannot send.
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {});

  cosim::Loop& loop() override { return loop_; }
  sw::Firmware& firmware() override { return app_; }
  cosim::ProcessorTiming timing() const override;
  std::int64_t period_ps() const override { return options_.axis.clock_ps; }
  cosim::Clk end() const override;
  bool finished() const override { return over_; }
  bool stopped() const override { return end_ == cosim::EndReason::kStopped; }
  std::vector<cosim::Place> places() const override;
  std::unique_ptr<cosim::RunResult> result() override;

 private:
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant& plant) override;
  std::int64_t read(std::size_t signal, int axis) const override;
  Sample sample_at(cosim::Clk edge) const;
  void look(const Look& now);
  void follow(const Look& now);
  bool in_record(cosim::Clk edge) const { return (edge + 1) % record_clk_ == 0; }
  std::optional<cosim::EndReason> end_after(cosim::Clk edge);
  cosim::Plant& seen();
  std::string noticed() const;
  std::string failure() const;
  std::unique_ptr<Result> result_now() const;
  std::string missed(const Result& result) const;

  Options options_;
  cosim::Hooks hooks_;
  cosim::Waves waves_;
  TrackPlant plant_;
  cosim::Clk record_clk_;
  std::unique_ptr<GantryChip> chip_;
  std::optional<cosim::FaultPlant> failing_;  // around the plant
  std::optional<cosim::FaultWatch> fault_watch_;
  std::unique_ptr<Estimator> estimator_;  // null: the firmware has its own filter
  sw::GantryApp app_;
  cosim::Loop loop_;
  host::DiskVector<Sample> samples_;
  host::DiskVector<Look> looks_;
  std::unique_ptr<Result> at_time_;  // what there was at run.time_s; null: that is to come
  cosim::EventHash hash_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  cosim::EndReason end_ = cosim::EndReason::kTimeout;
  std::optional<double> failed_s_;
  // Where the observer counts from, since which restart, and its first loss of a period.
  double counted_from_ = 0;  // [m]
  std::optional<std::uint32_t> counted_since_;
  std::optional<double> lost_s_;
  double lost_mm_ = 0;
  bool over_ = false;
};

}  // namespace trammel::gantry
