// SPDX-License-Identifier: Apache-2.0
//
// The table's program on the core of rtl/chips/kung_soc.sv. It uses no control register of the
// core, so any rv32im core runs it: the core waits by reading WAIT into a variable, whose answer is
// held until the IC interrupts or the serial port has something to do. The service routine runs to
// completion, and the console prints nothing in it.
#include "sw_nios/apps/kung/console.hpp"
#include "sw_nios/apps/kung/setup_words.hpp"
#include "sw_nios/hal/soc_map.hpp"

namespace trammel::sw {
namespace {

namespace map = soc_map;

volatile std::uint32_t& at(std::uint32_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

class MappedBus final : public Bus {
 public:
  std::uint32_t read(std::uint32_t addr) override { return at(map::kChip + addr); }
  void write(std::uint32_t addr, std::uint32_t data) override { at(map::kChip + addr) = data; }
};

KungSetup given(const SetupWords& words) {
  KungSetup setup;
  if ((words.flags & SetupWords::kUsed) != 0) unpack(words, setup);
  setup.points = reinterpret_cast<const Point*>(words.points);
  const auto* segments = reinterpret_cast<const FeedSegment*>(words.points);
  setup.feed.segments = segments;
  setup.feed.phases = reinterpret_cast<const FeedPhase*>(segments + setup.feed.n_segments);
  setup.precision.corrections = reinterpret_cast<Corrections*>(words.corrections);
  return setup;
}

}  // namespace
}  // namespace trammel::sw

// What the header of the image shows. Not zeroed at the start: a loader fills in the set-up.
extern "C" {
__attribute__((section(".data"))) trammel::sw::SetupWords core_setup;
const trammel::sw::Mailbox* core_report;

// A call of a pure virtual function, which nothing here can make.
void __cxa_pure_virtual() {
  for (;;) {
  }
}
}

// Apart from main, on whose stack the set-up would stay.
[[gnu::noinline]] static trammel::sw::KungProgram& made_program() {
  static trammel::sw::KungProgram program{trammel::sw::given(core_setup)};
  return program;
}

int main() {
  using namespace trammel::sw;
  namespace map = soc_map;
  static MappedBus bus;
  KungProgram& program = made_program();
  static Console console{program, bus};
  core_report = &program.app().mailbox();
  if ((core_setup.flags & SetupWords::kStart) != 0) program.start(bus);
  for (;;) {
    console.pump();
    const std::uint32_t wait = console.ring().empty() ? map::kWait : map::kWaitSend;
    const std::uint32_t why = at(wait);  // a cast to void would not read
    if ((why & map::kWaitIrq) != 0) {
      program.app().isr(bus);
      continue;
    }
    if ((why & map::kWaitReceived) != 0) {
      const std::uint32_t byte = at(map::kUart);
      console.lost(byte >> map::kUartLostShift & 0xFFu);
      console.take(static_cast<char>(byte & 0xFFu));
    }
    if ((why & map::kWaitCanSend) != 0 && !console.ring().empty()) {
      at(map::kUart) = static_cast<unsigned char>(console.ring().take());
    }
  }
}
