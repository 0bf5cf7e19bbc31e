// SPDX-License-Identifier: Apache-2.0
//
// gantry_tau of its bit-exact twin behind the Chip interface.
#include "cosim/bus_twin.hpp"
#include "machines/gantry/surroundings.hpp"
#include "machines/gantry/twin_words.hpp"

namespace trammel::gantry {
namespace {

class TwinChip final : public cosim::BusTwin<GantryChip, Surroundings, Pins, exact::GantryTau> {
 public:
  using BusTwin::BusTwin;

  const Store& store() const override { return state_.store; }
  Words words() const override { return words_of(twin_); }
};

}  // namespace

std::unique_ptr<GantryChip> make_twin_chip(const ChipSetup& setup) {
  return std::make_unique<TwinChip>(exact::GantryTau(), Surroundings(setup));
}

}  // namespace trammel::gantry
