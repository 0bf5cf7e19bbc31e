// SPDX-License-Identifier: Apache-2.0
#include "cosim/fault.hpp"

#include <fmt/format.h>

#include "cosim/run.hpp"

namespace trammel::cosim {
namespace {

constexpr Clk kForever = 1'000'000'000'000;  // longer than any run, yet a time that SystemC can add

void check(const char* key, int value, int most) {
  if (value >= 0 && value <= most) return;
  throw OptionsError(fmt::format("{}: value {} is out of range, allowed 0..{}", key, value, most));
}

std::uint32_t random_word(std::uint64_t x) {  // splitmix64
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::uint32_t>(x >> 32);
}

}  // namespace

const std::vector<std::string>& fault_words() {
  static const std::vector<std::string> kWords{
      "none",             "encoder_stuck",    "encoder_missing",     "encoder_swapped",
      "index_lost",       "encoder_jump",     "trip_pin",            "converter_stuck",
      "converter_offset", "converter_saturated", "converter_slipped", "gate_dead",
      "output_stuck",     "processor_hung",   "phase_open",          "supply_dip",
      "processor_stopped", "processor_slow",  "processor_garbage",   "bus_stall",
      "register_flip"};
  return kWords;
}

FaultPlace FaultPins::place(FaultKind kind) const {
  if (kind >= FaultKind::kSupplyDip) return {kind, kind, 0, ""};
  for (const FaultPlace& one : places) {
    if (kind >= one.first && kind <= one.last) return one;
  }
  return {};
}

std::vector<std::string> FaultPins::words() const {
  std::vector<std::string> own{fault_words().front()};
  for (std::size_t k = 1; k < fault_words().size(); ++k) {
    const bool has = place(static_cast<FaultKind>(k)).first != FaultKind::kNone;
    if (has) own.push_back(fault_words()[k]);
  }
  return own;
}

void check_fault(const Fault& fault, const FaultPins& pins) {
  if (!fault.any()) return;
  using K = FaultKind;
  const FaultPlace place = pins.place(fault.kind);
  if (place.first == K::kNone) {
    const auto own = pins.words();
    throw OptionsError(fmt::format("inject.fault: this machine has no {}; it has: {}",
                                   fault_words()[static_cast<std::size_t>(fault.kind)],
                                   fmt::join(own.begin() + 1, own.end(), ", ")));
  }
  check("inject.axis", fault.axis, pins.last_axis());
  if (place.lines > 0) check("inject.line", fault.line, place.lines - 1);
  if (fault.kind == K::kSupplyDip) check("inject.value", fault.value, 100);
  if (fault.kind == K::kConverterStuck) check("inject.value", fault.value, 4095);
  if (fault.kind == K::kEncoderMissing || fault.kind == K::kProcessorSlow ||
      fault.kind == K::kBusStall) {
    check("inject.value", fault.value, 65535);
  }
  if (fault.kind == K::kRegisterFlip && !pins.registers) {
    throw OptionsError("inject.fault: register_flip needs run.engine = \"rtl\", whose registers "
                       "have names");
  }
}

FaultSpan::FaultSpan(const Fault& fault, std::int64_t clock_ps) {
  if (!fault.any()) return;
  begin = clocks_of(fault.begin_s, clock_ps);
  if (fault.for_s > 0) end = begin + std::max<Clk>(1, clocks_of(fault.for_s, clock_ps));
}

ProcessorFault::ProcessorFault(const Fault& fault, std::int64_t clock_ps) {
  if (!fault.of_processor()) return;
  kind_ = fault.kind;
  span_ = FaultSpan(fault, clock_ps);
  value_ = fault.value > 0 ? fault.value : kind_ == FaultKind::kBusStall ? 1000 : 10;
}

Clk ProcessorFault::work(Clk now, Clk clocks) const {
  if (!span_.holds(now)) return clocks;
  if (kind_ == FaultKind::kProcessorSlow) return clocks * value_;
  if (kind_ != FaultKind::kProcessorStopped) return clocks;
  return span_.end == kNever ? kForever : span_.end - now + clocks;
}

Clk ProcessorFault::access(Clk now, Clk clocks) const {
  if (kind_ == FaultKind::kBusStall && span_.holds(now)) return clocks + value_;
  return work(now, clocks);
}

std::uint32_t ProcessorFault::written(Clk now, std::uint32_t data) const {
  if (kind_ != FaultKind::kProcessorGarbage || !span_.holds(now)) return data;
  return random_word(static_cast<std::uint64_t>(now));
}

}  // namespace trammel::cosim
