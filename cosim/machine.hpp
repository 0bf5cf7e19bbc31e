// SPDX-License-Identifier: Apache-2.0
//
// What runs of all machines have in common.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

enum class Platform { kSystemC, kDirect };
enum class Engine { kRtl, kTwin };  // the verilated chip, or its bit-exact twin

struct RunBasics {
  Platform platform = Platform::kSystemC;
  std::int64_t window_clk = 0;  // longest look-ahead of the loop; 0 = unbounded, 1 = lock step
  bool leap = true;             // waiting clocks are not evaluated; off: every clock is
  double max_s = 120;           // simulated time a run may take

  Clk window() const { return window_clk == 0 ? kNever : window_clk; }  // as the loop takes it
};

inline double seconds_of(Clk clocks, std::int64_t clock_ps) {
  return static_cast<double>(clocks) * static_cast<double>(clock_ps) * 1e-12;
}
inline Clk clocks_of(double seconds, std::int64_t clock_ps) {
  return std::llround(seconds * 1e12 / static_cast<double>(clock_ps));
}

struct ProcessorOptions {
  int access_clk = 8;               // clocks one bus access costs besides its handshake
  int interrupt_latency_clk = 100;  // from the interrupt line to the first access
};

enum class EndReason { kDone, kFault, kDiverged, kTimeout, kStopped, kPromise };

struct Hooks {
  std::function<void(double fraction)> progress;  // may be empty
  const std::atomic<bool>* stop = nullptr;        // set: return what there is, kStopped
};

// A combination of options that cannot run; the text names the keys and what is allowed.
struct OptionsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace trammel::cosim
