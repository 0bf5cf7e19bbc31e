// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/gantry/gantry.hpp"

#include "rtl/chips/generated/gantry_tau_regs.hpp"
#include "sw_nios/hal/platform_map.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"

namespace trammel::sw {
namespace {

namespace tau = gantry_tau_regs;

constexpr std::int32_t kFitFrom_mm = 80;             // 40 mm before the first period that is used
constexpr std::uint32_t kFitWait = 4612;             // [tick]
constexpr std::uint32_t kReleaseTicks = 461;         // 0.1 s
constexpr std::uint32_t kObserveAll = tau::kObserverActive | tau::kObserverVelocity;
constexpr std::int32_t kStallForce = 160;            // [count] above stiction in a zone, 118
constexpr std::int32_t kLeastRadius = 250, kMostRadius = 520;  // [code] of A and B at 0.5 m/s

std::int32_t counts_of(std::int32_t mm) { return mm * 32 / 5; }
std::uint32_t bits(std::int32_t force) { return static_cast<std::uint32_t>(force) & 0x7FF; }

}  // namespace

void GantryApp::start(Bus& bus) {
  bus.write(tau::kPassPeriod, c_.pass_clk);
  observed_ = kObserveAll;
  bus.write(tau::kObserver, observed_);
  bus.write(tau::kIrqEnable, tau::kStatusPass | tau::kStatusFrame | tau::kStatusSample);
  bus.write(tau::kReceiveGap, c_.gap_clk);
  send(bus, {gantry_channel::kValue, gantry_channel::kReset, gantry_channel::kResetMessage});
  if (c_.home) {
    mail_.phase = GantryPhase::kHoming;
  } else if (c_.calibrate) {
    mail_.phase = GantryPhase::kToFit;
  } else if (c_.open != OpenForce::kNone) {
    mail_.phase = GantryPhase::kOpen;
  }
}

void GantryApp::isr(Bus& bus) {
  if ((bus.read(platform_map::kIrq) & platform_map::kIrqChip) == 0) return;
  const std::uint32_t status = bus.read(tau::kStatus);
  const std::uint32_t events = status & (tau::kStatusPass | tau::kStatusSample);
  if (events != 0) bus.write(tau::kStatus, events);
  if ((status & tau::kStatusPass) != 0) pass(bus);
  if ((status & tau::kStatusSample) != 0) {
    if (mail_.phase == GantryPhase::kFitting) {
      collect(bus);
    } else {
      answer_samples(bus);
    }
  }
  if ((status & tau::kStatusFrame) != 0) receive(bus);
}

void GantryApp::pass(Bus& bus) {
  ++mail_.point;
  if (mail_.phase == GantryPhase::kFitting) return;
  const std::uint32_t ticks = bus.read(tau::kTicks);
  if ((bus.read(tau::kAngle) & tau::kAngleKnown) == 0) {
    last_tick_ = ticks;
    if (forces_.one != 0 || forces_.two != 0) go(bus, {0, 0});
    return;
  }
  units_ = static_cast<std::int32_t>(bus.read(tau::kPosition));
  count_ = (units_ >> 9) - mail_.zero;
  const auto velocity = static_cast<std::int32_t>(bus.read(tau::kVelocity));
  mail_.velocity = other_ != nullptr ? other_->step(velocity, forces_) : filter_.step(velocity);
  if (!seen_) {
    seen_ = true;
    still_count_ = near_count_ = count_;
    still_tick_ = near_tick_ = last_tick_ = moved_tick_ = ticks;
  }
  if (failed(bus, ticks)) return;
  if (mail_.phase == GantryPhase::kHoming) {
    home(bus, count_, ticks);
  } else if (mail_.phase == GantryPhase::kToFit) {
    go_to_fit(bus, ticks);
  } else if (mail_.phase == GantryPhase::kOpen) {
    const std::int32_t force = open_force();
    go(bus, {force, force});
  } else if (mail_.phase != GantryPhase::kIdle) {
    go(bus, control(ticks));
  }
  last_tick_ = ticks;
  if (lists_ > 0) describe(bus);
  if (c_.stream) stream(bus, ticks);
}

// Both motors to the right, until the position has not changed for long; then both rest until the
// stop has pushed the cart back. Zero is there, so that nothing pushes against the stop. Noise may
// move the position between two neighbouring counts for ever: then it rests after 0.1 s more.
void GantryApp::home(Bus& bus, std::int32_t count, std::uint32_t ticks) {
  const std::int32_t force = released_ ? 0 : c_.home_force;
  go(bus, {force, force});
  if (count != still_count_) {
    still_count_ = count;
    still_tick_ = ticks;
  }
  if (count < near_count_ || count > near_count_ + 1) {
    near_count_ = count < near_count_ ? count : count - 1;
    near_tick_ = ticks;
  }
  const std::uint32_t rest = released_ ? kReleaseTicks : c_.home_ticks;
  if (ticks - still_tick_ < rest && ticks - near_tick_ < rest + kReleaseTicks) return;
  if (!released_) {
    released_ = true;
    still_tick_ = near_tick_ = ticks;
    return go(bus, {0, 0});
  }
  released_ = false;
  mail_.zero += count;
  count_ = 0;
  mail_.homed = 1;
  still_tick_ = ticks;
  mail_.goal = 0;
  mail_.phase = c_.calibrate && !mail_.fitted ? GantryPhase::kToFit : ready(GantryPhase::kPosition);
}

void GantryApp::go_to_fit(Bus& bus, std::uint32_t ticks) {
  mail_.goal = counts_of(kFitFrom_mm);
  go(bus, control(ticks));
  if (mail_.error > 4 || mail_.error < -4) still_tick_ = ticks;
  if (ticks - still_tick_ > kFitWait) begin_fit(bus);
}

// The observer rests, so that every tick is the requester's; A and B take turns.
void GantryApp::begin_fit(Bus& bus) {
  mail_.phase = GantryPhase::kFitting;
  observed_ = 0;
  bus.write(tau::kObserver, 0);
  go(bus, {-c_.fit_force, -c_.fit_force});
  bus.write(tau::kRequest, tau::kRequestA);
  asked_ = 1;
}

void GantryApp::collect(Bus& bus) {
  const bool of_a = asked_ == 1;
  const std::uint32_t code = bus.read(of_a ? tau::kEncoderA : tau::kEncoderB) & 0x3FF;
  fit_.add(bus.read(tau::kTicks), of_a, static_cast<std::int32_t>(code));
  if (fit_.full()) return end_fit(bus);
  asked_ = of_a ? 4 : 1;
  bus.write(tau::kRequest, of_a ? tau::kRequestB : tau::kRequestA);
}

void GantryApp::end_fit(Bus& bus) {
  asked_ = 0;
  go(bus, {0, 0});
  mail_.fitted = fit_.fit(mail_.words);
  mail_.phase = GantryPhase::kIdle;
  if (!mail_.fitted) {
    mail_.failure = static_cast<std::uint32_t>(GantryFailure::kFitFailed);
  } else {
    bus.write(tau::kCalibrate, 1u << 16);
    for (const std::uint16_t word : mail_.words) bus.write(tau::kCalibrate, 2u << 16 | word);
    bus.write(tau::kCalibrate, 7u << 16);
  }
  observe(bus, kObserveAll);
  if (mail_.fitted) mail_.phase = c_.home ? GantryPhase::kHoming : ready(GantryPhase::kIdle);
}

// Where homing and calibration end.
GantryPhase GantryApp::ready(GantryPhase closed) const {
  return c_.open == OpenForce::kNone ? closed : GantryPhase::kOpen;
}

// A restart of the observer: the position counts anew from its first period, so that what was
// wanted is not there any more, and the motors rest until there is a new goal or homing has ended.
void GantryApp::observe(Bus& bus, std::uint32_t mask) {
  ++mail_.restarts;
  observed_ = mask;
  bus.write(tau::kObserver, mask);
  go(bus, {0, 0});
  mail_.zero = 0;
  seen_ = released_ = false;
  mail_.homed = 0;
  filter_ = {};
  if (other_ != nullptr) other_->restart();
  mail_.velocity = 0;
  if (mail_.phase != GantryPhase::kHoming) mail_.phase = GantryPhase::kIdle;
}

// What is watched of sensor and motion, where it is.
bool GantryApp::failed(Bus& bus, std::uint32_t ticks) {
  if (mail_.failure != 0) return true;
  if (c_.watch_sensor) {
    const auto a = static_cast<std::int32_t>(bus.read(tau::kEncoderA) & 0x3FF) - 512;
    const auto b = static_cast<std::int32_t>(bus.read(tau::kEncoderB) & 0x3FF) - 512;
    const std::int32_t square = a * a + b * b;
    if (square < kLeastRadius * kLeastRadius || square > kMostRadius * kMostRadius) {
      fail(bus, GantryFailure::kSensor);
    }
  }
  const std::int32_t sum = forces_.one + forces_.two;
  if (count_ != moved_count_ || within(sum, 2 * kStallForce) == sum ||
      mail_.phase == GantryPhase::kHoming) {
    moved_count_ = count_;
    moved_tick_ = ticks;
  } else if (c_.stall_ticks != 0 && ticks - moved_tick_ >= c_.stall_ticks) {
    fail(bus, GantryFailure::kStalled);
  }
  return mail_.failure != 0;
}

void GantryApp::fail(Bus& bus, GantryFailure why) {
  go(bus, {0, 0});
  mail_.phase = GantryPhase::kIdle;
  mail_.failure = static_cast<std::uint32_t>(why);
}

MotorForces GantryApp::control(std::uint32_t ticks) {
  mail_.error = count_ - mail_.goal;
  const std::uint32_t since = ticks - last_tick_;
  const auto keep = [&](std::int32_t ref) {
    return VelocityPi::step(c_.velocity, velocity_, ref, mail_.velocity, since);
  };
  if (mail_.phase == GantryPhase::kVelocity) {
    const std::int32_t u = keep(mail_.goal_velocity);
    return {-u, -u};
  }
  if (!c_.cascade) {
    const std::int32_t u = PositionPi::step(c_.position, position_, mail_.error, since);
    return {u, u};
  }
  const std::int64_t ref = -mail_.error * (std::int64_t{1} << c_.cascade_gain);
  const std::int32_t u = keep(narrowed(ref));
  return c_.compensate ? c_.compensation.share(mail_.error, -u) : MotorForces{-u, -u};
}

// The shift register is that of x^7 + x^6 + 1.
std::int32_t GantryApp::open_force() {
  constexpr std::uint32_t kTurn = 127;
  const std::uint32_t hold = open_pass_ / c_.open_passes;
  if (c_.open == OpenForce::kSteps) open_sign_ = hold % 2 == 0;
  if (c_.open == OpenForce::kRandom && open_pass_ % c_.open_passes == 0) {
    open_bits_ = (open_bits_ << 1 | ((open_bits_ >> 6 ^ open_bits_ >> 5) & 1)) & 0x7F;
    open_sign_ = ((open_bits_ & 1) != 0) == (hold / kTurn % 2 == 0);
  }
  ++open_pass_;
  return open_sign_ ? c_.open_force : -c_.open_force;
}

void GantryApp::go(Bus& bus, MotorForces forces) {
  if (c_.motors == Motors::kFirst) forces.two = 0;
  if (c_.motors == Motors::kSecond) forces.one = 0;
  forces_ = forces;
  bus.write(tau::kForce1, bits(forces.one));
  bus.write(tau::kForce2, bits(forces.two));
}

}  // namespace trammel::sw
