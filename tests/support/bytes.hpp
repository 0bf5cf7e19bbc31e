// SPDX-License-Identifier: Apache-2.0
//
// Catch prints a byte as a character, and from 80h on that is no UTF-8. Pins and status are bytes:
// they are printed as numbers. Every test includes this first (tests/CMakeLists.txt), since Catch
// calls the function by its full name, which must be known there.
#pragma once

#include <cstdio>
#include <string>

namespace Catch {
namespace Detail {

inline std::string stringify(const unsigned char& byte) {
  char text[16];
  std::snprintf(text, sizeof text, byte < 10 ? "%u" : "%u (0x%02X)", byte, byte);
  return text;
}

}  // namespace Detail
}  // namespace Catch
