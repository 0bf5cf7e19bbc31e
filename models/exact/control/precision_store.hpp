// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/control/precision_store.sv: the words of the precision controller, 64 of 48
// bits an axis. The bus sees the first 32 of them, and those that registers show.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class PrecisionStore {
 public:
  static constexpr int kWords = 64;   // of an axis
  static constexpr int kWindow = 32;  // of them, by PREC_ADDR

  enum class Word : std::uint8_t {
    kC, kIff, kKm, kKmi, kRatio, kKb, kFc,                        // taken at a knot
    kL1 = 8, kL2, kL3, kK1, kK2, kMisc,                           // taken at the next tick
    kE1 = 16, kE2, kD, kAcc, kVff, kP, kY,                        // to be read
    kSpline = 35, kIacc = 39, kKmNow = 45, kKbNow = 47,           // what a record shows
    kFcNow = 48, kV24 = 49, kAff = 51, kErr = 54,
    kErrSum = 59, kIqSum = 60, kDist = 61, kKnots = 62,           // read by registers
  };

  // By the bus: 32 bits, sign-extended; words that it does not have are left alone.
  static constexpr bool writable(int word) { return word >= 0 && word <= 13 && word != 7; }
  void write(int axis, int word, std::int32_t value) {
    if (writable(word)) at(axis, word) = value;
  }
  std::int32_t read(int axis, int word) const {
    return static_cast<std::int32_t>(fixed::wrap(at(axis, word), 32));
  }

  // By the law.
  std::int32_t word(int axis, Word word) const { return read(axis, static_cast<int>(word)); }
  void put(int axis, Word word, std::int64_t value) { put(axis, static_cast<int>(word), value); }
  void put(int axis, int word, std::int64_t value) { at(axis, word) = fixed::wrap(value, 48); }
  std::int64_t get(int axis, int word) const { return at(axis, word); }

 private:
  std::int64_t& at(int axis, int word) { return words_[index(axis, word)]; }
  const std::int64_t& at(int axis, int word) const { return words_[index(axis, word)]; }
  static constexpr std::size_t index(int axis, int word) {
    return static_cast<std::size_t>(kWords * axis + word);
  }

  std::array<std::int64_t, 2 * kWords> words_{};
};

}  // namespace trammel::exact
