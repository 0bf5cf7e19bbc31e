// SPDX-License-Identifier: Apache-2.0
//
// A verilated soc_host behind the interface SocCore. `Registers` knows the core: pc(root) and
// next_pc(root) read its program counter, and kSettles is the number of clocks after which it
// stands still while it waits. Included only by units that know the model.
#pragma once

#include <verilated.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "cosim/verilated/clocked_model.hpp"
#include "machines/kung/chip/soc.hpp"
#include "sw_nios/hal/soc_map.hpp"

namespace trammel::kung {

namespace map = sw::soc_map;


template <class Model, class Registers>
class VerilatedCore final : public SocCore {
  using Root = std::remove_pointer_t<decltype(Model::rootp)>;

 public:
  VerilatedCore(const CoreMemory& memory, bool audit) : audit_(audit) {
    Model& m = *model_;
    m.irq_i = m.bus_ready_i = 0;
    m.bus_rdata_i = 0;
    m.uart_rx_i = 1;
    m.rst_i = 1;
    auto& words = root().soc_host__DOT__u_ram__DOT__words;
    for (std::size_t n = 0; n < kWords; ++n) words[n] = n < memory.size() ? memory[n] : 0;
    for (int i = 0; i < kResetEdges; ++i) clock(true);
    m.rst_i = 0;
    changed_ = true;
    model_.settle(now_, true);
    awake_ = 0;
  }

  cosim::Clk now() const override { return now_; }
  Asks asks() const override {
    if (model_->bus_valid_o) return Asks::kTransfer;
    return model_->asks_o ? Asks::kInterrupt : Asks::kNothing;
  }
  cosim::BusOp transfer() const override {
    const unsigned strobes = model_->bus_wstrb_o;
    if (strobes != 0 && strobes != 0xF) throw std::logic_error("the core writes part of a word");
    return {model_->bus_addr_o, model_->bus_wdata_o, strobes != 0};
  }
  void step() override {
    clock(false);
    stalled_ = 0;
  }
  void answer(std::uint32_t data) override {
    model_->bus_ready_i = 1;
    model_->bus_rdata_i = data;
    clock(true);
    model_->bus_ready_i = 0;
    settle();
  }
  void interrupt(bool level) override {
    if (level && now_ >= broken_from_) {
      // The instruction behind the one that it has fetched ahead.
      poke(Registers::next_pc(*model_->rootp) + 4, 0);
      broken_from_ = cosim::kNever;
    }
    waited_ = true;
    model_->irq_i = level;
    clock(level);
    model_->irq_i = 0;
    stalled_ = model_->asks_o ? stalled_ + 1 : 0;
    if (level) settle();
  }
  cosim::Clk still() override {
    if (!model_->quiescent_o || stalled_ < Registers::kSettles) return now_;
    if (audit_) try_still();
    return host_ == nullptr ? cosim::kNever : host_->next();
  }
  void skip(cosim::Clk edge) override { now_ = edge; }
  std::optional<cosim::CoreTrap> trap() const override {
    if (!model_->trap_o) return std::nullopt;
    return cosim::CoreTrap{now_, Registers::pc(*model_->rootp)};
  }

  const sw::Mailbox& mailbox() const override {
    const std::uint32_t at = peek(peek(map::kHeader + 4 * map::kReport));
    if (at == 0) return mailbox_;
    const auto word = [this, at](std::uint32_t n) { return peek(at + 4 * n); };
    const auto count = [&word](std::uint32_t n) { return static_cast<std::int32_t>(word(n)); };
    mailbox_ = {word(0), word(1), word(2), word(3), word(4), {count(5), count(6)},
                {count(7), count(8)}};
    return mailbox_;
  }
  void poke(std::uint32_t address, std::uint32_t word) override {
    root().soc_host__DOT__u_ram__DOT__words[address / 4 % kWords] = word;
  }
  std::uint32_t peek(std::uint32_t address) const override {
    return model_->rootp->soc_host__DOT__u_ram__DOT__words[address / 4 % kWords];
  }
  void break_at(cosim::Clk edge) override { broken_from_ = edge; }
  void connect(cosim::SerialHost& host) override { host_ = &host; }
  bool listens() const override { return waited_; }
  cosim::Clk awake() const override { return awake_; }
  std::string moved() const override { return moved_; }

 private:
  static constexpr std::size_t kWords = sizeof(Root::soc_host__DOT__u_ram__DOT__words) / 4;
  static constexpr int kResetEdges = 4;   // as the chip
  static constexpr int kTried = 20;       // clocks of an audit

  Root& root() { return *model_->rootp; }

  void settle() {
    model_.settle(now_, true);
    changed_ = false;
  }
  void clock(bool changed) {
    if (host_ != nullptr) {
      const bool level = host_->level(now_);
      changed = changed || level != (model_->uart_rx_i != 0);
      model_->uart_rx_i = level;
      host_->see(now_, model_->uart_tx_o != 0);
    }
    model_.settle(now_, changed || changed_);
    changed_ = false;
    model_.raise(now_);
    ++now_;
    ++awake_;
  }

  // No byte of the model may change, its memory included.
  void try_still() {
    if (!moved_.empty()) return;
    before_.resize(sizeof(Root));
    std::memcpy(before_.data(), static_cast<const void*>(&root()), before_.size());
    for (int n = 0; n < kTried; ++n) model_.raise(now_);
    if (std::memcmp(before_.data(), static_cast<const void*>(&root()), before_.size()) != 0) {
      moved_ = "the waiting core moved after clock " + std::to_string(now_);
    }
  }

  cosim::ClockedModel<Model, cosim::NoTrace> model_{cosim::NoTrace{}, {false, false}};
  bool audit_;
  cosim::SerialHost* host_ = nullptr;
  cosim::Clk broken_from_ = cosim::kNever;
  cosim::Clk now_ = -kResetEdges, awake_ = 0;
  int stalled_ = 0;
  bool waited_ = false;
  bool changed_ = true;
  mutable sw::Mailbox mailbox_;
  std::vector<char> before_;
  std::string moved_;
};

}  // namespace trammel::kung
