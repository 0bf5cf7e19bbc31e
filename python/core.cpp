// SPDX-License-Identifier: Apache-2.0
//
// The module trammel._core: the library lab for Python. The modules beside it, in Python, make of
// it what users see.
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <system_error>

#include "host/errors.hpp"
#include "lab/build_info.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "machines/table.hpp"
#include "python/record.hpp"

namespace trammel::python {
namespace {

// A full disk, a folder without permission: OSError with its number.
void translate(const std::exception_ptr& pointer, void*) {
  try {
    std::rethrow_exception(pointer);
  } catch (const std::system_error& error) {
    PyErr_SetObject(PyExc_OSError,
                    nb::make_tuple(error.code().value(), nb::str(error.what())).ptr());
  }
}

}  // namespace
}  // namespace trammel::python

NB_MODULE(_core, module) {
  namespace nb = nanobind;
  using namespace trammel;
  lab::take_machines(linked_machines);
  module.doc() = "The library of Trammel: settings, runs and their records.";
  nb::register_exception_translator(python::translate);
  nb::exception<host::ConfigError>(module, "ConfigError", PyExc_ValueError);
  nb::exception<host::ToolMissing>(module, "ToolMissing", PyExc_RuntimeError);
  module.attr("version") = lab::kVersion;
  module.attr("commit") = lab::kCommit;
  module.def("take_data_from", &lab::take_data_from, nb::arg("folder"),
             "Scenarios and pictures of the machines are in this folder from now on.");
  module.def("machines", &lab::machine_names, "Names of the machines.");
  module.def(
      "scenarios",
      [] {
        std::vector<std::string> names;
        for (const auto& file : lab::scenarios()) names.push_back(file.stem().string());
        return names;
      },
      "Names of the built-in scenarios.");
  python::bind_settings(module);
  python::bind_record(module);
  python::bind_stepped(module);
}
