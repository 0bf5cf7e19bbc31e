// SPDX-License-Identifier: Apache-2.0
//
// Records what the samples cannot show: the fastest position sample from inside, the gates
// over the two PWM periods that begin with it, and the rules at the start and at the end. When a
// fault turns the gates off, the window of gates is moved to that edge. Its memory is bounded.
#pragma once

#include <deque>

#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/record.hpp"

namespace trammel::kung {

class SnapshotRecorder final : public cosim::Observer {
 public:
  // The period is that of the PWM.
  SnapshotRecorder(const KungChip& chip, const plant::XyTable& truth, cosim::Clk period)
      : chip_(chip), truth_(truth), period_(period) {}

  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) override;

  void path_begins();  // when no rule has been tuned yet
  Snapshot take();

 private:
  void open_if_fastest(cosim::Clk edge);           // at a position tick
  void keep_edge(const cosim::Stop& stop, cosim::Lines gates);
  void close_window();
  RuleTable rules(int axis) const;
  std::array<std::array<std::int32_t, 3>, 2> compare_values() const;  // [axis][phase]

  const KungChip& chip_;
  const plant::XyTable& truth_;
  const cosim::Clk period_;
  std::deque<GateEdge> recent_;                    // of the last three PWM periods
  Snapshot snapshot_;
  std::array<AxisSample, 2> last_{}, before_{};    // words of the last two samples
  GateWindow open_;                                // end 0: none is open
  Moment moment_;                                  // of the open window, kept when it is complete
  std::uint32_t tick_ = 0;
  double fastest_m_s_ = 1e-3;                      // below this the table stands still
  bool moment_open_ = false;
  bool on_path_ = false;
  bool tripped_ = false;
};

}  // namespace trammel::kung
