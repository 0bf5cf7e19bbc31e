// SPDX-License-Identifier: Apache-2.0
//
// The verilated chip behind the Chip interface; one template for the fast, the checked and the
// traced model. Included only by the units of this folder.
#pragma once

#include <verilated.h>

#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/verilated/chip_state.hpp"
#include "machines/kung/chip/verilated/probe.hpp"
#include "cosim/verilated/clocked_model.hpp"

namespace trammel::kung {

// A leap never passes `end`, and none is made during a bus transfer: no pin moves inside it.
template <class Model, class Tracer>
class ChipModel : public KungChip, private ChipState {
 public:
  using Root = std::remove_pointer_t<decltype(Model::rootp)>;

  ChipModel(Tracer tracer, cosim::ModelMode mode) : model_(std::move(tracer), mode) {
    quiet_inputs();
    model_->rst_i = 1;
    for (int i = 0; i < kResetEdges; ++i) {
      settle(now_);
      model_.raise(now_);
      ++now_;
    }
    model_->rst_i = 0;
    dirty_ = true;
    remember_outputs(*model_);
  }

  cosim::Clk now() const override { return now_; }
  cosim::Clk evaluated() const override { return evaluated_; }
  std::vector<cosim::DomainActivity> activity() const override { return model_.activity(kDomains); }
  WakeCounts wakes() const override { return wakes_; }

  // Between two runs, all that the next edges depend on.
  Root& registers() { return model_.registers(now_); }
  void upset() { model_.upset(now_); }
  ChipState& state() { return *this; }
  Tracer& tracer() { return model_.tracer(); }

  void sense(cosim::Lines lines) override {
    sense_encoders(*model_, lines);
    model_->trip_i = level(lines, kTripPin);
    dirty_ = true;
    sensed_ = now_;
  }

  void request(const cosim::BusOp& op) override { bus_.request(*model_, op); }

  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    while (now_ < end) {
      const cosim::Clk edge = now_;
      if (dirty_ || bus_.active() || model_.shows(edge)) settle(edge);
      const bool bus = bus_.active();
      if (bus) bus_.before_edge(*model_);
      const cosim::Clk clocks = bus ? 1 : std::min(model_.waiting(edge), end - edge);
      const Model& m = *model_;
      const auto busy = [&m](int axis) { return probe_busy(*m.rootp, axis); };
      auto& woken = wakes_[static_cast<std::size_t>(wake(m, edge, clocks, busy))];
      if (clocks > 1) {
        const cosim::Clk evaluated = model_.leap(edge, clocks);
        evaluated_ += evaluated;
        woken += evaluated;
        now_ += clocks;
        continue;
      }
      model_.raise(edge);
      ++evaluated_;
      ++woken;
      ++now_;
      unsigned why = 0;
      if (bus) {
        dirty_ = true;
        if (bus_.after_edge(*model_)) why |= cosim::kBusDone;
      }
      const auto code = [&](int channel) { return plant.sample(channel, edge); };
      if (converters_.serve(*model_, code)) dirty_ = true;
      why |= changed_outputs(m);
      if (why != 0) return {edge, why};
    }
    return {now_ - 1, cosim::kLimit};
  }

  cosim::Lines drive() const override { return gates(hi_, lo_); }

  bool irq() const override { return irq_; }
  std::uint32_t rdata() const override { return bus_.rdata(); }

  void read_words(int axis, AxisSample& sample) const override {
    probe_words(*model_->rootp, axis, sample);
  }
  AxisLaw law(int axis) const override { return probe_law(*model_->rootp, axis); }
  CurrentWords current(int axis) const override { return probe_current(*model_->rootp, axis); }
  std::int32_t rule(int axis, int index) const override {
    return probe_rule(*model_->rootp, axis, index);
  }
  std::int32_t integral(int axis) const override { return probe_integral(*model_->rootp, axis); }
  Fault fault() const override { return probe_fault(*model_->rootp); }
  std::optional<cosim::FailedAssertion> failed_assertion() const override {
    return model_.failed_assertion();
  }

 private:
  // In the order of kung_pkg::domains_t, the lowest bit first.
  static constexpr std::array<const char*, 12> kDomains{
      "system", "position", "adc", "angle", "rotate", "pi", "svpwm",
      "sense_x", "sense_y", "gates_x", "gates_y", "precision"};

  // Inputs start at random values like every other unset bit.
  void quiet_inputs() {
    Model& m = *model_;
    bus_.reset(m);
    m.adc_sdata_a_i = m.adc_sdata_b_i = 0;
    sense(0);
  }

  void settle(cosim::Clk edge) {
    model_.settle(edge, dirty_ || bus_.active());
    dirty_ = false;
  }

  cosim::ClockedModel<Model, Tracer> model_;
};

}  // namespace trammel::kung
