// SPDX-License-Identifier: Apache-2.0
//
// McAfee's programs at a port that only remembers, behind which two parts show what the test says:
// what each event of either part ends, what the timer is set to, and which failure is told.
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "sw_nios/apps/mcafee/mcafee.hpp"
#include "sw_nios/hal/platform_map.hpp"
#include "sw_nios/apps/mcafee/mcafee_xy.hpp"
#include "tests/support/port_byte.hpp"

using namespace trammel::sw;
namespace regs = trammel::mcafee_xy_regs;

namespace {

// Both motors off, X first.
const std::string kOff = "c1F d01 d00 c01 C1F D01 D00 C01 ";
const std::string kInit = "c05 c1D d00 d00 C05 C1D D00 D00 ";

// Bytes as text: c and d to X, C and D to Y.
struct TwoParts final : Bus {
  std::array<std::uint8_t, 2> status{0x84, 0x84};     // RSTI makes 80h of it
  std::array<std::deque<std::uint8_t>, 2> reply;      // then 00
  std::uint32_t irq = 0, hosts = 0, limits = 0, timer = 0;
  std::uint32_t sample = 0;  // of STATUS, until it is written
  std::string log;

  std::uint32_t read(std::uint32_t addr) override {
    switch (addr) {
      case platform_map::kIrq: return irq;
      case regs::kIrq: return hosts;
      case regs::kLimits: return limits;
      case regs::kStatus: return sample;
      case regs::kPortC: return shown_;
      default: return 0;
    }
  }
  void write(std::uint32_t addr, std::uint32_t data) override {
    if (addr == platform_map::kTimer) timer = data;
    if (addr == regs::kReset) log += "R ";
    if (addr == regs::kStatus) sample &= ~data;
    if (addr == regs::kPortC) byte_ = data;
    if (addr != regs::kPortB) return;
    const std::size_t part = (data & regs::kPortBY) != 0 ? 1 : 0;
    const bool ps = (data & regs::kPortBPs) != 0;
    if ((data & regs::kPortBReadStrobe) != 0) shown_ = ps ? next(part) : status[part];
    if ((data & regs::kPortBWriteStrobe) == 0) return;
    log += trammel::test::port_byte(part == 0 ? (ps ? 'd' : 'c') : (ps ? 'D' : 'C'), byte_) + ' ';
    if (!ps && byte_ == 0x1D) status[part] = 0x80;
  }

 private:
  std::uint8_t next(std::size_t part) {
    if (reply[part].empty()) return 0;
    const std::uint8_t byte = reply[part].front();
    reply[part].pop_front();
    return byte;
  }
  std::uint32_t shown_ = 0, byte_ = 0;
};

struct Bench {
  TwoParts bus;
  McafeeApp app;

