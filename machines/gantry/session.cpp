// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "machines/gantry/machine.hpp"
#include "machines/gantry/signals.hpp"

namespace trammel::gantry {
namespace {

sw::GantrySetup setup_of(const Options& options) {
  sw::GantrySetup setup = options.firmware;
  setup.pass_clk = static_cast<std::uint32_t>(options.run.clocks(1e-3 * options.pass_ms));
  setup.open_passes = static_cast<std::uint32_t>(
      std::max(1.0, std::round(options.open_hold_ms / options.pass_ms)));
  // From byte to byte: the silence, and a byte with a bit to spare.
  setup.gap_clk = options.gap_ms == 0 ? 0
                                      : static_cast<std::uint32_t>(
                                            options.run.clocks(1e-3 * options.gap_ms) +
                                            11 * TrackPlant::kClocksPerBit);
  return setup;
}

bool identifies(const Options& options) {
  return options.firmware.open == sw::OpenForce::kRandom;
}

std::unique_ptr<Estimator> estimator_of(const Options& options) {
  if (options.estimator.filter == Filter::kMean && !identifies(options)) return nullptr;
  return std::make_unique<Estimator>(options.estimator, options.pass_ms, identifies(options));
}

}  // namespace

cosim::FaultPins fault_pins(const Options&) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"motor 1", "motor 2"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2,
                  "input: serial line to the chip, over-temperature of the motor"},
                 {K::kConverterStuck, K::kConverterSlipped, 2,
                  "converter: A for motor 1 or B for motor 2, its derivative"},
                 {K::kOutputStuck, K::kOutputStuck, 2,
                  "output for motor 1: PWM of motor 1, 2, for motor 2: direction of motor 1, 2"},
                 {K::kPhaseOpen, K::kPhaseOpen, 1, "winding"}};
  for (int motor = 0; motor < kMotors; ++motor) pins.inputs.push_back({kRx, overtemp(motor)});
  pins.converter_bits = 10;
  return pins;
}

Session::Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves)
    : SampledSession(1e-3 * options.record_ms, hooks, options.run, options.fault,
                     options.processor, waves),
      options_(options),
      plant_(options.run.clocked(options.axis), options.stripes,
             read_sends(options.sends, options.firmware.checked), options.serial, options.line),
      chip_(options.run.engine == cosim::Engine::kRtl
                ? make_verilated_chip(options.run, waves.window, {record_clk_, ideal_store()})
                : make_twin_chip({record_clk_, ideal_store()})),
      estimator_(estimator_of(options)),
      app_(setup_of(options), estimator_.get()) {
  wire(*chip_, plant_, fault_pins(options_));
}

bool Session::drives_off() const {
  const Words words = chip_->words();
  return words.force[0] == 0 && words.force[1] == 0;
}

cosim::FaultTruth Session::truth(cosim::Clk) const {
  const double cart = plant_.axis().state().x[plant::BeltState::kCart];
  cosim::FaultTruth now;
  now.at = {1e3 * cart};
  now.at_stop = cart < options_.axis.stop_low || cart > options_.axis.stop_high;
  return now;
}

// What chip and program have seen of a fault.
std::string Session::noticed() const {
  const sw::GantryMailbox& mail = app_.mailbox();
  if (mail.failure != 0) return failure();
  if (chip_->words().malformed > 0) return "malformed frame";
  if (mail.unchecked > 0) return "frame without its checksum";
  if (mail.refused > 0) return "goal outside the track";
  if (mail.unknown > 0) return "unknown channel";
  return "";
}

std::string Session::failure() const {
  switch (static_cast<sw::GantryFailure>(app_.mailbox().failure)) {
    case sw::GantryFailure::kFitFailed: return "the calibration run was no steady motion";
    case sw::GantryFailure::kStalled: return "a force and no motion";
    case sw::GantryFailure::kSensor: return "A and B are not on their circle";
    case sw::GantryFailure::kNone: break;
  }
  return "";
}

void Session::sampled(cosim::Clk edge, bool recorded) {
  const Sample sample = sample_at(edge);
  if ((edge + 1) % kLook == 0) look(sample);
  if (!recorded) return;
  samples_.push_back(sample);
  hash_.mix(static_cast<std::uint32_t>(sample.words.position));
  hash_.mix(static_cast<std::uint32_t>(sample.words.velocity));
}

// Up to the end of the experiment; the record ends with its own next sample.
void Session::look(const Look& now) {
  if (at_time_) return;
  looks_.push_back(now);
  follow(now);
  const cosim::Clk time = cosim::clocks_of(options_.time_s, period_ps());
  if (now.edge + 1 > time - kLook) at_time_ = result_now();
}

std::int64_t Session::read(std::size_t signal, int) const {
  switch (static_cast<SignalOf>(signal)) {
    case SignalOf::kPosition: return chip_->words().position;
    case SignalOf::kVelocity: return chip_->words().velocity;
    case SignalOf::kForce: return chip_->words().force[0];
    case SignalOf::kError: return app_.mailbox().error;
    case SignalOf::kRegion: return chip_->words().region;
  }
  return 0;
}

