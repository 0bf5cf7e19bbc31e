// SPDX-License-Identifier: Apache-2.0
#include "models/exact/chips/kung_xy.hpp"

#include <algorithm>

namespace trammel::exact {

namespace map = kung_xy_regs;

namespace {

constexpr Clk kOverSeen = KungCurrent::kTaken + 1;  // edges after the tick

}  // namespace

void KungXy::pins(std::uint64_t lines) {
  for (int k = 0; k < 2; ++k) {
    Axis& axis = axes_[static_cast<std::size_t>(k)];
    const bool a = level(lines, xy::encoder_a(k)), b = level(lines, xy::encoder_b(k)),
               z = level(lines, xy::encoder_z(k));
    if (a == axis.pins.a && b == axis.pins.b && z == axis.pins.z) continue;
    axis.pins.a = a;
    axis.pins.b = b;
    axis.pins.z = z;
    axis.qep_next = now_;
  }
  if (level(lines, xy::kTripPin) == trip_pin_) return;
  trip_pin_ = !trip_pin_;
  slow_ = std::min(slow_, now_);
}

// The address is taken at edge now(), the register is read or written one edge later, and the
// response is taken two edges later.
void KungXy::request(const BusOp& op) {
  op_ = op;
  op_.address &= 0x3FCu;
  bus_acts_ = now_ + 1;
  slow_ = std::min(slow_, bus_acts_);
}

KungXy::Stop KungXy::run(Clk end, const Converters& converters) {
  while (now_ < end) {
    const Axis& x = axes_[0];
    const Axis& y = axes_[1];
    const Clk n = std::min({slow_, x.gates.next(), x.qep_next, y.gates.next(), y.qep_next});
    if (n >= end) {
      now_ = end;
      break;
    }
    now_ = n + 1;
    ++events_;
    const unsigned events = n == slow_ ? full(n, converters) : quick(n);
    if (events == 0) continue;
    if (words_ <= n) advance(n);
    return {n, events};
  }
  if (words_ < now_) advance(now_ - 1);
  return {now_ - 1, 0};
}

// An edge at which only gates and encoders have something to do.
unsigned KungXy::quick(Clk n) {
  const bool trip = supervisor_.out().trip;
  unsigned events = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    if (axis.gates.next() == n) {
      const unsigned before = axis.gates.gates();
      axis.gates.step(n, {axis.regs.enable, trip, axis.regs.dead_time}, false);
      if (axis.gates.gates() != before) events |= kGates;
    }
    if (axis.qep_next == n) {
      step_qep(k, n);
      if (axis.qep.out().error || (stroke(axis) && !trip)) slow_ = n + 1;
    }
  }
  return events;
}

