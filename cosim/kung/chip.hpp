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
#include "cosim/kung/lines.hpp"
#include "cosim/kung/types.hpp"
#include "cosim/kung/wakes.hpp"
#include "cosim/machine_chip.hpp"
#include "cosim/trigger.hpp"

namespace trammel::kung {

// What the current loop of one axis took and gave at its last run.
struct CurrentWords {
  std::int32_t code_a = 0, code_b = 0;         // converter codes, 2048 = 0 A
  std::int32_t count = 0;                      // encoder at the 16 kHz tick
  std::int32_t i_q_ref = 0;                    // command it used
  std::int32_t cmp_a = 0, cmp_b = 0, cmp_c = 0;  // compare values 0..1562
  std::int32_t i_d = 0, i_q = 0, v_d = 0, v_q = 0;
  bool busy = false;   // it is computing: the words are in motion
  bool clear = false;  // integrators are held at 0
};

using cosim::WaveWindow;

struct KungChip : cosim::MachineChip {
  virtual void read_words(int axis, AxisSample& sample) const = 0;  // controller words only
  virtual CurrentWords current(int axis) const = 0;
  virtual std::int32_t rule(int axis, int index) const = 0;  // stored rule 7 j + i, Q20 of a unit
  virtual std::int32_t integral(int axis) const = 0;         // of v*, in v* LSB / 4096
  virtual Fault fault() const = 0;
  // Of the edges evaluated, why; none for a chip without clocks.
  virtual WakeCounts wakes() const { return {}; }
};

// What a trigger may name: words of the controllers and registers.
using cosim::Signal;
using cosim::SignalReader;
const std::vector<Signal>& signals();

// Sees the chip after each edge that is evaluated; at the others no signal changes.
struct Watcher {
  virtual ~Watcher() = default;
  virtual void after(cosim::Clk edge, const SignalReader& chip) = 0;
};

// The bit-exact twin of the verilated chips: the same stops and words.
std::unique_ptr<KungChip> make_twin_chip();

// leap: waiting clocks are not evaluated; the edges of all events stay the same.
// An audited chip runs a plain and a leaping one in step; where a register, an output or a stop
// differs, its promise leap_is_exact is broken.
// checked: the promises of the RTL are looked at in every clock, and none is leapt over.
// A traced chip is one of these, and in its windows a second one that dumps every clock in step; if
// they differ, the promise waves_are_exact is broken.
std::unique_ptr<KungChip> make_verilated_chip(bool leap);
std::unique_ptr<KungChip> make_audited_chip();
std::unique_ptr<KungChip> make_checked_chip();
std::unique_ptr<KungChip> make_traced_chip(const std::string& fst_file, const WaveWindow& window,
                                           bool leap, bool checked);
std::unique_ptr<KungChip> make_watched_chip(Watcher& watcher, bool leap);

}  // namespace trammel::kung
