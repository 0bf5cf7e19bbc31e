// SPDX-License-Identifier: Apache-2.0
//
// Two verilated chips of which the second runs what the first ran, with the same inputs. From
// outside they are the first; that stops and registers are equal is a promise.
#pragma once

#include <cstring>
#include <kung_xy_registers.hpp>
#include <string>
#include <tuple>

#include "cosim/kung/verilated/chip_model.hpp"

namespace trammel::kung {

struct StepNames {
  const char* promise;
  const char* first;  // what happened to a register that differs
  const char* second;
};

template <class First, class Second>
class InStep : public KungChip {
 public:
  cosim::Clk now() const override { return first_.now(); }
  cosim::Lines drive() const override { return first_.drive(); }
  bool irq() const override { return first_.irq(); }
  std::uint32_t rdata() const override { return first_.rdata(); }
  void read_words(int axis, AxisSample& sample) const override { first_.read_words(axis, sample); }
  CurrentWords current(int axis) const override { return first_.current(axis); }
  std::int32_t rule(int axis, int index) const override { return first_.rule(axis, index); }
  std::int32_t integral(int axis) const override { return first_.integral(axis); }
  Fault fault() const override { return first_.fault(); }
  cosim::Clk evaluated() const override { return first_.evaluated(); }
  WakeCounts wakes() const override { return first_.wakes(); }
  std::optional<cosim::BrokenPromise> broken_promise() const override {
    return broken_ ? broken_ : first_.broken_promise();
  }

 protected:
  // A chip is built where it stays: from the arguments of each.
  template <class... A, class... B>
  InStep(const StepNames& names, std::tuple<A...> first, std::tuple<B...> second)
      : names_(names),
        first_(std::make_from_tuple<First>(std::move(first))),
        second_(std::make_from_tuple<Second>(std::move(second))) {}

  // The second runs as far as the first did and stops for the same reason.
  void follow(const cosim::Stop& stop, const cosim::Plant& plant) {
    if (broken_) return;
    const cosim::Stop same = second_.run(stop.edge + 1, plant);
    if (same.edge != stop.edge || same.why != stop.why) {
      differ("the stop", same.edge, std::to_string(stop.edge) + " for " + std::to_string(stop.why),
             std::to_string(same.edge) + " for " + std::to_string(same.why));
    }
  }

  void compare() {
    for_each_register(first_.registers(), second_.registers(),
                      [this](const char* name, const auto& first, const auto& second) {
                        if (broken_ || std::memcmp(&first, &second, sizeof first) == 0) return;
                        differ(name, first_.now() - 1, text(first), text(second));
                      });
  }

  // The second goes on from where the first stands.
  void hand_over() {
    for_each_register(first_.registers(), second_.registers(),
                      [](const char*, const auto& first, auto& second) { second = first; });
    second_.state() = first_.state();
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

  void differ(const char* what, cosim::Clk edge, const std::string& first,
              const std::string& second) {
    broken_ = cosim::BrokenPromise{names_.promise, what,
                                   second + ' ' + names_.second + ", " + first + ' ' + names_.first,
                                   edge};
  }

  StepNames names_;
  std::optional<cosim::BrokenPromise> broken_;

 protected:
  First first_;
  Second second_;
};

}  // namespace trammel::kung
