// SPDX-License-Identifier: Apache-2.0
//
// What runs of all machines have in common.
#pragma once

#include <atomic>
#include <functional>
#include <stdexcept>

namespace trammel::cosim {

enum class Platform { kSystemC, kDirect };

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
