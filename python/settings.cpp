// SPDX-License-Identifier: Apache-2.0
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "lab/settings.hpp"
#include "python/record.hpp"

namespace trammel::python {
namespace {

// (name, default as TOML, range, help) of each key.
nb::list keys_of(const lab::Machine& machine) {
  const auto defaults = machine.defaults();
  nb::list all;
  for (const lab::Key& key : machine.keys()) {
    all.append(nb::make_tuple(key.name, lab::value_text(key.get(*defaults)), lab::range_text(key),
                              key.help));
  }
  return all;
}

std::optional<std::string> range_of(const RunSettings& asked, const std::string& name) {
  const auto keys = lab::find_keys(asked.settings->machine().keys(), name);
  if (keys.empty()) return {};
  return lab::range_text(*keys.front());
}

}  // namespace

void bind_settings(nb::module_& module) {
  nb::class_<RunSettings>(module, "Settings", "What one run is asked for.")
      .def(
          "__init__",
          [](RunSettings* self, const std::string& scenario) {
            new (self) RunSettings{lab::load_scenario(lab::find_scenario(scenario))};
          },
          nb::arg("scenario"), "A built-in scenario, or the path of a .toml file.")
      .def(
          "set",
          [](RunSettings& self, const std::string& key, const std::string& value) {
            lab::apply_assignment(*self.settings, key + '=' + value);
          },
          nb::arg("key"), nb::arg("value"), "Gives a key this value, as the command line has it.")
      .def(
          "add_file",
          [](RunSettings& self, const std::string& file) { lab::apply_file(*self.settings, file); },
          nb::arg("file"), "Applies a TOML file.")
      .def(
          "validate", [](RunSettings& self) { lab::validate(*self.settings); },
          "Checks the rules that concern several keys; once, after all have their values.")
      .def(
          "copy", [](const RunSettings& self) { return RunSettings{self.settings->clone()}; },
          "The same settings once more.")
      .def_prop_ro("scenario", [](const RunSettings& self) { return self.settings->scenario; })
      .def_prop_ro("machine", [](const RunSettings& self) { return self.settings->machine().name; })
      .def_prop_ro(
          "values",
          [](const RunSettings& self) {
            nb::dict all;
            for (const lab::Key& key : self.settings->machine().keys()) {
              all[key.name.c_str()] = key.get(*self.settings);
            }
            return all;
          },
          "Every key and its value.")
      .def_prop_ro(
          "toml", [](const RunSettings& self) { return lab::run_toml(*self.settings); },
          "A scenario file that repeats the run.")
      .def_prop_ro(
          "command", [](const RunSettings& self) { return lab::repeat_command(*self.settings); },
          "The command that repeats the run.")
      .def("range", &range_of, nb::arg("key"), "What a key may be; None for one that is unknown.");
  module.def(
      "keys",
      [](const std::string& machine) {
        const lab::Machine* const found = lab::find_machine(machine);
        return found == nullptr ? nb::list() : keys_of(*found);
      },
      nb::arg("machine"), "(name, default, range, help) of every key of a machine.");
}

}  // namespace trammel::python
