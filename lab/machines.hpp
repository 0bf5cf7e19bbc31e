// SPDX-License-Identifier: Apache-2.0
//
// The table of machines that a program gives to the library.
#pragma once

#include <vector>

#include "lab/errors.hpp"
#include "lab/machine.hpp"

namespace trammel::lab {

using Machines = std::vector<const Machine*>;

// This program is of one machine, and another one is needed. Exit code 3.
struct NotLinked : ToolMissing {
  NotLinked()
      : ToolMissing("this program has one machine only; `./trammel run` builds the others") {}
};

// Before a program uses the library. Unless the table is `whole`, there are other machines:
// need_all_machines() throws NotLinked.
void take_machines(Machines (*table)(), bool whole = true);
void need_all_machines();

}  // namespace trammel::lab
