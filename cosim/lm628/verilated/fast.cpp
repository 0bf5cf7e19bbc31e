// SPDX-License-Identifier: Apache-2.0
//
// The verilated LM628 behind the Chip interface. A leap passes neither `end` nor the timer, and
// none is made during a bus transfer, so that no pin moves inside it.
#include <Vlm628_fast.h>
#include <Vlm628_fast___024root.h>

#include <algorithm>

#include "cosim/lm628/chip.hpp"
#include "cosim/lm628/host_port.hpp"
#include "cosim/verilated/clocked_model.hpp"

namespace trammel::lm628 {
namespace {

// Registers of the engine, in the order of rtl/motion/lm628_engine.asm.
enum Register { kPos = 0, kSpeed = 1, kActual = 5, kKp = 13, kKi = 14, kIl = 16, kSum = 23,
                kDeriv = 25 };

class VerilatedLm628 final : public Lm628Chip {
 public:
  explicit VerilatedLm628(bool leap) : model_(leap) {
    model_->wrap_i = 0;
    sense(0);
    set_pins();
    model_->rst_i = 1;
    while (now_ < 0) {
      model_->eval();
      model_.raise();
      ++now_;
    }
    model_->rst_i = 0;
    dirty_ = true;
  }

  cosim::Clk now() const override { return now_; }
  cosim::Clk evaluated() const override { return evaluated_; }
  cosim::Lines drive() const override { return code_; }
  bool irq() const override { return irq_; }
  bool host_irq() const override { return model_->hi_o != 0; }
  std::uint32_t rdata() const override { return rdata_; }

  void sense(cosim::Lines lines) override {
    model_->enc_a_i = lines >> kEncoderA & 1u;
    model_->enc_b_i = lines >> kEncoderB & 1u;
    model_->enc_idx_n_i = (lines >> kIndex & 1u) == 0;
    dirty_ = true;
  }

  void request(const cosim::BusOp& op) override { port_.request(op); }

  cosim::Stop run(cosim::Clk end, const cosim::Plant&) override {
    while (now_ < end) {
      const cosim::Clk edge = now_;
      const bool bus = port_.active();
      if (bus) set_pins();
      if (dirty_ || bus) model_->eval();
      dirty_ = false;
      ++evaluated_;
      const cosim::Clk clocks = bus ? 1 : std::min({model_.waiting(), end - edge, to_timer(edge)});
      if (clocks > 1) {
        model_.leap(clocks);
        now_ += clocks;
        continue;
      }
      const bool commits = model_->sample_o != 0;
      model_.raise();
      ++now_;
      unsigned why = commits ? cosim::kSample : 0u;
      if (bus && bus_edge(edge)) why |= cosim::kBusDone;
      if (edge == timer_) {
        timer_ = cosim::kNever;
        timer_irq_ = true;
      }
      why |= changed_outputs();
      if (why != 0) return {edge, why};
    }
    return {now_ - 1, cosim::kLimit};
  }

  Words words() const override {
    const auto& root = *model_->rootp;
    const auto m = [&root](int n) {
      return static_cast<std::int64_t>(
          root.lm628__DOT__u_engine__DOT__m_q[static_cast<std::size_t>(n)]);
    };
    Words w;
    w.position = m(kPos);
    w.speed = static_cast<std::int32_t>(m(kSpeed));
    w.actual = static_cast<std::int32_t>(m(kActual));
    w.error = static_cast<std::int32_t>(
        std::clamp<std::int64_t>((w.position >> 16) - w.actual, -32768, 32767));
    w.proportional = static_cast<std::int32_t>(m(kKp) * w.error);
    w.integral = static_cast<std::int32_t>(
        std::clamp<std::int64_t>(m(kKi) * (m(kSum) >> 8), -m(kIl), m(kIl)));
    w.derivative = static_cast<std::int32_t>(m(kDeriv));
    w.output = static_cast<std::int16_t>(root.lm628__DOT__u_engine__DOT__u_q);
    w.status = static_cast<std::uint8_t>(root.lm628__DOT__u_port__DOT__status);
    return w;
  }

 private:
  static constexpr cosim::Clk kResetEdges = 4;

  void set_pins() {
    const HostPins pins = port_.pins();
    model_->cs_n_i = pins.cs_n;
    model_->rd_n_i = pins.rd_n;
    model_->wr_n_i = pins.wr_n;
    model_->ps_i = pins.ps;
    model_->d_i = pins.d;
    model_->reset_n_i = pins.reset_n;
  }

  // The edge at which the timer ends is one of its own.
  cosim::Clk to_timer(cosim::Clk edge) const {
    return timer_ == cosim::kNever ? timer_ : std::max<cosim::Clk>(1, timer_ - edge);
  }

  // Passes the edge of a transfer; true when it ended.
  bool bus_edge(cosim::Clk edge) {
    namespace map = sw::lm628_map;
    if (port_.takes_data()) rdata_ = model_->d_o;
    if (!port_.advance()) return false;
    const cosim::BusOp& op = port_.op();
    if (op.addr == map::kTimer && op.write) {
      timer_ = op.data == 0 ? cosim::kNever : edge + op.data;
      timer_irq_ = false;
    } else if (op.addr == map::kIrq && !op.write) {
      rdata_ = (model_->hi_o ? map::kIrqHost : 0u) | (timer_irq_ ? map::kIrqTimer : 0u);
    }
    set_pins();
    dirty_ = true;
    return true;
  }

  unsigned changed_outputs() {
    unsigned why = 0;
    const bool strobe = model_->dac_wr_n_o && !dac_wr_n_;
    dac_wr_n_ = model_->dac_wr_n_o != 0;
    const unsigned six = model_->dac_o >> 2;
    if (strobe && !model_->dac_hi_lo_o) low_six_ = six;
    if (strobe && model_->dac_hi_lo_o && (six << 6 | low_six_) != code_) {
      code_ = six << 6 | low_six_;
      why |= cosim::kDrive;
    }
    const bool irq = model_->hi_o || timer_irq_;
    if (irq && !irq_) why |= cosim::kIrq;
    irq_ = irq;
    return why;
  }

  cosim::ClockedModel<Vlm628_fast> model_;
  HostPort port_;
  bool dirty_ = true;  // inputs changed since the last evaluation
  cosim::Clk now_ = -kResetEdges;
  cosim::Clk evaluated_ = 0;
  cosim::Clk timer_ = cosim::kNever;  // edge at which it ends
  bool timer_irq_ = false, irq_ = false;
  std::uint32_t rdata_ = 0;
  bool dac_wr_n_ = true;
  unsigned low_six_ = 0;
  unsigned code_ = static_cast<unsigned>(kZeroCode);
};

}  // namespace

std::unique_ptr<Lm628Chip> make_verilated_chip(bool leap) {
  return std::make_unique<VerilatedLm628>(leap);
}

}  // namespace trammel::lm628
