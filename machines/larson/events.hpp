// SPDX-License-Identifier: Apache-2.0
//
// What happens to the axes of a run: pulses and their rates, switches, lost steps, interrupts.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "machines/larson/plant.hpp"
#include "machines/larson/record.hpp"

namespace trammel::larson {

class Events {
 public:
  Events(const LarsonChip& chip, const TablePlant& plant, std::int64_t clock_ps);

  void on(const cosim::Stop& stop);
  void note_plant();  // up to now
  std::int64_t asked(std::size_t axis) const { return asked_[axis]; }  // [step] by the pulses
  void give(Result& result) const;

 private:
  void note_pulses(cosim::Clk edge);
  void note_rate(std::size_t axis, cosim::Clk edge);
  void note_requests(cosim::Clk edge);
  void note(Event event);

  const LarsonChip& chip_;
  const TablePlant& plant_;
  std::int64_t clock_ps_;
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
};

}  // namespace trammel::larson
