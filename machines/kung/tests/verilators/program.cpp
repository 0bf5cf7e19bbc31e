// SPDX-License-Identifier: Apache-2.0
//
// A run without waves, with a chip of another Verilator: second OUT KEY=VALUE...
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>
#ifndef TRAMMEL_WHOLE  // then as with a Verilator whose regions are not known
#include <kung_xy_state.hpp>
#endif

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "lab/layers.hpp"
#include "lab/machines.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "machines/kung/chip/chip.hpp"
#include "machines/kung/chip/soc.hpp"
#include "machines/kung/chip/verilated/chip_model.hpp"

namespace trammel {
namespace kung {

const lab::Machine& machine();

// Only the fast model is built here.
const std::vector<Signal>& signals() {
  static const std::vector<Signal> none;
  return none;
}

std::unique_ptr<KungChip> make_verilated_chip(const cosim::RunOptions& run,
                                              const std::optional<cosim::WaveWindow>&) {
  return std::make_unique<ChipModel<Vkung_xy, cosim::NoTrace>>(cosim::NoTrace{},
                                                               cosim::ModelMode{run.leap, false});
}

std::unique_ptr<KungChip> make_watched_chip(cosim::Watcher&, bool) {
  throw std::logic_error("no triggers here");
}

std::unique_ptr<SocCore> make_core(const CoreMemory&, bool) { return nullptr; }

}  // namespace kung

}  // namespace trammel

int main(int argc, char** argv) try {
  namespace lab = trammel::lab;
  lab::take_machines([] { return lab::Machines{&trammel::kung::machine()}; });
  const std::filesystem::path out = argc > 1 ? argv[1] : "";
  const auto settings = lab::load_scenario(lab::find_scenario("circle"));
  for (int i = 2; i < argc; ++i) lab::apply_assignment(*settings, argv[i]);
  lab::validate(*settings);
  const lab::Record record = lab::run(*settings);
  std::filesystem::create_directories(out);
  lab::write_trace(out / "trace.csv", record);
  std::ofstream(out / "metrics.json") << lab::metrics_json(record).dump(2) << '\n';
  return lab::exit_code(record.result->end);
} catch (const std::exception& error) {
  std::fprintf(stderr, "second: %s\n", error.what());
  return 2;
}
