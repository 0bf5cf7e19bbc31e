// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine mcafee, ready to be driven by a wiring: chip, plant, firmware, loop and
// record, and the decision when the run is over.
#pragma once

#include <memory>
#include <optional>

#include "machines/mcafee/record.hpp"
#include "machines/mcafee/signals.hpp"
#include "cosim/sampled_session.hpp"
#include "parts/lm628/coast.hpp"

namespace trammel::mcafee {

// The stage of models/ behind the interface of cosim/.
class StagePlant final : public cosim::FalliblePlant {
 public:
  explicit StagePlant(const plant::XyStageConfig& config) : stage_(config) {}

  const plant::XyStage& stage() const { return stage_; }
  unsigned limits() const;

  cosim::Lines sense() const override;
  cosim::Clk next() const override { return stage_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    stage_.commit(n, {static_cast<unsigned>(code(drive, 0)),
                      static_cast<unsigned>(code(drive, 1))});
  }
  int sample(int, cosim::Clk) const override { return 0; }  // there is no converter
  void open_phase(cosim::Clk n, int axis, int, bool open) override {
    stage_.open(n, static_cast<std::size_t>(axis), open);
  }
  void supply(cosim::Clk n, double share) override { stage_.supply(n, share); }
  std::optional<double> supplied(cosim::Clk n) const override {
    return stage_.axis(0).supplied(n) + stage_.axis(1).supplied(n);
  }

 private:
  plant::XyStage stage_;
};

// What the program is told: the options in its own units, and the rows of a table that outlives it.
sw::McafeeSetup setup_of(const Options& options, const Table& table);

class Session final : public cosim::SampledSession {
 public:
  // Throws cosim::OptionsError or std::invalid_argument for a path that cannot be followed.
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {});

  sw::Firmware& firmware() override { return app_; }
  std::vector<cosim::Place> places() const override;
  std::unique_ptr<cosim::RunResult> result() override;

 private:
  void sampled(cosim::Clk edge, bool recorded) override;
  std::optional<cosim::EndReason> ending(cosim::Clk edge) override;
  bool drives_off() const override;
  std::string noticed() const override;
  cosim::FaultTruth truth(cosim::Clk edge) const override;
  std::int64_t read(std::size_t signal, int axis) const override;
  Sample sample_at(cosim::Clk edge) const;
  double progress() const override;
  std::uint32_t rows() const { return options_.tracks() ? app_.mailbox().point : 0; }

  Options options_;
  Table table_;
  StagePlant plant_;
  std::unique_ptr<McafeeChip> chip_;
  sw::McafeeApp app_;
  host::DiskVector<Sample> samples_;
  lm628::Coast coast_;
};

}  // namespace trammel::mcafee
