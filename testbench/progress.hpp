// SPDX-License-Identifier: Apache-2.0
//
// A line that rewrites itself, on a terminal only.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

#include "cosim/machine.hpp"

namespace trammel::testbench {

class Progress {
 public:
  explicit Progress(std::string name)
      : name_(std::move(name)), shown_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (drawn_) fmt::print(stderr, "\r\033[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void operator()(double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    drawn_ = true;
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    const double left = fraction > 0 ? elapsed * (1 - fraction) / fraction : 0;
    fmt::print(stderr, "\r\033[K{} {:3.0f} %  {:.0f} s left", name_, 100 * fraction, left);
    std::fflush(stderr);
  }

 private:
  using Time = std::chrono::steady_clock::time_point;
  std::string name_;
  bool shown_;
  bool drawn_ = false;
  Time begin_ = std::chrono::steady_clock::now();
  Time last_{};
};

// What a run tells a person, and asks, while it goes on.
inline cosim::Hooks shown_in(Progress& progress, const std::atomic<bool>& stop) {
  cosim::Hooks hooks;
  hooks.progress = [&progress](double fraction) { progress(fraction); };
  hooks.stop = &stop;
  return hooks;
}

}  // namespace trammel::testbench
