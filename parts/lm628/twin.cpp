// SPDX-License-Identifier: Apache-2.0
#include "cosim/hosted_twin.hpp"
#include "parts/lm628/surroundings.hpp"
#include "parts/lm628/twin_words.hpp"

namespace trammel::lm628 {
namespace {

class TwinChip final : public cosim::HostedTwin<Lm628Chip, Surroundings, exact::Lm628> {
 public:
  explicit TwinChip(const PartOptions& part)
      : HostedTwin(exact::Lm628(clock_of(part.clock_MHz))) {
    state_ = Surroundings(part);
    in_.wrap = part.wrap;
    reset();
  }

  cosim::Lines drive() const override { return state_.lines; }
  bool host_irq() const override { return host_pin(); }
  Words words() const override { return words_of(twin_); }

  void sense(cosim::Lines lines) override {
    in_.a = level(lines, kEncoderA);
    in_.b = level(lines, kEncoderB);
    in_.index_n = !level(lines, kIndex);
  }

  void request(const cosim::BusOp& op) override { state_.port.request(op); }

 private:
  bool bus_active() const override { return state_.port.active(); }
  bool publishes() const override { return twin_.commits(); }
  bool host_pin() const override { return twin_.out().hi; }

  void put_transfer() override {
    const HostPins pins = state_.port.pins();
    in_.host = {pins.cs_n, pins.rd_n, pins.wr_n, pins.ps, pins.d};
    in_.reset_n = pins.reset_n;
  }

  bool bus_edge(cosim::Clk edge) override {
    const bool ended = state_.bus_edge(edge, twin_.out().d, host_pin());
    if (ended) put_transfer();
    return ended;
  }

  bool drive_changed() override {
    const exact::Lm628Output::Out out = twin_.out().drive;
    return state_.output({out.dac, out.dac_hi_lo, out.dac_wr_n, out.pwm_mag, out.pwm_sign});
  }
};

}  // namespace

std::unique_ptr<Lm628Chip> make_twin_chip(const PartOptions& part) {
  return std::make_unique<TwinChip>(part);
}

}  // namespace trammel::lm628
