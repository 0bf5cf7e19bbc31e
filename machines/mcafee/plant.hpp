// SPDX-License-Identifier: Apache-2.0
//
// The stage of models/ behind the interface of cosim/.
#pragma once

#include <cstddef>
#include <optional>

#include "cosim/fault_plant.hpp"
#include "machines/mcafee/pins.hpp"
#include "models/plant/xy_stage.hpp"

namespace trammel::mcafee {

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

}  // namespace trammel::mcafee
