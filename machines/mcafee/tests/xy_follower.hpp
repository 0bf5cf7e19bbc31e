// SPDX-License-Identifier: Apache-2.0
//
// What McAfee's parts can drive without a plant.
#pragma once

#include <array>
#include <cstdint>

#include "machines/mcafee/twin.hpp"

namespace trammel::test {

// Encoder lines of a count, marker high.
constexpr cosim::Lines count_lines(std::int64_t count, int k) {
  return cosim::Lines{((count + 1) & 2) != 0} << mcafee::encoder_a(k) |
         cosim::Lines{(count & 2) != 0} << mcafee::encoder_b(k) |
         cosim::Lines{1} << mcafee::marker(k);
}

// Motors that are at their desired positions from sample to sample.
class XyFollower final : public cosim::Plant, public cosim::Observer {
 public:
  explicit XyFollower(const mcafee::TwinChip& chip) : chip_(chip) {}

  // Goes there with the first sample, and stays.
  void hold(std::array<std::int64_t, 2> counts) {
    hold_ = counts;
    held_ = true;
  }
  void limit_at(std::int64_t count) { limit_ = count; }  // of X

  cosim::Lines sense() const override {
    return count_lines(count_[0], 0) | count_lines(count_[1], 1) |
           cosim::Lines{count_[0] >= limit_} << mcafee::limit_high(0);
  }
  cosim::Clk next() const override { return count_ == goal_ ? cosim::kNever : at_ + 4; }
  void commit(cosim::Clk n, cosim::Lines) override {
    if (n < next()) return;
    for (std::size_t k = 0; k < 2; ++k) {
      if (count_[k] != goal_[k]) count_[k] += goal_[k] > count_[k] ? 1 : -1;
    }
    at_ = n;
  }
  int sample(int, cosim::Clk) const override { return 0; }
  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override {
    if ((stop.why & cosim::kSample) == 0) return;
    for (std::size_t k = 0; k < 2; ++k) {
      const exact::Lm628& part = chip_.part(static_cast<int>(k));
      goal_[k] = held_ ? hold_[k] : part.engine().desired().position >> 16;
    }
    at_ = stop.edge;
  }

 private:
  const mcafee::TwinChip& chip_;
  std::array<std::int64_t, 2> count_{}, goal_{}, hold_{};
  cosim::Clk at_ = 0;
  bool held_ = false;
  std::int64_t limit_ = 1 << 30;
};

}  // namespace trammel::test
