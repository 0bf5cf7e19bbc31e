// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>
#include <Vkung_xy_checked.h>
#include <Vkung_xy_checked___024root.h>

#include "cosim/kung/verilated/fst_trace.hpp"
#include "cosim/kung/verilated/in_step.hpp"

namespace trammel::kung {

namespace {

template <class Model>
using WavedPair = InStep<ChipModel<Model, NoTrace>, ChipModel<Vkung_xy_fst, FstTrace>>;

// The run is that of a chip without waves. In its windows a traced chip, which would take longer,
// runs the same edges after it.
template <class Model>
class WavedChip final : public WavedPair<Model> {
  using Base = WavedPair<Model>;
  using Base::first_;
  using Base::second_;

 public:
  WavedChip(const std::string& file, const WaveWindow& window, bool leap, bool checked)
      : Base({"waves_are_exact", "in the run", "in its waves"},
             std::tuple{NoTrace{}, leap, checked}, std::tuple{FstTrace{file}, false}),
        window_(window) {
    while (window_.end <= first_.now()) next_window();
    if (window_.begin <= first_.now()) begin();
  }

  void sense(cosim::Lines lines) override {
    first_.sense(lines);
    if (showing_) second_.sense(lines);
  }
  void request(const cosim::BusOp& op) override {
    first_.request(op);
    if (showing_) second_.request(op);
  }

  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    while (true) {
      const cosim::Clk part = std::min(end, showing_ ? window_.end : window_.begin);
      const cosim::Stop stop = first_.run(part, plant);
      if (showing_) {
        this->follow(stop, plant);
        if ((stop.why & cosim::kSample) != 0) this->compare();  // a run may end inside a window
        count();
        if (first_.now() == window_.end) finish();
      }
      if (!showing_ && first_.now() >= window_.begin) begin();
      if (stop.why != cosim::kLimit || first_.now() >= end) return stop;
    }
  }

 private:
  void begin() {
    this->hand_over();
    second_.tracer().moved();
    showing_ = true;
  }

  void finish() {
    this->compare();
    showing_ = false;
    second_.tracer().flush();
    next_window();
  }

  void next_window() {
    const bool more = window_.period != cosim::kNever;
    window_.begin = more ? window_.begin + window_.period : cosim::kNever;
    window_.end = more ? window_.end + window_.period : cosim::kNever;
  }

  // Of a window every clock counts: the traced chip evaluates it.
  void count() {
    first_.state().evaluated_ = second_.state().evaluated_;
    first_.state().wakes_ = second_.state().wakes_;
  }

  WaveWindow window_;
  bool showing_ = false;
};

}  // namespace

std::unique_ptr<KungChip> make_traced_chip(const std::string& fst_file, const WaveWindow& window,
                                           bool leap, bool checked) {
  if (checked) {
    return std::make_unique<WavedChip<Vkung_xy_checked>>(fst_file, window, false, true);
  }
  return std::make_unique<WavedChip<Vkung_xy>>(fst_file, window, leap, false);
}

}  // namespace trammel::kung
