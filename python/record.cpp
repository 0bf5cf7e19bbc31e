// SPDX-License-Identifier: Apache-2.0
#include "lab/record.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <mutex>

#include "host/output_folder.hpp"
#include "lab/build_info.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/report_page.hpp"
#include "lab/write.hpp"
#include "python/record.hpp"
#include "python/simulation.hpp"

namespace trammel::python {
namespace {

using Values = nb::ndarray<nb::numpy, double, nb::ndim<2>>;

// SystemC has one kernel in a process.
std::mutex systemc_kernel;

Finished run(const RunSettings& asked, const nb::object& progress) {
  const std::shared_ptr<const lab::Settings> settings = asked.settings->clone();
  std::atomic<bool> stop{false};
  std::atomic<double> fraction{0};
  cosim::Hooks hooks;
  hooks.stop = &stop;
  if (!progress.is_none()) hooks.progress = [&](double done) { fraction = done; };
  Finished finished;
  apart(stop, fraction, progress, [&] {
    std::unique_lock<std::mutex> kernel(systemc_kernel, std::defer_lock);
    if (settings->run.platform == cosim::Platform::kSystemC &&
        settings->run.engine == cosim::Engine::kRtl) {
      kernel.lock();
    }
    finished.record = std::make_shared<lab::Record>(lab::run(*settings, hooks));
  });
  return finished;
}

// A row for each column.
Values values_of(const Finished& run) {
  const lab::Record& record = *run.record;
  const lab::ColumnTable& table = record.machine().columns();
  const std::size_t columns = table.columns.size(), samples = record.result->sample_count();
  auto all = std::make_unique<double[]>(columns * samples);
  {
    const nb::gil_scoped_release released;
    const std::lock_guard<std::mutex> lock(*run.reading);
    std::vector<double> values;
    for (std::size_t k = 0; k < samples; ++k) {
      table.read(*record.settings, *record.result, k, values);
      for (std::size_t n = 0; n < columns; ++n) all[n * samples + k] = values[n];
    }
  }
  double* const data = all.get();
  nb::capsule owner(all.release(), [](void* p) noexcept { delete[] static_cast<double*>(p); });
  return Values(data, {columns, samples}, owner);
}

// (name, unit, help, digits behind the point, or -digits in all; None for whole numbers).
nb::list columns_of(const Finished& run) {
  nb::list all;
  for (const lab::Column& column : run.record->machine().columns().columns) {
    nb::object digits = nb::none();
    using Kind = lab::Format::Kind;
    if (column.format.kind == Kind::kFixed) digits = nb::int_(column.format.digits);
    if (column.format.kind == Kind::kGeneral) digits = nb::int_(-column.format.digits);
    all.append(nb::make_tuple(column.name, column.unit, column.help, digits));
  }
  return all;
}

// (place in metrics.json, value, unit, name, expected, tolerance, printed, source).
nb::list figures_of(const Finished& run) {
  const auto optional = [](const std::optional<double>& value) -> nb::object {
    return value ? nb::object(nb::float_(*value)) : nb::none();
  };
  nb::list all;
  for (const lab::Figure& one : run.record->figures) {
    all.append(nb::make_tuple(one.id, one.value, one.unit, one.name(), optional(one.expected),
                              one.tolerance, optional(one.printed), one.source));
  }
  return all;
}

// All files of a run into a folder, as the program writes them; the notes it would print.
std::vector<std::string> save(const Finished& run, const std::string& folder, bool page) {
  const nb::gil_scoped_release released;
  const std::lock_guard<std::mutex> lock(*run.reading);
  host::OutputFolder output{std::filesystem::path(folder)};
  lab::Origin origin;
  origin.folder = output.target();
  const lab::Written written = lab::write_record(
      *run.record, output, lab::metrics_json(*run.record, origin), origin, page);
  output.publish(lab::kVersion);
  return written.notes;
}

void write_page(const std::vector<std::string>& folders, const std::string& file) {
  const nb::gil_scoped_release released;
  lab::write_page({folders.begin(), folders.end()}, file);
}

}  // namespace

void bind_record(nb::module_& module) {
  nb::class_<Finished>(module, "Record", "A finished run.")
      .def_prop_ro("end",
                   [](const Finished& run) { return lab::end_text(run.record->result->end); })
      .def_prop_ro("code",
                   [](const Finished& run) { return lab::exit_code(run.record->result->end); })
      .def_prop_ro("verdict", [](const Finished& run) { return run.record->verdict; })
      .def_prop_ro("cause",
                   [](const Finished& run) { return lab::cause_text(*run.record->result); })
      .def_prop_ro("name", [](const Finished& run) { return run.record->name; })
      .def_prop_ro("event_hash",
                   [](const Finished& run) { return run.record->result->event_hash; })
      .def_prop_ro("wall_s", [](const Finished& run) { return run.record->result->wall_s; })
      .def_prop_ro("simulated_s",
                   [](const Finished& run) {
                     const cosim::RunResult& result = *run.record->result;
                     return result.seconds(result.clocks);
                   })
      .def_prop_ro("settings",
                   [](const Finished& run) { return RunSettings{run.record->settings->clone()}; })
      .def_prop_ro("figures", &figures_of)
      .def_prop_ro("columns", &columns_of)
      .def_prop_ro("metrics",
                   [](const Finished& run) { return lab::metrics_json(*run.record).dump(); })
      .def_prop_ro("companions",
                   [](const Finished& run) {
                     nb::list all;
                     for (const lab::Record& one : run.record->companions) {
                       Finished other{{run.record, &one}, run.reading};
                       all.append(nb::cast(std::move(other)));
                     }
                     return all;
                   })
      .def("values", &values_of, "A row for each column, in doubles.")
      .def("save", &save, nb::arg("folder"), nb::arg("page"))
      .def(
          "write_trace",
          [](const Finished& run, const std::string& file) {
            const nb::gil_scoped_release released;
            const std::lock_guard<std::mutex> lock(*run.reading);
            lab::write_trace(file, *run.record);
          },
          nb::arg("file"));
  module.def("run", &run, nb::arg("settings"), nb::arg("progress") = nb::none(),
             "Simulates. Settings must have been validated.");
  module.def("write_page", &write_page, nb::arg("folders"), nb::arg("file"),
             "The page of the run in a folder, or of the runs in several.");
}

}  // namespace trammel::python
