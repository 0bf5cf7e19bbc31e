// SPDX-License-Identifier: Apache-2.0
#include <Vmcafee_fast.h>
#include <Vmcafee_fast___024root.h>

#include "cosim/lm628/verilated/words.hpp"
#include "cosim/mcafee/chip.hpp"
#include "cosim/verilated/axi_lite.hpp"
#include "cosim/verilated/hosted_chip.hpp"
#include "sw_nios/hal/mcafee_map.hpp"

namespace trammel::mcafee {
namespace {

class VerilatedMcafee final : public cosim::HostedChip<McafeeChip, Vmcafee_fast> {
 public:
  explicit VerilatedMcafee(bool leap) : HostedChip(leap) {
    bus_.reset(*model_);
    sense(0);
    reset();
    drive_changed();
  }

  cosim::Lines drive() const override { return codes_; }
  bool host_irq(int axis) const override { return (model_->hi_o >> axis & 1) != 0; }

  void sense(cosim::Lines lines) override {
    const auto pick = [lines](int x, int y) {
      return static_cast<std::uint8_t>((lines >> x & 1u) | (lines >> y & 1u) << 1);
    };
    model_->enc_a_i = pick(encoder_a(0), encoder_a(1));
    model_->enc_b_i = pick(encoder_b(0), encoder_b(1));
    model_->enc_idx_n_i = static_cast<std::uint8_t>(~pick(marker(0), marker(1)) & 3u);
    model_->limit_i = static_cast<std::uint8_t>(pick(limit_low(0), limit_high(0)) |
                                                pick(limit_low(1), limit_high(1)) << 2);
    dirty_ = true;
  }

  void request(const cosim::BusOp& op) override {
    if (op.addr >= sw::mcafee_map::kTimer) {
      platform_ = op;
      platform_active_ = true;
    } else {
      bus_.request(*model_, op);
    }
  }

  lm628::Words words(int axis) const override {
    const auto& root = *model_->rootp;
    if (axis == 0) {
      return lm628::words_of(root.mcafee_xy__DOT__u_x__DOT__u_engine__DOT__m_q,
                             root.mcafee_xy__DOT__u_x__DOT__u_engine__DOT__u_q,
                             root.mcafee_xy__DOT__u_x__DOT__u_port__DOT__status);
    }
    return lm628::words_of(root.mcafee_xy__DOT__u_y__DOT__u_engine__DOT__m_q,
                           root.mcafee_xy__DOT__u_y__DOT__u_engine__DOT__u_q,
                           root.mcafee_xy__DOT__u_y__DOT__u_port__DOT__status);
  }

 private:
  bool bus_active() const override { return bus_.active() || platform_active_; }
  void settle(bool) override {
    if (dirty_ || bus_.active()) model_->eval();
    if (bus_.active()) bus_.before_edge(*model_);
  }
  bool publishes() const override { return (model_->sample_o & 1) != 0; }
  bool host_pin() const override { return model_->irq_o != 0; }

  bool bus_edge(cosim::Clk edge) override {
    if (platform_active_) return platform_edge(edge);
    dirty_ = true;
    if (!bus_.after_edge(*model_)) return false;
    rdata_ = bus_.rdata();
    return true;
  }

  // A transfer of its own registers takes one clock.
  bool platform_edge(cosim::Clk edge) {
    namespace map = sw::mcafee_map;
    platform_active_ = false;
    if (platform_.addr == map::kTimer && platform_.write) {
      timer_.write(edge, platform_.data);
    } else if (!platform_.write) {
      rdata_ = platform_.addr != map::kIrq
                   ? 0
                   : (host_pin() ? map::kIrqHost : 0u) | (timer_.irq() ? map::kIrqTimer : 0u);
    }
    return true;
  }

  bool drive_changed() override {
    const cosim::Lines codes = cosim::Lines{model_->dac_x_o} << converter(0) |
                               cosim::Lines{model_->dac_y_o} << converter(1);
    const bool changed = codes != codes_;
    codes_ = codes;
    return changed;
  }

  cosim::AxiLiteMaster bus_;
  cosim::BusOp platform_;
  bool platform_active_ = false;
  cosim::Lines codes_ = 0;
};

}  // namespace

std::unique_ptr<McafeeChip> make_verilated_chip(bool leap) {
  return std::make_unique<VerilatedMcafee>(leap);
}

}  // namespace trammel::mcafee
