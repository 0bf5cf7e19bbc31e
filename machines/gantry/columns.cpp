// SPDX-License-Identifier: Apache-2.0
//
// Columns of the trace of the machine gantry.
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/units.hpp"

namespace trammel::gantry {
const lab::ColumnTable& columns() {
  static const lab::ColumnTable all = [] {
    using Table = lab::Columns<Options, Result>;
    using At = Table::At;
    using lab::fixed;
    Table t;
    t.add({"t_s", "s", 1e-8, fixed(8), "time from the start of the run"},
          [](const At& at) { return at.result.seconds(at.sample.edge); });
    t.add({"x_mm", "mm", 1e-4, fixed(5), "where the cart is", true},
          [](const At& at) { return 1e3 * at.sample.x; });
    t.add({"v_mm_s", "mm/s", 1e-2, fixed(3), "its speed", true},
          [](const At& at) { return 1e3 * at.sample.v; });
    t.add({"position_mm", "mm", 1e-4, fixed(5), "where the observer has it, from its start", true},
          [](const At& at) { return kUnit_mm * at.sample.words.position; });
    t.add({"goal_mm", "mm", 1e-4, fixed(5), "where the firmware wants it, as position_mm", true},
          [](const At& at) { return kCount_mm * (at.sample.goal + at.sample.zero); });
    t.add({"origin_mm", "mm", 1e-4, fixed(5), "where on the track these two are 0"},
          [](const At& at) { return 1e3 * at.sample.origin; });
    t.add({"velocity_mm_s", "mm/s", 1e-2, fixed(3), "velocity of the observer"},
          [](const At& at) { return kVelocity_mm_s * at.sample.words.velocity; });
    t.add({"filtered_mm_s", "mm/s", 1e-2, fixed(3), "that, filtered: see velocity.filter", true},
          [](const At& at) { return kVelocity_mm_s * at.sample.velocity; });
    t.add({"error_count", "count", 1, {}, "error of position in control counts"},
          [](const At& at) { return static_cast<double>(at.sample.error); });
    t.add({"phase", "", 1, {},
           "of the firmware: 0 idle, 1 homing, 2 and 3 calibration, 4 position, 5 velocity, 6 no "
           "controller",
           false, true},
          [](const At& at) { return static_cast<double>(at.sample.phase); });
    t.add({"angle", "", 1, {}, "angle within the stripe period, 2^14 a period"},
          [](const At& at) { return static_cast<double>(at.sample.words.phase); });
    t.add({"sensor_a_code", "", 1, {}, "A as the sensor has it"},
          [](const At& at) { return static_cast<double>(at.sample.stripes[0]); });
    t.add({"sensor_b_code", "", 1, {}, "B as the sensor has it"},
          [](const At& at) { return static_cast<double>(at.sample.stripes[1]); });
    t.add({"a_code", "", 1, {}, "last code of A"},
          [](const At& at) { return static_cast<double>(at.sample.words.codes[0]); });
    t.add({"b_code", "", 1, {}, "last code of B"},
          [](const At& at) { return static_cast<double>(at.sample.words.codes[2]); });
    for (std::size_t m = 0; m < kMotors; ++m) {
      const std::string motor = m == 0 ? "m1_" : "m2_";
      const auto add = [&](const char* name, lab::Column column, auto get) {
        column.name = motor + name;
        t.add(column, [m, get](const At& at) { return static_cast<double>(get(at.sample, m)); });
      };
      add("u_count", {"", "count", 1, {}, "force that the firmware wrote, positive to the right",
                      true},
          [](const Sample& s, std::size_t k) { return s.words.force[k]; });
      add("force_count", {"", "count", 1e-2, fixed(3),
                          "force of the motor, the same sign, mean of a period of its pulses"},
          [](const Sample& s, std::size_t k) { return -s.force[k]; });
      add("apart_mm", {"", "mm", 1e-5, fixed(6), "gear wheel from the cart"},
          [](const Sample& s, std::size_t k) { return 1e3 * s.motor[k]; });
      add("flank", {"", "", 1, {}, "flank that pushes; 0: within the backlash", false, true},
          [](const Sample& s, std::size_t k) { return s.flank[k]; });
    }
    return std::move(t).table();
  }();
  return all;
}

}  // namespace trammel::gantry
