// SPDX-License-Identifier: Apache-2.0
//
// The waves of a verilated chip: every signal at every edge from 0 on, as a file. Included only by
// the unit of a traced chip.
//
// Verilator compares all signals at each dump. In most clocks nothing moves but the clock and
// timers, so the others are compared with the last dump first: as bytes of the model, at once.
#pragma once

#include <verilated_fst_c.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cosim/waves.hpp"

namespace trammel::cosim {

// The part of a model that signals other than timers depend on, and its bytes at the last dump.
template <class Traced>
class StillBytes {
 public:
  explicit StillBytes(const typename Traced::Root& root)
      : now_(reinterpret_cast<const unsigned char*>(&root)),
        mask_(sizeof root),
        last_(sizeof root) {
    Traced::for_each_still(root, [this](const auto& member) {
      const auto first = reinterpret_cast<const unsigned char*>(&member) - now_;
      std::fill_n(mask_.begin() + first, sizeof member, static_cast<unsigned char>(0xff));
    });
    const auto end = std::find_if(mask_.rbegin(), mask_.rend(), [](auto byte) { return byte; });
    mask_.erase(end.base(), mask_.end());
  }

  bool moved() const {
    unsigned char differ = 0;
    for (std::size_t i = 0; i < mask_.size(); ++i) {
      differ = static_cast<unsigned char>(differ | ((now_[i] ^ last_[i]) & mask_[i]));
    }
    return differ != 0;
  }
  void keep() { std::copy_n(now_, mask_.size(), last_.begin()); }

 private:
  const unsigned char* now_;
  std::vector<unsigned char> mask_, last_;
};

// Traced: the generated description of a model with an FST writer.
template <class Traced>
class FstTrace {
  using Root = typename Traced::Root;

 public:
  FstTrace(std::string file, std::int64_t clock_ps)
      : name_(std::move(file)), scale_(wave_scale(clock_ps)) {}

  void attach(VerilatedContext& context, typename Traced::Model& model) {
    root_ = model.rootp;
    still_ = std::make_unique<StillBytes<Traced>>(*root_);
    context.traceEverOn(true);
    file_ = std::make_unique<VerilatedFstC>();
    const std::string unit = std::string("1") + scale_.unit;
    file_->set_time_unit(unit);
    file_->set_time_resolution(unit);
    // The chip's own scope only: around it Verilator repeats its ports. Its name begins with the
    // space behind the empty name of the model, in newer Verilators not.
    file_->dumpvars(99, std::string(" ") + Traced::kScope);
    file_->dumpvars(99, Traced::kScope);
    model.trace(file_.get(), 99);
    take_wave_error();
    file_->open(name_.c_str());
    check();
    file_->spTrace()->addChgCb(
        [](void* root, VerilatedFst::Buffer* buffer) {
          Traced::dump_timers(static_cast<const Root*>(root), buffer);
        },
        root_);
  }

  static constexpr bool shows(Clk edge) { return edge >= 0; }

  // The rising edge n stands at n periods, the falling one before it half a period earlier; the
  // file begins with a rising one.
  void fell(Clk edge) {
    if (begun_) dump(2 * static_cast<std::uint64_t>(edge) - 1);
  }
  void raised(Clk edge) {
    if (edge >= 0) dump(2 * static_cast<std::uint64_t>(edge));
  }

  // Registers and inputs were written from outside: all that depends on them must follow.
  void moved() {
    Traced::settle(root_);
    for (auto& activity : root_->__Vm_traceActivity.m_storage) activity = 1;
    root_->vlSymsp->__Vm_activity = true;
  }

  // Throws std::system_error when the waves up to here could not be written.
  void flush() {
    file_->flush();
    check();
  }

 private:
  void check() const {
    const int error = take_wave_error();
    if (error == 0) return;
    throw std::system_error(error, std::generic_category(), name_ + ": cannot be written");
  }

  void dump(std::uint64_t half) {
    // False as long as the model was not evaluated: at most falling edges.
    bool& evaluated = root_->vlSymsp->__Vm_activity;
    evaluated = evaluated && (!begun_ || still_->moved());
    const bool all = evaluated;
    file_->dump(half * static_cast<std::uint64_t>(scale_.period) / 2);
    if (all) still_->keep();
    begun_ = true;
  }

  std::string name_;
  WaveScale scale_;
  bool begun_ = false;
  Root* root_ = nullptr;
  std::unique_ptr<StillBytes<Traced>> still_;
  std::unique_ptr<VerilatedFstC> file_;
};

}  // namespace trammel::cosim
