// SPDX-License-Identifier: Apache-2.0
//
// The machines that a program is linked with: for lab::take_machines(). The build writes this
// function from the folders of machines/.
#pragma once

#include "lab/machines.hpp"

namespace trammel {

lab::Machines linked_machines();
bool all_are_linked();  // otherwise the program is of one machine: `./trammel run` builds it

}  // namespace trammel
