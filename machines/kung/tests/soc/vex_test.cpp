// SPDX-License-Identifier: Apache-2.0
//
// The same binary on another core: VexRiscv.
#include <Vsoc_host_vex.h>
#include <Vsoc_host_vex___024root.h>

#include <catch2/catch.hpp>

#include "machines/kung/chip/verilated/soc_core.hpp"
#include "machines/kung/tests/soc/runs.hpp"

using namespace trammel;
using namespace trammel::test;

namespace {

struct VexRegisters {
  using Root = Vsoc_host_vex___024root;
  static constexpr int kSettles = 64;  // a line of its cache may be on the way
  static std::uint32_t pc(const Root&) { return 0; }
  static std::uint32_t next_pc(const Root&) { return 0; }
};

}  // namespace

TEST_CASE("VexRiscv writes what native firmware writes, with the binary of PicoRV32") {
  const Options options = line();
  const CoreMemory memory = core_memory(make_plan(options)->setup, true);
  VerilatedCore<Vsoc_host_vex, VexRegisters> core(memory, true);
  const Ran ran = run(options, static_cast<cosim::Clk>(0.1 * kClockHz), nullptr, &core);
  const std::size_t writes = writes_of(ran.transfers).size();
  CHECK(writes > 200);
  CHECK(native_writes(options, ran.transfers) == writes);
  CHECK(ran.times.routine.count > 30);
  CHECK(core.moved().empty());
  WARN("VexRiscv: routines worst " << ran.times.routine.worst << ", mean "
                                   << ran.times.routine.mean());
}
