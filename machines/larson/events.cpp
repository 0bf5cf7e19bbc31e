// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "machines/larson/machine_members.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::larson {

Events::Events(const LarsonChip& chip, const TablePlant& plant, std::int64_t clock_ps)
    : chip_(chip),
      plant_(plant),
      clock_ps_(clock_ps),
      switches_(plant.switches()),
      asked_{plant.axis(0).translated(), plant.axis(1).translated()} {}

void Events::give(Result& result) const {
  result.happened = events_;
  result.happened_count = event_count_;
  result.pulses = pulses_;
  result.rates = rates_;
  result.interrupts = interrupts_;
}

void Events::note(Event event) {
  ++event_count_;
  if (events_.size() < kMostEvents) events_.push_back(std::move(event));
}

void Events::on(const cosim::Stop& stop) {
  if ((stop.why & cosim::kDrive) != 0) note_pulses(stop.edge);
  note_plant();
  if ((stop.why & ~cosim::kSample) != 0) note_requests(stop.edge);
  for (int k = 0; k < kAxes; ++k) words_[static_cast<std::size_t>(k)] = chip_.words(k);
}

void Events::note_pulses(cosim::Clk edge) {
  const cosim::Lines rose = chip_.drive() & ~drive_;
  drive_ = chip_.drive();
  for (int k = 0; k < kAxes; ++k) {
    if (!level(rose, step(k))) continue;
    ++pulses_[static_cast<std::size_t>(k)];
    asked_[static_cast<std::size_t>(k)] += level(drive_, forward(k)) ? 1 : -1;
    note_rate(static_cast<std::size_t>(k), edge);
  }
}

// Where a period is missing, or the code is another, others begin.
void Events::note_rate(std::size_t axis, cosim::Clk edge) {
  constexpr int kPulses = 64;
  RateRun& run = rate_runs_[axis];
  const std::uint32_t code = chip_.words(static_cast<int>(axis)) >> 16 & sw::larson_map::kRate;
  const double period_s = (4096 - code) / 240e3;
  const double since_s = cosim::seconds_of(edge - run.last, clock_ps_);
  if (code == run.code && run.last != 0 && since_s < 1.5 * period_s) {
    ++run.pulses;
    run.last = edge;
  } else {
    run = {code, edge, edge, 0};
  }
  if (run.pulses == kPulses) {
    rates_[code] = kPulses / cosim::seconds_of(edge - run.first, clock_ps_);
  }
}

// Switches, losses and pulses without a step since the last stop, at their own times, which need
// not be those of stops. The words are those that the chip had then, with the switch as it now is.
void Events::note_plant() {
  struct Seen {
    cosim::Clk edge = 0;
    std::size_t axis = 0;
    const plant::SwitchMoved* moved = nullptr;
    const plant::StepsLost* lost = nullptr;
    const plant::StepBreach* breach = nullptr;
  };
  std::vector<Seen> seen;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& moved = plant_.axis(k).moved();
    for (; moves_[k] < moved.size(); ++moves_[k]) {
      seen.push_back({moved[moves_[k]].edge, k, &moved[moves_[k]]});
    }
    const auto& lost = plant_.axis(k).lost();
    for (; losses_[k] < lost.size(); ++losses_[k]) {
      seen.push_back({lost[losses_[k]].edge, k, nullptr, &lost[losses_[k]]});
    }
    const auto& breaches = plant_.axis(k).breaches();
    for (; breaches_[k] < breaches.size(); ++breaches_[k]) {
      seen.push_back({breaches[breaches_[k]].edge, k, nullptr, nullptr, &breaches[breaches_[k]]});
    }
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.edge < b.edge; });
  for (const Seen& one : seen) {
    const auto axis = static_cast<int>(one.axis);
    std::string what;
    double place = plant_.at(one.axis, one.edge);
    if (one.moved != nullptr) {
      place = one.moved->at;
      const unsigned bit = 1u << (2 * axis + (one.moved->high ? 1 : 0));
      switches_ = one.moved->closed ? switches_ | bit : switches_ & ~bit;
      what = fmt::format("{} switch {}", one.moved->high ? "high" : "low",
                         one.moved->closed ? "closed" : "open");
    } else if (one.lost != nullptr) {
      place = one.lost->at;
      what = fmt::format("{} steps lost", one.lost->steps);
    } else {
      what = "no step: " + breach_text(*one.breach, clock_ps_);
    }
    const std::uint32_t status = words_[one.axis] >> 16 & ~sw::larson_map::kLimit;
    const bool closed = (switches_ >> 2 * axis & 3) != 0;
    note({one.edge, axis, std::move(what), place, words_[one.axis] & 0xFFFF,
          status | (closed ? sw::larson_map::kLimit : 0)});
  }
}

void Events::note_requests(cosim::Clk edge) {
  const unsigned now = chip_.requests();
  for (int axis = 0; axis < kAxes; ++axis) {
    if (((now & ~requests_) >> axis & 1) == 0) continue;
    ++interrupts_;
    const std::uint32_t words = chip_.words(axis);
    note({edge, axis, "interrupt", plant_.at(static_cast<std::size_t>(axis), edge), words & 0xFFFF,
          words >> 16});
  }
  requests_ = now;
}

}  // namespace trammel::larson
