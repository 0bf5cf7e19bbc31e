// SPDX-License-Identifier: Apache-2.0
//
// McAfee's programs through the port picture to the twins of two LM628 at 6 MHz, with motors that
// follow at once.

#include "sw_nios/apps/mcafee/mcafee.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cctype>
#include <cstdint>
#include <string>
#include <vector>

#include "cosim/direct.hpp"
#include "models/exact/control/feed_rate.hpp"
#include "sw_nios/hal/platform_map.hpp"
#include "sw_nios/apps/mcafee/mcafee_xy.hpp"
#include "machines/mcafee/tests/xy_follower.hpp"
#include "tests/support/port_byte.hpp"

using namespace trammel;
using namespace trammel::sw;
using trammel::test::XyFollower;

namespace {

constexpr double kClockS = 20e-9;

// Observes the port, and what the samples take.
class SpiedChip final : public mcafee::TwinChip {
 public:
  std::string bytes;  // that passed: c 1F, d 00 to X, C and D to Y; r, R data read
  std::array<std::int64_t, 2> target{};  // that the last sample took [count]

 private:
  void raise(cosim::Clk edge) override {
    for (int axis = 0; axis < 2; ++axis) {
      if (!part(axis).samples()) continue;
      target[static_cast<std::size_t>(axis)] = part(axis).engine().desired().target;
    }
    const exact::Lm628Bridge::Out before = twin_.port();
    TwinChip::raise(edge);
    log(before, twin_.port());
  }

  // At the end of a strobe.
  void log(const exact::Lm628Bridge::Out& was, const exact::Lm628Bridge::Out& is) {
    const bool wrote = !was.wr_n && is.wr_n, read = !was.rd_n && is.rd_n && was.ps;
    if (!wrote && !read) return;
    const int axis = was.cs_x_n ? 1 : 0;
    const char kind = read ? 'r' : was.ps ? 'd' : 'c';
    const unsigned byte = read ? part(axis).out().d : was.d;
    bytes += test::port_byte(axis == 1 ? static_cast<char>(std::toupper(kind)) : kind, byte) + ' ';
  }
};

// Runs a program to its end, or up to this time.
struct McafeeBench {
  SpiedChip chip;
  XyFollower follower{chip};
  McafeeApp app;
  bool stands = false;  // the table does not follow

  struct Watch final : cosim::Observer {
    McafeeBench* bench = nullptr;
    std::int64_t moving = 0;       // samples in which X moved
    std::int64_t fastest = 0;      // [2^-16 count/sample]
    int apart = 0;                 // samples that took the new target of one axis alone
    int starts = 0;                // samples with new targets
    int rests = 0;                 // samples between them in which X stood
    std::array<std::int64_t, 2> target{};
    void on(const cosim::Stop& stop, const cosim::Chip& c, const cosim::Plant& p) override {
      if (!bench->stands) bench->follower.on(stop, c, p);
      if ((stop.why & cosim::kSample) == 0) return;
      const auto& desired = bench->chip.part(0).engine().desired();
      if (desired.speed != 0 || desired.position >> 16 != last) ++moving;
      last = desired.position >> 16;
      fastest = std::max<std::int64_t>(fastest, std::abs(desired.speed));
      const auto& taken = bench->chip.target;
      const bool x = taken[0] != target[0], y = taken[1] != target[1];
      if (x != y) ++apart;
      if (x || y) ++starts;
      if (desired.speed == 0 && starts > 0 && bench->app.mailbox().point < rows) ++rests;
      target = taken;
    }
    std::int64_t last = 0;
    std::uint32_t rows = 0;  // before the last one
  } watch;

  explicit McafeeBench(const McafeeSetup& setup) : app(setup) {
    watch.bench = this;
    watch.rows = setup.row_count;
  }

