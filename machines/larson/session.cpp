// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/session.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "machines/larson/machine.hpp"
#include "machines/larson/signals.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::larson {
namespace {

constexpr double kLongestSettling = 5;  // [s] of buffers that still hold pulses

plant::StepperAxisConfig axis_of(const Options& options, double start) {
  plant::StepperAxisConfig axis = options.run.clocked(options.axis);
  axis.start = start;
  axis.input = {1e-6 * options.width_us, 1e-6 * options.setup_us, 1e-6 * options.hold_us};
  return axis;
}

sw::StepTableSetup table_of(const Options& options) {
  const auto clocks = [&options](double ms) {
    return static_cast<std::uint32_t>(options.run.clocks(1e-3 * ms));
  };
  sw::StepTableSetup table = options.table;
  table.poll_clk = clocks(options.poll_ms);
  table.settle_clk = clocks(options.wttbl_ms);
  return table;
}

std::vector<sw::LarsonCall> program_of(const std::vector<Call>& calls) {
  std::vector<sw::LarsonCall> program;
  program.reserve(calls.size());
  for (const Call& one : calls) program.push_back(one.call);
  return program;
}

}  // namespace

cosim::FaultPins fault_pins(const Options&) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"X", "Y"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, "limit switch: low, high"},
                 {K::kEncoderSwapped, K::kIndexLost, 0, ""},
                 {K::kOutputStuck, K::kOutputStuck, kOutputs, "output: step, direction, flush"},
                 {K::kPhaseOpen, K::kPhaseOpen, 1, "phase"}};
  for (int axis = 0; axis < kAxes; ++axis) {
    pins.inputs.push_back({limit_low(axis), limit_high(axis), buf_busy(axis)});
  }
  return pins;
}

Session::Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves)
    : SampledSession(1e-3 * options.record_ms, hooks, options.run, options.fault,
                     options.processor, waves),
      options_(options),
      calls_(calls_of(options)),
      program_(program_of(calls_)),
      answers_(calls_.size()),
      plant_(axis_of(options, options.start_x), axis_of(options, options.start_y)),
      chip_(options.run.engine == cosim::Engine::kRtl
                ? make_verilated_chip(options.run, waves.window, {record_clk_})
                : make_twin_chip({record_clk_})),
      app_(table_of(options), program_.data(), answers_.data(),
           static_cast<std::uint32_t>(program_.size())),
      switches_(plant_.switches()),
      asked_{plant_.axis(0).translated(), plant_.axis(1).translated()},
      heard_(heard_at(0)),
      last_at_{at(0, 0), at(1, 0)} {
  wire(*chip_, plant_, fault_pins(options_), "step");
}

// What the program has seen of a fault: a failure, or an error return.
std::string Session::noticed() const {
  if (app_.mailbox().failure != 0) return "CALTBL";
  for (std::size_t k = 0; k < done_.size(); ++k) {
    const cosim::FaultSpan span(options_.fault, period_ps());
    if (calls_[k].call.op == sw::LarsonOp::kWttbl && answers_[k].value == 0 &&
        done_[k].edge >= span.begin) {
      return "WTTBL";
    }
  }
  return "";
}

cosim::FaultTruth Session::truth(cosim::Clk edge) const {
  cosim::FaultTruth now;
  for (std::size_t k = 0; k < 2; ++k) {
    now.at.push_back(at(k, edge));
    now.at_stop = now.at_stop || plant_.axis(k).hit_stop();
  }
  return now;
}

// It is asked to move, or pulses wait.
bool Session::moving(std::size_t axis) const {
  const bool busy =
      (chip_->words(static_cast<int>(axis)) >> 16 & sw::larson_map::kBusy) != 0;
  return busy || plant_.axis(axis).waiting() > 0;
}

bool Session::resting() const { return !moving(0) && !moving(1); }

// [step] The Y axis leans by its perpendicularity.
std::array<double, 2> Session::platform(cosim::Clk edge) const {
  const double lean = std::tan(options_.perpendicularity_arcsec / 3600 * 0.017453292519943295);
  const double y = plant_.axis(1).platform(edge);
  return {plant_.axis(0).platform(edge) + lean * y, y};
}

CallDone Session::heard_at(cosim::Clk edge) const {
  return {edge, {at(0, edge), at(1, edge)}, platform(edge), {moving(0), moving(1)}};
}

void Session::noted(const cosim::Stop& stop) {
  if ((stop.why & (cosim::kBusDone | cosim::kIrq)) != 0) heard_ = heard_at(stop.edge);
  note_events(stop);
}

void Session::sampled(cosim::Clk edge, bool recorded) {
  const Sample sample = sample_at(edge);
  if ((edge + 1) % kLook == 0) look(sample);
  if (!recorded) return;
  samples_.push_back(sample);
  for (const AxisSample& axis : sample.axis) hash_.mix(axis.words);
}

// Up to the last one within record.settle_s of the last call; the record ends with its own sample.
void Session::look(const Sample& now) {
  if (at_end_) return;
  looks_.push_back(now);
  for (std::size_t k = 0; k < 2; ++k) {
    travel_[k] += std::fabs(now.axis[k].at - last_at_[k]);
    last_at_[k] = now.axis[k].at;
  }
  if (app_.mailbox().done == 0) return;
  const double since = cosim::seconds_of(now.edge + kLook - ended_, period_ps());
  if (since <= options_.settle_s || (!resting() && since <= kLongestSettling)) return;
  note_plant();  // up to here
  at_end_ = result_now();
}

