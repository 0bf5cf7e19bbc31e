// SPDX-License-Identifier: Apache-2.0
//
// The table of machines that a program gives to the library.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/errors.hpp"
#include "lab/machine.hpp"

namespace trammel::lab {

using Machines = std::vector<const Machine*>;

// This program is of one machine, and another one is needed: `machine`, or "" for all of them. Exit
// code 3.
struct NotLinked : host::ToolMissing {
  explicit NotLinked(std::string name = "")
      : host::ToolMissing("this program has one machine only; `./trammel run` builds the others"),
        machine(std::move(name)) {}
  std::string machine;
};

// Before a program uses the library. Unless the table is `whole`, there are other machines, and
// need_all_machines() throws NotLinked.
void take_machines(Machines (*table)(), bool whole = true);
void need_all_machines(const std::string& machine = "");

const Machine& first_machine();  // to which a file without a machine belongs

}  // namespace trammel::lab
