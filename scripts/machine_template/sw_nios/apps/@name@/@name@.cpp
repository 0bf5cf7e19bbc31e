// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/@name@/@name@.hpp"

#include "sw_nios/hal/pin_map.hpp"

namespace trammel::sw {
namespace {

namespace words = @name@_words;

constexpr std::int32_t kOne = 256;  // of gains and sum

std::int32_t clamp(std::int32_t value, std::int32_t limit) {
  return value > limit ? limit : value < -limit ? -limit : value;
}

}  // namespace

void @Name@App::start(Bus& bus) {
  count_ = bus.read(pin_map::word(words::kCount));
  bus.write(pin_map::word(words::kEnable), 1);
  bus.write(platform_map::kTimer, setup_.timer_clk);
}

void @Name@App::isr(Bus& bus) {
  if ((bus.read(platform_map::kIrq) & platform_map::kIrqTimer) == 0 || mail_.done != 0) return;
  bus.write(platform_map::kTimer, setup_.timer_clk);
  const std::uint32_t count = bus.read(pin_map::word(words::kCount));
  const auto speed = static_cast<std::int16_t>(static_cast<std::uint16_t>(count - count_));
  count_ = count;
  mail_.real[0] += speed;
  const std::int32_t duty = control(speed);
  bus.write(pin_map::word(words::kDuty), static_cast<std::uint32_t>(duty));

  const bool still = speed == 0 && (duty == kFull || duty == -kFull);
  stalled_ = still ? stalled_ + 1 : 0;
  ++mail_.point;
  if (stalled_ == kStalled) {
    end(bus, @Name@Failure::kStalled);
  } else if (mail_.point == setup_.interrupts) {
    end(bus, @Name@Failure::kNone);
  }
}

// The sum stands still while the duty is at its limit, so that it does not wind up.
std::int32_t @Name@App::control(std::int32_t speed) {
  const std::int32_t error = setup_.speed - speed;
  const std::int32_t wanted = (setup_.kp * error + sum_) / kOne;
  const std::int32_t duty = clamp(wanted, kFull);
  if (duty == wanted) sum_ = clamp(sum_ + setup_.ki * error, kFull * kOne);
  return duty;
}

void @Name@App::end(Bus& bus, @Name@Failure failure) {
  bus.write(pin_map::word(words::kEnable), 0);
  bus.write(platform_map::kTimer, 0);
  mail_.failure = static_cast<std::uint32_t>(failure);
  mail_.done = 1;
}

}  // namespace trammel::sw
