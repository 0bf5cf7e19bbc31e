// SPDX-License-Identifier: Apache-2.0
#include "python/stepped.hpp"

#include <algorithm>
#include <chrono>

#include "cosim/direct.hpp"
#include "host/errors.hpp"
#include "lab/machine.hpp"

namespace trammel::python {

Stepped::Stepped(std::shared_ptr<const lab::Settings> settings) : settings_(std::move(settings)) {
  const lab::Machine& machine = settings_->machine();
  cosim::Hooks hooks;
  hooks.stop = &stop_;
  session_ = lab::with_config_errors(
      [&] { return machine.session(*settings_, hooks, cosim::Waves{}); });
  if (session_->core() != nullptr) {
    throw host::ConfigError("run.cpu: value \"rtl\" cannot run step by step; \"native\" can");
  }
  if (settings_->run.wave != cosim::WaveFormat::kNone) {
    throw host::ConfigError("run.wave: a run step by step dumps no waves; it must be \"none\"");
  }
  session_->loop().watch(see_);
  thread_ = std::thread([this] { body(); });
}

Stepped::~Stepped() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    abandoned_ = true;
    target_ = 0;
  }
  changed_.notify_all();
  thread_.join();
}

void Stepped::body() {
  std::shared_ptr<const lab::Record> record;
  try {
    record = lab::with_config_errors([this] {
      cosim::run_direct(session_->loop(), session_->firmware(), session_->timing(),
                        session_->end(), [this] { return session_->finished(); },
                        [this](cosim::DirectBus& bus) { return idle(bus); });
      return std::make_shared<lab::Record>(lab::judged(settings_, session_->result()));
    });
  } catch (const Abandoned&) {
  } catch (...) {
    error_ = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  record_ = std::move(record);
  over_ = stands_ = true;
  changed_.notify_all();
}

cosim::Clk Stepped::idle(cosim::DirectBus& bus) {
  const cosim::Chip& chip = session_->loop().chip();
  if (chip.now() < target_) return target_;
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    stands_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !stands_ || abandoned_; });
    if (abandoned_) throw Abandoned();
    if (op_) {
      lock.unlock();
      bus.wait_until(chip.now());
      if (op_->write) {
        bus.write(op_->addr, op_->data);
      } else {
        data_ = bus.read(op_->addr);
      }
      lock.lock();
      op_.reset();
      if (chip.irq()) return chip.now() + 1;  // its routine comes first; then it stands again
      continue;
    }
    if (chip.now() < target_) return target_;
  }
}

void Stepped::go(std::function<void()> ask) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (over_) throw host::ConfigError("the run is over: finish() has its record");
  ask();
  stands_ = false;
  changed_.notify_all();
}

void Stepped::advance(cosim::Clk clocks) {
  go([&] { target_ = std::min(session_->end(), now() + clocks); });
}

void Stepped::access(const cosim::BusOp& op) {
  go([&] { op_ = op; });
}

void Stepped::finish(bool early) {
  if (over_) return;
  go([&] {
    if (early) stop_ = true;
    target_ = session_->end();
  });
}

bool Stepped::done() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, std::chrono::milliseconds(50), [this] { return stands_; });
  if (stands_ && error_) std::rethrow_exception(error_);
  return stands_;
}

cosim::Clk Stepped::now() const { return session_->loop().chip().now(); }

cosim::Lines Stepped::drive() const { return session_->loop().chip().drive(); }

cosim::Lines Stepped::sense() const { return see_.seen == nullptr ? 0 : see_.seen->sense(); }

std::vector<std::string> Stepped::signal_names() const {
  std::vector<std::string> names;
  if (dynamic_cast<const cosim::SignalReader*>(session_.get()) == nullptr) return names;
  for (const cosim::Signal& one : settings_->machine().traces.triggers().signals) {
    for (const char* const axis : {"x.", "y."}) {
      names.push_back(one.of_axis ? std::string(axis) + one.name : one.name);
      if (!one.of_axis) break;
    }
  }
  return names;
}

std::optional<std::int64_t> Stepped::signal(const std::string& name) const {
  const auto* const words = dynamic_cast<const cosim::SignalReader*>(session_.get());
  if (words == nullptr) return {};
  const std::vector<cosim::Signal>& signals = settings_->machine().traces.triggers().signals;
  for (std::size_t n = 0; n < signals.size(); ++n) {
    for (int axis = 0; axis < 2; ++axis) {
      const std::string prefix = !signals[n].of_axis ? "" : axis == 0 ? "x." : "y.";
      if (prefix + signals[n].name == name) return words->read(n, axis);
    }
  }
  return {};
}

}  // namespace trammel::python
