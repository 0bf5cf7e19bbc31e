// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/chip/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trammel::kung {
namespace {

constexpr std::int32_t kLargestIqRef = 2047;
constexpr double kVoltageLimit = 0.95 * 2047;  // the limit's table steps inside its circle
constexpr double kWorthTelling = 0.02;         // of the samples

}  // namespace

void AxisLoad::add(const AxisSample& s, const plant::AxisConfig& plant) {
  const double square = s.i_d_true_A * s.i_d_true_A + s.i_q_true_A * s.i_q_true_A;
  least_link_V = samples == 0 ? s.dc_link_V : std::min(least_link_V, s.dc_link_V);
  most_link_V = std::max(most_link_V, s.dc_link_V);
  ++samples;
  squares_A2 += square;
  squares_N2 += s.force_N * s.force_N;
  peak_current_A = std::max(peak_current_A, std::sqrt(square));
  if (std::abs(s.i_q_ref) >= kLargestIqRef) ++at_current;
  if (std::hypot(s.v_d, s.v_q) >= kVoltageLimit) ++at_voltage;
  const bool stopped = (s.x_true_m <= plant.stroke_min_m && s.force_N < 0) ||
                       (s.x_true_m >= plant.stroke_max_m && s.force_N > 0);
  if (plant.hard_stops && stopped) ++at_stop;
}

double AxisLoad::rms_current_A() const {
  return samples == 0 ? 0 : std::sqrt(squares_A2 / static_cast<double>(samples) / 2);
}

double AxisLoad::rms_force_N() const {
  return samples == 0 ? 0 : std::sqrt(squares_N2 / static_cast<double>(samples));
}

double AxisLoad::copper_loss_W(double resistance_ohm) const {
  return 3 * resistance_ohm * rms_current_A() * rms_current_A();
}

std::string AxisLoad::limits() const {
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    const double share = static_cast<double>(count) / static_cast<double>(samples);
    if (samples == 0 || share < kWorthTelling) return;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", what, 100 * share);
  };
  add(at_current, "i_q* at its limit");
  add(at_voltage, "voltage at the supply's");
  add(at_stop, "carriage at a hard stop");
  return text.empty() ? "" : text + " of the samples";
}

const char* cause_name(FaultCode code) {
  switch (code) {
    case FaultCode::kNone: return "none";
    case FaultCode::kTrip: return "external trip";
    case FaultCode::kOverCurrent: return "over-current";
    case FaultCode::kWatchdog: return "watchdog";
    case FaultCode::kEncoder: return "encoder fault";
    case FaultCode::kStroke: return "stroke exceeded";
  }
  return "unknown";
}

std::string cause_text(const Fault& fault) {
  if (fault.code == FaultCode::kNone) return "the processor's check: " + fault.processor;
  if (fault.code == FaultCode::kTrip && !fault.processor.empty()) return fault.processor;
  if (fault.code == FaultCode::kTrip || fault.code == FaultCode::kWatchdog) {
    return cause_name(fault.code);  // of no axis
  }
  return fmt::format("{} on axis {}", cause_name(fault.code), fault.axis == 0 ? 'X' : 'Y');
}

std::string Result::fault_text() const {
  if (end == EndReason::kFault) return cause_text(fault);
  return end == EndReason::kMissed ? missed : "";
}

}  // namespace trammel::kung
