// SPDX-License-Identifier: Apache-2.0
//
// The two-axis table as a plant: signatures of cosim::Plant (models/ may not see cosim/, which
// wraps it). State advances only in commit(); an axis is committed only when its own gates change
// or its own event is due, so what the other axis does cannot change its bits.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models/pins/xy_pins.hpp"
#include "models/plant/ad7476.hpp"
#include "models/plant/axis.hpp"

namespace trammel::plant {

using Lines = std::uint64_t;  // packed pins

struct XyTableConfig {
  std::array<AxisConfig, xy::kAxes> axis;
  std::uint64_t seed = 1;
  std::int64_t clock_ps = 20000;
};

// Kung et al. 2012 with the calibrated friction and carried mass (section 2).
inline XyTableConfig default_xy_table() {
  XyTableConfig c;
  c.axis[1].coulomb_n = 4.8;
  c.axis[1].mass_kg = 2.5 + 5.5;
  return c;
}

class XyTable {
 public:
  explicit XyTable(const XyTableConfig& c)
      : seed_(c.seed),
        adc_bits_{c.axis[0].adc_bits, c.axis[1].adc_bits},
        axes_{Axis(c.axis[0], period(c), hash(c.seed)),
              Axis(c.axis[1], period(c), hash(~c.seed))} {}

  Lines sense() const {
    Lines lines = 0;
    for (int k = 0; k < xy::kAxes; ++k) {
      const Encoder& e = axis(k).encoder();
      lines |= Lines{e.a()} << xy::encoder_a(k) | Lines{e.b()} << xy::encoder_b(k) |
               Lines{e.z()} << xy::encoder_z(k);
    }
    return lines;
  }

  Clk next() const { return std::min(axes_[0].next(), axes_[1].next()); }

  void commit(Clk n, Lines drive) {
    for (int k = 0; k < xy::kAxes; ++k) {
      Axis& a = axes_[static_cast<std::size_t>(k)];
      const unsigned gates = xy::axis_gates(drive, k);
      if (gates != a.gates() || n >= a.next()) a.commit(n, gates);
    }
  }

  // From edge n on, after a commit there.
  void open_phase(Clk n, int k, int phase, bool open) {
    axes_[static_cast<std::size_t>(k)].open_phase(n, phase, open);
  }
  void supply(Clk n, double share) {
    for (Axis& a : axes_) a.supply(n, share);
  }

  // The 16 bits of a converter's frame.
  int sample(int channel, Clk n) const {
    const int k = channel / 2;
    return serial_frame(axis(k).code(channel % 2, seed_, channel, n),
                        adc_bits_[static_cast<std::size_t>(k)]);
  }

  AxisState state(int k, Clk n) const { return axis(k).state(n); }
  bool at_stop(int k) const { return axis(k).at_stop(); }
  std::int64_t count(int k) const { return axis(k).encoder().count(); }
  bool shoot_through() const { return axes_[0].shoot_through() || axes_[1].shoot_through(); }
  const Axis& axis(int k) const { return axes_[static_cast<std::size_t>(k)]; }

 private:
  static double period(const XyTableConfig& c) { return static_cast<double>(c.clock_ps) * 1e-12; }

  std::uint64_t seed_;
  std::array<int, xy::kAxes> adc_bits_;
  std::array<Axis, xy::kAxes> axes_;
};

}  // namespace trammel::plant
