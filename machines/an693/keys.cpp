// SPDX-License-Identifier: Apache-2.0
//
// Keys of the machine an693. Words of the trajectory are those that the LM628 takes.
#include "machines/an693/machine_members.hpp"
#include "parts/lm628/keys.hpp"

namespace trammel::lab {

template <>
std::vector<std::string> enum_names<sw::An693Program>() {
  return {"hold", "absolute", "relative", "breakpoints", "tuning"};
}

}  // namespace trammel::lab

namespace trammel::an693 {

const std::vector<lab::Key>& keys() {
  static const auto all = [] {
    constexpr double kWord = 1073741823;  // 30 bits
    lab::KeyTable<Options> t(machine().name);
    t.names();
    t.text("program", "example of AN-693", TRAMMEL_LENS(program));
    lm628::add_run(t);
    t.one("run.reached_counts", 0, 32767,
          "largest error, and movement, of a shaft that counts as at its target; 0 = 50, or a "
          "quarter of a short travel",
          TRAMMEL_LENS(reached_counts));
    t.faults(fault_pins({}));
    lm628::add_part(t, TRAMMEL_LENS(part));
    lm628::add_monitors(t);
    lm628::add_filter(t);
    t.one("trajectory.acceleration", 0, kWord, "2^-16 count/sample^2", TRAMMEL_LENS(acceleration));
    t.one("trajectory.velocity", 0, kWord, "2^-16 count/sample; of breakpoints the first speed",
          TRAMMEL_LENS(velocity));
    t.one("trajectory.position_counts", -kWord - 1, kWord, "target, distance, or size of a step",
          TRAMMEL_LENS(position));
    t.one("trajectory.breakpoint_counts", 1, 500000000, "the first; the second is as far from it",
          TRAMMEL_LENS(breakpoint));
    t.one("trajectory.steps", 1, 10000, "of tuning", TRAMMEL_LENS(steps));
    t.one("trajectory.wait_s", 1e-3, 60, "before STT, between steps, and at the end",
          TRAMMEL_LENS(wait_s));
    t.processor();
    lm628::add_motor(t, TRAMMEL_LENS(plant.motor));
    t.one("encoder.counts", 4, 100000, "counts per revolution, after x4 decoding",
          TRAMMEL_LENS(plant.counts));
    t.one("encoder.hysteresis_counts", 0, 0.9, "of its comparators",
          TRAMMEL_LENS(plant.hysteresis));
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::an693
