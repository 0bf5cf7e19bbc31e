// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/errors.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/precision/figures.hpp"
#include "machines/kung/precision/plan.hpp"
#include "machines/kung/run/cpu.hpp"
#include "machines/kung/run/failure.hpp"
#include "machines/kung/run/response.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::kung {

namespace {
constexpr std::uint32_t kSamplesAfterFault = 20;  // enough to see the fault's effect in the record
constexpr std::uint32_t kLongestStop = 2000;      // a table that pushes on does not come to rest
constexpr double kAtRest_m_s = 1e-3;

}  // namespace

Session::Session(const Options& options, const Hooks& hooks, const cosim::Waves& waves)
    : SessionOf(hooks, options.run, options.fault, options.processor, waves),
      options_(options),
      plan_(plan_of(options)) {
  sw::KungSetup setup = plan_->setup;
  setup.precision.corrections = &corrections_;
  const sw::Trajectory path(setup);
  const sw::Point start = path.start();
  path_points_ = path.size();
  outcome_.emplace(*plan_);
  commanded_.emplace(path, static_cast<std::uint32_t>(ticks_per_point(options_)),
                     options_.plant.axis[0].encoder_count_m,
                     contour_reach(options_.lag_s(), options_.chip.sample_s()));
  options_.plant.axis[0].start_m = start.x * options_.plant.axis[0].encoder_count_m;
  options_.plant.axis[1].start_m = start.y * options_.plant.axis[1].encoder_count_m;
  plant_ = std::make_unique<TablePlant>(options_.run.clocked(options_.plant));
  chip_ = make_chip();
  firmware_ = std::make_unique<StallableApp>(setup, *chip_, hung());
  if (options_.cpu == Cpu::kRtl) {
    core_ = core_of(options_, setup);
    core_->break_at(hung().begin);
    if (!options_.uart.empty()) {
      console_ = std::make_unique<SerialConsole>(options_.uart,
                                                 [this] { return core_->listens(); });
      core_->connect(console_->host());
    }
  }
  recorder_ = std::make_unique<Recorder>(*chip_, plant_->table(),
                                         options_.controller == Controller::kPrecision,
                                         [this](const Sample& sample) { return over(sample); });
  snapshot_ = std::make_unique<SnapshotRecorder>(
      *chip_, plant_->table(), options_.run.clocks(1.0 / options_.chip.carrier_Hz));
  watch_trips();
  wire(*chip_, *plant_, fault_pins(options_));
}

void Session::on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant& plant) {
  snapshot_->on(stop, chip, plant);
  recorder_->on(stop, chip, plant);
  // A trip turns the gates off and interrupts: their own many changes tell nothing more.
  const bool trips = !options_.fault.any() || options_.fault.kind == cosim::FaultKind::kTripPin ||
                     options_.fault.kind == cosim::FaultKind::kEncoderJump ||
                     options_.fault.kind == cosim::FaultKind::kProcessorHung;
  const unsigned watched =
      trips ? cosim::kIrq | cosim::kBusDone | cosim::kTick : ~cosim::kLimit;
  if ((stop.why & watched) != 0) watch_fault(stop);
}

cosim::FaultSpan Session::hung() const {
  if (options_.fault.kind != cosim::FaultKind::kProcessorHung) return {};
  return {options_.fault, options_.run.clock_ps};
}

std::unique_ptr<KungChip> Session::make_chip() {
  const cosim::RunOptions& run = options_.run;
  if (run.engine == Engine::kTwin) return make_twin_chip();
  if (waves_.search != nullptr) return make_watched_chip(*waves_.search, run.leap);
  return make_verilated_chip(run, waves_.window);
}

const sw::Mailbox& Session::mailbox() const {
  return core_ ? core_->mailbox() : firmware_->mailbox();
}

// Its output is at the chip's trip input.
void Session::trapped(const cosim::CoreTrap& trap) {
  trap_text_ = fmt::format("the processor: illegal instruction or misaligned access at {:#010x}",
                           trap.address);
  plant_->trip_from(trap.edge);
}

void Session::core_ran(const cosim::CoreTimes& times) {
  result_.core = times;
  result_.core_awake = core_->awake();
  if (console_) result_.uart = console_->heard();
}

std::string Session::detected_by() const {
  const Fault fault = chip_->fault();
  return fault.code != FaultCode::kNone ? cause_text(fault) : check_text(mailbox());
}

cosim::FaultTruth Session::truth(cosim::Clk edge) const {
  cosim::FaultTruth now;
  for (std::size_t a = 0; a < kAxes; ++a) {
    const plant::AxisState state = plant_->table().state(static_cast<int>(a), edge);
    now.at.push_back(1e3 * state.x_m);
    now.current_A = std::max({now.current_A, std::abs(state.i_a_a), std::abs(state.i_b_a),
                              std::abs(state.i_a_a + state.i_b_a)});
    now.at_stop = now.at_stop || plant_->table().at_stop(static_cast<int>(a));
  }
  return now;
}

