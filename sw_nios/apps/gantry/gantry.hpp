// SPDX-License-Identifier: Apache-2.0
//
// Firmware of the gantry track (Brochier 2006, appendix C): homing, the calibration run, a control
// pass at each pass of the chip, and what comes and goes by Serial2002. Freestanding.
#pragma once

#include <cstdint>

#include "sw_nios/apps/gantry/calibration_fit.hpp"
#include "sw_nios/apps/gantry/controllers.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"
#include "sw_nios/hal/bus.hpp"

namespace trammel::sw {

// A run without controller: a force of both motors, the same, its sign changed after each hold, or
// changed by a pseudo-random sequence of 127 bits that is then repeated inverted.
enum class OpenForce : std::uint8_t { kNone, kConstant, kSteps, kRandom };
enum class Motors : std::uint8_t { kBoth, kFirst, kSecond };  // that the firmware drives

struct GantrySetup {
  bool cascade = false;           // of position: a velocity that a PI keeps, else PositionPi
  bool compensate = false;        // the backlash, of the cascade
  Motors motors = Motors::kBoth;
  OpenForce open = OpenForce::kNone;
  bool home = false;              // at power-on
  bool calibrate = false;         // at power-on, behind that
  bool stream = false;            // position, time and velocity go out every pass
  bool clip_goals = false;        // a goal beyond the track is its end, else refused
  bool checked = false;           // each frame has its checksum behind it, either way
  std::uint32_t gap_clk = 504'774;        // from byte to byte within a frame, longest; 0: any
  std::uint32_t pass_clk = 100'000;       // 2 ms
  std::int32_t cascade_gain = 9;          // K: vref = -(e << K)
  std::int32_t open_force = 0x88;         // positive to the right
  std::uint32_t open_passes = 10;         // of a hold
  std::int32_t home_force = 0x150;
  std::uint32_t home_ticks = 20'000;      // the position unchanged for so long is zero
  std::int32_t fit_force = 0x150;
  std::uint32_t stall_ticks = 0;          // a force and no motion for so long; 0: not watched
  bool watch_sensor = false;              // A and B must lie on a circle
  PositionPi::Config position;
  VelocityPi::Config velocity;
  Compensation compensation;
};

enum class GantryPhase : std::uint32_t {
  kIdle,
  kHoming,
  kToFit,
  kFitting,
  kPosition,
  kVelocity,
  kOpen,
};
enum class GantryFailure : std::uint32_t { kNone, kFitFailed, kStalled, kSensor };

// Points are control passes, the failure is a GantryFailure; the program never ends by itself.
struct GantryMailbox : Mailbox {
  GantryPhase phase = GantryPhase::kIdle;
  std::int32_t error = 0;                // [count]
  std::int32_t goal = 0;                 // [count]
  std::int32_t zero = 0;                 // [count] where homing ended
  std::int32_t velocity = 0;             // filtered
  std::int32_t goal_velocity = 0;
  std::uint32_t unknown = 0;             // frames for no channel
  std::uint32_t refused = 0;             // goals outside of the track
  std::uint32_t unchecked = 0;           // frames without their checksum
  std::uint32_t unsent = 0;              // frames for which there was no room
  std::uint32_t restarts = 0;            // of the observer since the start
  std::uint32_t homed = 0, fitted = 0;   // 1: so
  CalibrationWords words{};              // of the last fit
};

class GantryApp final : public Firmware {
 public:
  explicit GantryApp(const GantrySetup& setup, VelocityFilter* other = nullptr)
      : c_(setup), other_(other) {}

  void start(Bus& bus) override;
  void isr(Bus& bus) override;
  const GantryMailbox& mailbox() const override { return mail_; }

 private:
  void pass(Bus& bus);
  void home(Bus& bus, std::int32_t count, std::uint32_t ticks);
  void go_to_fit(Bus& bus, std::uint32_t ticks);
  void begin_fit(Bus& bus);
  void collect(Bus& bus);
  void end_fit(Bus& bus);
  void observe(Bus& bus, std::uint32_t mask);
  bool failed(Bus& bus, std::uint32_t ticks);
  void fail(Bus& bus, GantryFailure why);
  MotorForces control(std::uint32_t ticks);
  std::int32_t open_force();
  GantryPhase ready(GantryPhase closed) const;
  void go(Bus& bus, MotorForces forces);

  using Frame = gantry_channel::Frame;
  void receive(Bus& bus);
  void check(Bus& bus, const Frame& frame);
  void act(Bus& bus, const Frame& frame);
  void set(Bus& bus, std::uint32_t channel, std::uint32_t value);
  void send(Bus& bus, const Frame& frame);
  std::uint32_t room(Bus& bus) const;
  void poll(Bus& bus, std::uint32_t channel);
  void answer_samples(Bus& bus);
  void describe(Bus& bus);
  void stream(Bus& bus, std::uint32_t ticks);
  std::int32_t millimetres() const;

  GantrySetup c_;
  GantryMailbox mail_;
  PositionPi::State position_;
  VelocityPi::State velocity_;
  MeanFilter filter_;
  VelocityFilter* other_;  // instead of it, or null
  CalibrationFit fit_;
  std::int32_t count_ = 0, units_ = 0;
  std::int32_t still_count_ = 0, near_count_ = 0;  // near: the lower of two neighbours
  std::uint32_t still_tick_ = 0, near_tick_ = 0, last_tick_ = 0, moved_tick_ = 0;
  std::int32_t moved_count_ = 0;
  MotorForces forces_;                    // as last written
  std::uint32_t observed_ = 0x11;  // as last written
  std::uint32_t asked_ = 0;        // conversions that the host waits for, bit = channel
  std::uint32_t lists_ = 0;        // of the configuration, to send
  std::uint32_t described_ = 0;    // words of the first of them, sent
  Frame held_;                            // waits for its checksum
  bool holds_ = false;
  std::uint32_t open_pass_ = 0, open_bits_ = 1;  // open_bits_: of the shift register
  bool open_sign_ = true;
  bool seen_ = false;
  bool released_ = false;  // homing has reached the stop, the motors rest
};

}  // namespace trammel::sw
