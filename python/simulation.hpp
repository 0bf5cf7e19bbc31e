// SPDX-License-Identifier: Apache-2.0
//
// A run on behalf of Python: it simulates in a thread of its own, which never takes the interpreter
// lock, while the calling thread sleeps without it and wakes to see signals and to tell progress.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace trammel::python {

namespace nb = nanobind;

// Does `work` in another thread. Every 50 ms Python's signal handlers run, and `progress`, if it is
// not None, is called with the fraction done. What either raises sets `stop`, and is raised here
// when the work has ended by it.
template <class Work>
void apart(std::atomic<bool>& stop, const std::atomic<double>& fraction, const nb::object& progress,
           Work work) {
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  std::exception_ptr error, raised;
  std::thread worker([&] {
    try {
      work();
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex);
    done = true;
    ended.notify_one();
  });
  for (bool waiting = true; waiting;) {
    {
      const nb::gil_scoped_release released;
      std::unique_lock<std::mutex> lock(mutex);
      waiting = !ended.wait_for(lock, std::chrono::milliseconds(50), [&] { return done; });
    }
    if (stop) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (!progress.is_none()) progress(waiting ? fraction.load() : 1.0);
    } catch (...) {
      raised = std::current_exception();
      stop = true;
    }
  }
  worker.join();
  if (raised) std::rethrow_exception(raised);
  if (error) std::rethrow_exception(error);
}

}  // namespace trammel::python
