// SPDX-License-Identifier: Apache-2.0
#include "lab/key_table.hpp"
#include "machines/@name@/machine_members.hpp"
#include "machines/@name@/options.hpp"

namespace trammel::@name@ {

const std::vector<lab::Key>& keys() {
  static const auto all = [] {
    lab::KeyTable<Options> t(machine().name);
    t.names();
    t.platform_and_clocks();
    t.window();
    t.longest_run();
    t.waves("the first drive", "see docs/waves.md");
    t.one("controller.speed_counts", -100, 100, "wanted, encoder counts per millisecond",
          TRAMMEL_LENS(controller.speed));
    t.one("controller.kp", 0, 65536, "duty / 256 per count of error",
          TRAMMEL_LENS(controller.kp));
    t.one("controller.ki", 0, 65536, "the same, added up each millisecond",
          TRAMMEL_LENS(controller.ki));
    t.one("controller.duration_s", 0.01, 60, "after which the program ends",
          TRAMMEL_LENS(duration_s));
    t.processor();
    t.one("motor.inertia_kg_m2", 1e-6, 1, "of rotor and load", TRAMMEL_LENS(plant.motor.inertia));
    t.one("motor.external_torque_N_m", -10, 10, "against positive motion",
          TRAMMEL_LENS(plant.motor.external_torque));
    t.one("motor.supply_V", 1, 100, "of the bridge", TRAMMEL_LENS(plant.motor.supply));
    t.one("encoder.counts", 400, 40000, "per revolution, after x4 decoding",
          TRAMMEL_LENS(plant.counts));
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::@name@
