// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "machines/an693/machine_members.hpp"

namespace trammel::an693 {
namespace {

constexpr double kAtRest_rad_s = 0.1;

sw::An693Setup program_setup(const Options& o) {
  sw::An693Setup setup;
  setup.program = o.program;
  setup.converter = o.part.pulses()         ? sw::Lm628Converter::kNone
                    : o.part.dac_bits == 8 ? sw::Lm628Converter::k8Bits
                                           : sw::Lm628Converter::k12Bits;
  setup.filter = o.filter;
  setup.acceleration = o.acceleration;
  setup.velocity = o.velocity;
  setup.position = o.position;
  setup.breakpoint = o.breakpoint;
  setup.index_counts = o.index_check ? static_cast<std::uint32_t>(o.plant.counts) : 0;
  setup.error_limit = static_cast<std::uint32_t>(o.error_limit);
  setup.steps = static_cast<std::uint32_t>(o.steps);
  setup.wait_clk = static_cast<std::uint32_t>(o.run.clocks(o.wait_s));
  return setup;
}

// As long as the trajectory alone takes: ramps and constant speed, and the waits.
double expected_s(const Options& o) {
  const double a = std::max(1, o.acceleration), v = std::max(1, o.velocity);
  const double distance = std::abs(static_cast<double>(o.position)) * 65536;
  const double move = distance > v * v / a ? v / a + distance / v : 2 * std::sqrt(distance / a);
  switch (o.program) {
    case sw::An693Program::kHold: return o.wait_s;
    case sw::An693Program::kAbsolute: return move * o.sample_s() + o.wait_s;
    case sw::An693Program::kRelative: return move * o.sample_s() + 2 * o.wait_s;
    case sw::An693Program::kBreakpoints:
      return (1.5 * o.breakpoint * 65536.0 / v + 2.75 * v / a) * o.sample_s() + o.wait_s;
    case sw::An693Program::kTuning: return o.steps * (move * o.sample_s() + o.wait_s);
  }
  return o.run.max_s;
}

const char* failure_text(const sw::Mailbox& mailbox) {
  switch (static_cast<sw::An693Failure>(mailbox.failure)) {
    case sw::An693Failure::kReset: return "the status after a reset is none of the data sheet's";
    case sw::An693Failure::kBusy: return "the busy bit did not clear";
    case sw::An693Failure::kCommandError: return "the part reported a command error";
    case sw::An693Failure::kPositionError: return "the part reported a position error";
    case sw::An693Failure::kIndex: return "an index is not a turn from the one before";
    case sw::An693Failure::kNone: break;
  }
  return "";
}

}  // namespace

cosim::FaultPins fault_pins(const Options& options) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  const bool pulses = options.part.pulses();
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, "encoder: A, B"},
                 {K::kEncoderMissing, K::kIndexLost, 0, ""},
                 {K::kOutputStuck, K::kOutputStuck,
                  pulses ? lm628::kBridgeLines : lm628::kConverterBits,
                  "output: bit of the converter's code, or MAG, SIGN of an LM629"},
                 {K::kPhaseOpen, K::kPhaseOpen, 1, "winding"}};
  pins.inputs = {{lm628::kEncoderA, lm628::kEncoderB, lm628::kIndex}};
  return pins;
}

Bench::Bench(const Options& options, std::function<bool(const Sample&)> finished,
             const cosim::Waves& waves)
    : Rig(options.run, options.fault, options.processor, waves),
      options_(options),
      plant_(options.run.clocked(options.plant), options.part),
      chip_(options.run.engine == cosim::Engine::kTwin
                ? lm628::make_twin_chip(options.part)
                : lm628::make_verilated_chip(options.run, waves.window, options.part)),
      recorder_(
          *chip_,
          [this](Sample& sample) {
            const plant::DcMotorState s = plant_.axis().state(sample.edge);
            sample.theta = s.theta;
            sample.omega = s.omega;
            sample.i = s.i;
            sample.volt = plant_.voltage(sample.edge);
          },
          std::move(finished)) {
  wire(*chip_, plant_, fault_pins(options_), "counts");
}

cosim::FaultTruth Bench::truth(cosim::Clk edge) const {
  const plant::DcMotorState s = plant_.axis().state(edge);
  const double counts = options_.plant.counts / plant::MotorAxis::kTurn;
  return {{counts * s.theta}, std::abs(s.i), false};
}

// Whether nothing drives the motor: of pulses, for the whole sample.
bool Bench::drives_off() const {
  if (!options_.part.pulses()) return chip_->drive() == lm628::kZeroCode;
  return lm628::share_of_pulse(chip_->drive()) == 0 && output_ >> 8 == 0;
}

// As the loop does before an edge: a line that changes at this clock is seen.
void Bench::load(double torque) {
  plant_.load(chip_->now(), torque);
  chip_->sense(seen().sense());
}

Result Bench::result() {
  Result result;
  result.samples = recorder_.take_samples();
  result.event_hash = recorder_.event_hash();
  complete(result);
  return result;
}

Session::Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves)
    : SessionOf(hooks, options, [this](const Sample& sample) { return over(sample); }, waves),
      app_(program_setup(options)),
      expected_s_(expected_s(options)) {}

std::string Session::detected_by() const { return failure_text(app_.mailbox()); }

bool Session::over(const Sample& sample) {
  if (found() || chip().failed_assertion()) return true;
  const sw::Mailbox& mailbox = app_.mailbox();
  if (mailbox.point != steps_) {
    if (steps_ > 0) step_ends_.push_back(samples_);
    steps_ = mailbox.point;
  }
  ++samples_;
  if (hooks_.stopped()) {
    end_ = cosim::EndReason::kStopped;
    return true;
  }
  if (mailbox.failure != 0) {
    end_ = cosim::EndReason::kFault;
    return !options().fault.any() || coast_.over(std::abs(sample.omega) < kAtRest_rad_s);
  }
  if (std::abs(sample.words.error) > options().diverged_counts) {
    end_ = cosim::EndReason::kDiverged;
    return true;
  }
  if (hooks_.progress && samples_ % 64 == 0) {
    const double simulated_s = static_cast<double>(samples_) * options().sample_s();
    hooks_.progress(std::min(1.0, simulated_s / expected_s_));
  }
  if (mailbox.done == 0) return false;
  step_ends_.push_back(samples_);
  end_ = cosim::EndReason::kDone;
  return true;
}

std::vector<cosim::Place> Session::places() const {
  const double theta = plant().axis().state(chip().now()).theta;
  return {{"", "count", theta / plant::MotorAxis::kTurn * options().plant.counts}};
}

std::unique_ptr<cosim::RunResult> Session::result() {
  auto result = std::make_unique<Result>(Bench::result());
  const sw::Mailbox& mailbox = app_.mailbox();
  if (!result->assertion) result->end = end_;
  result->fault = failure_text(mailbox);
  result->desired = mailbox.desired[0];
  result->real = mailbox.real[0];
  if (end_ != cosim::EndReason::kDone && !result->samples.empty()) {  // it did not come to ask
    const lm628::Words last = result->samples.back().words;
    result->desired = static_cast<std::int32_t>(last.position >> 16);
    result->real = last.actual;
  }
  if (result->end == cosim::EndReason::kDone) {
    result->step_ends = step_ends_;
    result->fault = what_missed(options(), *result);
    if (!result->fault.empty()) result->end = cosim::EndReason::kMissed;
  }
  return result;
}

}  // namespace trammel::an693
