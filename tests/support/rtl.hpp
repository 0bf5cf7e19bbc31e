// SPDX-License-Identifier: Apache-2.0
//
// A verilated block under test: reset, clock edges, and signed reading of its ports.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <memory>

namespace trammel::test {

template <class Model>
class Rtl {
 public:
  Rtl() : context_(std::make_unique<VerilatedContext>()) {
    context_->randReset(2);  // registers without a reset start at random values
    context_->randSeed(1);
    model_ = std::make_unique<Model>(context_.get(), "top");
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
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Model> model_;
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
