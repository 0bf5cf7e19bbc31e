// SPDX-License-Identifier: Apache-2.0
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "python/record.hpp"
#include "python/register_tables.hpp"
#include "python/stepped.hpp"

namespace trammel::python {
namespace {

// Until the run stands. Python's signal handlers run meanwhile; where one raises, the run stops at
// its next sample.
void wait(Stepped& run) {
  for (;;) {
    bool stands = false;
    {
      const nb::gil_scoped_release released;
      stands = run.done();
    }
    if (stands) return;
    if (PyErr_CheckSignals() == 0) continue;
    const nb::python_error raised;
    run.halt();
    const nb::gil_scoped_release released;
    while (!run.done()) {
    }
    throw raised;
  }
}

}  // namespace

void bind_stepped(nb::module_& module) {
  nb::class_<Stepped>(module, "Stepped", "A run that goes on when it is told to.")
      .def(
          "__init__",
          [](Stepped* self, const RunSettings& asked) {
            new (self) Stepped(asked.settings->clone());
            wait(*self);
          },
          nb::arg("settings"))
      .def(
          "advance",
          [](Stepped& self, std::int64_t clocks) {
            self.advance(clocks);
            wait(self);
          },
          nb::arg("clocks"))
      .def(
          "read",
          [](Stepped& self, std::uint32_t address) {
            self.access({address, 0, false});
            wait(self);
            return self.data();
          },
          nb::arg("address"))
      .def(
          "write",
          [](Stepped& self, std::uint32_t address, std::uint32_t data) {
            self.access({address, data, true});
            wait(self);
          },
          nb::arg("address"), nb::arg("data"))
      .def(
          "finish",
          [](Stepped& self, bool early) {
            self.finish(early);
            do {
              wait(self);  // of a run that has failed it raises why, each time
            } while (!self.over());
            return Finished{self.record()};
          },
          nb::arg("early"))
      .def_prop_ro("over", &Stepped::over)
      .def_prop_ro("now", &Stepped::now, "Clocks from the start of the run.")
      .def_prop_ro("clock_s",
                   [](const Stepped& self) { return cosim::seconds_of(1, self.clock_ps()); },
                   "Period of the chip's clock [s].")
      .def_prop_ro("drive", &Stepped::drive, "Pins of the chip toward the machine.")
      .def_prop_ro("sense", &Stepped::sense, "Pins of the machine toward the chip.")
      .def_prop_ro("places",
                   [](const Stepped& self) {
                     nb::list all;
                     for (const cosim::Place& one : self.places()) {
                       all.append(nb::make_tuple(one.axis, one.value, one.unit));
                     }
                     return all;
                   },
                   "(axis, value, unit) of where the machine really is.")
      .def_prop_ro("signals", &Stepped::signal_names)
      .def("signal", &Stepped::signal, nb::arg("name"));
  module.def("registers", &registers_of, nb::arg("machine"),
             "(name, address, help of its fields) of the registers of a machine's chip, and "
             "(name, address, shift, width, bits, signed, of an axis) of their fields.");
}

}  // namespace trammel::python
