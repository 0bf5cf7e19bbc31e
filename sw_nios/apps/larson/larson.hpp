// SPDX-License-Identifier: Apache-2.0
//
// Runs a script of .TABLE calls, of waits, and of words written by hand, one after the other. What
// a call answers is left beside it, for the caller of the run. Freestanding.
#pragma once

#include <cstdint>

#include "sw_nios/apps/larson/table.hpp"
#include "sw_nios/hal/bus.hpp"

namespace trammel::sw {

enum class LarsonOp : std::uint8_t {
  kCaltbl,  // waits until the table is calibrated, as WTTBL does for a move
  kVeltbl,  // a, b: rates of X and Y
  kAbstbl,  // a, b: where
  kReltbl,  // a, b: by how much
  kWttbl,
  kWhrtbl,
  kWait,    // a: [clk], at most 2^31 - 1
  kMov,     // b into the word a: 0 X count, 1 X status, 2 Y count, 3 Y status
  kBis,     // the same, by a read, an OR and a write
  kBic,     // and by a read, an AND of the complement, and a write
  kMovb,    // b into the byte a: 0 and 1 low and high of the X count, 2 and 3 of the X status...
  kPoll     // reads the word a every poll_clk, until the bits b of it are 0
};

struct LarsonCall {
  LarsonOp op = LarsonOp::kWttbl;
  std::int32_t a = 0, b = 0;
};

struct LarsonAnswer {
  // WTTBL: 1 normal, 0 error; ABSTBL, RELTBL: a StepAnswer; WHRTBL: 0, or kNotCalibrated.
  std::int32_t value = 0;
  StepPoint at;            // WHRTBL
};

enum class LarsonFailure : std::uint32_t {
  kNone,
  kNotCalibrated  // CALTBL found no switch, or could not leave it
};

// Its failure is a LarsonFailure; points are calls that have ended.
struct LarsonMailbox : Mailbox {
  StepPoint known;               // where the last moves ended
  std::uint32_t calibrated = 0;  // 1: so
  std::uint32_t stopped = 0;     // axes that a switch has stopped since: bit 0 X, bit 1 Y
};

class LarsonApp final : public Firmware {
 public:
  // Calls and their answers, `number` of each, outlive the run.
  LarsonApp(const StepTableSetup& setup, const LarsonCall* calls, LarsonAnswer* answers,
            std::uint32_t number)
      : table_(setup), calls_(calls), answers_(answers), number_(number) {}

  void start(Bus& bus) override;
  void isr(Bus& bus) override;
  const LarsonMailbox& mailbox() const override { return mail_; }

  const StepTable& table() const { return table_; }

 private:
  void go_on(Bus& bus);
  bool begin(Bus& bus, const LarsonCall& call, LarsonAnswer& answer);
  void arm(Bus& bus);
  void wait(Bus& bus, std::uint32_t clk);
  bool settles(Bus& bus);
  void end(LarsonFailure failure);
  void report();

  LarsonMailbox mail_;
  StepTable table_;
  const LarsonCall* calls_;
  LarsonAnswer* answers_;
  std::uint32_t number_;
  bool begun_ = false;    // CALTBL
  bool waiting_ = false;  // for the timer
  bool polling_ = false;  // the timer runs for the table
};

}  // namespace trammel::sw
