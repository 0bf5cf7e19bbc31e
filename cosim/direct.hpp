// SPDX-License-Identifier: Apache-2.0
//
// The wiring without SystemC: firmware, bus and loop in one thread. The processor's time is the
// edge it has reached; the soft processor of SystemC counts the same way, so that both give
// equal events.
#pragma once

#include <functional>

#include "cosim/cosim.hpp"
#include "sw_nios/hal/bus.hpp"

namespace trammel::cosim {

// What the work of the processor costs.
struct ProcessorTiming {
  Clk access = 8;     // clocks a bus access takes besides its handshake
  Clk latency = 100;  // clocks from the interrupt line to the first instruction of its routine
};

class DirectBus final : public sw::Bus {
 public:
  DirectBus(Loop& loop, const ProcessorTiming& timing) : loop_(loop), timing_(timing) {}

  std::uint32_t read(std::uint32_t addr) override { return transfer({addr, 0, false}); }
  void write(std::uint32_t addr, std::uint32_t data) override { transfer({addr, data, true}); }

  void wait(Clk clocks) { wait_until(time_ + clocks); }
  void wait_until(Clk edge) {
    time_ = edge;
    loop_.advance(time_, 0);
  }

 private:
  std::uint32_t transfer(const BusOp& op) {
    wait(timing_.access);
    loop_.chip().request(op);
    time_ = loop_.advance(kNever, kBusDone).edge;
    return loop_.chip().rdata();
  }

  Loop& loop_;
  ProcessorTiming timing_;
  Clk time_ = 0;
};

// Runs until `finished()` holds after an interrupt or a sample, or until edge `end`.
inline void run_direct(Loop& loop, sw::Firmware& firmware, const ProcessorTiming& timing, Clk end,
                       const std::function<bool()>& finished) {
  DirectBus bus(loop, timing);
  firmware.start(bus);
  while (!finished() && loop.chip().now() < end) {
    if (!loop.chip().irq()) {
      const Stop stop = loop.advance(end, kIrq | kSample);
      if ((stop.why & kIrq) == 0) continue;
      bus.wait_until(stop.edge);
    }
    bus.wait(timing.latency);
    firmware.isr(bus);
  }
}

}  // namespace trammel::cosim
