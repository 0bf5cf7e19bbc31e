// SPDX-License-Identifier: Apache-2.0
#include "cosim/fault.hpp"

#include <fmt/format.h>

#include "cosim/machine.hpp"

namespace trammel::cosim {
namespace {

constexpr Clk kForever = 1'000'000'000'000;  // longer than any run, yet a time that SystemC can add

[[noreturn]] void refuse(const char* key, int value, int most) {
  if (most < 0) throw OptionsError("inject.fault: this machine has no such part");
  throw OptionsError(fmt::format("{}: value {} is out of range, allowed 0..{}", key, value, most));
}

void check(const char* key, int value, int most) {
  if (value < 0 || value > most) refuse(key, value, most);
}

std::uint32_t random_word(std::uint64_t x) {  // splitmix64
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::uint32_t>(x >> 32);
}

}  // namespace

void check_fault(const Fault& fault, const FaultPins& pins) {
  if (!fault.any()) return;
  check("inject.axis", fault.axis, pins.axes - 1);
  using K = FaultKind;
  if (fault.kind == K::kEncoderStuck) check("inject.line", fault.line, 1);
  if (fault.between(K::kConverterStuck, K::kConverterSlipped)) {
    check("inject.line", fault.line, pins.converters - 1);
  }
  if (fault.kind == K::kGateDead) check("inject.line", fault.line, pins.gates ? 5 : -1);
  if (fault.kind == K::kOutputStuck) {
    check("inject.line", fault.line, pins.gates ? -1 : pins.outputs - 1);
  }
  if (fault.kind == K::kPhaseOpen) check("inject.line", fault.line, pins.phases - 1);
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