// Calls that have ended since the last stop: when the processor last heard of the chip, which is
// the same in every wiring; a stop is where the look-ahead happens to end.
void Session::note_calls() {
  while (done_.size() < app_.mailbox().point) {
    if (calls_[done_.size()].call.op == sw::LarsonOp::kCaltbl) {
      for (std::size_t k = 0; k < 2; ++k) {
        const plant::StepperAxis& axis = plant_.axis(k);  // the last pulses are forward
        origin_[k] =
            static_cast<double>(axis.translated() + axis.waiting() - axis.steps_lost());
      }
    }
    CallDone done = heard_;
    for (std::size_t k = 0; k < 2; ++k) {
      done.at[k] -= origin_[k];
      done.platform[k] -= origin_[k];
    }
    done_.push_back(done);
  }
  if (app_.mailbox().done != 0 && ended_ == cosim::kNever) ended_ = heard_.edge;
}

std::int64_t Session::read(std::size_t signal, int axis) const {
  const auto k = static_cast<std::size_t>(axis);
  switch (static_cast<SignalOf>(signal)) {
    case SignalOf::kCount: return chip_->words(axis) & 0xFFFF;
    case SignalOf::kStatus: return chip_->words(axis) >> 16;
    case SignalOf::kWaiting: return plant_.axis(k).waiting();
    case SignalOf::kCall: return app_.mailbox().point;
    case SignalOf::kSwitches: return plant_.switches();
  }
  return 0;
}

Sample Session::sample_at(cosim::Clk edge) const {
  Sample sample;
  sample.edge = edge;
  const std::array<double, 2> platforms = platform(edge);
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::StepperAxis& axis = plant_.axis(k);
    const plant::StepperMotor::State state = axis.state(edge);
    sample.axis[k] = {chip_->words(static_cast<int>(k)),
                      static_cast<std::int32_t>(axis.translated()),
                      axis.waiting(),
                      state.at,
                      state.speed,
                      axis.load_angle(edge),
                      axis.rate(),
                      static_cast<std::int32_t>(asked_[k]),
                      platforms[k],
                      axis.torque(edge),
                      axis.current(),
                      axis.power(edge)};
  }
  sample.call = app_.mailbox().point;
  sample.switches = plant_.switches();
  sample.irq = chip_->irq();
  return sample;
}

double Session::progress() const {
  return app_.mailbox().point / static_cast<double>(calls_.size());
}

std::optional<cosim::EndReason> Session::ending(cosim::Clk edge) {
  if (app_.mailbox().done == 0) return {};
  if (done_at_ == cosim::kNever) done_at_ = edge;
  const double since = cosim::seconds_of(edge - done_at_, period_ps());
  if (since < options_.settle_s || (!resting() && since < kLongestSettling)) return {};
  return app_.mailbox().failure != 0 ? cosim::EndReason::kFault : cosim::EndReason::kDone;
}

std::vector<cosim::Place> Session::places() const {
  const cosim::Clk now = chip_->now();
  return {{"x", "step", at(0, now)}, {"y", "step", at(1, now)}};
}

// All but samples, looks and how it ended.
std::unique_ptr<Result> Session::result_now() const {
  auto result = std::make_unique<Result>();
  if (app_.mailbox().failure != 0) result->fault = "CALTBL found no switch, or could not leave it";
  result->calls = calls_;
  result->answers = answers_;
  result->done = done_;
  result->happened = events_;
  result->happened_count = event_count_;
  result->pulses = pulses_;
  for (std::size_t k = 0; k < 2; ++k) {
    result->lost[k] = std::abs(plant_.axis(k).steps_lost());
    result->slips[k] = plant_.axis(k).lost();
    result->breaches[k] = plant_.axis(k).breaches();
    result->moves[k] = plant_.axis(k).moves();
    result->peaks[k] = plant_.axis(k).peaks();
    result->mean_current[k] = plant_.axis(k).mean_current(looks_.empty() ? 0 : looks_.back().edge);
  }
  result->rates = rates_;
  result->travel = travel_;
  result->end_at = last_at_;
  result->origin = origin_;
  result->known = app_.mailbox().known;
  result->calibrated = app_.mailbox().calibrated != 0;
  result->stopped = app_.mailbox().stopped;
  result->interrupts = interrupts_;
  result->err_byte = chip_->err_byte();
  return result;
}

std::unique_ptr<cosim::RunResult> Session::result() {
  using End = cosim::EndReason;
  const bool whole = at_end_ && end_ != End::kStopped && end_ != End::kPromise;
  auto result = whole ? std::move(at_end_) : result_now();
  result->samples = std::move(samples_);
  result->looks = std::move(looks_);
  result->end = !whole ? end_ : result->fault.empty() ? End::kDone : End::kFault;
  if ((result->end == End::kDone && !waves_.found()) || result->end == End::kFault) {
    if (std::string missed = what_missed(options_, *result); !missed.empty()) {
      result->fault = std::move(missed);
      result->end = End::kMissed;
    }
  }
  if (result->end == End::kTimeout) result->fault = what_was_running(options_, *result);
  complete(*result);
  return result;
}

}  // namespace trammel::larson
