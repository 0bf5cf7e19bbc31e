// SPDX-License-Identifier: Apache-2.0
//
// The module trammel._core: the library lab for Python. The modules beside it, in Python, make of
// it what users see.
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "host/errors.hpp"
#include "host/files.hpp"
#include "host/output_folder.hpp"
#include "host/text.hpp"
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

// As UTF-8; a half character that stands for a byte is that byte again.
std::string bytes_of(const nb::str& text) {
  PyObject* bytes = PyUnicode_AsEncodedString(text.ptr(), "utf-8", "surrogateescape");
  if (bytes == nullptr) {
    PyErr_Clear();
    bytes = PyUnicode_AsEncodedString(text.ptr(), "utf-8", "surrogatepass");
  }
  const nb::bytes all = nb::steal<nb::bytes>(bytes);
  return {all.c_str(), all.size()};
}

// What knows no motor: texts and files as the program has them.
void bind_host(nb::module_& module) {
  module.def(
      "one_line", [](const nb::str& text) { return host::one_line(bytes_of(text)); },
      nb::arg("text"), "A message as one line that a terminal can show, of bounded length.");
  module.def(
      "printable_lines", [](const nb::str& text) { return host::printable_lines(bytes_of(text)); },
      nb::arg("text"), "Lines of text as a terminal can show them.");
  module.def(
      "replace_file",
      [](const nb::bytes& file, const nb::bytes& data) {
        const std::filesystem::path path(std::string(file.c_str(), file.size()));
        try {
          host::replace_file(path, {data.c_str(), data.size()});
        } catch (const host::WriteError& error) {
          throw std::system_error(error.code, std::generic_category());
        }
      },
      nb::arg("file"), nb::arg("data"), "Whole or not at all, in the place of a regular file.");
  module.def("record_files", &host::record_files, "Names of the files of a run's record.");
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
  python::bind_host(module);
  python::bind_settings(module);
  python::bind_record(module);
  python::bind_stepped(module);
}
