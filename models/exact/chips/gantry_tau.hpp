// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/chips/gantry_tau.sv, clock by clock, with one bus transfer at a time. step() is one
// edge; while quiescent() holds, advance(n) passes n <= next() of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "models/exact/bus/serial2002_port.hpp"
#include "models/exact/drive/force_pwm.hpp"
#include "models/exact/motion/rate_tick.hpp"
#include "models/exact/sense/adc_serial.hpp"
#include "models/exact/sense/calibration.hpp"
#include "models/exact/sense/conversion_slots.hpp"
#include "models/exact/sense/sincos_observer.hpp"
#include "models/pins/port.hpp"
#include "rtl/chips/generated/gantry_tau_regs.hpp"

namespace trammel::exact {

class GantryTau {
 public:
  struct In {  // pins
    bool adc_dout_i = false;
    bool nv_ready_i = true;
    std::uint16_t nv_data_i = 0;
    std::uint8_t overtemp_i = 0;
    bool rx_i = true;
  };
  struct Out {
    bool adc_cs_n_o = true, adc_sclk_o = false, adc_din_o = false;
    bool nv_valid_o = false, nv_write_o = false;
    std::uint32_t nv_addr_o = 0;
    std::uint16_t nv_data_o = 0;
    std::uint8_t pwm_o = 0, negative_o = 0;  // bit 0 of motor 1
    bool tx_o = true;
  };

  // The synchronisers and the banks of the calibration have no reset.
  void reset() {
    GantryTau fresh;
    fresh.hot_meta_ = hot_meta_;
    fresh.hot_ = hot_;
    fresh.calibration_ = calibration_;
    fresh.calibration_.reset();
    *this = fresh;
  }

  Out out() const {
    const AdcSerial::Out adc = adc_.out();
    const CalibrationStore::Out nv = calibration_.out();
    const auto& [first, second] = pwm_.out();
    return {adc.cs_n,
            adc.sclk,
            adc.din,
            nv.nv_valid,
            nv.nv_write,
            nv.nv_addr,
            nv.nv_data,
            both(first.pwm, second.pwm),
            both(first.negative, second.negative),
            serial_.tx()};
  }
  bool pass() const { return passed_; }
  bool irq() const { return (status() & irq_enable_) != 0; }

  AdcSerial::Out adc() const { return adc_.out(); }
  const SincosObserver::Out& observed() const { return observer_.out(); }
  const ConversionSlots& slots() const { return slots_; }
  const Serial2002Port& serial() const { return serial_; }
  const CalibrationStore& calibration() const { return calibration_; }
  std::uint32_t ticks() const { return ticks_; }
  std::int32_t force(std::size_t motor) const { return signed_force(force_[motor]); }

  // Valid from the present edge on; one at a time. A write is of these bits, whole bytes.
  void request(std::uint32_t address, std::uint32_t data, bool write, std::uint32_t bits = ~0u) {
    address_ = address & 0x7C;
    data_ = data;
    bits_ = bits;
    write_ = write;
    phase_ = 1;
  }
  bool open() const { return phase_ != 0; }
  std::uint32_t read_data() const { return read_data_; }

  void step(const In& in) {
    const bool acts = phase_ == 2;
    if (acts && !write_) read_data_ = read();
    const Signals s = signals(in);
    const std::uint32_t rose = events(s);
    rate_.step();
    slots_.step(s.slots);
    adc_.step(s.adc);
    observer_.step(s.observer, calibration_.data());
    calibration_.step(s.calibration);
    pwm_.step({force(0), force(1)});
    serial_.step(s.serial);
    pass_.step({pulses_.pass_restart || s.pass, period_ < kLeastPass ? 0 : period_});
    passed_ = s.pass;
    if (s.slots.pick) ++ticks_;
    hot_ = hot_meta_;
    hot_meta_ = in.overtemp_i;
    pulses_ = {};
    if (acts && write_) write();
    status_ |= rose;
    if (phase_ != 0) phase_ = phase_ == kEdges ? 0 : phase_ + 1;
  }

