// SPDX-License-Identifier: Apache-2.0
//
// The verilated chip that a run asks for, of the models of one chip. Each is constructed with
// `setup`.
#pragma once

#include <memory>
#include <optional>

#include "cosim/run.hpp"
#include "cosim/verilated/flipped_chip.hpp"
#include "cosim/verilated/fst_trace.hpp"
#include "cosim/verilated/waved_chip.hpp"

namespace trammel::cosim {

// Such a run needs more than the model for speed.
inline bool is_watched(const RunOptions& run, const std::optional<WaveWindow>& window) {
  return window || run.assertions || run.audit;
}

// Fast: the model for speed.
template <template <class Model, class Tracer> class ChipModel, class Fast, class Registers,
          class... Setup>
auto make_chip(const RunOptions& run, const Setup&... setup) {
  using Chip = FlippedChip<ChipModel<Fast, NoTrace>, Registers>;
  return std::make_unique<Chip>(NoTrace{}, ModelMode{run.leap, false, run.domains}, setup...);
}

// Checked: with the assertions of its blocks; Traced: the description of the model that dumps a
// window of waves.
template <class Interface, template <class Model, class Tracer> class ChipModel, class Fast,
          class Checked, class Traced, class Registers, class... Setup>
std::unique_ptr<Interface> make_watched_chip(const RunOptions& run,
                                             const std::optional<WaveWindow>& window,
                                             const Setup&... setup) {
  using Trace = FstTrace<Traced>;
  using Shown = ChipModel<typename Traced::Model, Trace>;
  const ModelMode mode{run.leap, run.assertions, run.domains};
  const auto make = [&](auto* kind) -> std::unique_ptr<Interface> {
    using Chip = std::remove_pointer_t<decltype(kind)>;
    if (!window) return std::make_unique<Chip>(NoTrace{}, mode, setup...);
    return std::make_unique<WavedChip<Chip, Shown, Registers>>(
        mode, Trace(run.wave_file, run.clock_ps), *window, setup...);
  };
  using Untraced = FlippedChip<ChipModel<Fast, NoTrace>, Registers>;
  using Judged = FlippedChip<ChipModel<Checked, NoTrace>, Registers>;
  if (run.audit) return std::make_unique<AuditedChip<Untraced, Registers>>(setup...);
  if (run.assertions) return make(static_cast<Judged*>(nullptr));
  return make(static_cast<Untraced*>(nullptr));
}

}  // namespace trammel::cosim