// Any edge. A word is read, as it was before the edge, ahead of the code that changes it.
unsigned KungXy::full(Clk n, const Converters& converters) {
  advance(n - 1);
  const bool tick_cur = n == tick_;
  const bool tick_pos = tick_cur && ticks_left_ == 0;
  const bool trip = supervisor_.out().trip;
  const std::uint64_t gates_before = gates();
  Write write;
  if (n == bus_acts_) {
    bus_acts_ = kNever;
    write = {op_.write, op_.address, op_.data, op_.bits};
    if (!op_.write) answer_ = read(n - 1, op_.address);
    if (!(write.all_of(map::kX + map::kTabData) || write.all_of(map::kY + map::kTabData) ||
          asks_precision(n))) {
      bus_ends_ = n + 1;
    }
  }
  unsigned events = tick_pos ? kTick : 0u;
  if (n == bus_ends_) {
    bus_ends_ = kNever;
    read_data_ = answer_;
    events |= kBusDone;
  }

  for (Axis& axis : axes_) {
    axis.gates.step(n, {axis.regs.enable, trip, axis.regs.dead_time}, true);
    if (!tick_cur) continue;
    const CurrentLoop::Out& cmp = axis.current.out();
    axis.gates.load(n, {cmp.cmp_a, cmp.cmp_b, cmp.cmp_c}, carrier());
  }
  if (gates() != gates_before) events |= kGates;

  if (trip && !trip_before_) irq_fault_.set(n);
  trip_before_ = trip;
  supervisor_.step(supervision(write));
  const auto limit = static_cast<std::uint16_t>(registers_.word(map::kWatchdog));
  watchdog_.step({tick_pos, commit_, enabled(), limit});

  const std::array<std::int32_t, 2> chosen{i_q_ref(axes_[0]), i_q_ref(axes_[1])};
  unsigned done = step_positions(n, tick_pos);
  const bool precise = step_precision(n, tick_cur, tick_pos);
  if (tick_cur) tick(n, tick_pos, chosen, converters);
  for (std::size_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    const bool preset = write.all_of(kBases[k] + map::kPosPreset, 0xFFFFFF) && !locked_;
    const std::int32_t value = signed_word(write.data, 24);
    if (tick_pos || commit_ || preset) {
      axis.command.clock(
          {tick_pos, commit_, axis.regs.interpolate, preset, axis.regs.pos_cmd, value});
      axis.position_in.r = axis.command.r();
    }
    if (axis.qep.out().error) axis.qep_error.set(n);
    axis.pins.preset = preset;
    axis.pins.preset_value = value;
    if (preset || axis.qep_next == n) step_qep(k, n);
    axis.pins.preset = false;
    axis.reset_table = false;
    if (write.all_of(kBases[k] + map::kTabData)) {
      axis.tab_pending = true;
      axis.tab_data = signed_word(write.data, 24);
    }
  }
  commit_ = false;
  if (write.valid) apply(n, write);
  for (std::size_t k = 0; k < 2; ++k) {
    if (axes_[k].regs.precision) done = (done & ~(1u << k)) | (precise ? 1u << k : 0u);
  }
  done_ |= done;
  if (done_ == 3) {
    done_ = 0;
    events |= kSample;
  }
  for (Axis& axis : axes_) {
    const bool level = clear_level(axis);
    if (level != axis.current.cleared()) axis.current.clear(n + 1, level);
  }

  const std::uint32_t enables = registers_.word(map::kIrqEn);
  const bool irq = (irq_tick_.value() && (enables & map::kIrqEnTick) != 0) ||
                   (irq_fault_.value() && (enables & map::kIrqEnFault) != 0);
  if (irq && !irq_) events |= kIrq;
  irq_ = irq;
  schedule(n, write.valid);
  return events;
}

// Words of the controllers as they are after edge n.
void KungXy::advance(Clk n) {
  for (Axis& axis : axes_) {
    axis.position.advance(n, axis.position_in, axis.saturated);
    axis.current.advance(n, axis.regs.current, axis.limited);
  }
  schedule_words();
}

void KungXy::schedule_words() {
  words_ = kNever;
  for (const Axis& axis : axes_) {
    words_ = std::min({words_, axis.current.due(), axis.position.next_word()});
  }
}

Supervisor::In KungXy::supervision(const Write& write) const {
  const auto limit = static_cast<std::int32_t>(registers_.word(map::kCurrentLimit));
  Supervisor::In in;
  in.tick_count = tick_count_;
  in.clear = write.all_of(map::kFaultClear) && write.data == map::kKeyFaultClear;
  in.trip_pin = trip_pin_;
  in.watchdog = watchdog_.bite();
  for (std::size_t k = 0; k < 2; ++k) {
    in.enabled[k] = axes_[k].regs.enable;
    in.over_current[k] = axes_[k].current.over(limit);
    in.encoder[k] = axes_[k].qep_error.value();
    in.stroke[k] = stroke(axes_[k]);
  }
  return in;
}

// The tick of the carrier; position: it is a position tick too.
void KungXy::tick(Clk n, bool position, const std::array<std::int32_t, 2>& i_q_ref_now,
                  const Converters& converters) {
  const auto limit = static_cast<std::int32_t>(registers_.word(map::kCurrentLimit));
  over_due_ = kNever;
  for (std::size_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    const std::int32_t count = axis.qep.out().count;
    axis.current.tick(n, carrier(), count, i_q_ref_now[k], converters.hold(static_cast<int>(k), n),
                      axis.regs.current);
    if (axis.current.will_be_over(limit, axis.regs.current)) over_due_ = n + kOverSeen;
    if (position) axis.position_in.x_p = count;
  }
  last_tick_ = n;
  tick_ += pwm_period(carrier());
  if (!position) {
    --ticks_left_;
    return;
  }
  const std::uint32_t rate =
      (registers_.word(map::kRates) & map::kRatesPositionMask) >> map::kRatesPositionShift;
  ticks_left_ = ticks_of_position(carrier(), rate) - 1;
  ++tick_count_;
  if (irq_left_ != 0) {
    --irq_left_;
    return;
  }
  irq_tick_.set(n);
  const std::uint32_t period = registers_.word(map::kIrqPeriod);
  irq_left_ = period == 0 ? 0 : period - 1;
}

