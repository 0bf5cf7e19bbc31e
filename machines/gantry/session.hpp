// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine gantry, ready to be driven by a wiring: chip, plant, firmware, loop and
// record, and the decision when the run is over.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cosim/sampled_session.hpp"
#include "machines/gantry/plant.hpp"
#include "machines/gantry/record.hpp"

namespace trammel::gantry {

class Session final : public cosim::SampledSession {
 public:
  // Throws host::ConfigError for what the host cannot send.
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {});

  sw::Firmware& firmware() override { return app_; }
  std::vector<cosim::Place> places() const override;
  std::unique_ptr<cosim::RunResult> result() override;

 private:
  void sampled(cosim::Clk edge, bool recorded) override;
  double progress() const override;
  std::optional<cosim::EndReason> ending(cosim::Clk edge) override;
  bool drives_off() const override;
  std::string noticed() const override;
  cosim::FaultTruth truth(cosim::Clk edge) const override;
  std::int64_t read(std::size_t signal, int axis) const override;
  Sample sample_at(cosim::Clk edge) const;
  void look(const Look& now);
  void follow(const Look& now);
  std::string failure() const;
  std::unique_ptr<Result> result_now() const;
  std::string missed(const Result& result) const;

  Options options_;
  TrackPlant plant_;
  std::unique_ptr<GantryChip> chip_;
  std::unique_ptr<Estimator> estimator_;  // null: the firmware has its own filter
  sw::GantryApp app_;
  host::DiskVector<Sample> samples_;
  host::DiskVector<Look> looks_;
  std::unique_ptr<Result> at_time_;  // what there was at run.time_s; null: that is to come
  std::optional<double> failed_s_;
  // Where the observer counts from, since which restart, and its first loss of a period.
  double counted_from_ = 0;  // [m]
  std::optional<std::uint32_t> counted_since_;
  std::optional<double> lost_s_;
  double lost_mm_ = 0;
};

}  // namespace trammel::gantry
