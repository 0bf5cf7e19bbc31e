// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/kung/learning.hpp"

#include "sw_nios/apps/kung/rounding.hpp"

namespace trammel::sw {
namespace {

// A point is the set point 62 ticks after its knot: between the means of the second and the third
// interval from there.
constexpr std::int64_t kThird = 18022, kFourth = 14746;  // 0.55, 0.45 [2^-15]
constexpr std::uint32_t kComplete = 4;      // points ago: the one whose error is complete
constexpr std::uint32_t kSmoothed = 6;  // the one with two of them on either side

}  // namespace

Learning::Learning(std::array<std::int16_t, Corrections::kPoints>* corrections, std::uint32_t lap,
                   std::uint32_t gain)
    : corrections_(lap == 0 || lap > Corrections::kPoints ? nullptr : corrections),
      lap_(lap),
      gain_(gain) {
  if (corrections_ == nullptr) return;
  for (std::int16_t& one : *corrections_) one = 0;
}

std::int32_t Learning::correction(std::uint32_t point) const {
  return corrections_ == nullptr ? 0 : (*corrections_)[point % lap_];
}

void Learning::step(std::uint32_t point, std::int32_t way, std::int32_t err_sum) {
  if (corrections_ == nullptr) return;
  const bool moves = way >= kSlow || way <= -kSlow;
  moved_ = moved_ << 1 | (moves ? 1u : 0u);
  const auto error =
      static_cast<std::int32_t>(rs(kThird * err_sum_ + kFourth * err_sum, 20));
  err_sum_ = err_sum;
  if (point < kComplete) return;
  wrong_ = {error - correction(point - kComplete), wrong_[0], wrong_[1], wrong_[2], wrong_[3]};
  if (point < kSmoothed) return;
  const std::uint32_t at = (point - kSmoothed) % lap_;
  std::int16_t& one = (*corrections_)[at];
  if (at < kEnds || at + kEnds >= lap_ || (moved_ >> kSmoothed & 1u) == 0) {
    one = 0;
    return;
  }
  const std::int64_t sum = wrong_[0] + 4 * wrong_[1] + 6 * wrong_[2] + 4 * wrong_[3] + wrong_[4];
  one = static_cast<std::int16_t>(
      sat(one + static_cast<std::int32_t>(rs(std::int64_t{gain_} * sum, 20)), 16));
}

}  // namespace trammel::sw
