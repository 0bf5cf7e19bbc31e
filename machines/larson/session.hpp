// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine larson, ready to be driven by a wiring: chip, plant, firmware, loop and
// record, and the decision when the run is over.
#pragma once

#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cosim/event_hash.hpp"
#include "cosim/fault_plant.hpp"
#include "cosim/fault_watch.hpp"
#include "cosim/session.hpp"
#include "machines/larson/plant.hpp"
#include "machines/larson/record.hpp"

namespace trammel::larson {

class Session final : public cosim::Session, private cosim::Observer, public cosim::SignalReader {
 public:
  // Throws host::ConfigError for a script that cannot be read.
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
  void look(const Sample& now);
  std::unique_ptr<Result> result_now() const;
  bool in_record(cosim::Clk edge) const { return (edge + 1) % record_clk_ == 0; }
  std::optional<cosim::EndReason> end_after(cosim::Clk edge);
  cosim::Plant& seen();
  void watch_fault(const cosim::Stop& stop);
  void note_calls();
  void note_events(const cosim::Stop& stop);
  void note_pulses(cosim::Clk edge);
  void note_rate(std::size_t axis, cosim::Clk edge);
  void note_plant();
  void note_requests(cosim::Clk edge);
  void note(Event event);
  std::string noticed() const;
  bool resting() const;
  double at(std::size_t axis, cosim::Clk edge) const { return plant_.axis(axis).state(edge).at; }
  std::array<double, 2> platform(cosim::Clk edge) const;
  CallDone heard_at(cosim::Clk edge) const;
  bool moving(std::size_t axis) const;

  Options options_;
  cosim::Hooks hooks_;
  cosim::Waves waves_;
  std::vector<Call> calls_;
  std::vector<sw::LarsonCall> program_;
  std::vector<sw::LarsonAnswer> answers_;
  TablePlant plant_;
  cosim::Clk record_clk_;
  std::unique_ptr<LarsonChip> chip_;
  std::optional<cosim::FaultPlant> failing_;  // around the plant
  std::optional<cosim::FaultWatch> fault_watch_;
  sw::LarsonApp app_;
  cosim::Loop loop_;
  host::DiskVector<Sample> samples_, looks_;
  std::unique_ptr<Result> at_end_;  // what there was at the last look; null: that is to come
  cosim::EventHash hash_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  cosim::EndReason end_ = cosim::EndReason::kTimeout;
  cosim::Clk ended_ = cosim::kNever;    // the program has
  cosim::Clk done_at_ = cosim::kNever;  // the sample of the record behind that
  bool over_ = false;

  std::vector<CallDone> done_;
  std::vector<Event> events_;
  std::size_t event_count_ = 0;
  std::uint32_t interrupts_ = 0;
  unsigned requests_ = 0;  // of the chip, after the last event
  unsigned switches_ = 0;
  cosim::Lines drive_ = 0;
  std::array<std::uint32_t, 2> pulses_{};
  std::array<std::int64_t, 2> asked_;  // [step] where they have the table
  std::array<std::size_t, 2> losses_{}, moves_{}, breaches_{};  // of the plant's lists, noted
  std::array<std::uint32_t, 2> words_{};           // of the chip, at the last stop
  struct RateRun {
    std::uint32_t code = 0;
    cosim::Clk first = 0, last = 0;
    int pulses = 0;  // since the first
  };
  std::array<RateRun, 2> rate_runs_;  // pulses one behind the other, at one rate code
  std::map<std::uint32_t, double> rates_;
  CallDone heard_;  // of the last event that the processor could answer to; [step] of the rotors
  std::array<double, 2> travel_{}, last_at_{}, origin_{};
};

}  // namespace trammel::larson
