// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/chip/soc.hpp"

#ifdef TRAMMEL_CORE
#include <Vsoc_host_fast.h>
#include <Vsoc_host_fast___024root.h>

#include <soc_host_state.hpp>

#include "machines/kung/chip/verilated/soc_core.hpp"

namespace trammel::kung {
namespace {

struct PicoRegisters {
  using Root = Vsoc_host_fast___024root;
  static constexpr int kSettles = 2;
  static std::uint32_t pc(const Root& root) {
    return root.soc_host__DOT__u_cpu__DOT__u_core__DOT__reg_pc;
  }
  static std::uint32_t next_pc(const Root& root) {
    return root.soc_host__DOT__u_cpu__DOT__u_core__DOT__reg_next_pc;
  }
};

}  // namespace

std::unique_ptr<SocCore> make_core(const CoreMemory& memory, bool audit) {
  return std::make_unique<VerilatedCore<Vsoc_host_fast, PicoRegisters>>(memory, audit);
}

}  // namespace trammel::kung

#else

namespace trammel::kung {

std::unique_ptr<SocCore> make_core(const CoreMemory&, bool) { return nullptr; }

}  // namespace trammel::kung
#endif
