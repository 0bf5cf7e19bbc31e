// SPDX-License-Identifier: Apache-2.0
//
// The two-axis chip kung_xy as the loop sees it, and the words of its controllers for the record.
// The verilated model stays behind this header.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cosim/cosim.hpp"
#include "machines/kung/chip/pins.hpp"
#include "machines/kung/chip/record.hpp"
#include "cosim/machine_chip.hpp"
#include "cosim/trigger.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::kung {

// What the current loop of one axis took and gave at its last run.
struct CurrentWords {
  std::int32_t code_a = 0, code_b = 0;         // converter codes, 2048 = 0 A
  std::int32_t count = 0;                      // encoder at the tick of the carrier
  std::int32_t i_q_ref = 0;                    // command it used
  std::int32_t cmp_a = 0, cmp_b = 0, cmp_c = 0;  // compare values 0 to the top of the carrier
  std::int32_t i_d = 0, i_q = 0, v_d = 0, v_q = 0;
  bool busy = false;   // it is computing: the words are in motion
  bool clear = false;  // integrators are held at 0
};

struct KungChip : cosim::MachineChip {
  virtual void read_words(int axis, AxisSample& sample) const = 0;  // controller words only
  // Of the precision controller, where it is on.
  virtual AxisLaw law(int) const { return {}; }
  virtual CurrentWords current(int axis) const = 0;
  virtual std::int32_t rule(int axis, int index) const = 0;  // stored rule 7 j + i, Q20 of a unit
  virtual std::int32_t integral(int axis) const = 0;         // of v*, in v* LSB / 4096
  virtual Fault fault() const = 0;
  // Of the edges evaluated, why; none for a chip without clocks.
  virtual WakeCounts wakes() const { return {}; }
};

// What the precision controller follows stands where the reference model does: its set point is
// command and model.
// Set point [count / 256], speed v24 [2^-14 count per tick].
inline void show_precision(std::int32_t set_point, std::int32_t speed, AxisSample& s) {
  s.set_point = set_point;
  s.r = s.x_r = static_cast<std::int32_t>(fixed::rs(set_point, 8));
  s.x_m = static_cast<std::int32_t>(fixed::wrap(std::int64_t{set_point} * 64, 32));
  s.dx = 8 * speed;
  s.e = static_cast<std::int32_t>(fixed::sat(s.x_r - s.x_p, 12));
  s.de = s.u = s.v_star = s.v = 0;
}

// What a trigger may name: words of the controllers and registers.
using cosim::Signal;
using cosim::SignalReader;
// Words of an axis that a column of trace.csv and a signal of that name show.
namespace words {
inline constexpr cosim::Word kE{"e", "count", "error to the model", 12, true};
inline constexpr cosim::Word kDe{"de", "count", "its change per sample", 12, true};
inline constexpr cosim::Word kU{"u", "unit / 256", "fuzzy output", 12, true};
inline constexpr cosim::Word kVStar{"v_star", "count / 16 per sample", "speed command", 12, true};
inline constexpr cosim::Word kV{"v", "count / 16 per sample", "speed", 12, true};
inline constexpr cosim::Word kIqRef{"i_q_ref", "I_fs / 4096", "current command", 12, true};
inline constexpr cosim::Word kId{"i_d", "I_fs / 2048", "measured d current", 12, true};
inline constexpr cosim::Word kIq{"i_q", "I_fs / 2048", "measured q current", 12, true};
inline constexpr cosim::Word kVd{"v_d", "V_dc / sqrt 3 / 2048", "d voltage", 12, true};
inline constexpr cosim::Word kVq{"v_q", "V_dc / sqrt 3 / 2048", "q voltage", 12, true};
}  // namespace words

const std::vector<Signal>& signals();
const cosim::TriggerForms& triggers();

// The bit-exact twin of the verilated chips: the same stops and words.
std::unique_ptr<KungChip> make_twin_chip();

// As the run asks. An audited chip runs a plain and a leaping one in step; where a register, an
// output or a stop differs, the assertion leap_is_exact fails. With a window its waves are dumped
// into run.wave_file by a second chip in step; if they differ, the assertion waves_are_exact fails.
std::unique_ptr<KungChip> make_verilated_chip(
    const cosim::RunOptions& run, const std::optional<cosim::WaveWindow>& window = {});

// Shows every evaluated edge to a watcher.
std::unique_ptr<KungChip> make_watched_chip(cosim::Watcher& watcher, bool leap);

}  // namespace trammel::kung
