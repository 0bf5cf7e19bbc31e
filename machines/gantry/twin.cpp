// SPDX-License-Identifier: Apache-2.0
//
// gantry_tau of its bit-exact twin behind the Chip interface.
#include <cstddef>

#include "cosim/bus_twin.hpp"
#include "machines/gantry/board.hpp"
#include "models/exact/chips/gantry_tau.hpp"

namespace trammel::gantry {
namespace {

class TwinChip final : public cosim::BusTwin<GantryChip, Board, Pins, exact::GantryTau> {
 public:
  using BusTwin::BusTwin;

  const Store& store() const override { return state_.store; }
  Words words() const override {
    const exact::SincosObserver::Out& o = twin_.observed();
    Words w;
    w.position = o.position;
    w.velocity = o.velocity;
    w.ticks = twin_.ticks();
    w.phase = o.phase;
    w.region = o.region;
    w.known = o.known;
    w.force = {twin_.force(0), twin_.force(1)};
    w.codes = twin_.slots().codes();
    w.malformed = static_cast<std::uint16_t>(twin_.serial().malformed());
    w.lost = static_cast<std::uint16_t>(twin_.serial().in().lost());
    return w;
  }
};

}  // namespace

std::unique_ptr<GantryChip> make_twin_chip(const ChipSetup& setup) {
  return std::make_unique<TwinChip>(exact::GantryTau(), Board(setup));
}

}  // namespace trammel::gantry