  bool quiescent(const In& in) const {
    if (phase_ != 0 || !rate_.quiescent() || due() || passed_ || pulses_.pass_restart ||
        in.overtemp_i != hot_meta_ || hot_meta_ != hot_) {
      return false;
    }
    const Signals s = signals(in);
    return slots_.quiescent(s.slots) && adc_.quiescent(s.adc) &&
           observer_.quiescent(s.observer) && calibration_.quiescent(s.calibration) &&
           pwm_.quiescent() && serial_.quiescent(s.serial);
  }

  Gap next(const In& in) const {
    if (!quiescent(in)) return 0;
    return std::min({rate_.next(), adc_.next(), pwm_.next(), serial_.next(), pass_.next({})});
  }

  void advance(Gap n) {
    rate_.advance(n);
    adc_.advance(n);
    pwm_.advance(n);
    serial_.advance(n);
    pass_.advance(n);
  }

 private:
  static constexpr int kEdges = 3;  // of a transfer: taken, acts, answered
  static constexpr std::uint32_t kLeastPass = 16;  // [clk]

  // What a write starts a clock later.
  struct Pulses {
    bool restart = false, pass_restart = false, send = false, calibrate = false, take = false;
    std::uint32_t ask = 0;
  };

  // What goes from block to block in a clock.
  struct Signals {
    ConversionSlots::In slots;
    AdcSerial::In adc;
    SincosObserver::In observer;
    CalibrationStore::In calibration;
    Serial2002Port::In serial;
    bool pass = false;
  };

  Signals signals(const In& in) const {
    Signals s;
    const AdcSerial::Out adc = adc_.out();
    const bool tick = rate_.tick(), active = (observe_ & 1) != 0 && calibration_.valid();
    s.slots = {tick,       slots_written_ & 0xFF, slots_written_ >> 16, active, pulses_.ask,
               adc.valid, adc.channel,           adc.code};
    const auto turn = tick ? slots_.pick(s.slots) : ConversionSlots::Client::kNone;
    s.observer = {tick,
                  pulses_.restart,
                  active,
                  (observe_ & 16) != 0,
                  turn == ConversionSlots::Client::kObserver,
                  adc.valid,
                  adc.channel,
                  adc.code};
    const std::optional<std::uint32_t> asked = observer_.asked(s.observer);
    const bool requester = turn == ConversionSlots::Client::kRequester;
    s.adc = {requester || asked.has_value(), requester ? slots_.channel() : asked.value_or(0),
             in.adc_dout_i};
    s.calibration = {pulses_.calibrate,
                     calibrate_ >> 16,
                     static_cast<std::uint16_t>(calibrate_),
                     observer_.busy() || tick || adc.valid,
                     in.nv_ready_i,
                     in.nv_data_i};
    s.serial = {in.rx_i, pulses_.send, {send_ >> 8, send_ & 31, send_value_}, pulses_.take,
                receive_gap_};
    s.pass = due();
    return s;
  }

  bool due() const { return pass_.count() == 1; }  // a control pass
  bool was_due() const { return (status_ & gantry_tau_regs::kStatusPass) != 0; }

  std::uint32_t events(const Signals& s) const {
    using namespace gantry_tau_regs;
    return (s.pass ? kStatusPass | (was_due() ? kStatusOverrun : 0) : 0) |
           (slots_.served(s.slots) ? kStatusSample : 0) |
           (calibration_.refused() ? kStatusRefused : 0) |
           (calibration_.stored(s.calibration) ? kStatusStored : 0);
  }

  std::uint32_t status() const {
    return status_ | (serial_.in().waits() ? gantry_tau_regs::kStatusFrame : 0);
  }

  static std::int32_t signed_force(std::uint32_t word) {
    return static_cast<std::int32_t>(word) - (word >= 1024 ? 2048 : 0);
  }

