// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>
#include <kung_xy_registers.hpp>

#include <cstring>
#include <string>

#include "cosim/kung/verilated/chip_model.hpp"

namespace trammel::kung {

namespace {

using Model = ChipModel<Vkung_xy, NoTrace>;

// A leaping chip, and beside it one that evaluates every clock, with the same inputs.
class AuditedChip final : public KungChip {
 public:
  cosim::Clk now() const override { return leaping_.now(); }
  void sense(cosim::Lines lines) override {
    plain_.sense(lines);
    leaping_.sense(lines);
  }
  void request(const cosim::BusOp& op) override {
    plain_.request(op);
    leaping_.request(op);
  }
  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    const cosim::Stop stop = leaping_.run(end, plant);
    if (broken_) return stop;
    const cosim::Stop same = plain_.run(stop.edge + 1, plant);
    if (same.edge != stop.edge || same.why != stop.why) {
      differs("the stop", same.edge, "plain stops for " + std::to_string(same.why) + ", leapt at " +
              std::to_string(stop.edge) + " for " + std::to_string(stop.why));
    } else {
      compare(stop.edge);
    }
    return stop;
  }

  cosim::Lines drive() const override { return leaping_.drive(); }
  bool irq() const override { return leaping_.irq(); }
  std::uint32_t rdata() const override { return leaping_.rdata(); }
  void read_words(int axis, AxisSample& sample) const override {
    leaping_.read_words(axis, sample);
  }
  CurrentWords current(int axis) const override { return leaping_.current(axis); }
  std::int32_t rule(int axis, int index) const override { return leaping_.rule(axis, index); }
  std::int32_t integral(int axis) const override { return leaping_.integral(axis); }
  Fault fault() const override { return leaping_.fault(); }
  cosim::Clk evaluated() const override { return leaping_.evaluated(); }
  WakeCounts wakes() const override { return leaping_.wakes(); }
  std::optional<cosim::BrokenPromise> broken_promise() const override { return broken_; }

 private:
  void compare(cosim::Clk edge) {
    for_each_register(plain_.registers(), leaping_.registers(),
                      [this, edge](const char* name, const auto& plain, const auto& leapt) {
                        if (!broken_ && std::memcmp(&plain, &leapt, sizeof plain) != 0) {
                          differs(name, edge, text(plain) + " plain, " + text(leapt) + " leapt");
                        }
                      });
  }

  template <class T>
  static std::string text(const T& value) {
    if constexpr (std::is_integral_v<T>) {
      return std::to_string(value);
    } else {
      return "a memory";
    }
  }

  void differs(const char* what, cosim::Clk edge, const std::string& how) {
    broken_ = cosim::BrokenPromise{"leap_is_exact", what, how, edge};
  }

  Model plain_{NoTrace{}, false};
  Model leaping_{NoTrace{}, true};
  std::optional<cosim::BrokenPromise> broken_;
};

}  // namespace

std::unique_ptr<KungChip> make_audited_chip() { return std::make_unique<AuditedChip>(); }

}  // namespace trammel::kung