// The table's way to rest is recorded, too.
bool Session::fault_is_over(const Sample& sample) {
  if (after_fault_++ == 0) result_.end_tick = std::max(sample.tick, result_.first_tick + 1);
  const bool rests = std::abs(sample.axis[0].v_true_m_s) + std::abs(sample.axis[1].v_true_m_s) <
                     kAtRest_m_s;
  return after_fault_ > kSamplesAfterFault && (rests || after_fault_ > kLongestStop);
}

cosim::ProcessorTiming Session::timing() const {
  namespace reg = kung_xy_regs;
  cosim::ProcessorTiming timing = SessionOf::timing();
  timing.compute = options_.point_clk;
  timing.computed = reg::kX + (options_.path.open_position() ? reg::kIqManual : reg::kPosCmd);
  return timing;
}

bool Session::over(const Sample& sample) {
  if (waves_.found()) return true;
  if (chip_->failed_assertion()) return true;
  const auto period = static_cast<std::uint32_t>(ticks_per_point(options_));
  const sw::Mailbox& mail = mailbox();
  const Fault fault = chip_->fault();
  if (fault.code != FaultCode::kNone || mail.failure != 0) {
    if (after_fault_ == 0) result_.fault = fault;  // what comes on the way to rest is no cause
    end_ = EndReason::kFault;
    const bool chip = result_.fault.code != FaultCode::kNone;
    result_.fault.processor = chip || !trap_text_.empty() ? trap_text_ : check_text(mail);
    return fault_is_over(sample);
  }
  if (hooks_.stopped()) {
    end_ = EndReason::kStopped;
    return true;
  }
  const bool precise = options_.controller == Controller::kPrecision;
  if (mail.point == 0) {
    const double swing = precise ? swing_m(options_, sample) : 0;
    if (swing == 0) return false;
    end_ = EndReason::kDiverged;
    result_.swing_m = swing;
    return true;
  }
  if (result_.points == 0) snapshot_->path_begins();
  result_.first_tick = mail.first_tick;
  result_.points = mail.point;
  result_.end_tick = result_.first_tick + path_points_ * period;
  for (std::size_t k = 0; k < 2; ++k) {
    const AxisSample& axis = sample.axis[k];
    const double error =
        model_m(axis, options_.plant.axis[k].encoder_count_m) - axis.x_true_m;
    if (sample.tick >= result_.first_tick && std::abs(error) > options_.diverged_m) {
      end_ = EndReason::kDiverged;
      return true;
    }
  }
  if (precise) limits_.on(sample, core_ ? nullptr : &firmware_->mailbox(), result_);
  if (sample.tick >= result_.first_tick && !options_.path.is_sweep()) {
    const PointM table{sample.axis[0].x_true_m, sample.axis[1].x_true_m};
    const double beside =
        commanded_->distance_m(table, std::min(outcome_->limit_m(), options_.diverged_m));
    outcome_->add(table, beside);
    if (beside > options_.diverged_m) {
      end_ = EndReason::kDiverged;
      result_.beside_m = beside;
      return true;
    }
  }
  const auto settle = static_cast<std::uint32_t>(
      std::lround(options_.settle_s / options_.chip.sample_s()));
  const std::uint32_t last = result_.end_tick + settle - 1;
  if (hooks_.progress && sample.tick % 20 == 0) {
    hooks_.progress(static_cast<double>(sample.tick) / last);
  }
  if (sample.tick < last) return false;
  end_ = EndReason::kDone;
  return true;
}

std::vector<cosim::Place> Session::places() const {
  const plant::XyTable& table = plant_->table();
  const cosim::Clk now = chip_->now();
  return {{"x", "m", table.state(0, now).x_m}, {"y", "m", table.state(1, now).x_m}};
}

std::unique_ptr<cosim::RunResult> Session::result() {
  result_.end = end_;
  result_.samples = recorder_->take_samples();
  result_.laws = recorder_->take_laws();
  result_.event_hash = recorder_->event_hash();
  result_.snapshot = snapshot_->take();
  result_.wakes = chip_->wakes();
  result_.from_last_m = outcome_->from_m(commanded_->commanded());
  if (options_.controller == Controller::kPrecision && !core_) {
    const sw::KungMailbox& found = firmware_->mailbox();
    result_.estimates = {estimate_of(options_, 0, found.estimator(0)),
                         estimate_of(options_, 1, found.estimator(1))};
  }
  if (result_.end == EndReason::kDone) {
    result_.all_points = result_.points == path_points_;
    if (options_.controller == Controller::kPrecision) {
      result_.error_m = largest_error_m(*plan_, result_);
    }
    result_.missed = options_.path.is_sweep()
                         ? unmeasured(*plan_, result_)
                         : outcome_->missed(result_.points, path_points_, commanded_->commanded(),
                                            commanded_->commanded(model_lag(options_)),
                                            result_.error_m);
    if (!result_.missed.empty()) result_.end = EndReason::kMissed;
  }
  complete(result_);
  if (core_ && !core_->moved().empty() && !result_.assertion) {
    result_.assertion = {"waiting_core_stands_still", "soc_host", core_->moved(), chip_->now()};
    result_.end = EndReason::kAssertion;
  }
  return std::make_unique<Result>(std::move(result_));
}

}  // namespace trammel::kung
