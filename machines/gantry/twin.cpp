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
  explicit TwinChip(const ChipSetup& setup) : BusTwin(exact::GantryTau()) {
    state_ = Board(setup);
    in_.nv_data_i = state_.nv_word();
    reset();
    BusTwin::drive_changed();
  }

  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    plant_ = &plant;
    return BusTwin::run(end, plant);
  }

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

 private:
  void put(const cosim::BusOp& op) override { twin_.request(op.addr, op.data, op.write); }

  bool drive_changed() override {
    state_.serve(twin_.out(), in_,
                 [this](int channel) { return plant_->sample(channel, state_.now - 1); });
    return BusTwin::drive_changed();
  }

  const cosim::Plant* plant_ = nullptr;
};

}  // namespace

std::unique_ptr<GantryChip> make_twin_chip(const ChipSetup& setup) {
  return std::make_unique<TwinChip>(setup);
}

}  // namespace trammel::gantry
