// SPDX-License-Identifier: Apache-2.0
//
// Why the program gave up, in words.
#pragma once

#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

const char* check_text(const sw::Mailbox& mailbox);  // "": it did not

}  // namespace trammel::kung