// The axes whose words are complete now.
unsigned KungXy::step_positions(Clk n, bool position_tick) {
  unsigned all_done = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    const bool starts = position_tick && !axis.regs.precision;
    if (starts && axis.position.overruns()) axis.overrun.set(n);
    const bool table = axis.tab_pending && !axis.position.busy();
    const bool done = axis.position.step(
        n, axis.position_in, {starts, axis.reset_table, table, axis.tab_data},
        axis.saturated);
    if (table) {
      axis.tab_pending = false;
      bus_ends_ = n + 1;
    }
    if (done) all_done |= 1u << k;
    axis.current.advance(n, axis.regs.current, axis.limited);
  }
  return all_done;
}

// True when i_q* of a position tick are there now.
bool KungXy::step_precision(Clk n, bool tick, bool position_tick) {
  KungPrecision::In in;
  in.tick = tick;
  in.position = position_tick;
  in.commit = commit_;
  for (std::size_t k = 0; k < 2; ++k) {
    const Axis& axis = axes_[k];
    in.axis[k] = {axis.regs.precision, axis.position_in.reset_model, axis.regs.qep_filter,
                  axis.qep.out().count};
  }
  const KungPrecision::Out out = precision_.clock(n, in);
  for (std::size_t k = 0; k < 2; ++k) {
    Axis& axis = axes_[k];
    if (!axis.regs.precision) continue;
    const Precision::Out& law = precision_.out(static_cast<int>(k));
    if (out.overrun) axis.overrun.set(n);
    if (out.underrun) axis.underrun.set(n);
    if (out.flags && law.saturated) axis.saturated.set(n);
    if (out.flags && law.clipped) axis.clipped.set(n);
  }
  if (out.access) {
    const KungPrecision::Request& request = precision_.request();
    if (!request.write) answer_ = precision_.answer();
    bus_ends_ = n + 2;
    if (request.counts) count_up(kBases[static_cast<std::size_t>(request.axis)] + map::kPrecAddr);
  }
  return out.done;
}

void KungXy::step_qep(std::size_t k, Clk n) {
  Axis& axis = axes_[k];
  const std::int32_t before = axis.qep.out().count;
  const Clk skipped = n - 1 - axis.qep_at;
  if (skipped > 0) axis.qep.advance(static_cast<Gap>(skipped));
  axis.pins.clear_error = axis.qep.out().error;
  const Qep::Out& out = axis.qep.step(axis.pins);
  axis.qep_at = n;
  if (axis.regs.precision && out.count != before && !axis.pins.preset) {
    precision_.moved(static_cast<int>(k), n - last_tick_, out.dir);
  }
  Qep::In held = axis.pins;
  held.preset = false;
  held.clear_error = out.error;
  const Gap gap = axis.qep.next(held);
  axis.qep_next = gap == kGapMax ? kNever : n + 1 + gap;
}

void KungXy::schedule(Clk n, bool again) {
  if (over_due_ <= n) over_due_ = kNever;
  // A write may have changed the limit for currents still in conversion.
  if (again && n < last_tick_ + kOverSeen) over_due_ = last_tick_ + kOverSeen;
  again = again || trip_before_ != supervisor_.out().trip ||
          !supervisor_.quiescent(supervision({}));
  slow_ = std::min({tick_, bus_acts_, bus_ends_, over_due_, precision_.due()});
  for (const Axis& axis : axes_) {
    again = again || axis.tab_pending || axis.qep.out().error;
    slow_ = std::min(slow_, axis.position.due());
  }
  if (again) slow_ = n + 1;
  schedule_words();
}

bool KungXy::stroke(const Axis& axis) const {
  const std::int32_t count = axis.qep.out().count;
  return axis.regs.stroke_enable &&
         (count < axis.regs.stroke_min || count > axis.regs.stroke_max);
}

bool KungXy::clear_level(const Axis& axis) const {
  return supervisor_.out().trip || !axis.regs.enable || !axis.regs.current_loop;
}

std::int32_t KungXy::i_q_ref(const Axis& axis) const {
  if (!axis.regs.position_loop) return axis.regs.iq_manual;
  return axis.regs.precision ? precision_.out(&axis == &axes_[0] ? 0 : 1).i_q_ref
                             : axis.position.afc().out().i_q_ref;
}

}  // namespace trammel::exact
