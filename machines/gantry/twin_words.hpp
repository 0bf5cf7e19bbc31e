// SPDX-License-Identifier: Apache-2.0
//
// What a sample takes from inside the bit-exact twin of gantry_tau.
#pragma once

#include "machines/gantry/chip.hpp"
#include "models/exact/chips/gantry_tau.hpp"

namespace trammel::gantry {

inline Words words_of(const exact::GantryTau& twin) {
  const exact::SincosObserver::Out& o = twin.observed();
  Words w;
  w.position = o.position;
  w.velocity = o.velocity;
  w.ticks = twin.ticks();
  w.phase = o.phase;
  w.region = o.region;
  w.known = o.known;
  w.force = {twin.force(0), twin.force(1)};
  w.codes = twin.slots().codes();
  w.malformed = static_cast<std::uint16_t>(twin.serial().malformed());
  w.lost = static_cast<std::uint16_t>(twin.serial().in().lost());
  return w;
}

}  // namespace trammel::gantry
