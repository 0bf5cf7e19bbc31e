// SPDX-License-Identifier: Apache-2.0
//
// Where the fields of a chip's registers are, against a table in a test: RTL, twin and firmware all
// follow the map, so that only numbers written down tell that a field has moved.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace trammel::test {

struct Place {
  const char* name;
  std::uint32_t address;  // in a register file, an offset
  int high, low;          // bits
};

inline std::string place_text(std::uint32_t address, int high, int low) {
  char text[40];
  std::snprintf(text, sizeof text, "0x%03X[%d:%d]", address, high, low);
  return text;
}

// The first field of the map, in its order, that is not the one of the table; "" if all are.
template <class Fields>
std::string moved_field(const Fields& fields, const std::vector<Place>& places) {
  std::size_t n = 0;
  for (const auto& field : fields) {
    if (n == places.size()) return std::string(field.name) + " is not in the table";
    const Place& place = places[n++];
    const std::string is = std::string(field.name) + " at " +
                           place_text(field.address, field.shift + field.width - 1, field.shift);
    const std::string was =
        std::string(place.name) + " at " + place_text(place.address, place.high, place.low);
    if (is != was) return is + ", wanted " + was;
  }
  return n == places.size() ? "" : std::string(places[n].name) + " is not in the map";
}

// A field that is no plain number of all its bits.
struct Number {
  const char* name;
  int bits;
  bool is_signed = true;
};

// The first field whose number is not the one of the table, in the order of the map; "" if none.
template <class Fields>
std::string other_number(const Fields& fields, const std::vector<Number>& numbers) {
  const auto text = [](const char* name, int bits, bool is_signed) {
    return std::string(name) + (is_signed ? " signed" : " unsigned") + ", bits: " +
           std::to_string(bits);
  };
  std::size_t n = 0;
  for (const auto& field : fields) {
    Number number{field.name, field.width, false};
    if (n < numbers.size() && std::string(field.name) == numbers[n].name) number = numbers[n++];
    const std::string is = text(field.name, field.bits, field.is_signed);
    const std::string was = text(number.name, number.bits, number.is_signed);
    if (is != was) return is + ", wanted " + was;
  }
  return n == numbers.size() ? "" : std::string(numbers[n].name) + " is not in the map";
}

}  // namespace trammel::test
