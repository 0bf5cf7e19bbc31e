// SPDX-License-Identifier: Apache-2.0
//
// The verb `run` without waves, for a chip of another Verilator: second OUT KEY=VALUE...
#include <stdexcept>

#include "cosim/kung/chip.hpp"
#include "systemc/machines/kung.hpp"
#include "testbench/run.hpp"

namespace trammel::kung {

// Only the fast model is built here.
const std::vector<Signal>& signals() {
  static const std::vector<Signal> none;
  return none;
}

std::unique_ptr<KungChip> make_audited_chip() { throw std::logic_error("no audit here"); }

std::unique_ptr<KungChip> make_checked_chip() { throw std::logic_error("no promises here"); }

std::unique_ptr<KungChip> make_traced_chip(const std::string&, const WaveWindow&, bool, bool) {
  throw std::logic_error("no waves here");
}

std::unique_ptr<KungChip> make_watched_chip(Watcher&, bool) {
  throw std::logic_error("no triggers here");
}

}  // namespace trammel::kung

int main(int argc, char** argv) {
  const std::atomic<bool> stop{false};
  trammel::testbench::RunArguments arguments;
  arguments.scenario = "circle";
  arguments.report = false;
  arguments.out = argc > 1 ? argv[1] : "";
  for (int i = 2; i < argc; ++i) arguments.assignments.emplace_back(argv[i]);
  return trammel::testbench::run(arguments, trammel::kung::simulate, stop);
}
