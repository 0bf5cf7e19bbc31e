// SPDX-License-Identifier: Apache-2.0
//
// What runs of all machines have in common.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cosim/assertion.hpp"
#include "cosim/cosim.hpp"
#include "cosim/fault_report.hpp"
#include "cosim/waves.hpp"

namespace trammel::cosim {

enum class Platform { kSystemC, kDirect };
enum class Engine { kRtl, kTwin };  // the verilated chip, or its bit-exact twin

inline double seconds_of(Clk clocks, std::int64_t clock_ps) {
  return static_cast<double>(clocks) * static_cast<double>(clock_ps) * 1e-12;
}
inline Clk clocks_of(double seconds, std::int64_t clock_ps) {
  return std::llround(seconds * 1e12 / static_cast<double>(clock_ps));
}

struct RunOptions {
  std::int64_t clock_ps = 20'000;  // of the chip's fabric: 50 MHz, where a machine sets no other
  Platform platform = Platform::kSystemC;
  std::int64_t window_clk = 0;  // longest look-ahead of the loop; 0 = unbounded, 1 = lock step
  bool leap = true;             // waiting clocks are not evaluated; the events stay the same
  bool domains = true;          // clock domains that sleep are not evaluated; the same
  Engine engine = Engine::kRtl;
  bool audit = false;           // a plain and a leaping chip in step, all registers compared; a
                                // difference fails the assertion leap_is_exact
  bool assertions = false;      // the assertions of the RTL are checked; every clock is evaluated
  double max_s = 120;           // simulated time a run may take
  WaveFormat wave = WaveFormat::kNone;
  double wave_begin_s = 0;      // from the start of the run, or from the trigger; both zero: the
  double wave_end_s = 0;        // machine's default window
  std::string wave_trigger;     // an event of the machine's; "" = none
  double wave_pre_s = 0.0002;   // of the default window, before the trigger
  double wave_every_s = 0;      // the window again in every such period; 0 = once
  std::string wave_file;        // set by the program: where the waves go

  Clk window() const { return window_clk == 0 ? kNever : window_clk; }  // as the loop takes it
  Clk clocks(double seconds) const { return clocks_of(seconds, clock_ps); }
  double seconds(Clk clocks) const { return seconds_of(clocks, clock_ps); }
  template <class Plant>
  Plant clocked(Plant settings) const {  // of a plant, with the chip's clock
    settings.clock_ps = clock_ps;
    return settings;
  }
};

struct ProcessorOptions {
  int access_clk = 8;               // clocks one bus access costs besides its handshake
  int interrupt_latency_clk = 100;  // from the interrupt line to the first access
};

// kMissed: the program ended, but the machine is not where it was to go.
enum class EndReason { kDone, kFault, kDiverged, kMissed, kTimeout, kStopped, kAssertion };

// Of a clock domain of the chip: edges at which it was awake. At the others its clock may be off.
struct DomainActivity {
  std::string domain;
  Clk awake = 0;
};

// What a run of any machine gives besides its record.
struct RunResult {
  RunResult() = default;
  RunResult(RunResult&&) = default;
  RunResult& operator=(RunResult&&) = default;
  virtual ~RunResult() = default;
  virtual std::size_t sample_count() const { return 0; }
  virtual std::string fault_text() const { return {}; }  // what stopped it, for people

  // From the start of the run to an edge.
  double seconds(Clk edge) const { return seconds_of(edge, clock_ps); }

  std::int64_t clock_ps = RunOptions().clock_ps;
  EndReason end = EndReason::kTimeout;
  std::optional<FailedAssertion> assertion;  // kAssertion: the first one
  Clk clocks = 0;
  Clk evaluated = 0;                     // of these; the others were leapt over
  std::vector<DomainActivity> activity;  // of the leaping RTL with clock domains
  Clk events = 0;                        // clocks that hold an event; 0: not counted
  double wall_s = 0;
  std::uint64_t event_hash = 0;          // of all drive, interrupt, sample and bus events
  std::optional<Clk> wave_trigger;       // edge at which it fired
  FaultReport fault_report;              // of the fault injected
  std::optional<double> supplied_J;      // energy from the motors' supply; none: not known
  std::vector<WaveSpan> waves;           // what the wave file holds
};

struct Hooks {
  std::function<void(double fraction)> progress;  // may be empty
  const std::atomic<bool>* stop = nullptr;        // set: return what there is, kStopped

  bool stopped() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

// A combination of options that cannot run; the text names the keys and what is allowed.
struct OptionsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace trammel::cosim
