// SPDX-License-Identifier: Apache-2.0
//
// Parts that an axis with a linear motor (axis.hpp) and one with a rotary motor (rotary_axis.hpp)
// have in common, and how a value that no axis can have is refused by its name.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "models/plant/current_sensor.hpp"
#include "models/plant/dc_link.hpp"
#include "models/plant/inverter.hpp"

namespace trammel::plant {

// The inverter and its supply.
struct InverterPart {
  double dc_link_v = 311;
  double supply_ohm = 0;  // of what charges the DC link; 0: a stiff one
  double dc_link_f = 1e-3;  // capacitor of one that is not
  double chopper_v = 0;     // at which its brake chopper burns; 0: none
  double switch_drop_v = 0;
  double diode_drop_v = 0;
};

// The sensors of the currents of phases a and b, with their converters.
struct CurrentSensorPart {
  double current_full_scale_a = 9.6;
  double current_noise_a = 0;                             // rms
  double current_offset_a_a = 0, current_offset_b_a = 0;  // of the sensors of phases a and b [A]
  double current_gain_a = 1, current_gain_b = 1;          // what they show of the current
  int adc_bits = 12;
};

inline DcLinkConfig link_config(const InverterPart& p) {
  return {p.dc_link_v, p.supply_ohm, p.dc_link_f, p.chopper_v};
}

inline InverterConfig inverter_config(const InverterPart& p) {
  return {p.dc_link_v, p.switch_drop_v, p.diode_drop_v};
}

inline std::array<CurrentSensorConfig, 2> sensor_configs(const CurrentSensorPart& p) {
  return {{{p.current_full_scale_a, p.current_noise_a, p.current_offset_a_a, p.current_gain_a,
            p.adc_bits},
           {p.current_full_scale_a, p.current_noise_a, p.current_offset_b_a, p.current_gain_b,
            p.adc_bits}}};
}

enum class Is { kFinite, kNotNegative, kPositive };

template <class Part>
struct PartValue {
  const char* name;
  double Part::* member;
  Is is;
};

// Throws std::invalid_argument that names the value, says what it is, and what is permitted.
void require_value(bool good, const char* name, double value, const std::string& permitted);

// "above name = 3"
std::string limit(const char* words, double value);

template <class Part, std::size_t size>
void check_values(const Part& part, const PartValue<Part> (&values)[size]) {
  for (const PartValue<Part>& one : values) {
    const double value = part.*one.member;
    require_value(std::isfinite(value), one.name, value, "finite");
    require_value(one.is != Is::kPositive || value > 0, one.name, value, "above 0");
    require_value(one.is != Is::kNotNegative || value >= 0, one.name, value, "0 or above");
  }
}

void check_part(const InverterPart& part);
void check_part(const CurrentSensorPart& part);

}  // namespace trammel::plant
