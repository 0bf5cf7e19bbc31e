// SPDX-License-Identifier: Apache-2.0
//
// DC link of an inverter: a source behind a resistance and a rectifier charges a capacitor, from
// which the legs draw. Current that the motor gives back only charges it, until a brake chopper
// burns what would raise the voltage further.
//   C dv/dt = max(V_s - v, 0) / R - i,  v <= V_chopper
#pragma once

#include <algorithm>
#include <cmath>

namespace trammel::plant {

struct DcLinkConfig {
  double source = 311;   // [V]
  double ohm = 0;        // [ohm]; 0: the voltage is that of the source
  double farad = 1e-3;   // [F]
  double chopper = 0;    // [V]; 0: none
};

class DcLink {
 public:
  explicit DcLink(const DcLinkConfig& c) : c_(c), volt_(c.source) {}

  bool stiff() const { return c_.ohm == 0; }
  double volt() const { return volt_; }
  double burnt() const { return burnt_; }  // [J] by the chopper
  double supplied() const { return supplied_; }  // [J] from the source of a link that is not stiff

  void set_source(double volt) {
    c_.source = volt;
    if (stiff()) volt_ = volt;
  }

  // `seconds` in which the legs drew the charge [C].
  void draw(double charge, double seconds) {
    if (stiff() || seconds <= 0) return;
    if (volt_ < c_.source || (volt_ == c_.source && charge > 0)) {
      // Towards the voltage at which source and legs agree, but not above the source.
      const double end = c_.source - c_.ohm * charge / seconds;
      const double next = end + (volt_ - end) * std::exp(-seconds / (c_.ohm * c_.farad));
      const double before = volt_;
      volt_ = std::min(next, std::max(c_.source, volt_ - charge / c_.farad));
      supplied_ += c_.source * (c_.farad * (volt_ - before) + charge);
    } else {
      volt_ -= charge / c_.farad;
    }
    volt_ = std::max(volt_, 0.0);
    if (c_.chopper > 0 && volt_ > c_.chopper) {
      burnt_ += 0.5 * c_.farad * (volt_ * volt_ - c_.chopper * c_.chopper);
      volt_ = c_.chopper;
    }
  }

 private:
  DcLinkConfig c_;
  double volt_;
  double burnt_ = 0, supplied_ = 0;
};

}  // namespace trammel::plant
