// SPDX-License-Identifier: Apache-2.0
//
// Position controller of one axis of kung_xy with its sequence, its table reset and the registers
// TAB_ADDR and TAB_DATA (rtl/control/afc.sv, rule_store.sv and their wiring). advance(n) passes
// edges at which only the sample or the table reset in progress continues; step(n) is any edge.
// due() is the first edge that needs a step.
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/exact/chips/kung_time.hpp"
#include "models/exact/control/afc.hpp"

namespace trammel::exact {

class KungPosition {
 public:
  struct In {
    Afc::Config config{};
    bool reset_model = false;
    std::int32_t r = 0, x_p = 0;
    int tab_addr = 0;
  };
  struct Event {
    bool tick = false;         // 2 kHz
    bool reset_table = false;  // pulse
    bool tab_write = false;    // of TAB_DATA, once the controller is idle
    std::int32_t tab_data = 0;
  };

  KungPosition() { ask(); }

  void advance(Clk n, const In& in, Sticky& saturated) {
    if (n <= at_) return;
    asked_ = asked_ || in.reset_model;
    if (running_) run_to(n, in, table_ == Table::kIdle, saturated);
    if (!running_ && saturation_due_) publish_saturation(n, saturated);
    if (table_ == Table::kFill) fill_to(n, in.tab_addr);
    at_ = n;
  }

  // Edge n, after advance(n - 1). True when the sample is complete.
  bool step(Clk n, const In& in, const Event& event, Sticky& saturated) {
    const bool running = running_, table_busy = table_ != Table::kIdle;
    const bool starts = !running && !table_busy && (event.tick || waiting_);
    const bool asked = asked_ || in.reset_model;
    if (event.tab_write) write(n, in.tab_addr, event.tab_data);
    switch (table_) {
      case Table::kIdle:
        if (event.reset_table) table_ = Table::kAsked;
        break;
      case Table::kAsked:
        if (!running) {
          table_ = Table::kFill;
          fill_from_ = n;
          filled_ = 0;
        }
        break;
      case Table::kFill:
        fill_to(n, in.tab_addr);
        if (filled_ == RuleStore::kRules) table_ = Table::kIdle;
        break;
    }
    if (running) run_to(n, in, !table_busy, saturated);
    if (saturation_due_) publish_saturation(n, saturated);
    if (!running && table_busy) waiting_ = waiting_ || event.tick;
    asked_ = asked;
    if (starts) {
      running_ = true;
      waiting_ = false;
      start_ = n;
      afc_.start(asked);
      asked_ = false;
    }
    at_ = n;
    const bool done = running && n == start_ + Afc::kClocks;
    if (done) running_ = false;
    return done;
  }

  Clk due() const {
    if (running_) return start_ + Afc::kClocks;
    if (table_ == Table::kFill) return fill_from_ + RuleStore::kRules;
    return waiting_ || table_ == Table::kAsked ? at_ + 1 : kNever;
  }
  // The edge at which advance() next has something to show.
  Clk next_word() const {
    return running_ ? start_ + afc_.next_clock() : saturation_due_ ? start_ + kSaturated : kNever;
  }

  bool busy() const { return running_ || waiting_ || table_ != Table::kIdle; }
  bool overruns() const { return running_ || waiting_; }
  int step_number() const { return running_ ? static_cast<int>(at_ - start_) / 2 : 0; }
  const Afc& afc() const { return afc_; }

  // TAB_ADDR changes at edge n.
  void address(Clk n, int before, int after) {
    refresh(n, before);
    if (after != port_addr_) port_due_ = std::min(port_due_, n + 1);
  }
  // What TAB_DATA reads after edge n.
  std::int32_t table_read(Clk n, int addr) {
    refresh(n, addr);
    return port_;
  }

 private:
  enum class Table { kIdle, kAsked, kFill };
  static constexpr Clk kSaturated = Afc::kPublished + 1;  // STATUS shows saturation

  // After reset the table is filled first.
  void ask() { table_ = Table::kAsked; }

  // A table that waits for its reset is no longer tuned.
  void run_to(Clk n, const In& in, bool writable, Sticky& saturated) {
    const auto clock = static_cast<int>(n - start_);
    const Afc::In words{in.r, in.x_p};
    const int before = afc_.next_clock();
    if (before > clock) return;
    Afc::Config config = in.config;
    config.adapt = config.adapt && writable;
    for (const int tuned : {64, 66, 68, 70}) {
      if (clock < tuned || afc_.next_clock() > tuned || !config.adapt) continue;
      afc_.run_to(tuned - 1, config, words);
      before_write(start_ + tuned, in.tab_addr);
      afc_.run_to(tuned, config, words);
    }
    afc_.run_to(clock, config, words);
    if (before <= Afc::kPublished && afc_.next_clock() > Afc::kPublished) saturation_due_ = true;
    if (saturation_due_) publish_saturation(n, saturated);
  }

  void publish_saturation(Clk n, Sticky& saturated) {
    if (n < start_ + kSaturated) return;
    if (afc_.out().saturated) saturated.set(start_ + kSaturated);
    saturation_due_ = false;
  }

  void fill_to(Clk n, int addr) {
    while (filled_ < RuleStore::kRules && fill_from_ + 1 + filled_ <= n) {
      before_write(fill_from_ + 1 + filled_, addr);
      afc_.set_rule(filled_, RuleStore::initial(filled_));
      ++filled_;
    }
  }

  void write(Clk n, int addr, std::int32_t value) {
    if (addr >= RuleStore::kRules) return;
    before_write(n, addr);
    afc_.set_rule(addr, value);
  }

  // Once stale, the external port reads again in the first clock without a write.
  void before_write(Clk n, int addr) {
    refresh(n - 1, addr);
    port_due_ = n + 1;
  }
  void refresh(Clk n, int addr) {
    if (port_due_ > n) return;
    port_ = afc_.rule(addr);
    port_addr_ = addr;
    port_due_ = kNever;
  }

  Afc afc_;
  Clk at_ = -1;
  bool running_ = false, waiting_ = false, asked_ = false;
  Clk start_ = -kLongAgo;
  bool saturation_due_ = false;
  Table table_ = Table::kIdle;
  Clk fill_from_ = 0;
  int filled_ = 0;
  std::int32_t port_ = 0;
  int port_addr_ = 0;
  Clk port_due_ = kNever;
};

}  // namespace trammel::exact
