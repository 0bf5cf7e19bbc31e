// SPDX-License-Identifier: Apache-2.0
//
// A sampled session of the parts that a machine names: its options, plant, chip, record and
// result. A machine whose figures are of an experiment within the record keeps the result that
// there was at its end as `at_end_`.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "cosim/sampled_session.hpp"

namespace trammel::cosim {

template <class Options, class Plant, class Chip, class Result>
class MachineSession : public SampledSession {
 public:
  std::unique_ptr<RunResult> result() final {
    const bool whole =
        at_end_ && end_ != EndReason::kStopped && end_ != EndReason::kAssertion;
    std::unique_ptr<Result> result = whole ? std::move(at_end_) : result_now();
    result->samples = std::move(samples_);
    result->end = whole ? EndReason::kDone : end_;
    conclude(*result, whole);
    if (result->end == EndReason::kDone && !waves_.found()) miss(*result);
    complete(*result);
    return result;
  }

 protected:
  using Samples = decltype(Result::samples);
  using Sample = typename Samples::value_type;

  // Each `record_s` a sample is recorded; 0: each sample is. `unit`: of the axes in truth().
  // `plant()` makes the plant, rtl(run, window, setup...) and twin(setup...) make the chip.
  template <class MakePlant, class Rtl, class Twin, class... Setup>
  MachineSession(const Options& options, const Hooks& hooks, const Waves& waves, double record_s,
                 const char* unit, MakePlant plant, Rtl rtl, Twin twin, const Setup&... setup)
      : SampledSession(record_s, hooks, options.run, options.fault, options.processor, waves),
        options_(options),
        plant_(plant()),
        chip_(options.run.engine == Engine::kRtl ? rtl(options.run, waves.window, setup...)
                                                 : twin(setup...)) {
    wire(*chip_, plant_, fault_pins(options_), unit);
  }

  virtual Sample sample_at(Clk edge) const = 0;
  virtual void look(const Sample&) {}  // each one, until the experiment has ended
  virtual void mix(const Sample& sample) = 0;  // one that is recorded, into the hash
  virtual std::unique_ptr<Result> result_now() const = 0;  // but its samples and how it ended
  virtual void conclude(Result&, bool /*whole*/) {}  // with both; whole: it is at_end_
  virtual std::string missed(const Result&) const = 0;  // why a run to the end is not done, or ""

  void miss(Result& result) const {
    std::string why = missed(result);
    if (why.empty()) return;
    result.fault = std::move(why);
    result.end = EndReason::kMissed;
  }

  Options options_;
  Plant plant_;
  std::unique_ptr<Chip> chip_;
  Samples samples_;
  std::unique_ptr<Result> at_end_;

 private:
  void sampled(Clk edge, bool recorded) final {
    const Sample sample = sample_at(edge);
    if (!at_end_) {
      look(sample);
      if (at_end_) at_end_->supplied_J = plant_.supplied(edge);
    }
    if (!recorded) return;
    samples_.push_back(sample);
    mix(sample);
  }
};

}  // namespace trammel::cosim
