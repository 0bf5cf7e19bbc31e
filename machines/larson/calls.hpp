// SPDX-License-Identifier: Apache-2.0
//
// The calls of a run: what the program is told of them, and when each has ended.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "machines/larson/plant.hpp"
#include "machines/larson/record.hpp"

namespace trammel::larson {

class Calls {
 public:
  // Throws host::ConfigError for a script that cannot be read.
  Calls(const Options& options, const LarsonChip& chip, const TablePlant& plant);

  sw::LarsonApp app() {  // whose program and answers outlive it
    return {table_, program_.data(), answers_.data(), static_cast<std::uint32_t>(program_.size())};
  }
  std::size_t size() const { return calls_.size(); }
  cosim::Clk ended() const { return ended_; }  // the program has; kNever: it has not

  bool moving(std::size_t axis) const;  // it is asked to move, or pulses wait
  bool resting() const { return !moving(0) && !moving(1); }
  std::array<double, 2> platform(cosim::Clk edge) const;  // [step]

  void hear(cosim::Clk edge) { heard_ = heard_at(edge); }  // the processor does of the chip
  void note(const sw::Mailbox& mailbox);
  // A WTTBL whose table was not at rest in time, after edge `begin`.
  bool late(cosim::Clk begin) const;
  void give(Result& result) const;

 private:
  CallDone heard_at(cosim::Clk edge) const;

  const LarsonChip& chip_;
  const TablePlant& plant_;
  double lean_;
  sw::StepTableSetup table_;
  std::vector<Call> calls_;
  std::vector<sw::LarsonCall> program_;
  std::vector<sw::LarsonAnswer> answers_;
  std::vector<CallDone> done_;
  std::array<double, 2> origin_{};
  cosim::Clk ended_ = cosim::kNever;
  CallDone heard_;  // of the last event that the processor could answer to; [step] of the rotors
};

}  // namespace trammel::larson
