// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/kung/estimator.hpp"

#include "sw_nios/apps/kung/rounding.hpp"
#include "sw_nios/path/sine1024.hpp"

namespace trammel::sw {
namespace {

constexpr std::uint32_t kForget = 10;       // 2^-10 a sample
constexpr std::int64_t kFitting = 1 << 29;  // below, wide elements are narrow again

constexpr std::uint32_t low(std::uint64_t x) { return static_cast<std::uint32_t>(x & 0xFFFFFFFFu); }
constexpr std::uint32_t high(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

using Wide = Estimator::Wide;

constexpr std::int64_t value(Wide x) {
  return static_cast<std::int64_t>(std::uint64_t{static_cast<std::uint32_t>(x.high)} << 32 | x.low);
}
constexpr std::int32_t value(std::int32_t x) { return x; }
constexpr void set(Wide& x, std::int64_t to) {
  const auto pattern = static_cast<std::uint64_t>(to);
  x = {low(pattern), static_cast<std::int32_t>(high(pattern))};
}
constexpr void set(std::int32_t& x, std::int32_t to) { x = to; }
constexpr std::uint64_t pattern(Wide x) { return static_cast<std::uint64_t>(value(x)); }
constexpr std::uint32_t pattern(std::int32_t x) { return static_cast<std::uint32_t>(x); }

// Highest bit: not within +-2^30.
constexpr std::uint32_t outside(std::int32_t x) {
  return static_cast<std::uint32_t>(x) + 0x40000000u;
}

// a b modulo 2^64; of a wide word three multiplications of 32 bits.
constexpr std::uint64_t product(Wide a, std::int32_t b) {
  const std::uint32_t upper = static_cast<std::uint32_t>(a.high) * static_cast<std::uint32_t>(b);
  return static_cast<std::uint64_t>(std::int64_t{b} * std::int64_t{a.low}) +
         (std::uint64_t{upper} << 32);
}
constexpr std::uint64_t product(std::int32_t a, std::int32_t b) {
  return static_cast<std::uint64_t>(std::int64_t{a} * b);
}

// x >> shift, shift 0 to 31.
constexpr std::uint64_t shifted(std::uint64_t x, std::uint32_t shift) {
  return std::uint64_t{high(x) >> shift} << 32 |
         (low(x) >> shift | (high(x) << 1) << (31 - shift));
}
constexpr std::uint32_t shifted(std::uint32_t x, std::uint32_t shift) { return x >> shift; }

// The highest 31 bits of d, which is 10 + shift bits long; shift is at most 31.
constexpr std::uint32_t leading(std::uint32_t d, std::uint32_t shift) { return d << (21 - shift); }
constexpr std::uint32_t leading(std::uint64_t d, std::uint32_t shift) {
  return shift <= 21 ? low(d) << (21 - shift) : low(shifted(d, shift - 21));
}

// By which d, 11 to 41 bits long, is shifted to leave 10; `shift` is what it was.
template <class Word>
[[gnu::noinline]] std::uint32_t scale_of(Word d, std::uint32_t shift) {
  while (shifted(d, shift) >= 1024) ++shift;
  while (shifted(d, shift) < 512) --shift;
  return shift;
}

// 2^61 / d within 2^-28, d of 31 bits: a quotient of 16 bits and a step of Newton's.
[[gnu::always_inline]] inline std::int32_t reciprocal(std::uint32_t d) {
  const std::uint32_t about = 0xFFFFFFFFu / (d >> 15) << 14;
  const std::int32_t off = (1 << 29) - static_cast<std::int32_t>(high(std::uint64_t{about} * d));
  const std::int64_t more = std::int64_t{8 * off} * std::int64_t{about};
  const std::uint32_t better = about + high(static_cast<std::uint64_t>(more));
  constexpr std::uint32_t kMost = 0x7FFFFFFFu;
  return static_cast<std::int32_t>(better > kMost ? kMost : better);
}

// x / d, nearest, halves away from 0, within +-2^29; `guess` is at most 1 beside it, or any.
template <class Word>
[[gnu::noinline]] std::int32_t nearest(std::int64_t x, Word d, std::int32_t guess) {
  constexpr std::uint32_t kMost = 1u << 29;
  const bool negative = x < 0;
  const std::uint64_t size =
      (negative ? 0 - static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x)) + d / 2;
  auto q = static_cast<std::uint32_t>(negative ? -guess : guess);
  std::uint64_t rest = size - std::uint64_t{q} * d;
  if (static_cast<std::int64_t>(rest) < 0) {
    --q;
    rest += d;
  } else if (rest >= d) {
    ++q;
    rest -= d;
  }
  if (rest >= d) {
    const std::uint64_t all = size / d;
    q = all > kMost ? kMost : low(all);
  }
  return negative ? -static_cast<std::int32_t>(q) : static_cast<std::int32_t>(q);
}

// The same by the reciprocal of d, in 1/256, where that cannot be on the wrong side of a half.
template <class Word>
[[gnu::always_inline]] inline std::int32_t quotient(std::int64_t x, Word d, std::uint32_t shift,
                                                    std::int32_t inverse) {
  constexpr std::int32_t kMargin = 3, kMost = 1 << 28;
  const auto parts = static_cast<std::uint64_t>(x);
  const auto upper = static_cast<std::int32_t>(high(parts));
  const auto top = static_cast<std::int32_t>(low(parts) >> shift | (high(parts) << 1)
                                                                      << (31 - shift));
  const auto fine = static_cast<std::int32_t>((std::int64_t{top} * inverse) >> 32);
  const std::int32_t guess = (fine + 128) >> 8;
  const std::uint32_t beside = static_cast<std::uint32_t>(fine + 128 + kMargin) & 255u;
  if (upper >> shift != top >> 31) return nearest(x, d, 0);
  if (beside < 2 * kMargin || static_cast<std::uint32_t>(fine + kMost) > 2 * kMost) {
    return nearest(x, d, guess);
  }
  return guess;
}

}  // namespace

Estimator::Estimator(const EstimatorSetup& setup, std::int32_t point) : setup_(setup) {
  theta_ = {setup.mass, setup.viscous, setup.coulomb, 0, 0, 0};
  const std::int32_t cogging = 4 * setup.coulomb;
  least_ = {setup.mass_min, 0, 0, -cogging, -cogging, -kMostForce};
  most_ = {setup.mass_max, 3 * setup.viscous, cogging, cogging, cogging, kMostForce};
  points_ = {point, point, point, point};
  set(wide_[wide_place(0, 0)], kStart[0]);
  set(wide_[wide_place(1, 1)], kStart[1]);
  for (std::uint32_t i = 2; i < kUnknowns; ++i) narrow_[narrow_place(i, i)] = kStart[i];
  for (std::uint32_t i = 0; i < kUnknowns; ++i) {
    q_start_[i] = std::int64_t{kStart[i]} * theta_[i];
    set(q_[i], q_start_[i]);
    invert_wide(i, static_cast<std::uint64_t>(kStart[i]));
  }
}

std::int64_t Estimator::weight(std::uint32_t i, std::uint32_t j) const {
  if (i < j) return weight(j, i);
  if (j >= 2) return narrow_[narrow_place(i, j)];
  return fits_ && i >= 2 ? fitting_[2 * (i - 2) + j] : value(wide_[wide_place(i, j)]);
}

void Estimator::command(std::int32_t point) {
  points_ = {point, points_[0], points_[1], points_[2]};
}

void Estimator::step(std::int32_t err_sum, std::int32_t iq_sum) {
  Theta phi;
  std::int32_t current = 0;
  const bool moves = sample(err_sum, iq_sum, phi, current);
  if (sums_ < kFirst) return;
  if (moves) {
    if (fits_) {
      learn(phi);
    } else {
      learn_wide(phi);
    }
    push(phi, current);
  }
  const std::int32_t mass = theta_[kMass], quarter = mass / 4;
  least_[kMass] = clip(mass - quarter, setup_.mass_min, setup_.mass_max);
  most_[kMass] = clip(mass + quarter, setup_.mass_min, setup_.mass_max);
  for (int sweeps = 0; sweeps < 2; ++sweeps) {
    if (fits_) {
      sweep();
    } else {
      sweep_wide();
    }
  }
}

// Regressors and current of the sample before the last; false: too slow to tell anything.
bool Estimator::sample(std::int32_t err_sum, std::int32_t iq_sum, Theta& phi,
                       std::int32_t& current) {
  // (52360 c0 + 504680 c1 + 455576 c2 + 35960 c3) / 2^15; the sum of the weights is 2^20.
  const std::int32_t c = points_[1];
  const std::int64_t beside = std::int64_t{52360} * (points_[0] - c) +
                              std::int64_t{455576} * (points_[2] - c) +
                              std::int64_t{35960} * (points_[3] - c);
  const std::int32_t mean = 32 * c + static_cast<std::int32_t>(rs(beside, 15));
  positions_ = {mean - err_sum, positions_[0], positions_[1]};
  currents_ = {iq_sum, currents_[0], currents_[1], currents_[2]};
  if (sums_ < kFirst && ++sums_ < kFirst) return false;

  const std::int32_t d0 = positions_[0] - positions_[1], d1 = positions_[1] - positions_[2];
  const std::int32_t slowest = setup_.slowest;
  if ((d0 < slowest || d1 < slowest) && (d0 > -slowest || d1 > -slowest)) return false;

  // i0 + 6 i1 + i2 with i(k) = 27 I(k) + 5 I(k+1)
  const std::array<std::int32_t, 4>& i = currents_;
  current = sat(rs(27 * i[0] + 167 * i[1] + 57 * i[2] + 5 * i[3], 6), 20);
  const std::int32_t at = floor_div(positions_[1], setup_.pitch);
  phi = {sat(rs(d0 - d1, setup_.accel_shift), 16),
         sat(rs(d0 + d1, setup_.speed_shift), 16),
         d0 > 0 ? kOne : -kOne,
         sine1024(at),
         sine1024(at + 256),
         kOne};
  return true;
}

template <std::uint32_t I, std::uint32_t J>
void Estimator::learn_from(const Theta& phi, std::uint32_t& beyond) {
  auto& r = element<I, J>();
  constexpr std::int32_t kRest = I == J ? kStart[I] : 0;
  const std::int32_t both = I == kForce ? kOne * phi[J] : phi[I] * phi[J];
  set(r, value(r) + both - rs(value(r) - kRest, kForget));
  if constexpr (I >= 2 && J < 2) beyond |= outside(r);
  if constexpr (I == J) invert<I>();
  if constexpr (J < I) {
    learn_from<I, J + 1>(phi, beyond);
  } else if constexpr (I + 1 < kUnknowns) {
    learn_from<I + 1, 0>(phi, beyond);
  }
}

void Estimator::learn(const Theta& phi) {
  std::uint32_t beyond = 0;
  learn_from<0, 0>(phi, beyond);
  if (beyond >> 31 == 0) return;
  fits_ = false;
  for (std::uint32_t n = 0; n < fitting_.size(); ++n) set(wide_[3 + n], std::int64_t{fitting_[n]});
}

void Estimator::learn_wide(const Theta& phi) {
  bool fit = true;
  for (std::uint32_t i = 0; i < kUnknowns; ++i) {
    for (std::uint32_t j = 0; j <= i; ++j) {
      const std::int64_t before = weight(i, j);
      const std::int32_t rest = i == j ? kStart[i] : 0;
      const std::int64_t r = before + phi[i] * phi[j] - rs(before - rest, kForget);
      if (j >= 2) {
        narrow_[narrow_place(i, j)] = static_cast<std::int32_t>(r);
      } else {
        set(wide_[wide_place(i, j)], r);
        fit = fit && (i < 2 || (r < kFitting && r >= -kFitting));
      }
      if (i == j) invert_wide(i, static_cast<std::uint64_t>(r));
    }
  }
  if (!fit) return;
  fits_ = true;
  for (std::uint32_t n = 0; n < fitting_.size(); ++n) {
    fitting_[n] = static_cast<std::int32_t>(value(wide_[3 + n]));
  }
}

template <std::uint32_t I>
void Estimator::invert() {
  const auto d = pattern(element<I, I>());
  if (shifted(d, shift_[I]) - 512 >= 512) shift_[I] = scale_of(d, shift_[I]);
  inverse_[I] = reciprocal(leading(d, shift_[I]));
}

void Estimator::invert_wide(std::uint32_t i, std::uint64_t d) {
  shift_[i] = scale_of(d, shift_[i]);
  inverse_[i] = reciprocal(leading(d, shift_[i]));
}

void Estimator::push(const Theta& phi, std::int32_t current) {
  for (std::uint32_t i = 0; i < kUnknowns; ++i) {
    const std::int64_t pushed = std::int64_t{phi[i]} * current * 65536;
    set(q_[i], value(q_[i]) + pushed - rs(value(q_[i]) - q_start_[i], kForget));
  }
}

// Row I of R times theta, from column J on.
template <std::uint32_t I, std::uint32_t J>
std::uint64_t Estimator::row(const Theta& theta) {
  const std::uint64_t first = product(element<I, J>(), theta[J]);
  if constexpr (J + 1 == kUnknowns) {
    return first;
  } else {
    return first + row<I, J + 1>(theta);
  }
}

// An unknown within its limits. The others are solved with it as it is then: one that was cut only
// after the sweep would drive them away from the solution, further with each step.
[[gnu::always_inline]] inline std::int32_t Estimator::limited(std::uint32_t i,
                                                              std::int32_t solved) {
  if (i == kMass) at_limit_ = solved < setup_.mass_min || solved > setup_.mass_max;
  return clip(solved, least_[i], most_[i]);
}

// One unknown after the other, each with the newest of the others.
template <std::uint32_t I>
void Estimator::solve(Theta& theta) {
  const std::uint64_t left = pattern(q_[I]) - row<I, 0>(theta);
  theta[I] = limited(I, theta[I] + quotient(static_cast<std::int64_t>(left),
                                            pattern(element<I, I>()), shift_[I], inverse_[I]));
  if constexpr (I + 1 < kUnknowns) solve<I + 1>(theta);
}

void Estimator::sweep() {
  Theta theta = theta_;
  solve<0>(theta);
  theta_ = theta;
}

void Estimator::sweep_wide() {
  for (std::uint32_t i = 0; i < kUnknowns; ++i) {
    std::uint64_t left = pattern(q_[i]);
    for (std::uint32_t j = 0; j < kUnknowns; ++j) {
      Wide r{};
      set(r, weight(i, j));
      left -= product(r, theta_[j]);
    }
    const auto diagonal = static_cast<std::uint64_t>(weight(i, i));
    theta_[i] = limited(i, theta_[i] + quotient(static_cast<std::int64_t>(left), diagonal,
                                                shift_[i], inverse_[i]));
  }
}

}  // namespace trammel::sw
