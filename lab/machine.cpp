// SPDX-License-Identifier: Apache-2.0
#include "lab/machine.hpp"

namespace trammel::lab {

std::vector<std::string> machine_names() {
  std::vector<std::string> names;
  for (const Machine* machine : machines()) names.push_back(machine->name);
  return names;
}

const Machine* find_machine(const std::string& name) {
  for (const Machine* machine : machines()) {
    if (machine->name == name) return machine;
  }
  return nullptr;
}

}  // namespace trammel::lab