  void run(double seconds, const cosim::ProcessorTiming& timing = {}) {
    cosim::Loop loop(chip, follower, watch);
    cosim::run_direct(loop, app, timing, static_cast<cosim::Clk>(seconds / kClockS),
                      [this] { return app.mailbox().done != 0; });
  }
};

constexpr const char* kReady = "c05 c1D d00 d00 C05 C1D D00 D00 ";  // both initialised

McafeeFailure failure_of(const McafeeApp& app) {
  return static_cast<McafeeFailure>(app.mailbox().failure);
}

// What passed the port after a text.
std::string after(const McafeeBench& bench, const std::string& text) {
  const auto at = bench.chip.bytes.find(text);
  return at == std::string::npos ? bench.chip.bytes : bench.chip.bytes.substr(at + text.size());
}

McafeeSetup stage(McafeeStage which) {
  McafeeSetup setup;
  setup.stage = which;
  setup.wait_clk = 50'000;
  return setup;
}

McafeeSetup tracking(const std::vector<McafeeRow>& rows) {
  McafeeSetup setup = stage(McafeeStage::kTrack);
  setup.rows = rows.data();
  setup.row_count = static_cast<std::uint32_t>(rows.size());
  return setup;
}

// Two parts that answer, and a feed rate that never does; the timer has always just ended.
class DeafFeed final : public Bus {
 public:
  std::uint32_t read(std::uint32_t addr) override {
    if (addr == platform_map::kIrq) return platform_map::kIrqTimer;
    if (addr == mcafee_xy_regs::kPortC) return cleared_[part_] ? 0x80 : 0x84;
    return 0;
  }
  void write(std::uint32_t addr, std::uint32_t data) override {
    if (addr == mcafee_xy_regs::kPortC) byte_ = data;
    if (addr != mcafee_xy_regs::kPortB) return;
    part_ = (data & mcafee_xy_regs::kPortBY) != 0;
    const bool command = (data & mcafee_xy_regs::kPortBPs) == 0;
    const bool writes = (data & mcafee_xy_regs::kPortBWriteStrobe) != 0;
    if (command && writes && byte_ == static_cast<std::uint32_t>(Lm628Command::kRsti)) {
      cleared_[part_] = true;
    }
  }

 private:
  std::array<bool, 2> cleared_{};
  std::size_t part_ = 0;
  std::uint32_t byte_ = 0;
};

}  // namespace

TEST_CASE("F-04 DECOMP gives EE2Dh and 769Eh") {
  CHECK(mcafee_velocity(254, 255) == 0xEE2D);
  CHECK(mcafee_velocity(127, 255) == 0x769E);
  CHECK(mcafee_velocity(0, 255) == 0);
}

