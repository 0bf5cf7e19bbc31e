// SPDX-License-Identifier: Apache-2.0
//
// A run that stops where its caller wants and goes on when it is told to: wired directly, in a
// thread of its own that waits while the caller looks around. It stops only while the firmware
// waits for its interrupt; then the bus is free, and the caller may use it as a second master.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cosim/session.hpp"
#include "lab/record.hpp"

namespace trammel::python {

class Stepped {
 public:
  // Throws ConfigError for settings that cannot run so. Returns when the firmware has started.
  explicit Stepped(std::shared_ptr<const lab::Settings> settings);
  ~Stepped();
  Stepped(const Stepped&) = delete;
  Stepped& operator=(const Stepped&) = delete;

  // Asks for this; done() tells when it is so. One at a time.
  void advance(cosim::Clk clocks);
  void access(const cosim::BusOp& op);
  void finish(bool early);  // the rest of the scenario, or none of it

  // Waits at most 50 ms; true when the run stands or is over. Rethrows what the run has thrown.
  bool done();
  void halt() { target_ = 0; }  // the advance ends at the next sample

  // While it stands, or when it is over:
  bool over() const { return over_; }
  cosim::Clk now() const;
  std::int64_t clock_ps() const { return session_->period_ps(); }
  std::uint32_t data() const { return data_; }  // of the last access
  cosim::Lines drive() const;
  cosim::Lines sense() const;
  std::vector<cosim::Place> places() const { return session_->places(); }
  std::vector<std::string> signal_names() const;
  std::optional<std::int64_t> signal(const std::string& name) const;
  std::shared_ptr<const lab::Record> record() const { return record_; }  // when it is over

 private:
  struct Abandoned {};
  struct See final : cosim::Observer {
    void on(const cosim::Stop&, const cosim::Chip&, const cosim::Plant& plant) override {
      seen = &plant;
    }
    const cosim::Plant* seen = nullptr;
  };

  void body();
  cosim::Clk idle(cosim::DirectBus& bus);
  void go(std::function<void()> ask);

  std::shared_ptr<const lab::Settings> settings_;
  std::atomic<bool> stop_{false};
  std::atomic<cosim::Clk> target_{0};
  std::unique_ptr<cosim::Session> session_;
  See see_;
  std::optional<cosim::BusOp> op_;
  std::uint32_t data_ = 0;
  std::shared_ptr<const lab::Record> record_;
  std::exception_ptr error_;

  std::mutex mutex_;
  std::condition_variable changed_;
  bool stands_ = false;  // the thread waits for what comes next
  bool over_ = false;
  bool abandoned_ = false;
  std::thread thread_;
};

}  // namespace trammel::python
