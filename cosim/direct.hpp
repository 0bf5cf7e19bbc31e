// SPDX-License-Identifier: Apache-2.0
//
// The wiring without SystemC: firmware, bus and loop in one thread. The processor's time is the
// edge it has reached; the soft processor of SystemC counts the same way, so that both give
// equal events.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

#include "cosim/cosim.hpp"
#include "cosim/fault.hpp"
#include "sw_nios/hal/bus.hpp"

namespace trammel::cosim {

// What the work of the processor costs.
struct ProcessorTiming {
  Clk access = 8;     // clocks a bus access takes besides its handshake
  Clk latency = 100;  // clocks from the interrupt line to the first instruction of its routine
  ProcessorFault fault = {};
  // The firmware computes for so many clocks before it writes the register at this address.
  Clk compute = 0;
  std::uint32_t computed = 0;

  // Clocks of work before a transfer, from edge `now` on.
  Clk before(Clk now, const BusOp& op) const {
    const bool computes = op.write && compute > 0 && op.addr == computed;
    const Clk computing = computes ? fault.work(now, compute) : 0;
    return computing + fault.access(now + computing, access);
  }
};

class DirectBus final : public sw::Bus {
 public:
  // Thrown through the firmware when the run ends inside its routine.
  struct RunOver {};

  // The run ends at edge `end`, or as soon as `finished()` holds after a sample: as in SystemC
  // whatever the processor is at then.
  DirectBus(Loop& loop, const ProcessorTiming& timing, Clk end = kNever,
            std::function<bool()> finished = {})
      : loop_(loop), timing_(timing), end_(end), finished_(std::move(finished)) {}

  std::uint32_t read(std::uint32_t addr) override { return transfer({addr, 0, false}); }
  void write(std::uint32_t addr, std::uint32_t data) override { transfer({addr, data, true}); }

  void wait(Clk clocks) { wait_until(time_ + clocks); }
  void wait_latency() { wait(timing_.fault.work(time_, timing_.latency)); }
  void wait_until(Clk edge) {
    time_ = edge;
    while (loop_.chip().now() < std::min(edge, end_)) advance(std::min(edge, end_), 0);
    if (edge > end_) throw RunOver();
  }

 private:
  std::uint32_t transfer(const BusOp& op) {
    wait(timing_.before(time_, op));
    loop_.chip().request({op.addr, timing_.fault.written(time_, op.data), op.write});
    Stop stop;
    do {
      if (loop_.chip().now() >= end_) throw RunOver();
      stop = advance(end_, kBusDone);
    } while ((stop.why & kBusDone) == 0);
    time_ = stop.edge;
    return loop_.chip().rdata();
  }

  Stop advance(Clk end, unsigned until) {
    const Stop stop = loop_.advance(end, finished_ ? until | kSample : until);
    if ((stop.why & kSample) != 0 && finished_ && finished_()) throw RunOver();
    return stop;
  }

  Loop& loop_;
  ProcessorTiming timing_;
  Clk end_;
  std::function<bool()> finished_;
  Clk time_ = 0;
};

// What is done while the firmware waits for its interrupt: returns the edge, later than the next
// one, before which it wants to be asked again. It may use the bus.
using Idle = std::function<Clk(DirectBus& bus)>;

// Runs until `finished()` holds after a sample, or until edge `end`.
inline void run_direct(Loop& loop, sw::Firmware& firmware, const ProcessorTiming& timing, Clk end,
                       const std::function<bool()>& finished, const Idle& idle = {}) {
  DirectBus bus(loop, timing, end, finished);
  try {
    firmware.start(bus);
    while (!finished() && loop.chip().now() < end) {
      Clk until = end;
      if (idle && !loop.chip().irq()) until = std::min(end, idle(bus));
      if (!loop.chip().irq()) {
        const Stop stop = loop.advance(until, kIrq | kSample);
        if ((stop.why & kIrq) == 0 || finished()) continue;
        bus.wait_until(stop.edge);
      }
      bus.wait_latency();
      firmware.isr(bus);
    }
  } catch (const DirectBus::RunOver&) {
  }
}

}  // namespace trammel::cosim
