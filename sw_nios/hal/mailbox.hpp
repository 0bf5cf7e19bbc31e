// SPDX-License-Identifier: Apache-2.0
//
// What firmware reports to the outside, in plain words of memory: a session reads them without
// cost where the firmware runs natively, a debugger or a test bench finds them on a core.
#pragma once

#include <cstdint>

namespace trammel::sw {

struct Mailbox {
  std::uint32_t done = 0;        // 1: the program has ended, nothing more will be commanded
  std::uint32_t failure = 0;     // why it ended early, in the application's list; 0: it did not
  std::uint32_t point = 0;       // points, rows, moves or readings so far
  std::uint32_t first_tick = 0;  // sample at which the first point takes effect, once known
  std::uint32_t speed = 0;       // of the point, where the application sets it
  std::int32_t desired[2] = {};  // position of each axis at the end [count]
  std::int32_t real[2] = {};
};

}  // namespace trammel::sw
