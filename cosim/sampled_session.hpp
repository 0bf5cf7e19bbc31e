// SPDX-License-Identifier: Apache-2.0
//
// What the sessions of machines share beside their rig.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "cosim/event_hash.hpp"
#include "cosim/rig.hpp"
#include "cosim/session.hpp"

namespace trammel::cosim {

// A rig with firmware at the bus.
template <class Base>
class SessionOf : public Session, public Base {
 public:
  Loop& loop() final { return Base::loop(); }
  ProcessorTiming timing() const override { return Base::timing(); }
  std::int64_t period_ps() const final { return Base::period_ps(); }
  Clk end() const final { return Base::end(); }
  bool stopped() const final { return end_ == EndReason::kStopped; }

 protected:
  template <class... Arguments>
  explicit SessionOf(const Hooks& hooks, Arguments&&... arguments)
      : Base(std::forward<Arguments>(arguments)...), hooks_(hooks) {}

  Hooks hooks_;
  EndReason end_ = EndReason::kTimeout;
};

// One that records samples and hashes its events.
class SampledSession : public SessionOf<Rig>, public SignalReader {
 public:
  bool finished() const final { return over_; }

 protected:
  using SessionOf<Rig>::SessionOf;
  // Of its samples those at multiples of `record_s` are recorded.
  SampledSession(double record_s, const Hooks& hooks, const RunOptions& run, const Fault& fault,
                 const ProcessorOptions& processor, const Waves& waves)
      : SessionOf(hooks, run, fault, processor, waves),
        record_clk_(std::max<Clk>(1, run.clocks(record_s))) {}

  // At each stop of the loop its events are noted first, then the sample, if one was published.
  void on(const Stop& stop, const Chip& chip, const Plant& plant) final;

  virtual void passed() {}                                // a stop, before all else
  virtual void noted(const Stop&) {}                      // its events
  virtual void sampled(Clk edge, bool recorded) = 0;
  virtual double progress() const = 0;                    // 1: the program has ended
  // After a sample of the record; of most machines when the program has ended.
  virtual std::optional<EndReason> ending(Clk edge);

  void complete(RunResult& result) const;  // all that the machine does not know itself

  const Clk record_clk_ = 1;  // between two samples of the record; 1: each sample is one
  EventHash hash_;

 private:
  std::optional<EndReason> ended(Clk edge);

  std::size_t recorded_ = 0;
  bool over_ = false;
};

}  // namespace trammel::cosim
