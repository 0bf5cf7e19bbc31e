// SPDX-License-Identifier: Apache-2.0
//
// Keeps a close look at one place of the run beside the 2 kHz record: the fastest position sample,
// the gates of the two PWM periods that begin with it, and the rules first and last. When a fault
// turns the gates off, the window is moved around that edge. Bounded, and idle between its events.
#pragma once

#include <deque>

#include "machines/kung/chip.hpp"
#include "machines/kung/record.hpp"

namespace trammel::kung {

class DetailRecorder final : public cosim::Observer {
 public:
  DetailRecorder(const KungChip& chip, const plant::XyTable& truth) : chip_(chip), truth_(truth) {}

  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) override;

  void path_begins();  // the rules are those of a table not yet used
  Detail take();

 private:
  void look(cosim::Clk edge);                      // at a 2 kHz tick: is it the fastest so far?
  void keep_edge(const cosim::Stop& stop, cosim::Lines gates);
  void close_window();
  RuleTable rules(int axis) const;
  std::array<std::array<std::int32_t, 3>, 2> compare_values() const;  // [axis][phase]

  const KungChip& chip_;
  const plant::XyTable& truth_;
  std::deque<GateEdge> recent_;                    // of the last three PWM periods
  Detail detail_;
  std::array<AxisSample, 2> last_{}, before_{};    // words of the last two samples
  GateWindow open_;                                // end 0: none is open
  Moment moment_;                                  // of the open window, kept when it is complete
  std::uint32_t tick_ = 0;
  double fastest_m_s_ = 1e-3;                      // slower than this the table stands still
  bool moment_open_ = false;
  bool tripped_ = false;
};

}  // namespace trammel::kung
