// SPDX-License-Identifier: Apache-2.0
#include "cosim/fault_plant.hpp"

#include "cosim/machine_chip.hpp"

namespace trammel::cosim {
namespace {

// Count of the lines, modulo 4: A leads B when it grows.
unsigned count_of(bool a, bool b) { return b ? (a ? 2u : 3u) : (a ? 1u : 0u); }
bool line_a(unsigned count) { return count == 1 || count == 2; }
bool line_b(unsigned count) { return count >= 2; }

}  // namespace

void require_bit(MachineChip& chip, const std::string& bit) {
  if (chip.flip(bit, false)) return;
  throw OptionsError("inject.bit: \"" + bit + "\" is no bit of a register of this chip; names are "
                     "those of waves, as in u_supervisor.trip_q[0], and not with a wave trigger");
}

FaultPlant::FaultPlant(FalliblePlant& plant, const FaultPins& pins, const Fault& fault,
                       std::int64_t clock_ps)
    : plant_(plant),
      pins_(pins),
      fault_(fault),
      span_(fault, clock_ps),
      event_(fault.of_processor() || fault.kind == FaultKind::kProcessorHung ? kNever
                                                                             : span_.begin),
      index_(fault.axis * pins.place(fault.kind).lines + fault.line) {
  check_fault(fault, pins);
  if (!pins.inputs.empty()) encoder_ = pins.inputs.at(static_cast<std::size_t>(fault.axis));
  const Lines lines = plant_.sense();
  true_ = seen_ = count_of(level(lines, encoder_[0]), level(lines, encoder_[1]));
}

Lines FaultPlant::sense() const {
  Lines lines = plant_.sense();
  const auto put = [&lines, this](int line, bool level) {
    lines = level ? lines | bit(line) : lines & ~bit(line);
  };
  const bool a = level(lines, encoder_[0]), b = level(lines, encoder_[1]);
  if (fault_.kind == FaultKind::kEncoderMissing) {  // what is lost stays lost
    put(encoder_[0], line_a(seen_));
    put(encoder_[1], line_b(seen_));
  }
  if (!active_) return lines;
  const int line = encoder_[static_cast<std::size_t>(fault_.line & 1)];
  switch (fault_.kind) {
    case FaultKind::kEncoderStuck:
      put(line, fault_.value == 0 ? level(held_, line) : fault_.value > 0);
      break;
    case FaultKind::kEncoderSwapped:
      put(encoder_[0], b);
      put(encoder_[1], a);
      break;
    case FaultKind::kIndexLost: put(encoder_[2], false); break;
    case FaultKind::kEncoderJump:
      put(encoder_[0], !a);
      put(encoder_[1], !b);
      break;
    case FaultKind::kTripPin: put(pins_.trip, true); break;
    default: break;
  }
  return lines;
}

int FaultPlant::sample(int channel, Clk n) const {
  const int code = plant_.sample(channel, n);
  if (!active_ || channel != index_) return code;
  const int top = (1 << std::max(12, pins_.converter_bits)) - 1;
  const int step = (top + 1) / 4096;  // of 12 bits
  switch (fault_.kind) {
    case FaultKind::kConverterStuck:
      return fault_.value == 0 ? code_ : std::clamp(fault_.value * step, 0, top);
    case FaultKind::kConverterOffset: return std::clamp(code + fault_.value * step, 0, top);
    case FaultKind::kConverterSaturated: return fault_.value < 0 ? 0 : top;
    case FaultKind::kConverterSlipped:
      return fault_.value < 0 ? code * 2 % 65536 : code / 2;
    default: return code;
  }
}

Lines FaultPlant::driven(Lines drive) const {
  if (!active_) return drive;
  const Lines line = bit(index_);
  if (fault_.kind == FaultKind::kGateDead) return drive & ~line;
  if (fault_.kind != FaultKind::kOutputStuck) return drive;
  return fault_.value > 0 ? drive | line : drive & ~line;
}

void FaultPlant::commit(Clk n, Lines drive) {
  const Lines before = driven_.value_or(drive);
  if (n >= event_ && !active_) {
    // The plant passes its own event first: what is held is what it shows at this edge.
    plant_.commit(n, before);
    begin(n);
  } else if (n >= event_) {
    plant_.commit(n, before);
    end(n);
  }
  const Lines now = driven(drive);
  if (n >= plant_.next() || now != driven_) plant_.commit(n, now);
  driven_ = now;
  follow_counts();
}

void FaultPlant::begin(Clk n) {
  active_ = true;
  event_ = span_.end;
  held_ = plant_.sense();
  if (fault_.between(FaultKind::kConverterStuck, FaultKind::kConverterSlipped)) {
    code_ = plant_.sample(index_, n);
  }
  if (fault_.kind == FaultKind::kPhaseOpen) plant_.open_phase(n, fault_.axis, fault_.line, true);
  if (fault_.kind == FaultKind::kSupplyDip) plant_.supply(n, 0.01 * fault_.value);
  if (fault_.kind == FaultKind::kRegisterFlip) {
    flip();
    event_ = kNever;
  }
}

void FaultPlant::end(Clk n) {
  active_ = false;
  event_ = kNever;
  if (fault_.kind == FaultKind::kPhaseOpen) plant_.open_phase(n, fault_.axis, fault_.line, false);
  if (fault_.kind == FaultKind::kSupplyDip) plant_.supply(n, 1);
}

// A lost count is one that the seen count does not follow.
void FaultPlant::follow_counts() {
  const Lines lines = plant_.sense();
  const unsigned now = count_of(level(lines, encoder_[0]), level(lines, encoder_[1]));
  if (now == true_) return;
  const unsigned step = (now - true_) & 3u;
  true_ = now;
  const int lost = fault_.value > 0 ? fault_.value : 10;
  if (active_ && fault_.kind == FaultKind::kEncoderMissing && ++counts_ >= lost) {
    counts_ = 0;
    return;
  }
  seen_ = (seen_ + step) & 3u;
}

}  // namespace trammel::cosim
