// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/believed.hpp"

#include <fmt/format.h>

#include <array>

#include "machines/kung/plan/parts.hpp"
#include "machines/kung/plan/register_values.hpp"

namespace trammel::kung {
namespace {

// One value: its name in [believed] and [plant], where it is, and what is computed from it.
struct Belief {
  const char* name;
  double BelievedMotor::* believed;
  double plant::AxisConfig::* plant;
  bool by_rule, in_precision;  // else always
};

constexpr std::array<Belief, 5> kBeliefs{{
    {"force_constant_N_A", &BelievedMotor::force_constant_n_a,
     &plant::AxisConfig::force_constant_n_a, true, true},
    {"resistance_ohm", &BelievedMotor::resistance_ohm, &plant::AxisConfig::resistance_ohm, true,
     false},
    {"inductance_q_H", &BelievedMotor::inductance_q_h, &plant::AxisConfig::inductance_q_h, true,
     false},
    {"pole_pitch_m", &BelievedMotor::pole_pitch_m, &plant::AxisConfig::pole_pitch_m, false, false},
    {"mass_kg", &BelievedMotor::mass_kg, &plant::AxisConfig::mass_kg, true, false},
}};

std::string key_of(const char* section, std::size_t axis, const std::string& name) {
  return fmt::format("{}.{}.{}", section, axis == 0 ? 'x' : 'y', name);
}

}  // namespace

plant::AxisConfig believed_motor(const Options& options, std::size_t axis) {
  plant::AxisConfig motor = options.plant.axis[axis];
  const BelievedMotor& own = options.believed[axis];
  for (const Belief& one : kBeliefs) {
    if (own.*one.believed != 0) motor.*one.plant = own.*one.believed;
  }
  if (own.mass_kg != 0) motor.payload_kg = 0;
  return motor;
}

std::string motor_key(const Options& options, std::size_t axis, const std::string& name) {
  for (const Belief& one : kBeliefs) {
    if (name == one.name && options.believed[axis].*one.believed != 0) {
      return key_of("believed", axis, name);
    }
  }
  return key_of("plant", axis, name);
}

void check_believed(const Options& options, std::size_t axis) {
  for (const Belief& one : kBeliefs) {
    const double value = options.believed[axis].*one.believed;
    if (value == 0) continue;
    const std::string key = key_of("believed", axis, one.name);
    const double least = lab::find_keys(keys(), key_of("plant", axis, one.name)).front()->min;
    in_range(key, value, least, lab::find_keys(keys(), key).front()->max, "or 0 = the plant's");
  }
}

AxisGains gains_of(const Options& options, std::size_t axis) {
  AxisGains gains = options.gains[axis];
  if (!options.gains_by_rule) return gains;
  const MotorGains rule = gains_by_rule(believed_motor(options, axis));
  gains.kv = rule.kv_A_s_m / kSpeedGain;
  gains.current_kp_V_A = rule.current_kp_V_A;
  gains.current_ki_V_A = rule.current_ki_V_A;
  return gains;
}

std::string gain_by(const Options& options, std::size_t axis,
                    std::initializer_list<const char*> names) {
  if (!options.gains_by_rule) return "";
  const plant::AxisConfig motor = believed_motor(options, axis);
  std::vector<std::string> values;
  for (const char* const name : names) {
    for (const Belief& one : kBeliefs) {
      if (std::string(name) != one.name) continue;
      values.push_back(
          fmt::format("{} = {:g}", motor_key(options, axis, name), motor.*one.plant));
      if (one.plant != &plant::AxisConfig::mass_kg || motor.payload_kg == 0) continue;
      values.push_back(
          fmt::format("{} = {:g}", key_of("plant", axis, "payload_kg"), motor.payload_kg));
    }
  }
  return fmt::format("by gains.by_rule of {}, ", fmt::join(values, " and "));
}

std::vector<std::string> unused_beliefs(const Options& options) {
  std::vector<std::string> lines;
  const bool precise = options.controller == Controller::kPrecision;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    for (const Belief& one : kBeliefs) {
      if (options.believed[axis].*one.believed == 0 || !one.by_rule) continue;
      if (options.gains_by_rule || (precise && one.in_precision)) continue;
      lines.push_back(fmt::format("{} has no effect without gains.by_rule = true{}",
                                  key_of("believed", axis, one.name),
                                  one.in_precision ? " or controller = \"precision\"" : ""));
    }
  }
  return lines;
}

}  // namespace trammel::kung