  void write() {
    using namespace gantry_tau_regs;
    const std::uint32_t ones = data_ & bits_;
    const auto merge = [&](std::uint32_t old, std::uint32_t kept) {
      return ((old & ~bits_) | ones) & kept;
    };
    const bool low = (bits_ & 0xFF) != 0;
    switch (address_) {
      case kObserver:
        observe_ = merge(observe_, 0x11);
        pulses_.restart = low;
        break;
      case kSlots: slots_written_ = merge(slots_written_, 0xFF00FF); break;
      case kRequest: pulses_.ask = ones & 0x4F; break;
      case kForce1: force_[0] = merge(force_[0], 0x7FF); break;
      case kForce2: force_[1] = merge(force_[1], 0x7FF); break;
      case kPassPeriod:
        period_ = merge(period_, 0xFFFFFF);
        pulses_.pass_restart = (bits_ & 0xFFFFFF) != 0;
        break;
      case kStatus: status_ &= ~ones; break;
      case kIrqEnable: irq_enable_ = merge(irq_enable_, 7); break;
      case kReceive: pulses_.take = (ones & 1) != 0; break;
      case kSendValue: send_value_ = merge(send_value_, ~0u); break;
      case kSend:
        send_ = merge(send_, 0x71F);
        pulses_.send = low;
        break;
      case kCalibrate:
        calibrate_ = merge(calibrate_, 0x7FFFF);
        pulses_.calibrate = (bits_ & 0xFFFF) != 0;
        break;
      case kReceiveGap: receive_gap_ = merge(receive_gap_, 0xFFFFFF); break;
      default: break;
    }
  }

  std::uint32_t read() const;

  RateTick rate_;
  ConversionSlots slots_;
  AdcSerial adc_;
  SincosObserver observer_;
  CalibrationStore calibration_;
  ForcePwm pwm_;
  Serial2002Port serial_;
  Timer pass_;
  Pulses pulses_{false, true, false, false, false, 0};
  std::uint32_t observe_ = 0, slots_written_ = 0x10002, status_ = 0, irq_enable_ = 0;
  std::uint32_t period_ = 100'000, ticks_ = 0;  // [clk]
  std::uint32_t receive_gap_ = 504'774;  // [clk]
  std::uint32_t send_value_ = 0, send_ = 0x400, calibrate_ = 0;
  std::array<std::uint32_t, 2> force_{};
  std::uint8_t hot_meta_ = 0, hot_ = 0;
  std::uint32_t address_ = 0, data_ = 0, bits_ = ~0u, read_data_ = 0;
  bool write_ = false, passed_ = false;
  int phase_ = 0;  // of the transfer
};

inline std::uint32_t GantryTau::read() const {
  using namespace gantry_tau_regs;
  const SincosObserver::Out& o = observer_.out();
  const auto& codes = slots_.codes();
  const Frame frame = serial_.in().frame();
  const auto pair = [](std::uint32_t low, std::uint32_t high) { return low | high << 16; };
  switch (address_) {
    case kId: return kIdValue;
    case kObserver: return observe_;
    case kPosition: return static_cast<std::uint32_t>(o.position);
    case kVelocity: return static_cast<std::uint32_t>(o.velocity);
    case kAngle: return pair(o.phase, o.region) | (o.known ? kAngleKnown : 0);
    case kTicks: return ticks_;
    case kSlots: return slots_written_;
    case kRequest: return slots_.pending();
    case kEncoderA: return pair(codes[0], codes[1]);
    case kEncoderB: return pair(codes[2], codes[3]);
    case kCurrent: return codes[4];
    case kForce1: return force_[0];
    case kForce2: return force_[1];
    case kOvertemp: return hot_;
    case kPassPeriod: return period_;
    case kStatus: return status();
    case kIrqEnable: return irq_enable_;
    case kReceive:
      return frame.channel | frame.kind << 8 | (serial_.in().waits() ? kReceiveWaits : 0);
    case kReceiveValue: return frame.value;
    case kReceiveErrors: return pair(serial_.malformed(), serial_.in().lost());
    case kSendValue: return send_value_;
    case kSend: return send_;
    case kSendState:
      return pair(serial_.out().room() | (serial_.idle() ? kSendStateIdle : 0),
                  serial_.out().lost());
    case kCalibrate: return calibrate_;
    case kCalibration:
      return (calibration_.valid() ? kCalibrationValid : 0) |
             (calibration_.busy() ? kCalibrationBusy : 0) | calibration_.count() << 8;
    case kReceiveGap: return receive_gap_;
    default: return 0;
  }
}

}  // namespace trammel::exact
