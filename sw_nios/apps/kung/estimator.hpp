// SPDX-License-Identifier: Apache-2.0
//
// What one axis carries and what holds it back, from the sums of the precision controller:
// recursive least squares with forgetting over six unknowns (docs/precision.md, "Estimator"). Both
// sides are the means of the 32 ticks between two knots: position from control points and error,
// current from i_q*. Integers only. A core takes 1,000 clocks for a division of 64 bits, of which
// there would be twelve: quotients come from reciprocals, exactly.
#pragma once

#include <array>
#include <cstdint>

namespace trammel::sw {

// Words of one axis; the defaults are those of X with its default motor.
struct EstimatorSetup {
  std::int32_t mass = 431985;     // at the start, as theta
  std::int32_t viscous = 559940;  // at most 3 times that
  std::int32_t coulomb = 131236;  // at most 4 times that, and so the cogging
  std::int32_t mass_min = 109363;
  std::int32_t mass_max = 1749814;
  std::int32_t pitch = 48800;      // period of the cogging [count / 8]
  std::int32_t slowest = 16384;    // way from knot to knot that teaches something [2^-13 count]
  std::uint32_t accel_shift = 3;   // of the regressors of mass and viscous friction
  std::uint32_t speed_shift = 12;
};

class Estimator {
 public:
  enum Unknown : std::uint32_t { kMass, kViscous, kCoulomb, kSine, kCosine, kForce };
  static constexpr std::uint32_t kUnknowns = 6;
  using Theta = std::array<std::int32_t, kUnknowns>;  // Q16
  static constexpr std::int32_t kMostForce = 1 << 23;

  // 64 bits, whose halves are multiplied apart.
  struct Wide {
    std::uint32_t low;
    std::int32_t high;
  };

  // At rest at that control point [2^-8 count].
  [[gnu::cold]] Estimator(const EstimatorSetup& setup, std::int32_t point);

  // ERR_SUM and IQ_SUM of the last knot.
  void step(std::int32_t err_sum, std::int32_t iq_sum);
  void command(std::int32_t point);  // the control point of the next knot, after step()

  const Theta& theta() const { return theta_; }
  // The mass would have left its range in the last step.
  bool at_limit() const { return at_limit_; }
  // R, the sums of the products of two regressors.
  std::int64_t weight(std::uint32_t i, std::uint32_t j) const;

 private:
  static constexpr std::uint32_t kFirst = 5;  // sums before the first sample
  static constexpr std::int32_t kOne = 1024;  // regressor of a constant force
  // R at the start, and what forgetting leaves of it. Within the identification move cogging is a
  // constant force: by its larger weights the difference goes to the force.
  static constexpr std::int32_t kCogging = 3 << 19;
  static constexpr std::array<std::int32_t, kUnknowns> kStart{2048,     8192,     98304,
                                                              kCogging, kCogging, 1024};

  // R is symmetric. Of regressors 2 to 5, at most 1024, 32 bits hold the sums of products, 2^30; so
  // they do of these with 0 and 1 while the axis moves as it should.
  template <std::uint32_t I, std::uint32_t J>
  auto& element() {
    if constexpr (I < J) {
      return element<J, I>();
    } else if constexpr (J >= 2) {
      return narrow_[narrow_place(I, J)];
    } else if constexpr (I >= 2) {
      return fitting_[2 * (I - 2) + J];
    } else {
      return wide_[wide_place(I, J)];
    }
  }
  static constexpr std::uint32_t narrow_place(std::uint32_t i, std::uint32_t j) {
    return (i - 2) * (i - 1) / 2 + (j - 2);
  }
  static constexpr std::uint32_t wide_place(std::uint32_t i, std::uint32_t j) {
    return i == 0 ? 0 : 2 * i - 1 + j;
  }

  bool sample(std::int32_t err_sum, std::int32_t iq_sum, Theta& phi, std::int32_t& current);
  // All of one call are inlined: the unknowns stay in registers.
  template <std::uint32_t I, std::uint32_t J>
  [[gnu::always_inline]] inline void learn_from(const Theta& phi, std::uint32_t& beyond);
  template <std::uint32_t I>
  [[gnu::always_inline]] inline void invert();
  template <std::uint32_t I, std::uint32_t J>
  [[gnu::always_inline]] inline std::uint64_t row(const Theta& theta);
  template <std::uint32_t I>
  [[gnu::always_inline]] inline void solve(Theta& theta);
  std::int32_t limited(std::uint32_t i, std::int32_t solved);
  [[gnu::noinline]] void learn(const Theta& phi);
  [[gnu::noinline]] void push(const Theta& phi, std::int32_t current);
  [[gnu::noinline]] void sweep();
  // The same in loops, small and slower.
  void learn_wide(const Theta& phi);
  void sweep_wide();
  void invert_wide(std::uint32_t i, std::uint64_t d);

  EstimatorSetup setup_;
  std::array<std::int32_t, 4> points_{};     // in effect, the newest first
  std::array<std::int32_t, 3> positions_{};  // means [2^-13 count]
  std::array<std::int32_t, 4> currents_{};   // sums
  std::uint32_t sums_ = 0;
  bool fits_ = true;
  std::array<Wide, 11> wide_{};
  std::array<std::int32_t, 8> fitting_{};  // those of rows 2 to 5 among wide_, if they fit
  std::array<std::int32_t, 10> narrow_{};
  std::array<Wide, kUnknowns> q_{};
  std::array<std::int64_t, kUnknowns> q_start_{};
  std::array<std::uint32_t, kUnknowns> shift_{};   // leaves 10 bits of a diagonal element
  std::array<std::int32_t, kUnknowns> inverse_{};  // 2^(40 + shift) / element
  Theta theta_{};
  Theta least_{}, most_{};  // limits of each unknown, of the mass in this step
  bool at_limit_ = false;
};

}  // namespace trammel::sw
