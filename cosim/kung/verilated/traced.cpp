// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy_fst.h>
#include <Vkung_xy_fst___024root.h>
#include <verilated_fst_c.h>

#include <stdexcept>

#include "cosim/kung/verilated/chip_model.hpp"

namespace trammel::kung {

namespace {

constexpr std::uint64_t kHalfPeriodNs = 10;  // 50 MHz

// Time zero is edge 0; the reset before it is not dumped.
class FstTrace {
 public:
  explicit FstTrace(const WaveWindow& window) : window_(window) {}

  void attach(VerilatedContext& context, Vkung_xy_fst& model) {
    context.traceEverOn(true);
    file_ = std::make_unique<VerilatedFstC>();
    file_->set_time_unit("1ns");
    file_->set_time_resolution("1ns");
    model.trace(file_.get(), 99);
    file_->open(window_.fst_file.c_str());
    if (!file_->isOpen()) throw std::runtime_error("cannot write waves: " + window_.fst_file);
  }

  bool shows(cosim::Clk edge) const { return edge >= window_.begin && edge < window_.end; }
  cosim::Clk next_shown(cosim::Clk edge) const {
    return edge < window_.begin ? window_.begin : cosim::kNever;
  }

  // The rising edge n stands at n periods, the falling one before it half a period earlier.
  void dump(cosim::Clk edge, bool high) {
    if (edge == window_.begin && !high) return;
    const auto half = 2 * static_cast<std::uint64_t>(edge) - (high ? 0u : 1u);
    file_->dump(half * kHalfPeriodNs);
    if (edge + 1 == window_.end && high) file_->flush();
  }

 private:
  WaveWindow window_;
  std::unique_ptr<VerilatedFstC> file_;
};

}  // namespace

std::unique_ptr<KungChip> make_traced_chip(const WaveWindow& window, bool leap) {
  return std::make_unique<ChipModel<Vkung_xy_fst, FstTrace>>(FstTrace{window}, leap);
}

}  // namespace trammel::kung
