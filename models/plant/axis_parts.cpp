// SPDX-License-Identifier: Apache-2.0
#include "models/plant/axis_parts.hpp"

#include <sstream>
#include <stdexcept>

namespace trammel::plant {
namespace {

using I = InverterPart;
using S = CurrentSensorPart;

constexpr PartValue<I> kInverter[] = {{"dc_link_v", &I::dc_link_v, Is::kNotNegative},
                                      {"supply_ohm", &I::supply_ohm, Is::kNotNegative},
                                      {"dc_link_f", &I::dc_link_f, Is::kPositive},
                                      {"chopper_v", &I::chopper_v, Is::kNotNegative},
                                      {"switch_drop_v", &I::switch_drop_v, Is::kNotNegative},
                                      {"diode_drop_v", &I::diode_drop_v, Is::kNotNegative}};

constexpr PartValue<S> kSensors[] = {
    {"current_full_scale_a", &S::current_full_scale_a, Is::kPositive},
    {"current_noise_a", &S::current_noise_a, Is::kNotNegative},
    {"current_offset_a_a", &S::current_offset_a_a, Is::kFinite},
    {"current_offset_b_a", &S::current_offset_b_a, Is::kFinite},
    {"current_gain_a", &S::current_gain_a, Is::kFinite},
    {"current_gain_b", &S::current_gain_b, Is::kFinite}};

}  // namespace

void require_value(bool good, const char* name, double value, const std::string& permitted) {
  if (good) return;
  std::ostringstream text;
  text << "axis: " << name << ": value " << value << " must be " << permitted;
  throw std::invalid_argument(text.str());
}

std::string limit(const char* words, double value) {
  std::ostringstream text;
  text << words << ' ' << value;
  return text.str();
}

void check_part(const InverterPart& part) { check_values(part, kInverter); }

void check_part(const CurrentSensorPart& part) {
  check_values(part, kSensors);
  require_value(part.adc_bits >= 6 && part.adc_bits <= 16, "adc_bits", part.adc_bits, "6 to 16");
}

}  // namespace trammel::plant
