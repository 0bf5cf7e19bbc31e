// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/failure.hpp"

namespace trammel::kung {

const char* check_text(const sw::Mailbox& mailbox) {
  switch (static_cast<sw::Failure>(mailbox.failure)) {
    case sw::Failure::kWrongChip: return "the chip's ID is not that of the register map";
    case sw::Failure::kOutOfStroke: return "the path leaves the stroke";
    case sw::Failure::kBusy: return "a busy bit did not clear";
    case sw::Failure::kSensor:
      return "a current sensor shows more than 1/8 of its range with the drives off";
    case sw::Failure::kPreset: return "the position did not become the start point";
    case sw::Failure::kLate: return "an interrupt was lost, or its service crossed a position tick";
    case sw::Failure::kFollowing:
      return "the position is farther from its model than chip.following_error_m";
    case sw::Failure::kDCurrent:
      return "a measured d current is above chip.d_current_A, though its loop holds it at 0";
    case sw::Failure::kFault: return "the chip interrupts for a fault that it does not name";
    case sw::Failure::kNone: break;
  }
  return "";
}

}  // namespace trammel::kung
