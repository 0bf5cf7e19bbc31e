// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/larson/table.hpp"

#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::sw {
namespace {

namespace map = larson_map;

constexpr std::int32_t kTicks = 240'000;  // [Hz] of the interface
constexpr std::int32_t kTravel = 6000;    // [step] of 0.001 inch
constexpr std::int32_t kFar = 60'000;     // of any table
constexpr std::int32_t kOff = 2000;       // more than a switch may be run into

}  // namespace

std::uint32_t StepTable::code(std::int32_t rate) const {
  const std::int32_t most = setup_.most_rate;
  const std::int32_t pps = rate > most ? most : rate < 1 ? 1 : rate;
  std::int32_t ticks = (kTicks + pps / 2) / pps;
  if (ticks > 4096) ticks = 4096;
  if (kTicks > ticks * most) ++ticks;  // not above it by rounding
  return static_cast<std::uint32_t>(4096 - ticks);
}

void StepTable::veltbl(const StepPoint& rate) {
  axes_[0].rate = code(rate.x);
  axes_[1].rate = code(rate.y);
}

// One word starts it: a status word cannot be changed bit by bit where a switch is closed.
void StepTable::run(Bus& bus, std::uint32_t axis, std::int32_t steps, std::uint32_t code) {
  const std::uint32_t number = static_cast<std::uint32_t>(steps < 0 ? -steps : steps);
  axes_[axis].steps = steps;
  axes_[axis].moving = true;
  settled_ = false;
  bus.write(map::count(axis), ~number & 0xFFFF);
  bus.write(map::status(axis),
            map::kEnable | map::kBusy | (steps > 0 ? map::kForward : 0) | code);
}

std::int32_t StepTable::clipped(std::int32_t target) {
  if (target < 0 || target > setup_.soft_end) error_ = true;
  return target < 0 ? 0 : target > setup_.soft_end ? setup_.soft_end : target;
}

StepAnswer StepTable::abstbl(Bus& bus, const StepPoint& to) {
  if (busy()) return StepAnswer::kMoving;
  if (!calibrated_) return StepAnswer::kNotCalibrated;
  const std::int32_t target[2] = {clipped(to.x), clipped(to.y)};
  for (std::uint32_t k = 0; k < 2; ++k) {
    const std::int32_t steps = target[k] - axes_[k].from;
    if (steps != 0) run(bus, k, steps, axes_[k].rate);
  }
  return StepAnswer::kStarted;
}

StepAnswer StepTable::reltbl(Bus& bus, const StepPoint& by) {
  return abstbl(bus, {axes_[0].from + by.x, axes_[1].from + by.y});
}

// The count is the complement of the steps that are left.
std::int32_t StepTable::position(Bus& bus, std::uint32_t axis) const {
  const Axis& a = axes_[axis];
  if (!a.moving) return a.from;
  const auto left = static_cast<std::int32_t>(~bus.read(map::count(axis)) & 0xFFFF);
  return a.steps > 0 ? a.from + a.steps - left : a.from + a.steps + left;
}

StepPoint StepTable::whrtbl(Bus& bus) const {
  const std::int32_t x = position(bus, 0);
  return {x, position(bus, 1)};
}

std::uint32_t StepTable::settling() {
  if (settled_) return 0;
  settled_ = true;
  return setup_.settle_clk;
}

bool StepTable::wttbl() {
  const bool normal = !error_;
  error_ = false;
  return normal;
}

// Bit 14 tells a switch from the end of the count.
void StepTable::ended(Bus& bus, std::uint32_t axis) {
  Axis& a = axes_[axis];
  const std::uint32_t status = bus.read(map::status(axis));
  if ((status & map::kBusy) != 0) return;
  a.at_switch = (status & map::kLimit) != 0;
  a.from = position(bus, axis);
  a.moving = false;
  if (a.seek != Seek::kNone) {
    seek_on(bus, axis);
  } else if (a.at_switch) {
    error_ = true;
    if (calibrated_ || stopped_ != 0) stopped_ |= 1u << axis;
    calibrated_ = false;  // what the buffer held is lost
  }
}

void StepTable::on_vector(Bus& bus, std::uint32_t vector) {
  if (vector == map::kVectorX) ended(bus, 0);
  if (vector == map::kVectorY) ended(bus, 1);
}

void StepTable::caltbl(Bus& bus) {
  if (busy()) return;
  calibrated_ = error_ = false;
  stopped_ = 0;
  const std::int32_t far = setup_.soft_end > kTravel ? kFar : 2 * kTravel;
  for (std::uint32_t k = 0; k < 2; ++k) {
    axes_[k].from = 0;
    axes_[k].seek = Seek::kToSwitch;
    if (axes_[k].at_switch) bus.write(map::status(k), map::kReset);
    run(bus, k, -far, code(setup_.seek_rate));
  }
}

// At the switch: reset, and away from it until it opens; then the margin.
void StepTable::seek_on(Bus& bus, std::uint32_t axis) {
  Axis& a = axes_[axis];
  if (a.seek == Seek::kToSwitch && a.at_switch) {
    bus.write(map::status(axis), map::kReset);
    a.seek = Seek::kOffSwitch;
    run(bus, axis, kOff, code(setup_.back_rate));
  } else if (a.seek == Seek::kMargin && !a.at_switch) {
    a.seek = Seek::kNone;
    a.from = 0;
    calibrated_ = axes_[1 - axis].seek == Seek::kNone && !error_;
  } else {  // the count ran out, or the switch closed again
    a.seek = Seek::kNone;
    error_ = true;
  }
}

bool StepTable::wants_timer() const {
  return axes_[0].seek == Seek::kOffSwitch || axes_[1].seek == Seek::kOffSwitch;
}

void StepTable::on_timer(Bus& bus) {
  for (std::uint32_t k = 0; k < 2; ++k) {
    if (axes_[k].seek == Seek::kOffSwitch) look(bus, k);
  }
}

void StepTable::look(Bus& bus, std::uint32_t axis) {
  Axis& a = axes_[axis];
  const std::uint32_t status = bus.read(map::status(axis));
  if ((status & (map::kLimit | map::kBusy)) != map::kBusy) return;  // closed, or over
  bus.write(map::status(axis), status & map::kRate);                // stops without an interrupt
  a.moving = false;
  a.seek = Seek::kMargin;
  run(bus, axis, setup_.margin, code(setup_.back_rate));
}

}  // namespace trammel::sw