Sample Session::sample_at(cosim::Clk edge) const {
  const plant::BeltAxis axis = plant_.axis().ahead(edge);  // bridges may not have switched for 1 ms
  const plant::BeltState& s = axis.state();
  Sample sample;
  sample.edge = edge;
  sample.words = chip_->words();
  sample.x = s.x[plant::BeltState::kCart];
  sample.v = s.v[plant::BeltState::kCart];
  sample.origin = plant_.origin(edge, sample.words.position);
  sample.motor = {s.x[plant::BeltState::kMotor1] - sample.x,
                  s.x[plant::BeltState::kMotor2] - sample.x};
  for (std::size_t m = 0; m < sample.force.size(); ++m) {
    sample.force[m] = axis.mean_force(m, TrackPlant::kCarrier);
  }
  sample.stripes = {plant_.sample(kA, edge), plant_.sample(kB, edge)};
  sample.flank = {axis.flank(plant::BeltState::kMotor1), axis.flank(plant::BeltState::kMotor2)};
  const sw::GantryMailbox& mail = app_.mailbox();
  sample.error = mail.error;
  sample.goal = mail.goal;
  sample.zero = mail.zero;
  sample.velocity = mail.velocity;
  sample.goal_velocity = mail.goal_velocity;
  sample.phase = static_cast<int>(mail.phase);
  return sample;
}

// The observer against the place that its sensor sees: half a period apart it has lost its count.
void Session::follow(const Look& sample) {
  if (!sample.words.known || lost_s_) return;
  const double period = options_.stripes.period;
  const double from = plant_.axis().seen(sample.edge).x - sample.words.position * period / 16384;
  if (counted_since_ != app_.mailbox().restarts) {
    counted_since_ = app_.mailbox().restarts;
    counted_from_ = from;
  }
  if (std::fabs(from - counted_from_) < period / 2) return;
  lost_s_ = cosim::seconds_of(sample.edge, period_ps());
  lost_mm_ = 1e3 * std::fabs(from - counted_from_);
}

double Session::progress() const {
  return cosim::seconds_of(samples_.back().edge, period_ps()) / options_.time_s;
}

std::optional<cosim::EndReason> Session::ending(cosim::Clk edge) {
  const double now = cosim::seconds_of(edge, period_ps());
  if (app_.mailbox().failure != 0) {  // the way to rest is of the record
    if (!failed_s_) failed_s_ = now;
    constexpr double kAtRest = 1e-4, kLongest = 1;  // [m/s], [s]
    const bool at_rest = std::fabs(samples_.back().v) < kAtRest;
    if (at_rest || now > *failed_s_ + kLongest) return cosim::EndReason::kFault;
  }
  if (now < options_.time_s) return {};
  return cosim::EndReason::kDone;
}

std::vector<cosim::Place> Session::places() const {
  return {{"", "mm", 1e3 * plant_.axis().cart(chip_->now())}};
}

// Why a run that came to its end is not done; "" where it is.
std::string Session::missed(const Result& result) const {
  if (lost_s_) {
    return fmt::format("the observer has lost a stripe: at {:.3f} s it was {:.2f} mm off the cart",
                       *lost_s_, lost_mm_);
  }
  if (result.phase == sw::GantryPhase::kHoming) return "homing did not end";
  if (result.phase == sw::GantryPhase::kToFit || result.phase == sw::GantryPhase::kFitting) {
    return "the calibration run did not end";
  }
  if (options_.reached_mm < 0 || result.looks.empty()) return "";
  const StepFigures step = step_figures(options_, result);
  if (!step.begun) return "the run ended before the last of host.sends (run.reached_mm)";
  if (std::fabs(step.rest_mm) <= options_.reached_mm) return "";
  return fmt::format("the cart is {:.2f} mm from its reference (run.reached_mm)", step.rest_mm);
}

// All but samples, looks and how it ended.
std::unique_ptr<Result> Session::result_now() const {
  auto result = std::make_unique<Result>();
  result->fault = failure();
  const Words words = chip_->words();
  result->heard = plant_.heard();
  const sw::GantryMailbox& mail = app_.mailbox();
  result->passes = mail.point;
  result->unknown = mail.unknown;
  result->refused = mail.refused;
  result->unchecked = mail.unchecked;
  result->unsent = mail.unsent;
  result->malformed = words.malformed;
  result->lost = words.lost;
  result->phase = mail.phase;
  result->homed = mail.homed != 0;
  result->fitted = mail.fitted != 0;
  result->fit = mail.words;
  result->store = chip_->store();
  if (identifies(options_)) {
    result->identified = identification(estimator_->samples(), options_.estimator.dead_samples);
  }
  return result;
}

std::unique_ptr<cosim::RunResult> Session::result() {
  using End = cosim::EndReason;
  const bool whole = at_time_ && end_ != End::kStopped && end_ != End::kPromise;
  auto result = whole ? std::move(at_time_) : result_now();
  result->samples = std::move(samples_);
  result->looks = std::move(looks_);
  result->end = !result->fault.empty() ? End::kFault : whole ? End::kDone : end_;
  if (result->end == End::kDone && !waves_.found()) {
    result->fault = missed(*result);
    if (!result->fault.empty()) result->end = End::kMissed;
  }
  complete(*result);
  return result;
}

}  // namespace trammel::gantry
