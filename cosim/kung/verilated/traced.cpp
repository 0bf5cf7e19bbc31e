// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy_fst.h>
#include <Vkung_xy_fst___024root.h>
#include <verilated_fst_c.h>

#include <stdexcept>

#include "cosim/kung/verilated/chip_model.hpp"
#include "cosim/kung/verilated/signals.hpp"

namespace trammel::kung {

namespace {

using Root = Vkung_xy_fst___024root;

constexpr std::uint64_t kHalfPeriodNs = 10;  // 50 MHz

// Time zero is edge 0; the reset before it is not dumped.
class FstTrace {
 public:
  FstTrace(std::string file, const WaveWindow& window) : name_(std::move(file)), window_(window) {}

  void attach(VerilatedContext& context, Vkung_xy_fst& model) {
    context.traceEverOn(true);
    file_ = std::make_unique<VerilatedFstC>();
    file_->set_time_unit("1ns");
    file_->set_time_resolution("1ns");
    // The chip's own scope only: around it Verilator repeats its ports. Its name begins with the
    // space behind the empty name of the model, in newer Verilators not.
    file_->dumpvars(99, " kung_xy");
    file_->dumpvars(99, "kung_xy");
    model.trace(file_.get(), 99);
    file_->open(name_.c_str());
    if (!file_->isOpen()) throw std::runtime_error("cannot write waves: " + name_);
  }

  bool shows(cosim::Clk edge) const {
    return edge >= 0 && edge >= window_.begin && edge < window_.end;
  }
  cosim::Clk next_shown(cosim::Clk edge) const {
    return edge < window_.begin ? window_.begin : cosim::kNever;
  }

  // The rising edge n stands at n periods, the falling one before it half a period earlier; the
  // file begins with a rising one.
  void dump(cosim::Clk edge, bool high) {
    if (!begun_ && !high) return;
    begun_ = true;
    const auto half = 2 * static_cast<std::uint64_t>(edge) - (high ? 0u : 1u);
    file_->dump(half * kHalfPeriodNs);
  }

  // After the last edge of a window the next one is shown.
  void raised(cosim::Clk edge) {
    if (edge + 1 != window_.end) return;
    file_->flush();
    if (window_.period == cosim::kNever) return;
    window_.begin += window_.period;
    window_.end += window_.period;
  }

 private:
  std::string name_;
  WaveWindow window_;
  bool begun_ = false;
  std::unique_ptr<VerilatedFstC> file_;
};

// Dumps nothing and lets a watcher see every evaluated edge.
class Watch final : SignalReader {
 public:
  explicit Watch(Watcher& watcher) : watcher_(watcher) {}

  void attach(VerilatedContext&, Vkung_xy_fst& model) { root_ = model.rootp; }
  static constexpr bool shows(cosim::Clk) { return false; }
  static constexpr cosim::Clk next_shown(cosim::Clk) { return cosim::kNever; }
  void dump(cosim::Clk, bool) {}
  void raised(cosim::Clk edge) { watcher_.after(edge, *this); }

  std::int64_t read(std::size_t signal, int axis) const override {
    return signal_rows<Root>()[signal].read(*root_, axis);
  }

 private:
  Watcher& watcher_;
  const Root* root_ = nullptr;
};

}  // namespace

const std::vector<Signal>& signals() {
  static const std::vector<Signal> all = [] {
    std::vector<Signal> list;
    for (const auto& row : signal_rows<Root>()) list.push_back(row.signal);
    return list;
  }();
  return all;
}

std::unique_ptr<KungChip> make_traced_chip(const std::string& fst_file, const WaveWindow& window,
                                           bool leap, bool checked) {
  return std::make_unique<ChipModel<Vkung_xy_fst, FstTrace>>(FstTrace{fst_file, window}, leap,
                                                             checked);
}

std::unique_ptr<KungChip> make_checked_chip() {
  return std::make_unique<ChipModel<Vkung_xy_fst, NoTrace>>(NoTrace{}, false, true);
}

std::unique_ptr<KungChip> make_watched_chip(Watcher& watcher, bool leap) {
  return std::make_unique<ChipModel<Vkung_xy_fst, Watch>>(Watch{watcher}, leap);
}

}  // namespace trammel::kung
