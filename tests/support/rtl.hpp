// SPDX-License-Identifier: Apache-2.0
//
// A verilated block under test: reset, clock edges, and signed reading of its ports.
//
// Models that count coverage (TRAMMEL_COVERAGE is defined) leave it in the file that the variable
// TRAMMEL_COVERAGE of the environment names. A model holds its own counters, so all live to the
// end of the program.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

namespace trammel::test {

#ifdef TRAMMEL_COVERAGE
struct Covered {
  const char* file = std::getenv("TRAMMEL_COVERAGE");
  std::shared_ptr<VerilatedContext> context = std::make_shared<VerilatedContext>();
  std::vector<std::shared_ptr<void>> models;

  ~Covered() {
    if (file != nullptr) context->coveragep()->write(file);
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
    if (covered().file != nullptr) covered().models.push_back(model_);
#endif
    model_->clk_i = 0;
    model_->rst_i = 0;
    model_->eval();
  }

  ~Rtl() { model_->final(); }

  Rtl(const Rtl&) = delete;
  Rtl& operator=(const Rtl&) = delete;

  Model* operator->() { return model_.get(); }

  // Settles combinational outputs after inputs changed.
  void eval() { model_->eval(); }

  // One rising edge; outputs are those after the edge.
  void tick() {
    model_->eval();
    model_->clk_i = 1;
    model_->eval();
    model_->clk_i = 0;
    model_->eval();
  }

  void reset() {
    model_->rst_i = 1;
    tick();
    tick();
    model_->rst_i = 0;
    model_->eval();
  }

 private:
  static std::shared_ptr<VerilatedContext> context() {
#ifdef TRAMMEL_COVERAGE
    if (covered().file != nullptr) return covered().context;
#endif
    return std::make_shared<VerilatedContext>();
  }

  std::shared_ptr<VerilatedContext> context_ = context();
  std::shared_ptr<Model> model_;
};

// The low `bits` of a port as a two's complement number.
inline std::int64_t as_signed(std::uint64_t value, int bits) {
  const int shift = 64 - bits;
  return static_cast<std::int64_t>(value << shift) >> shift;
}

// The low `bits` of a number, to be written to a port.
inline std::uint32_t as_bits(std::int64_t value, int bits) {
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) & mask);
}

}  // namespace trammel::test
