// SPDX-License-Identifier: Apache-2.0
//
// The table's program on a small RISC-V core: registers of the chip in its address space, its
// interrupt line as the core's external interrupt. Interrupts are never taken: a routine runs to
// completion, then the core waits for the next one.
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::sw {
namespace {

constexpr std::uint32_t kChip = 0x8000'0000;
constexpr std::uint32_t kExternal = 1u << 11;  // of mie and mip

class MappedBus final : public Bus {
 public:
  std::uint32_t read(std::uint32_t addr) override { return *at(addr); }
  void write(std::uint32_t addr, std::uint32_t data) override { *at(addr) = data; }

 private:
  static volatile std::uint32_t* at(std::uint32_t addr) {
    return reinterpret_cast<volatile std::uint32_t*>(kChip + addr);
  }
};

// The assembler counts control and status registers as an extension; every core has them.
#define TRAMMEL_CSR(text) ".option push\n.option arch, +zicsr\n" text "\n.option pop"

void allow_external() { asm volatile(TRAMMEL_CSR("csrs mie, %0") : : "r"(kExternal)); }

// A core whose `wfi` does nothing polls here.
void wait_for_interrupt() {
  std::uint32_t pending = 0;
  do {
    asm volatile(TRAMMEL_CSR("wfi\ncsrr %0, mip") : "=r"(pending) : : "memory");
  } while ((pending & kExternal) == 0);
}

#undef TRAMMEL_CSR

}  // namespace
}  // namespace trammel::sw

// A call of a pure virtual function, which nothing here can make.
extern "C" void __cxa_pure_virtual() {
  for (;;) {
  }
}

int main() {
  using namespace trammel::sw;
  static KungApp app{KungSetup{}};
  MappedBus bus;
  allow_external();
  app.start(bus);
  for (;;) {
    wait_for_interrupt();
    app.isr(bus);
  }
}
