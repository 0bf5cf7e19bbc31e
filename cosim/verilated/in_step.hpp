// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip and a second one that runs what the first ran, with the same inputs. From
// outside they are the first; stops and registers are asserted to be equal.
//
// Chips have registers(), the root of their model, and state(), all else that their next edges
// depend on. Registers::for_each() visits those of two models.
#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "cosim/assertion.hpp"
#include "cosim/verilated/tracer.hpp"

namespace trammel::cosim {

struct StepNames {
  const char* assertion;
  const char* first;  // what happened to a register that differs
  const char* second;
};

template <class First, class Second, class Registers>
class InStep : public First {
 public:
  std::optional<FailedAssertion> failed_assertion() const override {
    return broken_ ? broken_ : First::failed_assertion();
  }

 protected:
  template <class Tracer, class... Setup>
  InStep(const StepNames& names, ModelMode first, Tracer tracer, ModelMode second,
         const Setup&... setup)
      : First(NoTrace{}, first, setup...),
        names_(names),
        second_(std::move(tracer), second, setup...) {}

  // The second runs as far as the first did and stops for the same reason.
  void follow(const Stop& stop, const Plant& plant) {
    if (broken_) return;
    const Stop same = second_.run(stop.edge + 1, plant);
    if (same.edge != stop.edge || same.why != stop.why) {
      differ("the stop", same.edge, std::to_string(stop.edge) + " for " + std::to_string(stop.why),
             std::to_string(same.edge) + " for " + std::to_string(same.why));
    }
  }

  void compare() {
    Registers::for_each(this->registers(), second_.registers(),
                        [this](const char* name, const auto& first, const auto& second) {
                          if (broken_ || std::memcmp(&first, &second, sizeof first) == 0) return;
                          differ(name, this->now() - 1, text(first), text(second));
                        });
  }

  // The second goes on from where the first stands.
  void hand_over() {
    Registers::for_each(this->registers(), second_.registers(),
                        [](const char*, const auto& first, auto& second) { second = first; });
    second_.state() = this->state();
  }

 private:
  template <class T>
  static std::string text(const T& value) {
    if constexpr (std::is_integral_v<T>) {
      return std::to_string(value);
    } else {
      return "a memory";
    }
  }

  void differ(const char* what, Clk edge, const std::string& first, const std::string& second) {
    broken_ =
        FailedAssertion{names_.assertion, what,
                        second + ' ' + names_.second + ", " + first + ' ' + names_.first, edge};
  }

  StepNames names_;
  std::optional<FailedAssertion> broken_;

 protected:
  Second second_;
};

// A leaping chip, and beside it one that evaluates every clock.
template <class Chip, class Registers>
class AuditedChip final : public InStep<Chip, Chip, Registers> {
  using Base = InStep<Chip, Chip, Registers>;

 public:
  template <class... Setup>
  explicit AuditedChip(const Setup&... setup)
      : Base({"leap_is_exact", "leapt", "plain"}, {true, false}, NoTrace{}, {false, false},
             setup...) {}

  void sense(Lines lines) override {
    Base::sense(lines);
    this->second_.sense(lines);
  }
  void request(const BusOp& op) override {
    Base::request(op);
    this->second_.request(op);
  }
  bool flip(const std::string& bit, bool really) override {
    return Base::flip(bit, really) && this->second_.flip(bit, really);
  }
  Stop run(Clk end, const Plant& plant) override {
    const Stop stop = Base::run(end, plant);
    this->follow(stop, plant);
    this->compare();
    return stop;
  }
};

}  // namespace trammel::cosim
