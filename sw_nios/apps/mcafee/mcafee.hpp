// SPDX-License-Identifier: Apache-2.0
//
// McAfee's three programs (1994, ch. VI, App. B to D) for two LM628 behind one port. Stage I reads
// a position repeatedly, Stage II makes one long move, Stage III follows a table of rows at the
// speed of the fuzzy feed rate: self-paced tracking. Integers only, run to completion.
#pragma once

#include <array>
#include <cstdint>

#include "sw_nios/hal/bus.hpp"
#include "sw_nios/hal/lm628.hpp"
#include "sw_nios/hal/lm628_index.hpp"

namespace trammel::sw {

enum class McafeeStage : std::uint8_t { kRead, kMove, kTrack };

// A piece of the path, all of equal length, as written by the path tool (App. D, Table 5).
struct McafeeRow {
  std::uint8_t c = 0;   // curvature at its start
  std::uint8_t cc = 0;  // magnitude of its change over the preview
  std::uint8_t vx = 0;  // 255 |dx| / length
  std::uint8_t vy = 0;
  std::int8_t dx = 0;  // [count]
  std::int8_t dy = 0;
};

// App. D, DECOMP: speed of an axis, the low word of an LM628 velocity [2^-16 count/sample].
constexpr std::uint32_t mcafee_velocity(std::uint32_t v, std::uint32_t scale) {
  return (v * scale >> 8) * 0xF1;
}

struct McafeeSetup {
  McafeeStage stage = McafeeStage::kTrack;
  Lm628Filter filter{255, 0, 0, 0, 1};
  std::uint32_t wait_clk = 5'000'000;  // between readings of Stage I, and at the end of the others
  std::uint32_t sample_clk = 17'067;   // 2048 ticks of 6 MHz; of 8 MHz they are 12'800
  std::uint32_t readings = 0;          // of Stage I; 0 = endless

  std::int32_t acceleration = 60'000;  // [2^-16 count/sample^2]
  std::int32_t velocity = 0x2BB0D;     // [2^-16 count/sample], of Stage II
  std::int32_t position = 0xCE40;      // [count], of Stage II

  const McafeeRow* rows = nullptr;  // of Stage III
  std::uint32_t row_count = 0;
  std::uint32_t speed = 0;           // 1..255: constant; 0 = from the feed rate
  std::uint32_t least_speed = 8;     // at a sharp corner the feed rate is 0, which would never end
  std::uint32_t velocity_shift = 0;  // left shift of the LM628 velocity
  std::uint32_t error_limit = 0;     // [count] position error that turns a motor off; 0: none
  std::uint32_t index_counts = 0;    // between two indexes, to check them; 0: no check
};

enum class McafeeFailure : std::uint32_t {
  kNone,
  kReset,          // the status after a reset is not one that the data sheet names
  kBusy,           // the busy bit did not clear, or the feed rate was not ready
  kCommandError,   // status bit 1
  kPositionError,  // status bit 5
  kLimit,          // a limit switch was reached
  kIndex,          // an index that is not a turn from the one before
  kLate            // a sample fell between the STT of both axes: the processor is too slow
};

class McafeeApp final : public Firmware {
 public:
  static constexpr std::uint32_t kResetClk = 100'000;  // 8000 ticks of 6 MHz are 66 667

  explicit McafeeApp(const McafeeSetup& setup)
      : setup_(setup), index_{Lm628Index(setup.index_counts), Lm628Index(setup.index_counts)} {}

  void start(Bus& bus) override;
  void isr(Bus& bus) override;
  // `failure` is a McafeeFailure; a point is a reading, or a row whose motion was started, and
  // `speed` the v of that row; the real position is read by RDRP.
  const Mailbox& mailbox() const override { return mail_; }
  bool ending() const { return state_ == State::kPause || mail_.done != 0; }  // no motion left

 private:
  enum class State : std::uint8_t {
    kReset,
    kReading,  // Stage I
    kMoving,   // Stage II
    kRow,      // a row runs
    kSample,   // the next one starts at the next sample
    kLast,     // the last one runs
    kPause,
    kDone
  };
  struct Parts;

  void on_timer(Bus& bus, Parts& parts);
  void on_host(Bus& bus, Parts& parts);
  void begin(Bus& bus, Parts& parts);
  void load_row(Bus& bus, Parts& parts);
  void start_row(Bus& bus, Parts& parts);
  void watch_row(Bus& bus, Parts& parts);
  void finish(Bus& bus, Parts& parts);
  void wait(Bus& bus, State state, std::uint32_t clocks);
  void fail(Bus& bus, McafeeFailure failure);
  std::uint32_t feed_rate(Bus& bus, const McafeeRow& row);

  struct Axis {
    std::int32_t target = 0;     // [count] of the row that runs
    std::int32_t next = 0;       // of the row that is loaded
    std::uint32_t velocity = 0;  // of the row that is loaded
    bool loaded = false;         // it moves in that row
    std::uint32_t fastest = 1;   // in the row that runs
    bool near = true;            // close to the target of that row
  };

  Mailbox mail_;
  McafeeSetup setup_;
  State state_ = State::kReset;
  std::array<Lm628Index, 2> index_;
  std::array<Axis, 2> axes_;
  std::uint32_t loaded_ = 0;  // rows
  std::uint32_t speed_ = 0;   // v of the last one
};

}  // namespace trammel::sw
