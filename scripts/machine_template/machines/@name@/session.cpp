// SPDX-License-Identifier: Apache-2.0
#include "machines/@name@/session.hpp"

#include <algorithm>
#include <utility>

#include "machines/@name@/machine.hpp"

namespace trammel::@name@ {
namespace {

constexpr double kInterruptS = 1e-3;

sw::@Name@Setup setup(const Options& o) {
  sw::@Name@Setup setup = o.controller;
  setup.interrupts = static_cast<std::uint32_t>(o.duration_s / kInterruptS + 0.5);
  // The timer is written again two accesses after its interrupt is taken.
  const cosim::Clk lost = o.processor.interrupt_latency_clk + 2 * (o.processor.access_clk + 1);
  setup.timer_clk = static_cast<std::uint32_t>(
      std::max<cosim::Clk>(1, cosim::clocks_of(kInterruptS, o.plant.clock_ps) - lost));
  return setup;
}

}  // namespace

// Words of the chip, by their numbers.
const std::vector<cosim::Signal>& signals() {
  static const std::vector<cosim::Signal> all{
      {{"enable", "", "pin of the chip", 1, false}, false},
      {{"duty", "clk", "of a period, the sign is the direction", 13, true}, false},
      {{"count", "count", "encoder counter", 16, true}, false}};
  return all;
}

Session::Session(const Options& options, const cosim::Hooks& hooks, const cosim::Waves& waves)
    : options_(options),
      hooks_(hooks),
      waves_(waves),
      app_(setup(options)),
      plant_(options.plant),
      chip_(make_verilated_chip(options.run, waves.window)),
      loop_(*chip_, plant_, *this, options.run.window()) {}

cosim::Clk Session::end() const { return cosim::clocks_of(options_.run.max_s, period_ps()); }

std::int64_t Session::read(std::size_t signal, int) const {
  return static_cast<std::int32_t>(chip_->word(static_cast<std::uint32_t>(signal)));
}

void Session::on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) {
  if (waves_.search != nullptr) waves_.search->on(stop, *chip_, *this);
  if (over_ || stop.why == cosim::kLimit) return;
  hash_.mix(stop, chip);
  if ((stop.why & cosim::kSample) == 0) return;
  Sample sample;
  sample.edge = stop.edge;
  sample.duty = static_cast<std::int32_t>(read(sw::@name@_words::kDuty, 0));
  sample.count = static_cast<std::int32_t>(read(sw::@name@_words::kCount, 0));
  const plant::DcMotorState s = plant_.state(stop.edge);
  sample.theta = s.theta;
  sample.omega = s.omega;
  sample.i = s.i;
  hash_.mix(static_cast<std::uint32_t>(sample.count));
  samples_.push_back(sample);
  over_ = over();
}

bool Session::over() {
  if (waves_.found() || chip_->broken_promise()) return true;
  if (hooks_.stopped()) {
    end_ = cosim::EndReason::kStopped;
    return true;
  }
  const sw::Mailbox& mailbox = app_.mailbox();
  if (hooks_.progress && samples_.size() % 64 == 0) {
    hooks_.progress(std::min(1.0, mailbox.point * kInterruptS / options_.duration_s));
  }
  if (mailbox.done == 0) return false;
  end_ = mailbox.failure == 0 ? cosim::EndReason::kDone : cosim::EndReason::kFault;
  return true;
}

std::vector<cosim::Place> Session::places() const {
  return {{"", "rad", plant_.state(chip_->now()).theta}};
}

std::unique_ptr<cosim::RunResult> Session::result() {
  auto result = std::make_unique<Result>();
  result->end = end_;
  if (app_.mailbox().failure != 0) result->fault = "the motor does not turn";
  result->samples = std::move(samples_);
  result->event_hash = hash_.value();
  result->events = hash_.events();
  close_result(*result, *chip_, waves_.window, started_);
  return result;
}

}  // namespace trammel::@name@
