// SPDX-License-Identifier: Apache-2.0
//
// Three-leg voltage source inverter on a stiff DC link, from its actual gate bits. Currents count
// positive out of the leg. A leg with one switch on is tied to a rail; with both off the sign of
// its current selects the diode (out: lower, in: upper); with both off and no current it floats at
// the voltage that keeps the current zero, unless a diode would conduct at that voltage. A leg
// whose phase is open floats whatever its switches and diodes do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trammel::plant {

struct InverterConfig {
  double dc_link = 311;    // [V]
  double switch_drop = 0;  // [V]
  double diode_drop = 0;   // [V]
};

// Gate bits of an axis: upper switches of A, B, C at bits 0..2, lower switches at bits 3..5.
constexpr bool upper_on(unsigned gates, std::size_t leg) { return ((gates >> leg) & 1u) != 0; }
constexpr bool lower_on(unsigned gates, std::size_t leg) {
  return ((gates >> (leg + 3)) & 1u) != 0;
}
constexpr bool both_off(unsigned gates, std::size_t leg) {
  return !upper_on(gates, leg) && !lower_on(gates, leg);
}
constexpr bool shoot_through(unsigned gates) { return (gates & (gates >> 3) & 7u) != 0; }

struct Legs {
  std::array<double, 3> volt{};  // [V] from the negative rail
  std::array<int, 3> diode{};    // sign of the current a diode carries; 0: switched or floating
  unsigned floating = 0;         // bit per leg that carries no current
  unsigned upper = 0;            // bit per leg whose current the upper rail carries
  bool open = false;             // no current can flow at all
};

class Inverter {
 public:
  explicit Inverter(const InverterConfig& c) : c_(c) {}

  const InverterConfig& config() const { return c_; }
  void set_dc_link(double volt) { c_.dc_link = volt; }  // [V]

  // current: phase currents; zero: bit per leg whose current is known to be zero; emf: phase
  // back-EMF; keep_zero(leg, volt): voltage of `leg` that keeps its current zero, given the other
  // two; opened: bit per leg whose phase is open.
  template <class KeepZero>
  Legs resolve(unsigned gates, const std::array<double, 3>& current, unsigned zero,
               const std::array<double, 3>& emf, KeepZero keep_zero, unsigned opened = 0) const {
    Legs legs;
    legs.upper = gates & ~(gates >> 3) & ~opened & 7u;
    for (std::size_t k = 0; k < 3; ++k) {
      if (((opened >> k) & 1u) != 0) {
        legs.floating |= 1u << k;
      } else if (!both_off(gates, k)) {
        legs.volt[k] = switched(gates, k, current[k]);
      } else if (((zero >> k) & 1u) == 0 && current[k] != 0) {
        clamp(legs, k, current[k] > 0 ? 1 : -1);
      } else {
        legs.floating |= 1u << k;
      }
    }
    if (legs.floating == 0) return legs;
    if (legs.floating == 7) open_all(legs, emf, opened);
    if (count(legs.floating) == 2) open_two(legs, emf, opened);
    if (count(legs.floating) == 1) {
      const std::size_t k = first(legs.floating);
      const double v = keep_zero(k, legs.volt);
      if (opened == 0 && (v > top() || v < bottom())) {
        clamp(legs, k, v > top() ? -1 : 1);
      } else {
        legs.volt[k] = v;
      }
    }
    legs.open = count(legs.floating) > 1;
    return legs;
  }

 private:
  double top() const { return c_.dc_link + c_.diode_drop; }
  double bottom() const { return -c_.diode_drop; }

  double switched(unsigned gates, std::size_t leg, double i) const {
    if (upper_on(gates, leg) && lower_on(gates, leg)) return 0.5 * c_.dc_link;
    const double rail = upper_on(gates, leg) ? c_.dc_link : 0;
    if (i == 0) return rail;
    const bool through_switch = upper_on(gates, leg) == (i > 0);
    const double drop = through_switch ? c_.switch_drop : c_.diode_drop;
    return i > 0 ? rail - drop : rail + drop;
  }

  void clamp(Legs& legs, std::size_t leg, int sign) const {
    legs.volt[leg] = sign > 0 ? bottom() : top();
    legs.diode[leg] = sign;
    legs.floating &= ~(1u << leg);
    if (sign < 0) legs.upper |= 1u << leg;
  }

  // No leg conducts: a pair of diodes does when the line back-EMF exceeds the link (rectifier).
  void open_all(Legs& legs, const std::array<double, 3>& emf, unsigned opened) const {
    if (count(opened) > 1) return;
    std::size_t high = first(~opened & 7u), low = high;
    for (std::size_t k = 0; k < 3; ++k) {
      if (((opened >> k) & 1u) != 0) continue;
      if (emf[k] > emf[high]) high = k;
      if (emf[k] < emf[low]) low = k;
    }
    if (emf[high] - emf[low] <= top() - bottom()) return;
    clamp(legs, high, -1);
    clamp(legs, low, 1);
  }

  // One leg fixes the potential and its current is zero; of the others, the one farthest outside
  // the rails conducts.
  void open_two(Legs& legs, const std::array<double, 3>& emf, unsigned opened) const {
    const std::size_t fixed = first(~legs.floating & 7u);
    std::size_t worst = fixed;
    double excess = 0;
    int sign = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == fixed || ((opened >> k) & 1u) != 0) continue;
      const double v = legs.volt[fixed] + emf[k] - emf[fixed];
      if (v - top() > excess) {
        excess = v - top();
        worst = k;
        sign = -1;
      }
      if (bottom() - v > excess) {
        excess = bottom() - v;
        worst = k;
        sign = 1;
      }
    }
    if (sign != 0) clamp(legs, worst, sign);
  }

  static unsigned count(unsigned mask) { return (mask & 1u) + ((mask >> 1) & 1u) + (mask >> 2); }
  static std::size_t first(unsigned mask) {
    return (mask & 1u) != 0 ? 0 : (mask & 2u) != 0 ? 1 : 2;
  }

  InverterConfig c_;
};

}  // namespace trammel::plant