TEST_CASE("F-05 Stage II moves 52 800 counts in 24 173 samples at 6 MHz") {
  McafeeSetup setup = stage(McafeeStage::kMove);
  setup.acceleration = 0x25;
  McafeeBench bench(setup);
  bench.run(12);
  CHECK(bench.app.mailbox().done);
  CHECK(failure_of(bench.app) == McafeeFailure::kNone);
  CHECK(bench.app.mailbox().real[0] == 52'800);
  CHECK(bench.app.mailbox().real[1] == 0);
  CHECK(std::abs(bench.watch.moving - 24'173) <= 25);
  CHECK(bench.watch.fastest == 0x2BB0D);
  CHECK(after(bench, kReady) ==
        "c1E d00 d08 d00 dFF c04 "
        "c1F d00 d2A d00 d00 d00 d25 d00 d02 dBB d0D d00 d00 dCE d40 c01 "  // seven words
        "c1D d00 d00 C1D D00 D00 "
        "c0A r00 r00 rCE r40 C0A R00 R00 R00 R00 ");
}

TEST_CASE("Stages II and III end with both motors off at an error above the limit") {
  const std::vector<McafeeRow> rows(4, McafeeRow{0, 0, 180, 180, 100, 100});
  for (const bool tracks : {false, true}) {
    CAPTURE(tracks);
    McafeeSetup setup = tracks ? tracking(rows) : stage(McafeeStage::kMove);
    setup.error_limit = 50;
    McafeeBench bench(setup);
    bench.follower.hold({0, 0});
    bench.run(5);
    CHECK(failure_of(bench.app) == McafeeFailure::kPositionError);
    CHECK(bench.chip.drive() == 0x8080);
    const std::string text = after(bench, kReady);
    CHECK_THAT(text, Catch::Contains("c1A d00 d32 "));
    CHECK((text.find("C1A D00 D32 ") != std::string::npos) == tracks);
  }
}

TEST_CASE("a program that checks the index ends where it comes too often, with both motors off") {
  const std::vector<McafeeRow> rows(4, McafeeRow{0, 0, 180, 180, 100, 100});
  for (const bool tracks : {false, true}) {
    CAPTURE(tracks);
    McafeeSetup setup = tracks ? tracking(rows) : stage(McafeeStage::kMove);
    setup.index_counts = 800;  // the follower's marker is low: each fourth count is an index
    McafeeBench bench(setup);
    bench.run(5);
    CHECK(failure_of(bench.app) == McafeeFailure::kIndex);
    CHECK_THAT(bench.chip.bytes, Catch::Contains("c1F d01 d00 c01 C1F D01 D00 C01 "));
  }
}

TEST_CASE("F-06 Stage I reads FF FF FF FB again and again while the encoder stands at -5") {
  McafeeSetup setup = stage(McafeeStage::kRead);
  setup.readings = 20;
  McafeeBench bench(setup);
  bench.follower.hold({-5, 0});
  bench.run(0.5);
  CHECK(bench.app.mailbox().done);
  std::string expected;
  for (int k = 0; k < 21; ++k) expected += "c0A rFF rFF rFF rFB ";
  CHECK(after(bench, kReady) == expected + "C0A R00 R00 R00 R00 ");
}

TEST_CASE("Stage III loads an acceleration once, then for each row the values that are not 0") {
  const std::vector<McafeeRow> rows{{0, 0, 255, 0, 50, 0}, {255, 0, 180, 180, 10, -10}};
  McafeeBench bench(tracking(rows));
  bench.run(2);
  REQUIRE(bench.app.mailbox().done);
  CHECK(failure_of(bench.app) == McafeeFailure::kNone);
  CHECK(bench.app.mailbox().real[0] == 60);
  CHECK(bench.app.mailbox().real[1] == -10);
  // Feed rates are 254 and 0, which is raised to 8: 8 * 180 >> 8 = 5, 5 * F1h = 04B5h.
  const std::string text = after(bench, kReady);
  const auto part = [](char c, char d) {
    const std::string axis =
        "c1C d00 d22 c1E d00 d08 d00 dFF c04 c1F d00 d20 d00 d00 dEA d60 c01 ";
    std::string mapped = axis;
    for (char& letter : mapped) letter = letter == 'c' ? c : letter == 'd' ? d : letter;
    return mapped;
  };
  const std::string begin = part('c', 'd') + part('C', 'D') +
                            "c1F d00 d0B d00 d00 dEE d2D d00 d00 d00 d32 c01 "
                            "c1F d00 d0B d00 d00 d04 dB5 d00 d00 d00 d0A "
                            "C1F D00 D0B D00 D00 D04 DB5 DFF DFF DFF DF6 ";
  CHECK(text.substr(0, begin.size()) == begin);
  CHECK_THAT(text, Catch::Contains("c01 C01 "));
}

TEST_CASE("Stage III goes by the feed rate of curvature and change, each of its own byte") {
  for (const auto& [c, cc] : {std::pair{30, 100}, {100, 30}, {0, 200}, {200, 0}, {110, 255}}) {
    const std::vector<McafeeRow> rows{
        {static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(cc), 255, 0, 30, 0}};
    McafeeBench bench(tracking(rows));
    bench.run(5);
    CAPTURE(c, cc);
    CHECK(bench.app.mailbox().done);
    const std::int32_t rate = exact::FeedRate().step({c, cc}).v;
    CHECK(bench.app.mailbox().speed == static_cast<std::uint32_t>(rate < 8 ? 8 : rate));
  }
}

TEST_CASE("Stage III goes no slower than its floor, by the feed rate or at a constant speed") {
  // Of C and CC of 0 and of 255: feed rates of 254 and 0.
  const std::vector<McafeeRow> rows{{0, 0, 255, 0, 30, 0}, {255, 255, 255, 0, 30, 0}};
  for (const std::uint32_t speed : {0u, 1u, 39u, 40u, 41u, 255u}) {
    McafeeSetup setup = tracking(rows);
    setup.speed = speed;
    setup.least_speed = 40;
    McafeeBench bench(setup);
    bench.run(5);
    CAPTURE(speed, setup.least_speed);
    CHECK(bench.app.mailbox().done);
    const std::uint32_t last = speed < 40 ? 40 : speed, first = speed == 0 ? 254 : last;
    CHECK(bench.app.mailbox().speed == last);
    std::vector<std::uint32_t> given;  // velocities of the rows: LTRJ with 000Bh
    const std::string& bytes = bench.chip.bytes;
    const std::string begin = "c1F d00 d0B d00 d00 d";
    for (auto at = bytes.find(begin); at != std::string::npos; at = bytes.find(begin, at + 1)) {
      const auto byte = [&](std::size_t n) {
        return std::stoul(bytes.substr(at + begin.size() + 4 * n, 2), nullptr, 16);
      };
      given.push_back(static_cast<std::uint32_t>(byte(0) << 8 | byte(1)));
    }
    CHECK(given == std::vector<std::uint32_t>{mcafee_velocity(first, 255),
                                              mcafee_velocity(last, 255)});
  }
}

TEST_CASE("Stage III gives no axis the velocity 0, and shifts the velocities it gives") {
  // 8 * 12 >> 8 = 0: F1h stands for it, shifted by 2 03C4h.
  const std::vector<McafeeRow> rows{{255, 255, 255, 12, 100, 5}};
  McafeeSetup setup = tracking(rows);
  setup.velocity_shift = 2;
  McafeeBench bench(setup);
  bench.run(20);
  REQUIRE(bench.app.mailbox().done);
  CHECK_THAT(bench.chip.bytes, Catch::Contains("C1F D00 D0B D00 D00 D03 DC4 D00 D00 D00 D05 "));
  CHECK(bench.app.mailbox().real[1] == 5);
}

TEST_CASE("no sample falls between the STT of the two axes, and the samples coincide") {
  std::vector<McafeeRow> rows;
  for (int k = 0; k < 60; ++k) {  // of many lengths, so that rows end anywhere in a sample
    const auto way = static_cast<std::int8_t>(20 + k * 7 % 23);
    const auto scale = static_cast<std::uint8_t>(100 + k * 29 % 155);
    rows.push_back({0, 0, scale, 180, way, static_cast<std::int8_t>(k % 2 == 0 ? way : -way)});
  }
  McafeeBench bench(tracking(rows));
  bench.run(5);
  REQUIRE(bench.app.mailbox().done);
  CHECK(failure_of(bench.app) == McafeeFailure::kNone);
  CHECK(bench.watch.apart == 0);  // of all samples
  CHECK(bench.watch.starts == 60);

  // A processor that is too slow for it says so, at the first pair that a sample has parted.
  int late = 0;
  for (const auto& [access, latency] :
       {std::pair{8, 14000}, {8, 15000}, {8, 16000}, {8, 17000}, {8, 20000}, {40, 100}, {300, 100},
        {500, 100}, {600, 100}, {800, 100}, {1000, 100}}) {
    McafeeBench slow(tracking(rows));
    slow.run(20, {access, latency});
    CAPTURE(access, latency);
    const bool failed = failure_of(slow.app) == McafeeFailure::kLate;
    late += failed;
    CHECK(slow.watch.apart <= (failed ? 2 : 0));  // that pair, and the stop after it
    CHECK((failed || slow.watch.starts == 60));
  }
  CHECK(late >= 5);
  CHECK(late <= 9);
}

TEST_CASE("at full speed an axis stands for one sample at most between rows of a straight path") {
  const std::vector<McafeeRow> rows(12, McafeeRow{0, 0, 255, 0, 50, 0});
  McafeeSetup setup = tracking(rows);
  setup.speed = 254;
  McafeeBench bench(setup);
  bench.run(5);
  CHECK(bench.app.mailbox().real[0] == 600);
  CHECK(bench.watch.starts == 12);
  CHECK(bench.watch.rests <= 11);
}

TEST_CASE("the rows end with the desired positions, wherever the table is") {
  const std::vector<McafeeRow> rows(3, McafeeRow{0, 0, 255, 255, 40, -30});
  McafeeBench bench(tracking(rows));
  bench.stands = true;
  bench.run(5);
  CHECK(bench.app.mailbox().done);
  CHECK(failure_of(bench.app) == McafeeFailure::kNone);
  CHECK(bench.app.mailbox().real[0] == 0);
  CHECK(bench.app.mailbox().real[1] == 0);
}

TEST_CASE("where one axis alone moves a sample parts nothing, however slow the processor is") {
  for (const bool y : {false, true}) {
    const McafeeRow row = y ? McafeeRow{0, 0, 0, 255, 0, 40} : McafeeRow{0, 0, 255, 0, 40, 0};
    const std::vector<McafeeRow> rows(6, row);
    for (const std::uint32_t access : {8u, 300u, 500u, 800u, 1000u}) {
      CAPTURE(y, access);
      McafeeBench bench(tracking(rows));
      bench.run(20, {access, 100});
      CHECK(bench.app.mailbox().done);
      CHECK(failure_of(bench.app) == McafeeFailure::kNone);
      CHECK(bench.app.mailbox().real[y ? 1 : 0] == 240);
    }
  }
}

TEST_CASE("a feed rate that never comes ends the program, and nothing restarts it") {
  const std::vector<McafeeRow> rows(4, McafeeRow{0, 0, 255, 0, 100, 0});
  DeafFeed bus;
  McafeeApp app(tracking(rows));
  app.start(bus);
  for (int n = 0; n < 2; ++n) {
    app.isr(bus);
    CHECK(failure_of(app) == McafeeFailure::kBusy);
    CHECK(app.mailbox().done);
    CHECK(app.mailbox().point == 0);
  }
}

TEST_CASE("a limit switch ends the program with both motors off") {
  const std::vector<McafeeRow> rows(40, McafeeRow{0, 0, 255, 0, 100, 0});
  McafeeBench bench(tracking(rows));
  bench.follower.limit_at(1000);
  bench.run(5);
  CHECK(failure_of(bench.app) == McafeeFailure::kLimit);
  CHECK(bench.chip.drive() == 0x8080);
  const std::string off = "c1F d01 d00 c01 C1F D01 D00 C01 ";
  REQUIRE(bench.chip.bytes.size() > off.size());
  CHECK(bench.chip.bytes.substr(bench.chip.bytes.size() - off.size()) == off);
}
