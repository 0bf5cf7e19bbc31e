// SPDX-License-Identifier: Apache-2.0
//
// Speed control of a DC motor by the chip @name@_pwm: the timer interrupts once per ms, the
// encoder count gives the speed, and an integer PI controller the duty word. Freestanding.
#pragma once

#include <cstdint>

#include "sw_nios/hal/bus.hpp"

namespace trammel::sw {

// Words of the chip on its bus, see sw_nios/hal/pin_map.hpp.
namespace @name@_words {
inline constexpr std::uint32_t kEnable = 0;  // bit 0
inline constexpr std::uint32_t kDuty = 1;    // 13 bits, signed
inline constexpr std::uint32_t kCount = 2;   // 16 bits, signed; wraps
}  // namespace @name@_words

struct @Name@Setup {
  std::int32_t speed = 40;         // [count per interrupt]
  std::int32_t kp = 8192;          // [duty / 256 per count of error]
  std::int32_t ki = 105;           // [the same, each interrupt]
  std::uint32_t interrupts = 500;  // after which the program ends
  std::uint32_t timer_clk = 50'000;
};

enum class @Name@Failure : std::uint32_t {
  kNone,
  kStalled  // no count for kStalled interrupts, though the duty was at its limit
};

class @Name@App final : public Firmware {
 public:
  static constexpr std::int32_t kFull = 2500;      // duty of a whole period
  static constexpr std::uint32_t kStalled = 50;

  explicit @Name@App(const @Name@Setup& setup) : setup_(setup) {}

  void start(Bus& bus) override;
  void isr(Bus& bus) override;
  // Its failure is a @Name@Failure, a point an interrupt, real[0] the travel so far [count].
  const Mailbox& mailbox() const override { return mail_; }

 private:
  std::int32_t control(std::int32_t speed);
  void end(Bus& bus, @Name@Failure failure);

  Mailbox mail_;
  @Name@Setup setup_;
  std::uint32_t count_ = 0;    // at the last interrupt
  std::int32_t sum_ = 0;       // integral part [duty / 256]
  std::uint32_t stalled_ = 0;  // interrupts without a count
};

}  // namespace trammel::sw
