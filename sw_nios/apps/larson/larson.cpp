// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/apps/larson/larson.hpp"

#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::sw {
namespace {

namespace map = larson_map;

std::uint32_t word_at(std::int32_t number) { return 4 * static_cast<std::uint32_t>(number); }

}  // namespace

void LarsonApp::start(Bus& bus) {
  go_on(bus);
  report();
}

// All that waits is taken: the line is a level, and the vector's read is the grant.
void LarsonApp::isr(Bus& bus) {
  const std::uint32_t causes = bus.read(map::kIrq);
  if ((causes & map::kIrqTimer) != 0) {
    bus.write(map::kTimer, 0);
    if (polling_) table_.on_timer(bus);
    polling_ = waiting_ = false;
  }
  while (const std::uint32_t vector = bus.read(map::kVector)) table_.on_vector(bus, vector);
  if (mail_.done == 0) go_on(bus);
  report();
}

void LarsonApp::report() {
  mail_.known = table_.known();
  mail_.calibrated = table_.calibrated() ? 1 : 0;
  mail_.stopped = table_.stopped();
}

void LarsonApp::end(LarsonFailure failure) {
  mail_.failure = static_cast<std::uint32_t>(failure);
  mail_.done = 1;
}

// Calls until one has to wait.
void LarsonApp::go_on(Bus& bus) {
  while (mail_.done == 0 && !waiting_) {
    if (mail_.point == number_) return end(LarsonFailure::kNone);
    LarsonAnswer& answer = answers_[mail_.point];
    if (!begin(bus, calls_[mail_.point], answer)) break;
    ++mail_.point;
  }
  arm(bus);
}

// The timer is the script's own, or the table's while it leaves its switches.
void LarsonApp::arm(Bus& bus) {
  if (mail_.done != 0 || waiting_ || polling_ || !table_.wants_timer()) return;
  polling_ = true;
  bus.write(map::kTimer, table_.poll_clk());
}

void LarsonApp::wait(Bus& bus, std::uint32_t clk) {
  waiting_ = true;
  polling_ = false;
  bus.write(map::kTimer, clk);
}

// True: the timer runs until the table has settled.
bool LarsonApp::settles(Bus& bus) {
  const std::uint32_t clk = table_.settling();
  if (clk != 0) wait(bus, clk);
  return clk != 0;
}

// False: it has to wait, and is asked again.
bool LarsonApp::begin(Bus& bus, const LarsonCall& call, LarsonAnswer& answer) {
  const StepPoint point{call.a, call.b};
  switch (call.op) {
    case LarsonOp::kCaltbl:
      if (!begun_) {
        if (table_.busy()) return false;
        table_.caltbl(bus);
        begun_ = true;
      }
      if (table_.busy() || settles(bus)) return false;
      begun_ = false;
      if (!table_.calibrated()) end(LarsonFailure::kNotCalibrated);
      return true;
    case LarsonOp::kVeltbl:
      table_.veltbl(point);
      return true;
    case LarsonOp::kAbstbl:
      answer.value = static_cast<std::int32_t>(table_.abstbl(bus, point));
      return true;
    case LarsonOp::kReltbl:
      answer.value = static_cast<std::int32_t>(table_.reltbl(bus, point));
      return true;
    case LarsonOp::kWttbl:
      if (table_.busy() || settles(bus)) return false;
      answer.value = table_.wttbl() ? 1 : 0;
      return true;
    case LarsonOp::kWhrtbl:
      answer.at = table_.whrtbl(bus);
      answer.value = static_cast<std::int32_t>(
          table_.calibrated() ? StepAnswer::kStarted : StepAnswer::kNotCalibrated);
      return true;
    case LarsonOp::kWait:
      wait(bus, static_cast<std::uint32_t>(call.a));
      return true;
    case LarsonOp::kMov:
      bus.write(word_at(call.a), static_cast<std::uint32_t>(call.b) & 0xFFFF);
      return true;
    case LarsonOp::kBis:
      bus.write(word_at(call.a), bus.read(word_at(call.a)) | static_cast<std::uint32_t>(call.b));
      return true;
    case LarsonOp::kBic:
      bus.write(word_at(call.a), bus.read(word_at(call.a)) & ~static_cast<std::uint32_t>(call.b));
      return true;
    case LarsonOp::kMovb:
      bus.write(map::byte(static_cast<std::uint32_t>(call.a)),
                static_cast<std::uint32_t>(call.b) & 0xFF);
      return true;
    case LarsonOp::kPoll:
      if ((bus.read(word_at(call.a)) & static_cast<std::uint32_t>(call.b)) == 0) break;
      wait(bus, table_.poll_clk());
      return false;
  }
  return true;
}

}  // namespace trammel::sw
