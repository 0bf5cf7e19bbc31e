// SPDX-License-Identifier: Apache-2.0
//
// Registers of the twin of kung_xy: what a write does and what a read shows.
#include <algorithm>

#include "models/exact/chips/kung_xy.hpp"

namespace trammel::exact {

namespace map = kung_xy_regs;

namespace {

std::uint32_t word(std::int32_t value) { return static_cast<std::uint32_t>(value); }
std::uint32_t halves(std::int32_t low, std::int32_t high) {
  return (word(low) & 0xFFFFu) | (word(high) << 16);
}

}  // namespace

KungXy::KungXy() {
  for (std::size_t k = 0; k < 2; ++k) decode(axes_[k], kBases[k], -1);
}

void KungXy::reset() {
  KungXy fresh;
  fresh.precision_ = precision_;
  fresh.precision_.reset();
  *this = fresh;
}

// Locking always works; unlocking requires both axes disabled.
void KungXy::lock(std::uint32_t key) {
  if (key == map::kKeyLock) locked_ = true;
  if (key == map::kKeyUnlock && !enabled()) locked_ = false;
}

void KungXy::apply(Clk n, const Write& write) {
  if (write.all_of(map::kLock)) lock(write.data);
  const std::uint32_t ones = write.data & write.bits;
  if (write.is(map::kIrqStat)) {
    if ((ones & map::kIrqStatTick) != 0) irq_tick_.clear(n);
    if ((ones & map::kIrqStatFault) != 0) irq_fault_.clear(n);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (!write.is(kBases[k] + map::kStatus)) continue;
    Axis& axis = axes_[k];
    if ((ones & map::kStatusOverrun) != 0) axis.overrun.clear(n);
    if ((ones & map::kStatusQepError) != 0) axis.qep_error.clear(n);
    if ((ones & map::kStatusSaturated) != 0) axis.saturated.clear(n);
    if ((ones & map::kStatusLimited) != 0) axis.limited.clear(n);
    if ((ones & map::kStatusUnderrun) != 0) axis.underrun.clear(n);
    if ((ones & map::kStatusClipped) != 0) axis.clipped.clear(n);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (!write.is(kBases[k] + map::kAngleStep)) continue;
    axes_[k].current.hold_angle(n, axes_[k].regs.current);
  }
  const bool held = locked_ || (write.is(map::kRates) && enabled());
  const std::uint32_t pulses = registers_.write(write.address, write.data, write.bits, held);
  if (write.is(map::kCommit)) commit_ = (pulses & map::kCommitTake) != 0;
  for (std::size_t k = 0; k < 2; ++k) {
    if (write.is(kBases[k] + map::kCtrl)) {
      axes_[k].reset_table = (pulses & map::kCtrlResetTable) != 0;
    }
    decode(axes_[k], kBases[k], n);
  }
}

// The registers of an axis as its blocks see them from edge n + 1 on.
void KungXy::decode(Axis& axis, std::uint32_t base, Clk n) {
  const auto reg = [this, base](std::uint32_t offset) { return registers_.word(base + offset); };
  const auto number = [&reg](std::uint32_t offset, int bits) {
    return signed_word(reg(offset), bits);
  };
  const std::uint32_t ctrl = reg(map::kCtrl);
  KungAxisRegisters& r = axis.regs;
  const bool enable = (ctrl & map::kCtrlEnable) != 0;
  if (enable && !r.enable) axis.gates.enable_rises(n);
  r.enable = enable;
  r.current_loop = (ctrl & map::kCtrlCurrentLoop) != 0;
  r.position_loop = (ctrl & map::kCtrlPositionLoop) != 0;
  r.interpolate = (ctrl & map::kCtrlInterpolate) != 0;
  r.precision = (ctrl & map::kCtrlPrecision) != 0;
  r.stroke_enable = (reg(map::kStrokeEn) & map::kStrokeEnEnable) != 0;
  r.stroke_min = number(map::kStrokeMin, 24);
  r.stroke_max = number(map::kStrokeMax, 24);
  r.pos_cmd = number(map::kPosCmd, 24);
  r.iq_manual = number(map::kIqManual, 12);
  const std::uint32_t dead_time = reg(map::kDeadtime) & map::kDeadtimeClkMask;
  r.dead_time = std::max(dead_time, registers_.word(map::kDeadtimeMin));
  const std::uint32_t offsets = reg(map::kCurrentOffset);
  r.current = {reg(map::kAngleStep), reg(map::kThetaOfs),
               gain_of(reg(map::kKpCur)), gain_of(reg(map::kKiCur)),
               signed_word(offsets >> map::kCurrentOffsetAShift, 12),
               signed_word(offsets >> map::kCurrentOffsetBShift, 12),
               static_cast<int>(reg(map::kAdcFrame))};

  KungPosition::In& p = axis.position_in;
  p.reset_model = (ctrl & map::kCtrlResetModel) != 0;
  p.config.adapt = (ctrl & map::kCtrlAdapt) != 0;
  p.config.feedforward = (ctrl & map::kCtrlFeedforward) != 0;
  p.config.kp = gain_of(reg(map::kKp));
  p.config.ki = gain_of(reg(map::kKi));
  p.config.kv = gain_of(reg(map::kKv));
  p.config.eta = gain_of(reg(map::kEta));
  p.config.shift_e = signed_word(reg(map::kShift) >> map::kShiftEShift, 5);
  p.config.shift_de = signed_word(reg(map::kShift) >> map::kShiftDeShift, 5);
  p.config.a0 = static_cast<std::int32_t>(reg(map::kA0) & map::kA0ValueMask);
  p.config.a0_scale =
      static_cast<int>((reg(map::kA0) & map::kA0ScaleMask) >> map::kA0ScaleShift);
  p.config.b2 = number(map::kB2, 24);
  const auto index = static_cast<int>(reg(map::kTabAddr));
  if (index != p.tab_addr) axis.position.address(n, p.tab_addr, index);
  p.tab_addr = index;

  const auto filter = static_cast<std::uint8_t>(
      (reg(map::kDeadtime) & map::kDeadtimeQepFilterMask) >> map::kDeadtimeQepFilterShift);
  r.qep_filter = filter;
  if (filter == axis.pins.filter) return;
  axis.pins.filter = filter;
  axis.qep_next = std::min(axis.qep_next, n + 1);
}

// A request of the bus that the precision controller answers.
bool KungXy::asks_precision(Clk n) {
  using Word = PrecisionStore::Word;
  KungPrecision::Request request;
  request.write = op_.write;
  request.data = static_cast<std::int32_t>(op_.data);
  const auto ask = [&](int axis, int of) {
    request.axis = axis;
    request.word = of;
    precision_.request(n, request);
    return true;
  };
  const auto asks = [&](int axis, Word of) {
    return !op_.write && ask(axis, static_cast<int>(of));
  };
  if (op_.address == map::kKnot) return asks(axes_[0].regs.precision ? 0 : 1, Word::kKnots);
  for (int axis = 0; axis < 2; ++axis) {
    const std::uint32_t base = kBases[static_cast<std::size_t>(axis)];
    if (op_.address < base || op_.address >= base + 0x100u) continue;
    switch (op_.address - base) {
      case map::kPrecData:
        if (op_.write && op_.bits != ~0u) return false;
        request.counts = true;
        return ask(axis, static_cast<int>(registers_.word(base + map::kPrecAddr)));
      case map::kPrecErr: return asks(axis, Word::kErr);
      case map::kErrSum: return asks(axis, Word::kErrSum);
      case map::kIqSum: return asks(axis, Word::kIqSum);
      case map::kPrecDist: return asks(axis, Word::kDist);
      default: return false;
    }
  }
  return false;
}

void KungXy::count_up(std::uint32_t address) {
  registers_.set(address, (registers_.word(address) + 1) & map::kPrecAddrWordMask);
}

// As it is after edge n, to which the controllers have been advanced.
std::uint32_t KungXy::read(Clk n, std::uint32_t address) {
  for (std::size_t k = 0; k < 2; ++k) {
    if (address >= kBases[k] && address < kBases[k] + 0x100u) {
      return read_axis(n, axes_[k], address - kBases[k], registers_.word(address));
    }
  }
  const Supervisor::Out& fault = supervisor_.out();
  switch (address) {
    case map::kIrqStat:
      return (irq_tick_.value() ? map::kIrqStatTick : 0) |
             (irq_fault_.value() ? map::kIrqStatFault : 0);
    case map::kTick: return tick_count_;
    case map::kFault:
      return static_cast<std::uint32_t>(fault.code) | (fault.axis ? map::kFaultAxis : 0) |
             fault.tick << map::kFaultTickShift;
    case map::kLock: return locked_ ? 1 : 0;
    default: return registers_.word(address);
  }
}

std::uint32_t KungXy::read_axis(Clk n, Axis& axis, std::uint32_t offset,
                                std::uint32_t stored) {
  const Afc::Out& afc = axis.position.afc().out();
  const CurrentLoop::Out& loop = axis.current.out();
  switch (offset) {
    case map::kStatus:
      return (axis.position.busy() ? map::kStatusBusy : 0) |
             (axis.overrun.value() ? map::kStatusOverrun : 0) |
             (axis.qep_error.value() ? map::kStatusQepError : 0) |
             (axis.saturated.value() ? map::kStatusSaturated : 0) |
             (axis.limited.value() ? map::kStatusLimited : 0) |
             (axis.underrun.value() ? map::kStatusUnderrun : 0) |
             (axis.clipped.value() ? map::kStatusClipped : 0) |
             word(axis.position.step_number()) << map::kStatusStepShift;
    case map::kPos: return word(axis.position_in.x_p);
    case map::kPosModel: return word(afc.x_r);
    case map::kErr: return word(afc.e);
    case map::kDerr: return word(afc.de);
    case map::kU: return word(afc.u);
    case map::kVstar: return word(afc.v_star);
    case map::kIqCmd: return word(i_q_ref(axis));
    case map::kSpeed: return word(afc.v);
    case map::kIdIq: return halves(loop.i_d, loop.i_q);
    case map::kPhaseCurrents: return halves(loop.i_a, loop.i_b);
    case map::kVdVq: return halves(loop.v_d, loop.v_q);
    case map::kTabData: return word(axis.position.table_read(n, axis.position_in.tab_addr));
    case map::kIndexLatch: return word(axis.qep.out().index_latch);
    default: return stored;
  }
}

}  // namespace trammel::exact
