// SPDX-License-Identifier: Apache-2.0
//
// Keys of machines with an LM628 and a DC motor. Included only where a table is made.
#pragma once

#include "lab/key_table.hpp"
#include "models/plant/dc_motor.hpp"
#include "parts/lm628/options.hpp"
#include "sw_nios/hal/lm628.hpp"

namespace trammel::lab {

template <>
inline std::vector<std::string> enum_names<lm628::Variant>() {
  return {"lm628", "lm629"};
}

}  // namespace trammel::lab

namespace trammel::lm628 {

// A function that adds the key PREFIX + name of a member of what `select` finds in the options.
template <class Options, class Select>
auto keys_of(lab::KeyTable<Options>& t, const std::string& prefix, Select select) {
  return [=, &t](const char* name, double min, double max, const char* help, auto member) {
    t.one(prefix + name, min, max, help, [=](auto& o) -> auto& { return select(o).*member; });
  };
}

// Keys of a run, from its engine to its waves.
template <class Options>
void add_run(lab::KeyTable<Options>& t) {
  t.platform_and_clocks();
  t.window();
  t.longest_run();
  t.one("run.diverged_counts", 1, 32767, "position error that ends the run as diverged",
        TRAMMEL_LENS(diverged_counts));
  t.waves("the first drive", "see docs/waves.md");
}

// `clock` selects the frequency in the Options.
template <class Options, class Lens>
void add_clock(lab::KeyTable<Options>& t, Lens clock) {
  t.one("chip.clock_MHz", 6, 8, "of the part: 6 or 8; a sample is 2048 clocks", clock);
}

// `select` finds the PartOptions in the Options.
template <class Options, class Select>
void add_part(lab::KeyTable<Options>& t, Select select) {
  using P = PartOptions;
  const auto add = keys_of(t, "chip.", select);
  add("variant", 0, 0, "lm628: converter and linear amplifier; lm629: pulses of sign and "
      "magnitude, and an H-bridge", &P::variant);
  add("dac_bits", 8, 12, "of the converter: 8 or 12; the program loads the mode that it needs",
      &P::dac_bits);
  add_clock(t, [select](auto& o) -> auto& { return select(o).clock_MHz; });
  add("wrap", 0, 0, "products and sum of the output wrap at 16 bits instead of saturating",
      &P::wrap);
}

template <class Options>
void add_monitors(lab::KeyTable<Options>& t) {
  t.one("chip.error_limit_counts", 0, 32767,
        "position error at which a part turns its motor off (LPES); 0 = none",
        TRAMMEL_LENS(error_limit));
  t.one("chip.index_check", 0, 0, "the program checks that an index is a turn from the one before",
        TRAMMEL_LENS(index_check));
}

template <class Options>
void add_filter(lab::KeyTable<Options>& t) {
  using F = sw::Lm628Filter;
  const auto add = keys_of(t, "filter.", TRAMMEL_LENS(filter));
  add("kp", 0, 32767, "of the error", &F::kp);
  add("ki", 0, 32767, "of the sum of errors / 256", &F::ki);
  add("kd", 0, 32767, "of the change of the error", &F::kd);
  add("il", 0, 32767, "limit of the integral term", &F::il);
  add("interval_samples", 1, 256, "of the derivative term", &F::interval);
}

// `motor` selects the plant::DcMotorConfig of the Options.
template <class Options, class Lens>
void add_motor(lab::KeyTable<Options>& t, Lens motor) {
  const auto add = keys_of(t, "motor.", motor);
  using M = plant::DcMotorConfig;
  add("resistance_ohm", 0.01, 1000, "of the winding; assumed", &M::resistance);
  add("inductance_H", 1e-4, 1, "of the winding; assumed", &M::inductance);
  add("constant_N_m_A", 1e-3, 10, "torque of a current, and V s/rad; assumed", &M::constant);
  add("inertia_kg_m2", 1e-6, 1, "of rotor and load; assumed", &M::inertia);
  add("viscous_N_m_s", 0, 1, "viscous friction, per rad/s; assumed", &M::viscous);
  add("coulomb_N_m", 0, 1, "Coulomb friction", &M::coulomb);
  add("friction_speed_rad_s", 1e-3, 10, "where friction smooths out", &M::friction_speed);
  add("external_torque_N_m", -10, 10, "against positive motion", &M::external_torque);
  add("supply_V", 1, 100, "of the amplifier, at full scale of the converter; assumed",
      &M::supply);
}

}  // namespace trammel::lm628
