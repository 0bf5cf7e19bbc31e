// SPDX-License-Identifier: Apache-2.0
//
// A verilated block under test: reset, clock edges, and signed reading of its ports.
//
// Models that count coverage (TRAMMEL_COVERAGE is defined) leave it in files <name>.<n>, one per
// instance, where <name> is the environment variable TRAMMEL_COVERAGE. A model holds its own
// counters and writing takes time, so all live to the end of the program.
#pragma once

#include <verilated.h>
#ifdef TRAMMEL_COVERAGE
#include <verilated_cov.h>
#endif

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "cosim/verilated/clock_pins.hpp"
#include "tests/support/bits.hpp"

#ifdef TRAMMEL_WAVES
#include "tests/support/waves.hpp"
#else
namespace trammel::test {
struct Waves {  // none, unless a failed test is run again
  template <class Model>
  void begin(VerilatedContext&, Model&) {}
  void settled() {}
  void rose() {}
  void fell() {}
  void end() {}
};
}  // namespace trammel::test
#endif

namespace trammel::test {

// Verilator's scopes leave the context of the thread, whichever was evaluated last: before a model
// ends it must be the model's own, for the last one may be gone.
template <class Model>
void end_model(const std::shared_ptr<VerilatedContext>& context, std::shared_ptr<Model>& model) {
  Verilated::threadContextp(context.get());
  model.reset();
}

#ifdef TRAMMEL_COVERAGE
struct Covered {
  struct Instance {
    std::shared_ptr<VerilatedContext> context;
    std::shared_ptr<void> model;
  };

  const char* name = std::getenv("TRAMMEL_COVERAGE");  // nullptr: nothing is left
  std::vector<Instance> instances;

  std::string file(std::size_t n) const { return name + ("." + std::to_string(n)); }

  ~Covered() {
    if (name == nullptr) return;
    std::size_t n = 0;
    for (; n < instances.size(); ++n) instances[n].context->coveragep()->write(file(n).c_str());
    while (std::remove(file(n).c_str()) == 0) ++n;  // of an earlier run with more of them
    for (Instance& one : instances) end_model(one.context, one.model);
  }
};

inline Covered& covered() {
  static Covered all;
  return all;
}
#endif

template <class Model>
class Rtl {
 public:
  Rtl() {
    context_->randReset(2);  // registers without a reset start at random values
    context_->randSeed(1);
    model_ = std::make_shared<Model>(context_.get(), "top");
#ifdef TRAMMEL_COVERAGE
    if (covered().name != nullptr) covered().instances.push_back({context_, model_});
#endif
    cosim::enable_all_clocks(*model_);
    waves_.begin(*context_, *model_);
    cosim::clock_pin(*model_) = 0;
    cosim::reset_pin(*model_) = 0;
    model_->eval();
  }

  ~Rtl() {
    model_->final();
    waves_.end();
    end_model(context_, model_);
  }

  Rtl(const Rtl&) = delete;
  Rtl& operator=(const Rtl&) = delete;

  Model* operator->() { return model_.get(); }

  // Settles combinational outputs after inputs changed.
  void eval() { model_->eval(); }

  // One rising edge; outputs are those after the edge. The time is its number, which the message of
  // a failed assertion begins with.
  void tick() {
    model_->eval();
    context_->timeInc(1);
    waves_.settled();
    cosim::clock_pin(*model_) = 1;
    model_->eval();
    waves_.rose();
    cosim::clock_pin(*model_) = 0;
    model_->eval();
    waves_.fell();
  }

  void reset() {
    cosim::reset_pin(*model_) = 1;
    tick();
#ifdef TRAMMEL_COVERAGE
    // Random values that become zero here are not toggles made by a test.
    if (!was_reset_) context_->coveragep()->zero();
#endif
    was_reset_ = true;
    tick();
    cosim::reset_pin(*model_) = 0;
    model_->eval();
  }

 private:
  std::shared_ptr<VerilatedContext> context_ = std::make_shared<VerilatedContext>();
  std::shared_ptr<Model> model_;
  bool was_reset_ = false;
  Waves waves_;
};

}  // namespace trammel::test
