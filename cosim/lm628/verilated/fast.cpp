// SPDX-License-Identifier: Apache-2.0
#include <Vlm628_fast.h>
#include <Vlm628_fast___024root.h>

#include "cosim/lm628/chip.hpp"
#include "cosim/lm628/host_port.hpp"
#include "cosim/lm628/verilated/words.hpp"
#include "cosim/verilated/hosted_chip.hpp"

namespace trammel::lm628 {
namespace {

class VerilatedLm628 final : public cosim::HostedChip<Lm628Chip, Vlm628_fast> {
 public:
  explicit VerilatedLm628(bool leap) : HostedChip(leap) {
    model_->wrap_i = 0;
    sense(0);
    set_pins();
    reset();
  }

  cosim::Lines drive() const override { return code_; }
  bool host_irq() const override { return host_pin(); }

  void sense(cosim::Lines lines) override {
    model_->enc_a_i = lines >> kEncoderA & 1u;
    model_->enc_b_i = lines >> kEncoderB & 1u;
    model_->enc_idx_n_i = (lines >> kIndex & 1u) == 0;
    dirty_ = true;
  }

  void request(const cosim::BusOp& op) override { port_.request(op); }

  Words words() const override {
    const auto& root = *model_->rootp;
    return words_of(root.lm628__DOT__u_engine__DOT__m_q, root.lm628__DOT__u_engine__DOT__u_q,
                    root.lm628__DOT__u_port__DOT__status);
  }

 private:
  void set_pins() {
    const HostPins pins = port_.pins();
    model_->cs_n_i = pins.cs_n;
    model_->rd_n_i = pins.rd_n;
    model_->wr_n_i = pins.wr_n;
    model_->ps_i = pins.ps;
    model_->d_i = pins.d;
    model_->reset_n_i = pins.reset_n;
  }

  bool bus_active() const override { return port_.active(); }
  void settle(bool bus) override {
    if (bus) set_pins();
    if (dirty_ || bus) model_->eval();
  }
  bool publishes() const override { return model_->sample_o != 0; }
  bool host_pin() const override { return model_->hi_o != 0; }

  bool bus_edge(cosim::Clk edge) override {
    namespace map = sw::lm628_map;
    if (port_.takes_data()) rdata_ = model_->d_o;
    if (!port_.advance()) return false;
    const cosim::BusOp& op = port_.op();
    if (op.addr == map::kTimer && op.write) {
      timer_.write(edge, op.data);
    } else if (op.addr == map::kIrq && !op.write) {
      rdata_ = (host_pin() ? map::kIrqHost : 0u) | (timer_.irq() ? map::kIrqTimer : 0u);
    }
    set_pins();
    dirty_ = true;
    return true;
  }

  bool drive_changed() override {
    const bool strobe = model_->dac_wr_n_o && !dac_wr_n_;
    dac_wr_n_ = model_->dac_wr_n_o != 0;
    const unsigned six = model_->dac_o >> 2;
    if (strobe && !model_->dac_hi_lo_o) low_six_ = six;
    if (!strobe || !model_->dac_hi_lo_o || (six << 6 | low_six_) == code_) return false;
    code_ = six << 6 | low_six_;
    return true;
  }

  HostPort port_;
  bool dac_wr_n_ = true;
  unsigned low_six_ = 0;
  unsigned code_ = static_cast<unsigned>(kZeroCode);
};

}  // namespace

std::unique_ptr<Lm628Chip> make_verilated_chip(bool leap) {
  return std::make_unique<VerilatedLm628>(leap);
}

}  // namespace trammel::lm628
