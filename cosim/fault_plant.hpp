// SPDX-License-Identifier: Apache-2.0
//
// A fault between plant and chip: what the chip senses and samples, and what it drives, with the
// fault in it. It begins and ends at edges that are events of the plant, at which a leap ends.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>

#include "cosim/fault.hpp"
#include "models/pins/port.hpp"

namespace trammel::cosim {

// A plant whose motor or supply can fail.
struct FalliblePlant : Plant {
  // From edge n on; an axis' phase carries no current while it is open.
  virtual void open_phase(Clk n, int axis, int phase, bool open) = 0;
  virtual void supply(Clk n, double share) = 0;  // of all axes, 1 = whole
};

struct MachineChip;

// Throws OptionsError where the chip has no such bit.
void require_bit(MachineChip& chip, const std::string& bit);

class FaultPlant final : public Plant {
 public:
  FaultPlant(FalliblePlant& plant, const FaultPins& pins, const Fault& fault,
             std::int64_t clock_ps);

  Lines sense() const override;
  Clk next() const override { return std::min(plant_.next(), event_); }
  void commit(Clk n, Lines drive) override;
  int sample(int channel, Clk n) const override;

  // Called at the edge at which a register flips.
  std::function<void()> flip;

 private:
  void begin(Clk n);
  void end(Clk n);
  void follow_counts();
  Lines driven(Lines drive) const;
  Lines bit(int line) const { return Lines{1} << line; }

  FalliblePlant& plant_;
  FaultPins pins_;
  Fault fault_;
  FaultSpan span_;
  Clk event_;            // the next of begin and end
  bool active_ = false;
  std::array<int, 3> encoder_{};  // A, B, index of the axis, where it has them
  int index_ = 0;        // of the line among those of all axes: channel of a converter, output
  Lines held_ = 0;       // as the lines were where the fault began
  int code_ = 0;         // as the converter's was
  std::optional<Lines> driven_;
  unsigned true_ = 0, seen_ = 0;  // counts of the encoder, modulo 4
  int counts_ = 0;       // since the last one lost
};

}  // namespace trammel::cosim
