// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact, edge-exact twin of the chip rtl/chips/kung_xy.sv at its pins, without a clock: it
// knows the next edge at which anything can change and goes there. What a bus transfer reads, when
// a write acts, gates, interrupt, faults and every word of the controllers are those of the RTL at
// every edge. Words of the controllers are computed when they are read or used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/chips/kung_current.hpp"
#include "models/exact/chips/kung_gates.hpp"
#include "models/exact/chips/kung_position.hpp"
#include "models/exact/chips/kung_precision.hpp"
#include "models/exact/chips/kung_registers.hpp"
#include "models/exact/chips/kung_time.hpp"
#include "models/exact/control/command.hpp"
#include "models/exact/drive/supervisor.hpp"
#include "models/exact/motion/watchdog.hpp"
#include "models/exact/sense/qep.hpp"
#include "models/pins/xy_pins.hpp"

namespace trammel::exact {

class KungXy {
 public:
  KungXy();

  // What an edge changed, as a set of bits.
  enum Event : unsigned {
    kGates = 1,
    kIrq = 2,      // the line rose
    kBusDone = 4,  // the transfer ended
    kTick = 8,     // 2 kHz
    kSample = 16   // the words of both position controllers, or the precision controller, are there
  };
  struct Stop {
    Clk edge = -1;
    unsigned events = 0;  // none: the limit was reached
  };
  struct BusOp {
    std::uint32_t address = 0, data = 0;  // byte address
    bool write = false;
    std::uint32_t bits = ~0u;  // of the bytes written
  };
  // Converters of phases a and b of an axis, held at an edge; offset binary, 2048 = 0 A.
  struct Converters {
    virtual ~Converters() = default;
    virtual std::array<std::int32_t, 2> hold(int axis, Clk edge) const = 0;
  };

  void reset();                     // edge 0 is the next
  Clk now() const { return now_; }  // next edge to execute
  void pins(std::uint64_t lines);   // of xy_pins.hpp, seen from edge now() on
  void request(const BusOp& op);    // valid from edge now() on; one at a time
  Stop run(Clk end, const Converters& converters);  // through the first event, or up to `end`

  std::uint64_t gates() const { return axes_[0].gates.gates() | axes_[1].gates.gates() << 6; }
  bool irq() const { return irq_; }
  std::uint32_t read_data() const { return read_data_; }  // of the last read
  std::int64_t events() const { return events_; }         // edges at which anything was done

  const Afc& afc(int axis) const { return at(axis).position.afc(); }
  // Of an axis whose i_q* is the precision controller's.
  bool is_precise(int axis) const { return at(axis).regs.precision; }
  const KungPrecision& precision() const { return precision_; }
  std::int32_t position(int axis) const { return at(axis).position_in.x_p; }  // of the last tick
  const KungCurrent& current(int axis) const { return at(axis).current; }
  const Supervisor::Out& fault() const { return supervisor_.out(); }

 private:
  static constexpr std::array<std::uint32_t, 2> kBases{kung_xy_regs::kX, kung_xy_regs::kY};

  struct Axis {
    Qep qep;
    Qep::In pins;
    Clk qep_at = -1;    // last edge it executed
    Clk qep_next = 0;
    Command command;
    KungPosition position;
    KungPosition::In position_in;
    KungCurrent current;
    KungGates gates;
    KungAxisRegisters regs;
    Sticky overrun, qep_error, saturated, limited, underrun, clipped;
    bool reset_table = false;  // pulses after a write
    bool tab_pending = false;
    std::int32_t tab_data = 0;
  };
  struct Write {  // takes effect at this edge
    bool valid = false;
    std::uint32_t address = 0, data = 0, bits = ~0u;
    bool is(std::uint32_t reg) const { return valid && address == reg; }
    // Keys, rules and presets take effect only with all their bytes.
    bool all_of(std::uint32_t reg, std::uint32_t mask = ~0u) const {
      return is(reg) && (bits & mask) == mask;
    }
  };

  const Axis& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }

  unsigned quick(Clk n);
  unsigned full(Clk n, const Converters& converters);
  void advance(Clk n);
  void schedule_words();

  Supervisor::In supervision(const Write& write) const;
  void tick(Clk n, bool position, const std::array<std::int32_t, 2>& i_q_ref,
            const Converters& converters);
  unsigned step_positions(Clk n, bool position_tick);
  bool asks_precision(Clk n);
  void count_up(std::uint32_t address);
  bool step_precision(Clk n, bool tick, bool position_tick);
  void step_qep(std::size_t k, Clk n);
  void lock(std::uint32_t key);
  void apply(Clk n, const Write& write);
  void decode(Axis& axis, std::uint32_t base, Clk n);
  void schedule(Clk n, bool again);

  std::uint32_t carrier() const {
    return registers_.word(kung_xy_regs::kRates) & kung_xy_regs::kRatesCarrierMask;
  }
  bool enabled() const { return axes_[0].regs.enable || axes_[1].regs.enable; }
  bool stroke(const Axis& axis) const;
  bool clear_level(const Axis& axis) const;
  std::int32_t i_q_ref(const Axis& axis) const;
  std::uint32_t read(Clk n, std::uint32_t address);
  std::uint32_t read_axis(Clk n, Axis& axis, std::uint32_t offset, std::uint32_t stored);

  Clk now_ = 0;
  Clk slow_ = 0;         // next edge of full()
  Clk words_ = kNever;   // next edge at which a word of a controller changes
  Clk tick_ = 0;         // next tick of the carrier
  Clk last_tick_ = -kLongAgo;
  std::int64_t events_ = 0;

  KungRegisters registers_;
  std::array<Axis, 2> axes_;
  KungPrecision precision_;
  Supervisor supervisor_;
  Watchdog watchdog_;
  bool trip_pin_ = false;
  bool trip_before_ = false;  // one edge late
  bool locked_ = false;
  bool commit_ = false;       // pulses after a write
  Sticky irq_tick_, irq_fault_;
  bool irq_ = false;
  std::uint32_t ticks_left_ = 0;  // of the carrier, until the position tick
  std::uint32_t irq_left_ = 0;    // position ticks
  std::uint32_t tick_count_ = 0;
  unsigned done_ = 0;            // position controllers of this sample
  Clk over_due_ = kNever;        // edge at which an over-current is seen

  BusOp op_;
  Clk bus_acts_ = kNever, bus_ends_ = kNever;
  std::uint32_t answer_ = 0, read_data_ = 0;
};

}  // namespace trammel::exact
