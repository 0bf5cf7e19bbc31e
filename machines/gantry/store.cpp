// SPDX-License-Identifier: Apache-2.0
//
// Calibration data of an ideal sensor (specification of the observer): codes of 512 +- 400, 500
// codes of derivative at 500 mm/s.
#include <algorithm>
#include <cstddef>
#include <initializer_list>

#include "machines/gantry/machine_members.hpp"

namespace trammel::gantry {

Store ideal_store() {
  sw::CalibrationWords words{};
  const auto put = [&words](std::size_t at, std::initializer_list<int> values) {
    for (const int value : values) words[at++] = static_cast<std::uint16_t>(value & 0xFFFF);
  };
  put(0, {'I' | 'D' << 8, 'E' | 'A' << 8, 'L', 0, 512, 512, 2048, 6144, 10240, 14336});
  put(14, {162, 0, 1652, 1, -162, 0, -1652, 4097, -162, 0, -1652, 8193, 162, 0, 1652, 12289});
  put(30, {0, 512, 512, 12, 12, 1012, 1012, 0, 4096, 8192, 12288});
  for (const std::size_t region : {0u, 1u, 2u, 3u}) {
    const int sign = region == 0 || region == 3 ? 1 : -1;
    put(41 + 5 * region, {sign * 21885, 0, sign * 13736, 0, sign * 11641});
  }
  put(61, {13});
  words.back() = sw::checksum(words);
  Store store{};
  std::copy(words.begin(), words.end(), store.begin());
  return store;
}

}  // namespace trammel::gantry
