// SPDX-License-Identifier: Apache-2.0
//
// gantry_tau of its bit-exact twin behind the Chip interface.
#include <cstddef>

#include "cosim/bus_twin.hpp"
#include "machines/gantry/board.hpp"
#include "models/exact/chips/gantry_tau.hpp"

namespace trammel::gantry {
namespace {

class TwinChip final : public cosim::BusTwin<GantryChip, Board, exact::GantryTau> {
 public:
  explicit TwinChip(const ChipSetup& setup) : BusTwin(exact::GantryTau()) {
    state_ = Board(setup);
    in_.nv_data = state_.nv_word();
    reset();
    state_.lines = pins();
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

  void sense(cosim::Lines lines) override {
    in_.rx = level(lines, kRx);
    in_.overtemp = static_cast<std::uint8_t>((level(lines, overtemp(0)) ? 1 : 0) |
                                             (level(lines, overtemp(1)) ? 2 : 0));
  }

 private:
  cosim::Lines pins() const {
    cosim::Lines lines = cosim::Lines{twin_.tx()} << kTx;
    for (int motor = 0; motor < kMotors; ++motor) {
      const exact::ForcePwm::Out out = twin_.motors()[static_cast<std::size_t>(motor)];
      lines |= cosim::Lines{out.pwm} << pwm(motor) | cosim::Lines{out.negative} << negative(motor);
    }
    return lines;
  }

  void put(const cosim::BusOp& op) override { twin_.request(op.addr, op.data, op.write); }

  bool drive_changed() override {
    const exact::AdcSerial::Out adc = twin_.adc();
    const exact::CalibrationStore::Out nv = twin_.nv();
    const Ports ports{adc.cs_n, adc.sclk, adc.din, nv.nv_valid, nv.nv_write, nv.nv_addr,
                      nv.nv_data};
    if (state_.serve(ports, [this](int ch) { return plant_->sample(ch, state_.now - 1); })) {
      in_.adc_dout = state_.dout;
      in_.nv_data = state_.nv_word();
    }
    return state_.changed(pins());
  }

  const cosim::Plant* plant_ = nullptr;
};

}  // namespace

std::unique_ptr<GantryChip> make_twin_chip(const ChipSetup& setup) {
  return std::make_unique<TwinChip>(setup);
}

}  // namespace trammel::gantry