  explicit Bench(const McafeeSetup& setup) : app(setup) {
    app.start(bus);
    CHECK(bus.log == "R ");
    CHECK(bus.timer == 100'000);
  }
  std::string on_timer() {
    bus.irq = platform_map::kIrqTimer;
    return interrupt();
  }
  // Of one part, with this status.
  std::string on_host(std::size_t part, std::uint8_t status) {
    bus.irq = platform_map::kIrqChip;
    bus.hosts = part == 0 ? regs::kIrqX : regs::kIrqY;
    bus.status[part] = status;
    const std::string bytes = interrupt();
    bus.hosts = 0;
    return bytes;
  }
  McafeeFailure failure() const { return static_cast<McafeeFailure>(app.mailbox().failure); }

 private:
  std::string interrupt() {
    bus.log.clear();
    app.isr(bus);
    return bus.log;
  }
};

McafeeSetup stage(McafeeStage which) {
  McafeeSetup setup;
  setup.stage = which;
  setup.wait_clk = 7777;
  setup.sample_clk = 1234;
  return setup;
}

void reply(Bench& bench, std::size_t part, std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  for (const int shift : {24, 16, 8, 0}) {
    bench.bus.reply[part].push_back(static_cast<std::uint8_t>(bits >> shift));
  }
}

}  // namespace

TEST_CASE("mcafee: in Stage II each sample looks at the switches, and each of them ends it") {
  for (const std::uint32_t limit : {1u, 2u, 4u, 8u}) {
    CAPTURE(limit);
    Bench bench(stage(McafeeStage::kMove));
    bench.on_timer();
    for (int n = 0; n < 3; ++n) {
      CHECK(bench.bus.timer == 1234);
      CHECK(bench.on_timer().empty());
    }
    CHECK(bench.failure() == McafeeFailure::kNone);
    bench.bus.limits = limit;
    CHECK(bench.on_timer() == kOff);
    CHECK(bench.failure() == McafeeFailure::kLimit);
    CHECK(bench.app.mailbox().done == 1);
    CHECK(bench.bus.timer == 0);
    CHECK(bench.on_timer().empty());
  }
}

TEST_CASE("mcafee: a switch that is closed from the start ends a program whose parts are ready") {
  Bench bench(stage(McafeeStage::kMove));
  bench.bus.limits = regs::kLimitsXLow;
  const std::string begun = bench.on_timer();
  CHECK(begun.substr(0, kInit.size()) == kInit);
  CHECK(bench.failure() == McafeeFailure::kNone);
  CHECK(bench.on_timer() == kOff);
  CHECK(bench.failure() == McafeeFailure::kLimit);
}

TEST_CASE("mcafee: the end of Stage II waits its own time, then reads both positions") {
  for (const std::size_t part : {0u, 1u}) {
    CAPTURE(part);
    Bench bench(stage(McafeeStage::kMove));
    bench.on_timer();
    CHECK_FALSE(bench.app.ending());
    CHECK(bench.on_host(part, 0x84) == "c1D d00 d00 C1D D00 D00 ");
    CHECK(bench.bus.timer == 7777);
    CHECK(bench.app.ending());
    CHECK(bench.app.mailbox().done == 0);
    reply(bench, 0, 52'800);
    reply(bench, 1, -77'777);
    CHECK(bench.on_timer() == "c0A C0A ");
    CHECK(bench.app.mailbox().done == 1);
    CHECK(bench.app.mailbox().real[0] == 52'800);
    CHECK(bench.app.mailbox().real[1] == -77'777);
    CHECK(bench.failure() == McafeeFailure::kNone);
  }
}

TEST_CASE("mcafee: an error of either part turns both motors off, once, and the first is told") {
  struct Case {
    std::uint8_t status;
    McafeeFailure failure;
  };
  const std::vector<McafeeRow> rows(4, McafeeRow{0, 0, 180, 180, 100, 100});
  for (const auto& [status, failure] : {Case{0x02, McafeeFailure::kCommandError},
                                        Case{0x20, McafeeFailure::kPositionError}}) {
    for (const std::size_t part : {0u, 1u}) {
      for (const bool tracks : {false, true}) {
        CAPTURE(int{status}, part, tracks);
        McafeeSetup setup = stage(tracks ? McafeeStage::kTrack : McafeeStage::kMove);
        setup.rows = rows.data();
        setup.row_count = 4;
        setup.speed = 100;
        Bench bench(setup);
        bench.on_timer();
        const std::string bytes = bench.on_host(part, status);
        CHECK(bytes.find(kOff) != std::string::npos);
        CHECK(bytes.find(kOff, bytes.find(kOff) + 1) == std::string::npos);
        CHECK(bench.failure() == failure);
        CHECK(bench.app.mailbox().done == 1);
        CHECK(bench.bus.timer == 0);
        const std::string again = bench.on_host(1 - part, status == 0x02 ? 0x20 : 0x02);
        CHECK(again == "c1D d00 d00 C1D D00 D00 ");
        CHECK(bench.failure() == failure);
        CHECK(bench.on_timer().empty());
      }
    }
  }
}

TEST_CASE("mcafee: Stage III goes to its last target on both axes, waits, and ends where it is") {
  const std::vector<McafeeRow> rows(1, McafeeRow{0, 0, 255, 255, 40, -30});
  McafeeSetup setup = stage(McafeeStage::kTrack);
  setup.rows = rows.data();
  setup.row_count = 1;
  setup.speed = 55;
  Bench bench(setup);
  bench.on_timer();
  CHECK(bench.on_timer().empty());  // no sample yet
  CHECK(bench.app.mailbox().point == 0);
  bench.bus.sample = regs::kStatusSample;
  CHECK(bench.on_timer() == "c01 C01 ");
  CHECK(bench.failure() == McafeeFailure::kNone);
  CHECK(bench.app.mailbox().point == 1);
  CHECK(bench.app.mailbox().speed == 55);
  struct Case {
    std::int32_t x, y;
  };
  for (const auto& [x, y] : {Case{40, -29}, Case{39, -30}, Case{-30, 40}, Case{40, 40}}) {
    CAPTURE(x, y);
    CHECK(bench.bus.timer == 1234);
    reply(bench, 0, x);
    reply(bench, 1, y);
    bench.on_timer();
    CHECK_FALSE(bench.app.ending());
    bench.bus.reply = {};
  }
  reply(bench, 0, 40);
  reply(bench, 1, -30);
  CHECK(bench.on_timer() == "c08 C08 ");
  CHECK(bench.bus.timer == 7777);
  CHECK(bench.app.ending());
  CHECK(bench.app.mailbox().done == 0);
  reply(bench, 0, 38);
  reply(bench, 1, -31);
  CHECK(bench.on_timer() == "c0A C0A ");
  CHECK(bench.app.mailbox().done == 1);
  CHECK(bench.app.mailbox().real[0] == 38);
  CHECK(bench.app.mailbox().real[1] == -31);
}

TEST_CASE("mcafee: an index that is missing at the end of a move is told, of either axis") {
  for (const std::size_t part : {0u, 1u}) {
    for (const std::int32_t sign : {1, -1}) {
      for (const bool lost : {false, true}) {
        CAPTURE(part, sign, lost);
        McafeeSetup setup = stage(McafeeStage::kMove);
        setup.index_counts = 800;
        Bench bench(setup);
        bench.on_timer();
        reply(bench, 0, 700);  // an index of X: the axes have each their own last one
        bench.on_host(0, 0x88);
        REQUIRE(bench.failure() == McafeeFailure::kNone);
        bench.on_host(0, 0x84);
        const std::int32_t way = sign * (lost ? 803 : 802);
        reply(bench, 0, part == 0 ? 700 + way : 700);
        reply(bench, 1, part == 1 ? way : 0);
        bench.on_timer();
        CHECK(bench.failure() == (lost ? McafeeFailure::kIndex : McafeeFailure::kNone));
        CHECK(Catch::EndsWith(kOff).match(bench.bus.log) == lost);
      }
    }
  }
}

TEST_CASE("mcafee: Stage I takes its readings, one each wait, and no more") {
  McafeeSetup setup = stage(McafeeStage::kRead);
  setup.readings = 3;
  Bench bench(setup);
  CHECK(bench.on_timer() == kInit);
  CHECK(bench.bus.timer == 1);
  for (std::uint32_t n = 1; n < 3; ++n) {
    CHECK(bench.on_timer() == "c0A ");
    CHECK(bench.app.mailbox().point == n);
    CHECK(bench.bus.timer == 7777);
  }
  CHECK(bench.on_timer() == "c0A c0A C0A ");
  CHECK(bench.app.mailbox().point == 3);
  CHECK(bench.app.mailbox().done == 1);
  setup.readings = 0;  // endless
  Bench endless(setup);
  endless.on_timer();
  for (int n = 0; n < 50; ++n) endless.on_timer();
  CHECK(endless.app.mailbox().point == 50);
  CHECK(endless.app.mailbox().done == 0);
}

TEST_CASE("mcafee: a part that is not reset as the data sheet says ends the program untouched") {
  for (const std::size_t part : {0u, 1u}) {
    Bench bench(stage(McafeeStage::kMove));
    bench.bus.status[part] = 0x00;
    CAPTURE(part);
    CHECK(bench.on_timer() == (part == 0 ? "" : "c05 c1D d00 d00 "));
    CHECK(bench.failure() == McafeeFailure::kReset);
    CHECK(bench.app.mailbox().done == 1);
    CHECK(bench.bus.timer == 0);
  }
}
