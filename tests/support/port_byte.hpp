// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace trammel::test {

// One byte at the port of an LM628 as text, by what it is and in hexadecimal: c1F, dA0.
inline std::string port_byte(char kind, unsigned byte) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  return {kind, kDigits[byte >> 4 & 15], kDigits[byte & 15]};
}

}  // namespace trammel::test
