// SPDX-License-Identifier: Apache-2.0
//
// Settings and finished runs as Python sees them.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>
#include <mutex>
#include <string>

#include "lab/record.hpp"
#include "lab/settings.hpp"

namespace trammel::python {

namespace nb = nanobind;

// What a run is asked for; layers are applied by the methods, later ones win.
struct RunSettings {
  std::shared_ptr<lab::Settings> settings;
};

// A finished run. It is not changed any more, so threads may share it; what reads its record, which
// lies on the disk, does so one at a time.
struct Finished {
  std::shared_ptr<const lab::Record> record;
  std::shared_ptr<std::mutex> reading = std::make_shared<std::mutex>();
};

void bind_settings(nb::module_& module);
void bind_record(nb::module_& module);
void bind_stepped(nb::module_& module);

}  // namespace trammel::python
