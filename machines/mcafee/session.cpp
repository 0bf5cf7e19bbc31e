// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "machines/mcafee/machine.hpp"
#include "machines/mcafee/twin.hpp"

namespace trammel::mcafee {
namespace {

constexpr double kAtRest_mm_s = 0.1;

Table table_for(const Options& o) {
  if (o.stage != sw::McafeeStage::kTrack) return {};
  return make_table(o.path, o.count_mm(), o.travel_mm());
}

const char* what_failed(const sw::Mailbox& mailbox) {
  switch (static_cast<sw::McafeeFailure>(mailbox.failure)) {
    case sw::McafeeFailure::kReset: return "a status after reset that the data sheet has not";
    case sw::McafeeFailure::kBusy: return "a busy bit that did not clear";
    case sw::McafeeFailure::kCommandError: return "a command error of a part";
    case sw::McafeeFailure::kPositionError: return "a position error of a part";
    case sw::McafeeFailure::kLimit: return "a limit switch";
    case sw::McafeeFailure::kIndex: return "an index that is not a turn from the one before";
    case sw::McafeeFailure::kLate:
      return "a sample between the STT of both axes: the processor is too slow "
             "(processor.access_clk, processor.interrupt_latency_clk)";
    case sw::McafeeFailure::kNone: break;
  }
  return "";
}

}  // namespace

cosim::FaultPins fault_pins(const Options&) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"X", "Y"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, "encoder: A, B"},
                 {K::kEncoderMissing, K::kIndexLost, 0, ""},
                 {K::kOutputStuck, K::kOutputStuck, 8, "output: bit of the converter's code"},
                 {K::kPhaseOpen, K::kPhaseOpen, 1, "winding"}};
  for (int axis = 0; axis < kAxes; ++axis) {
    pins.inputs.push_back({encoder_a(axis), encoder_b(axis), marker(axis)});
  }
  return pins;
}

unsigned StagePlant::limits() const {
  unsigned lines = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::LeadscrewSensor& s = stage_.axis(k).sensor();
    lines |= (s.at_low() ? 1u : 0u) << 2 * k | (s.at_high() ? 2u : 0u) << 2 * k;
  }
  return lines;
}

cosim::Lines StagePlant::sense() const {
  cosim::Lines lines = cosim::Lines{limits()} << limit_low(0);
  for (int axis = 0; axis < kAxes; ++axis) {
    const plant::SineEncoder& e =
        stage_.axis(static_cast<std::size_t>(axis)).sensor().encoder();
    lines |= cosim::Lines{e.a()} << encoder_a(axis) | cosim::Lines{e.b()} << encoder_b(axis) |
             cosim::Lines{!e.marker()} << marker(axis);
  }
  return lines;
}

sw::McafeeSetup setup_of(const Options& o, const Table& table) {
  const std::int64_t period_ps = o.run.clock_ps;
  sw::McafeeSetup setup;
  setup.stage = o.stage;
  setup.filter = o.filter;
  setup.wait_clk = static_cast<std::uint32_t>(cosim::clocks_of(o.wait_s, period_ps));
  setup.readings = static_cast<std::uint32_t>(o.readings);
  setup.sample_clk = static_cast<std::uint32_t>(cosim::clocks_of(o.sample_s(), period_ps));
  setup.acceleration = o.acceleration;
  setup.velocity = o.velocity;
  setup.position = o.position;
  setup.rows = table.rows.data();
  setup.row_count = static_cast<std::uint32_t>(table.rows.size());
  setup.index_counts =
      o.index_check ? static_cast<std::uint32_t>(4 * o.stage_axis.encoder.lines) : 0;
  setup.error_limit = static_cast<std::uint32_t>(o.error_limit);
  setup.speed = static_cast<std::uint32_t>(o.speed);
  setup.least_speed = static_cast<std::uint32_t>(o.least_speed);
  setup.velocity_shift = static_cast<std::uint32_t>(o.velocity_shift);
  return setup;
}

Session::Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves)
    : SampledSession(hooks, options.run, options.fault, options.processor, waves),
      options_(options),
      table_(table_for(options)),
      plant_({options.run.clocked(options.stage_axis), options.run.clocked(options.stage_axis)}),
      chip_(options.run.engine == cosim::Engine::kRtl
                ? make_verilated_chip(options.run, waves.window, options.clock_MHz)
                : make_twin_chip(options.clock_MHz)),
      app_(setup_of(options, table_)) {
  wire(*chip_, plant_, fault_pins(options_));
}

bool Session::drives_off() const {
  return chip_->drive() == codes(kZeroCode, kZeroCode);
}

