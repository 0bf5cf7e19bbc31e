// SPDX-License-Identifier: Apache-2.0
//
// One run of the machine larson, ready to be driven by a wiring: chip, plant, firmware, loop and
// record, and the decision when the run is over.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cosim/sampled_session.hpp"
#include "machines/larson/plant.hpp"
#include "machines/larson/record.hpp"

namespace trammel::larson {

class Session final : public cosim::SampledSession {
 public:
  // Throws host::ConfigError for a script that cannot be read.
  Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves = {});

  sw::Firmware& firmware() override { return app_; }
  std::vector<cosim::Place> places() const override;
  std::unique_ptr<cosim::RunResult> result() override;

 private:
  void passed() override { note_calls(); }
  void noted(const cosim::Stop& stop) override;
  void sampled(cosim::Clk edge, bool recorded) override;
  double progress() const override;
  std::optional<cosim::EndReason> ending(cosim::Clk edge) override;
  bool drives_off() const override { return resting(); }
  std::string noticed() const override;
  cosim::FaultTruth truth(cosim::Clk edge) const override;
  std::int64_t read(std::size_t signal, int axis) const override;
  Sample sample_at(cosim::Clk edge) const;
  void look(const Sample& now);
  std::unique_ptr<Result> result_now() const;
  void note_calls();
  void note_events(const cosim::Stop& stop);
  void note_pulses(cosim::Clk edge);
  void note_rate(std::size_t axis, cosim::Clk edge);
  void note_plant();
  void note_requests(cosim::Clk edge);
  void note(Event event);
  bool resting() const;
  double at(std::size_t axis, cosim::Clk edge) const { return plant_.axis(axis).state(edge).at; }
  std::array<double, 2> platform(cosim::Clk edge) const;
  CallDone heard_at(cosim::Clk edge) const;
  bool moving(std::size_t axis) const;

  Options options_;
  std::vector<Call> calls_;
  std::vector<sw::LarsonCall> program_;
  std::vector<sw::LarsonAnswer> answers_;
  TablePlant plant_;
  std::unique_ptr<LarsonChip> chip_;
  sw::LarsonApp app_;
  host::DiskVector<Sample> samples_, looks_;
  std::unique_ptr<Result> at_end_;  // what there was at the last look; null: that is to come
  cosim::Clk ended_ = cosim::kNever;    // the program has
  cosim::Clk done_at_ = cosim::kNever;  // the sample of the record behind that

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
