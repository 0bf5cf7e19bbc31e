// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>

#include "cosim/kung/verilated/in_step.hpp"

namespace trammel::kung {

namespace {

using AuditModel = ChipModel<Vkung_xy, NoTrace>;

// A leaping chip, and beside it one that evaluates every clock.
class AuditedChip final : public InStep<AuditModel, AuditModel> {
 public:
  AuditedChip()
      : InStep({"leap_is_exact", "leapt", "plain"}, std::tuple{NoTrace{}, true},
               std::tuple{NoTrace{}, false}) {}

  void sense(cosim::Lines lines) override {
    first_.sense(lines);
    second_.sense(lines);
  }
  void request(const cosim::BusOp& op) override {
    first_.request(op);
    second_.request(op);
  }
  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    const cosim::Stop stop = first_.run(end, plant);
    follow(stop, plant);
    compare();
    return stop;
  }
};

}  // namespace

std::unique_ptr<KungChip> make_audited_chip() { return std::make_unique<AuditedChip>(); }

}  // namespace trammel::kung
