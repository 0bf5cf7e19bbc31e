// SPDX-License-Identifier: Apache-2.0
//
// The session of a machine, run in direct wiring, and what each tells of its processor.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <typeinfo>
#include <utility>

#include "cosim/direct.hpp"
#include "cosim/session.hpp"
#include "cosim/trigger_search.hpp"

namespace trammel::test {

inline void run_through(cosim::Session& session) {
  cosim::run_direct(session.loop(), session.firmware(), session.timing(), session.end(),
                    [&session] { return session.finished(); });
}

// The run up to where its trigger is found, or all of it.
template <class Session, class Result, class Options>
Result run_to(const Options& options, cosim::TriggerSearch* search) {
  cosim::Waves waves;
  waves.search = search;
  Session session(options, {}, waves);
  run_through(session);
  const auto result = session.result();
  return std::move(static_cast<Result&>(*result));
}

// Keys of the processor and of the run's end, and what a session must make of them.
template <class Options>
void set_timing(Options& options) {
  options.processor.access_clk = 23;
  options.processor.interrupt_latency_clk = 457;
  options.run.max_s = 0.75;
  options.fault.kind = cosim::FaultKind::kProcessorSlow;
  options.fault.value = 3;
}
inline void check_timing(const cosim::Session& session, std::int64_t period_ps) {
  CHECK(session.timing().access == 23);
  CHECK(session.timing().latency == 457);
  CHECK(session.timing().fault.access(1, 23) == 3 * 23);
  CHECK(session.period_ps() == period_ps);
  CHECK(session.end() == 750'000'000'000 / period_ps);
  CHECK_FALSE(session.finished());
  CHECK_FALSE(session.stopped());
}

// The engine that a run asks for is the one that its session has; `twin` makes one.
template <class Session, class Options, class Twin>
void check_engines(Options options, Twin twin) {
  struct Seen final : cosim::Observer {
    void on(const cosim::Stop&, const cosim::Chip& chip, const cosim::Plant&) override {
      type = &typeid(chip);
    }
    const std::type_info* type = nullptr;
  };
  const auto reference = twin();
  for (const cosim::Engine engine : {cosim::Engine::kTwin, cosim::Engine::kRtl}) {
    options.run.engine = engine;
    Session session(options, {});
    Seen seen;
    session.loop().watch(seen);
    session.loop().advance(100'000, 0);
    REQUIRE(seen.type != nullptr);
    CHECK((*seen.type == typeid(*reference)) == (engine == cosim::Engine::kTwin));
  }
}

}  // namespace trammel::test
