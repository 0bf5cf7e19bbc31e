// SPDX-License-Identifier: Apache-2.0
//
// The register maps of the chips, by machine: the build finds the generated headers and writes the
// unit with registers_of().
#pragma once

#include <nanobind/nanobind.h>

#include <string>

namespace trammel::python {

namespace nb = nanobind;

// (registers, fields); empty lists for a machine whose chip has none.
nb::tuple registers_of(const std::string& machine);

template <class Registers, class Fields>
nb::tuple register_lists(const Registers& registers, const Fields& fields) {
  nb::list names, parts;
  for (const auto& one : registers) names.append(nb::make_tuple(one.name, one.address));
  for (const auto& one : fields) {
    parts.append(nb::make_tuple(one.name, one.address, one.shift, one.width, one.bits,
                                one.is_signed, one.of_axis, one.help));
  }
  return nb::make_tuple(names, parts);
}

}  // namespace trammel::python