std::string Session::noticed() const { return what_failed(app_.mailbox()); }

cosim::FaultTruth Session::truth(cosim::Clk edge) const {
  cosim::FaultTruth now;
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::LeadscrewAxis& axis = plant_.stage().axis(k);
    const plant::DcMotorState state = axis.state(edge);
    now.at.push_back(1e3 * state.theta / axis.sensor().radians_per_m());
    now.current_A = std::max(now.current_A, std::abs(state.i));
  }
  now.at_stop = plant_.limits() != 0;
  return now;
}

void Session::sampled(cosim::Clk edge, bool) {
  samples_.push_back(sample_at(edge));
  for (const AxisSample& axis : samples_.back().axis) {
    hash_.mix(static_cast<std::uint64_t>(axis.words.position));
    hash_.mix(static_cast<std::uint32_t>(axis.words.actual));
  }
}

std::int64_t Session::read(std::size_t signal, int axis) const {
  const std::size_t own = lm628::signals().size();
  if (signal < own) return lm628::word(chip_->words(axis), signal);
  switch (static_cast<OwnSignal>(signal - own)) {
    case OwnSignal::kRow: return rows();
    case OwnSignal::kSpeed: return app_.mailbox().speed;
    case OwnSignal::kLimits: return plant_.limits();
  }
  return 0;
}

Sample Session::sample_at(cosim::Clk edge) const {
  Sample sample;
  sample.edge = edge;
  for (std::size_t k = 0; k < 2; ++k) {
    const plant::LeadscrewAxis& axis = plant_.stage().axis(k);
    const plant::DcMotorState state = axis.state(edge);
    const double mm = 1e3 / axis.sensor().radians_per_m();  // a radian
    const int part = static_cast<int>(k);
    sample.axis[k] = {chip_->words(part), chip_->host_irq(part), mm * state.theta,
                      mm * state.omega,   state.i,               axis.voltage()};
  }
  sample.limits = plant_.limits();
  sample.row = rows();
  sample.v = app_.mailbox().speed;
  return sample;
}

std::optional<cosim::EndReason> Session::ending(cosim::Clk) {
  const Sample& sample = samples_.back();
  if (app_.mailbox().failure != 0) {
    end_ = cosim::EndReason::kFault;  // also where the run ends before the way to rest does
    const double speed = std::hypot(sample.axis[0].mm_s, sample.axis[1].mm_s);
    if (options_.fault.any() && !coast_.over(speed < kAtRest_mm_s)) return {};
    return end_;
  }
  const auto off = [&](const AxisSample& axis) {
    return std::abs(axis.words.error) > options_.diverged_counts;
  };
  if (std::any_of(sample.axis.begin(), sample.axis.end(), off)) return cosim::EndReason::kDiverged;
  if (app_.mailbox().done != 0) return cosim::EndReason::kDone;
  return {};
}

double Session::progress() const {
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 1; };
  switch (options_.stage) {
    case sw::McafeeStage::kRead: return share(app_.mailbox().point, options_.readings);
    case sw::McafeeStage::kMove:
      return share(std::abs(chip_->words(0).actual), std::abs(options_.position));
    case sw::McafeeStage::kTrack: break;
  }
  return share(app_.mailbox().point, static_cast<double>(table_.rows.size()));
}

std::vector<cosim::Place> Session::places() const {
  const cosim::Clk now = chip_->now();
  const plant::XyStage& stage = plant_.stage();
  return {{"x", "mm", 1e3 * stage.axis(0).position(now)},
          {"y", "mm", 1e3 * stage.axis(1).position(now)}};
}

std::unique_ptr<cosim::RunResult> Session::result() {
  auto result = std::make_unique<Result>();
  const sw::Mailbox& mailbox = app_.mailbox();
  result->samples = std::move(samples_);
  result->end = end_;
  result->fault = what_failed(mailbox);
  if (options_.stage == sw::McafeeStage::kRead) result->readings = mailbox.point;
  result->real = {mailbox.real[0], mailbox.real[1]};
  if (end_ != cosim::EndReason::kDone && !result->samples.empty()) {  // it did not ask
    const Sample& last = result->samples.back();
    result->real = {last.axis[0].words.actual, last.axis[1].words.actual};
  }
  result->table = table_;
  find_contour(options_, *result);
  if (end_ == cosim::EndReason::kDone && !waves_.found()) {
    result->fault = what_missed(options_, *result);
    if (!result->fault.empty()) result->end = cosim::EndReason::kMissed;
  }
  complete(*result);
  return result;
}

}  // namespace trammel::mcafee
