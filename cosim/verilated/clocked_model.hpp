// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip with a clock clk_i or clk, in its own context. An edge is one evaluation: the
// model's stored clock values are set back by hand, so that the next evaluation sees a rising edge;
// where their names are not known, an evaluation with the clock low does that. Inputs that changed
// settle before it. A tracer is told of every edge, and the assertions of a checked model are
// evaluated.
//
// A chip with the ports leap_i, next_o and quiescent_o leaps: while every register waits
// (quiescent_o) the timers alone move, for next_o edges, and one evaluation with leap_i = n - 1
// stands for n of them. No pin may move inside a leap. Every edge of another chip is evaluated.
//
// A leaping chip with the ports clock_en_i and awake_o has its registers in clock domains, and an
// edge is evaluated in the domains that are awake. Timers lag: as long as they only count (next_o)
// and no domain that reads them is awake (timed_o), they stay behind, and catch up by one leap.
#pragma once

#include <verilated.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "cosim/assertion.hpp"
#include "cosim/cosim.hpp"
#include "cosim/run.hpp"
#include "cosim/verilated/clock_pins.hpp"
#include "cosim/verilated/regions.hpp"
#include "cosim/verilated/tracer.hpp"

namespace trammel::cosim {

// Whether a model has the ports of the leap contract.
template <class Model, class = void>
inline constexpr bool kLeaps = false;
template <class Model>
inline constexpr bool kLeaps<Model, std::void_t<decltype(std::declval<Model&>().leap_i),
                                                decltype(std::declval<Model&>().next_o),
                                                decltype(std::declval<Model&>().quiescent_o)>> =
    true;

template <class Model, class Tracer>
class ClockedModel {
  using Root = std::remove_pointer_t<decltype(Model::rootp)>;
  static constexpr bool kByDomain = Regions<Root>::kKnown;
  struct NoClocks {};
  template <bool known, class = void>
  struct ClocksOf {
    using Type = NoClocks;
  };
  template <class Unused>
  struct ClocksOf<true, Unused> {
    using Type = DomainClocks<Model, Root>;
  };
  using Clocks = typename ClocksOf<kByDomain>::Type;

 public:
  ClockedModel(Tracer tracer, ModelMode mode)
      : leap_(mode.leap && !mode.checked), checked_(mode.checked), tracer_(std::move(tracer)) {
    context_->assertOn(mode.checked);
    context_->randReset(2);
    context_->randSeed(1);
    model_ = std::make_unique<Model>(context_.get(), "");  // no scope around the chip's
    if constexpr (kLeaps<Model>) model_->leap_i = 0;
    enable_all_clocks(*model_);
    tracer_.attach(*context_, *model_);
    if constexpr (kByDomain) {
      clock_pin(*model_) = 0;
      model_->eval();
      by_domain_ = clocks_.learn(*model_) && mode.domains;
      awake_.resize(Clocks::kTimers);
      if (!by_domain_) {  // the trial left some clocks off, and the pin high
        enable_all_clocks(*model_);
        clock_pin(*model_) = 0;
        model_->eval();
      }
    }
    if constexpr (kAllDomains<Model> != 1 && std::is_same_v<Tracer, NoTrace>) {
      if (leap_ && mode.domains && !by_domain_) tell_whole();
    }
  }

  // The model leaves the context of the thread, which else is that of the chip evaluated last.
  ~ClockedModel() {
    Verilated::threadContextp(context_.get());
    model_->final();
  }

  ClockedModel(const ClockedModel&) = delete;
  ClockedModel& operator=(const ClockedModel&) = delete;

  Model& operator*() const { return *model_; }
  Model* operator->() const { return model_.get(); }
  Tracer& tracer() { return tracer_; }
  bool shows(Clk edge) const { return tracer_.shows(edge); }

  // The registers as they are before the edge `now`.
  Root& registers(Clk now) {
    catch_up(now);
    return *model_->rootp;
  }

  // A register was changed by hand: what was foreseen does not hold.
  void upset(Clk now) { event_ = now; }

  // Before the rising edge: inputs that changed reach the combinational logic.
  void settle(Clk edge, bool changed) {
    const bool shown = shows(edge);
    if (shown) clock_pin(*model_) = 0;
    if (changed) follow_inputs();
    if (shown) tracer_.fell(edge);
  }

