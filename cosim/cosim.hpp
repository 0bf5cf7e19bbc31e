// SPDX-License-Identifier: Apache-2.0
//
// How chip, plant and processor meet in time. Plain C++17: no SystemC, no verilated header, no
// thread.
// All times are integer indices of fabric clock edges; time [ps] = index * period_ps.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

namespace trammel::cosim {

using Clk = std::int64_t;     // index of a fabric clock edge
using Lines = std::uint64_t;  // packed pins; each machine names the bits in one header

inline constexpr Clk kNever = std::numeric_limits<Clk>::max();

// Why run() stopped.
enum Why : unsigned {
  kLimit = 1,    // the end it was given
  kDrive = 2,    // gates or other outputs toward the plant changed
  kIrq = 4,      // the interrupt line rose
  kBusDone = 8,  // the bus transfer ended
  kTick = 16,    // sample tick: inputs of the position loop were latched at this edge
  kSample = 32   // the position loop of that sample is done, its words can be read
};

struct Stop {
  Clk edge = -1;     // last edge executed
  unsigned why = 0;  // what it changed
};

struct BusOp {
  std::uint32_t addr = 0;  // byte address
  std::uint32_t data = 0;
  bool write = false;
};

// Physics. State advances only in commit(): at a drive change or at the plant's own sensor edge.
struct Plant {
  virtual ~Plant() = default;
  virtual Lines sense() const = 0;                   // lines at the last commit
  virtual Clk next() const = 0;                      // first n > last commit where sense() changes
  virtual void commit(Clk n, Lines drive) = 0;       // integrate to n <= next(); drive holds from n
  virtual int sample(int channel, Clk n) const = 0;  // converter code at n; pure
  // [J] from the supply until n, from the last commit on; none: its model has no currents.
  virtual std::optional<double> supplied(Clk) const { return {}; }
};

// A clocked IC: verilated, twin, or an audit pair in step.
struct Chip {
  virtual ~Chip() = default;
  virtual Clk now() const = 0;               // next edge to execute
  virtual void sense(Lines) = 0;             // pins seen from edge now() on
  virtual void request(const BusOp&) = 0;    // bus valid from edge now(); run() ends it
  // Edges [now, end): stops after the first that changes drive or irq, ticks, or ends a transfer.
  virtual Stop run(Clk end, const Plant&) = 0;
  virtual Lines drive() const = 0;
  virtual bool irq() const = 0;
  virtual std::uint32_t rdata() const = 0;
};

struct Observer {
  virtual ~Observer() = default;
  virtual void on(const Stop&, const Chip&, const Plant&) = 0;
};

// The only scheduler; every wiring calls it. A window of 1 is lock step; kNever is full look-ahead.
class Loop {
 public:
  Loop(Chip& chip, Plant& plant, Observer& observer, Clk window = kNever)
      : chip_(chip), plant_(plant), observer_(observer), window_(window) {
    chip_.sense(plant_.sense());
  }

  // Executes edges up to `end` (exclusive), or through the first edge with an `until` reason.
  Stop advance(Clk end, unsigned until = kIrq | kBusDone) {
    Stop stop{chip_.now() - 1, kLimit};
    while (chip_.now() < end) {
      const Clk now = chip_.now();
      if (plant_.next() == now) {
        plant_.commit(now, chip_.drive());
        chip_.sense(plant_.sense());
      }
      const Clk cap = window_ == kNever ? kNever : now + window_;
      stop = chip_.run(std::min({end, plant_.next(), cap}), plant_);
      if (stop.why & kDrive) plant_.commit(stop.edge, chip_.drive());
      observer_.on(stop, chip_, plant_);
      if (guest_ != nullptr) guest_->on(stop, chip_, plant_);
      if (stop.why & until) break;
    }
    return stop;
  }

  Chip& chip() { return chip_; }

  // One more observer of every stop, after the first.
  void watch(Observer& guest) { guest_ = &guest; }

 private:
  Chip& chip_;
  Plant& plant_;
  Observer& observer_;
  Observer* guest_ = nullptr;
  Clk window_;
};

}  // namespace trammel::cosim