  void raise(Clk edge) {
    if (by_domain_) {
      rise_awake(edge);
    } else {
      rise();
    }
    tracer_.raised(edge);
    if (checked_ && !broken_) look_for_failed_assertion(edge);
  }

  // How many edges from the present one on only count; at least 1, the evaluated one.
  Clk waiting(Clk edge) const {
    if constexpr (kByDomain) {
      if (by_domain_) return leap_ && awake() == 0 ? std::max<Clk>(1, event_ - edge) : 1;
    }
    if constexpr (kLeaps<Model>) {
      if (leap_ && model_->quiescent_o) return std::max<Clk>(1, model_->next_o);
    }
    return 1;
  }

  // That many edges, at most waiting(), in so many evaluations: 1, or none where timers lag. No
  // assertion is checked: a checked model does not leap.
  Clk leap(Clk edge, Clk clocks) {
    if (by_domain_) return 0;
    if constexpr (kLeaps<Model>) {
      model_->leap_i = static_cast<std::uint16_t>(clocks - 1);
      rise();
      model_->leap_i = 0;
    }
    tracer_.raised(edge);
    return 1;
  }

  // Edges at which each domain was awake, by these names; of a leaping chip only.
  template <std::size_t n>
  std::vector<DomainActivity> activity(const std::array<const char*, n>& names) const {
    std::vector<DomainActivity> found;
    if constexpr (kByDomain) {
      static_assert(n == Regions<Root>::kDomains);
      if (!by_domain_ || !leap_) return found;
      for (std::size_t d = 0; d < n; ++d) {
        found.push_back({names[d], 0});
        for (std::size_t k = 0; k < awake_.size(); ++k) {
          if ((k >> d & 1u) != 0) found.back().awake += awake_[k];
        }
      }
    }
    return found;
  }

  const std::optional<FailedAssertion>& failed_assertion() const { return broken_; }

 private:
  // Domains that the next edge may change.
  unsigned awake() const {
    if constexpr (kByDomain) {
      if (leap_ && !reset_pin(*model_)) return model_->awake_o;
      return Clocks::kAll - Clocks::kTimers;
    } else {
      return 0;
    }
  }

  void follow_inputs() {
    if constexpr (kByDomain) {
      if (by_domain_) return Regions<Root>::inputs(*model_->rootp);
    }
    model_->eval();
  }

  void rise_awake(Clk edge) {
    if constexpr (kByDomain) {
      if (leap_ && edge < event_ && !model_->timed_o && !reset_pin(*model_)) {
        const unsigned up = awake();
        ++awake_[up];
        clocks_.rise(*model_->rootp, up);
        return;
      }
      catch_up(edge);
      const unsigned up = awake();
      ++awake_[up];
      clocks_.rise(*model_->rootp, up | Clocks::kTimers);
      time_ = edge + 1;
      event_ = time_ + model_->next_o;
    }
  }

  // The timers alone, to the edge `now`.
  void catch_up(Clk now) {
    if constexpr (kByDomain) {
      if (!by_domain_ || time_ == now || time_ == kUnset) {
        time_ = now;
        return;
      }
      model_->leap_i = static_cast<std::uint16_t>(now - time_ - 1);
      clocks_.rise(*model_->rootp, Clocks::kTimers);
      model_->leap_i = 0;
      time_ = now;
    }
  }

  void rise() {
    if constexpr (StoredClocks<Root>::kKnown) {
      StoredClocks<Root>::fall(*model_->rootp);
    } else {
      clock_pin(*model_) = 0;
      model_->eval();
    }
    clock_pin(*model_) = 1;
    model_->eval();
  }

  void look_for_failed_assertion(Clk edge) {
    broken_ = take_failed_assertion();
    if (broken_) broken_->edge = edge;
  }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Model> model_;
  bool leap_, checked_;
  bool by_domain_ = false;  // clocks are raised by domain
  Clocks clocks_;
  static constexpr Clk kUnset = std::numeric_limits<Clk>::min();
  // Edge at which the timers stand, and the next that they must see.
  Clk time_ = kUnset, event_ = kUnset;
  std::vector<Clk> awake_;  // edges at which these domains were awake
  Tracer tracer_;
  std::optional<FailedAssertion> broken_;
};

}  // namespace trammel::cosim
