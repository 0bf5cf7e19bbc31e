// SPDX-License-Identifier: Apache-2.0
//
// AC characteristics of the core in a fabric of 50 MHz, as in the data sheet's tables (SNVS781C
// p.3 and 4), measured at the pins of the RTL beside its twin. docs/lm628.md has the same figures;
// tests/scripts/unit/lm628_page_test.py compares them.
//
// Pins change just after an edge. What is valid after n more edges is so at most 20 n ns after the
// change, at any phase, and at least 20 (n - 1) ns after it; what takes n edges that see a level
// needs 20 n ns of it.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "tests/chips/lm628_pair.hpp"

using trammel::exact::Opcode;
using trammel::test::Lm628Pair;
using Bench = trammel::test::Lm628Bench<Lm628Pair>;

namespace {

struct Figure {
  const char* name;
  int ns;
};
constexpr Figure kFigures[] = {
    {"T1", 40},          {"T2", 20},          {"T3", 0},           {"T6", 20},
    {"T7", 0},           {"T8", 0},           {"T9", 0},           {"T10", 60},
    {"T11", 40},         {"T12", 60},         {"T13", 20},         {"T14", 20},
    {"T15", 20},         {"T16", 0},          {"T17", 20},         {"T18", 20},
    {"busy", 20020},     {"busy-max", 70020}, {"reset", 1000000},  {"sample", 256000},
    {"strobe", 1000},    {"parts", 2000},     {"pulse", 64000},    {"step", 500}};

int figure(const std::string& name) {
  for (const Figure& f : kFigures) {
    if (f.name == name) return f.ns;
  }
  FAIL("no figure " << name);
  return 0;
}

constexpr int kClock = 20;  // [ns]

// The least number of clocks with which it works; with one fewer it does not.
int least(const std::function<bool(int)>& works, int low = 0, int high = 64) {
  REQUIRE(works(high));
  while (low < high) {
    const int middle = (low + high) / 2;
    if (works(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

// Times of one access, in clocks.
struct Access {
  int select = 2;   // CS and PS before the strobe
  int strobe = 9;   // low
  int data = 9;     // of a write: valid before WR rises
  int hold = 6;     // data and PS after it
  int recover = 8;  // from the strobe's end to the next access
};

void write(Bench& bench, bool ps, std::uint8_t value, const Access& t) {
  auto& h = bench.chip.in.host;
  h.cs_n = false;
  h.ps = ps;
  h.d = static_cast<std::uint8_t>(~value);
  if (t.select > 0) bench.clocks(t.select);
  h.wr_n = false;
  if (t.strobe > t.data) bench.clocks(t.strobe - t.data);
  h.d = value;
  if (t.data > 0) bench.clocks(t.data);
  h.wr_n = true;
  if (t.hold > 0) bench.clocks(t.hold);
  h.cs_n = true;
  h.ps = !ps;
  h.d = static_cast<std::uint8_t>(~value);
  if (t.recover > t.hold) bench.clocks(t.recover - t.hold);
}

std::uint8_t read(Bench& bench, bool ps, const Access& t) {
  auto& h = bench.chip.in.host;
  h.cs_n = false;
  h.ps = ps;
  if (t.select > 0) bench.clocks(t.select);
  h.rd_n = false;
  bench.clocks(t.strobe);
  const std::uint8_t value = bench.out().d_oe ? bench.out().d : std::uint8_t{0};
  h.rd_n = true;
  if (t.hold > 0) bench.clocks(t.hold);
  h.cs_n = true;
  h.ps = !ps;
  if (t.recover > t.hold) bench.clocks(t.recover - t.hold);
  return value;
}

struct Ready : Bench {
  Ready() {
    start();
    clear_status();
  }
};

// SBPA's four bytes, by these times: the breakpoint is where they say.
bool writes(const Access& t) {
  Ready bench;
  write(bench, false, Bench::code(Opcode::kMski), t);
  bench.ready();
  write(bench, true, 0x12, t);
  write(bench, true, 0x40, t);
  bench.ready();
  write(bench, false, Bench::code(Opcode::kRdsigs), t);
  bench.ready();
  bench.read_word();
  if (bench.status() != 0x80) return false;
  bench.command(Opcode::kSbpa, {0, 3});  // it may interrupt now
  bench.move_to(8);
  bench.sample(2);
  return bench.out().hi;
}

// The position, by these times.
bool reads(const Access& t) {
  Ready bench;
  bench.move_to(0x1A5);
  bench.sample(2);
  bench.command(Opcode::kRdrp);
  for (const unsigned word : {0u, 0x1A5u}) {
    const unsigned high = read(bench, true, t), low = read(bench, true, t);
    if ((high << 8 | low) != word) return false;
    if ((read(bench, false, {}) & 1) == 0) return false;  // both were taken
    bench.ready();
  }
  return bench.status() == 0x80;
}

int ns_with(const std::function<bool(const Access&)>& works, int Access::*time) {
  return kClock * least([&](int n) {
    Access t;
    t.*time = n;
    return works(t);
  });
}

int ns(int clocks) { return kClock * clocks; }

}  // namespace

TEST_CASE("lm628 needs no more of the host's times than the data sheet's part") {
  CHECK(ns_with(writes, &Access::select) == figure("T8"));
  CHECK(ns_with(reads, &Access::select) == figure("T8"));
  CHECK(figure("T7") == 0);  // CS and PS change together there
  CHECK(ns_with(writes, &Access::hold) == figure("T9"));
  CHECK(ns_with(reads, &Access::hold) == figure("T9"));
  CHECK(ns_with(writes, &Access::data) == figure("T15"));
  CHECK(figure("T16") == figure("T9"));  // data and PS leave together
  const auto pulse = [](int n) {
    Access t;
    t.strobe = t.data = n;
    return writes(t);
  };
  CHECK(ns(least(pulse)) == figure("T14"));
  const auto close = [](const std::function<bool(const Access&)>& works) {
    return ns(least([&](int n) {
      Access t;
      t.select = t.hold = 0;
      t.recover = n;
      return works(t);
    }));
  };
  CHECK(close(reads) == figure("T17"));
  CHECK(close(writes) == figure("T18"));
  for (const auto& [name, limit] : {std::pair{"T7", 0}, {"T8", 30}, {"T9", 30}, {"T14", 100},
                                    {"T15", 50}, {"T16", 120}, {"T17", 120}, {"T18", 120}}) {
    CAPTURE(name);
    CHECK(figure(name) <= limit);
  }
}

TEST_CASE("lm628 gives data as the data sheet's part does, and leaves the bus") {
  Ready bench;
  auto& h = bench.chip.in.host;
  h.cs_n = false;
  h.ps = false;
  bench.clocks(2);
  h.rd_n = false;
  int access = 0;
  for (; !bench.out().d_oe || bench.out().d != 0x80; ++access) bench.clocks(1);
  bench.clocks(20);
  h.rd_n = true;
  int off = 0;
  for (; bench.out().d_oe; ++off) {
    REQUIRE(bench.out().d == 0x80);
    bench.clocks(1);
  }
  CHECK(ns(access) == figure("T10"));
  CHECK(ns(off - 1) == figure("T11"));
  CHECK(ns(off) == figure("T12"));
  CHECK(figure("T10") <= 180);
  CHECK(figure("T12") <= 180);
}

TEST_CASE("lm628 shows busy to the first read after a write, for 160 ticks or up to tick 400") {
  const auto busy_after = [](int phase, int gap) {  // status, read so long after WR rose
    Ready bench;
    bench.sample();
    bench.clocks(phase);
    Access t;
    t.hold = 0;
    t.recover = gap;
    write(bench, false, Bench::code(Opcode::kUdf), t);
    return (read(bench, false, {0, 9, 9, 6, 8}) & 1) != 0;
  };
  CHECK(ns(least([&](int gap) { return busy_after(100, gap); }, 0, 30)) == figure("T13"));
  const auto ends = [&](int phase) {
    return ns(least([&](int gap) { return !busy_after(phase, gap); }, 500, 6000));
  };
  CHECK(ends(100) == figure("busy"));
  CHECK(ends(5000) == figure("busy"));
  int longest = 0;
  const int before = 12800 - 2500 - 1000;  // it would end at tick 0
  for (int phase = before - 20; phase < before; phase += 2) {
    longest = std::max(longest, ends(phase));
  }
  CHECK(longest == figure("busy-max"));
  CHECK(longest <= 100'000);  // as the part's users found
}

TEST_CASE("lm628 resets by a short RST and is ready after 1 ms") {
  const auto resets = [](int low) {
    Ready bench;
    if (low == 0) return false;
    bench.chip.in.reset_n = false;
    bench.clocks(low);
    bench.chip.in.reset_n = true;
    bench.clocks(60'000);
    return bench.status() == 0x84;
  };
  CHECK(ns(least(resets, 0, 60)) == figure("T6"));
  const auto ready = [](int after) {
    Ready bench;
    bench.chip.in.reset_n = false;
    bench.clocks(60);
    bench.chip.in.reset_n = true;
    bench.clocks(after);
    return read(bench, false, {0, 9, 9, 6, 8}) == 0x84;
  };
  CHECK(ns(least(ready, 1, 75'000)) == figure("reset"));
  CHECK(figure("reset") <= 1'500'000);
}

TEST_CASE("lm628 counts an encoder of 20 ns a state, and takes an index as short") {
  const auto counts = [](int a_count) {
    if (a_count == 0) return false;
    Ready bench;
    bench.move_to(4000, a_count);
    bench.sample(2);
    return bench.ask(Opcode::kRdrp) == 4000;
  };
  const int state = least(counts, 0, 16);
  CHECK(ns(state) == figure("T2"));
  CHECK(ns(2 * state) == figure("T1"));
  const auto captures = [](int before) {  // the index begins and ends so long beside A and B low
    Ready bench;
    bench.command(Opcode::kSip);
    auto& in = bench.chip.in;
    bench.move_to(3);
    bench.clocks(10);
    in.index_n = before == 0;
    if (before > 0) bench.clocks(before);
    in.index_n = false;
    in.a = in.b = false;
    bench.clocks(1);
    in.a = true;
    if (before > 0) bench.clocks(before);
    in.index_n = true;
    bench.sample(2);
    return (bench.status() & 0x08) != 0;
  };
  CHECK(ns(least(captures, 0, 16)) == figure("T3"));
}

TEST_CASE("lm628 puts out a sample every 256 us: strobes of the converter, pulses of the LM629") {
  Ready bench;
  bench.command(Opcode::kPort12);
  bench.command(Opcode::kLfil, {0x0008, 100});
  bench.command(Opcode::kUdf);
  bench.trajectory(0, {});
  bench.command(Opcode::kStt);
  bench.move_to(-13);
  bench.sample(3);
  const auto until = [&](const std::function<bool()>& is) {
    for (int n = 0; !is(); ++n) {
      REQUIRE(n < 20'000);
      bench.clocks(1);
    }
    return bench.now();
  };
  const auto wr = [&] { return bench.out().drive.dac_wr_n; };
  const auto no_wr = [&] { return !bench.out().drive.dac_wr_n; };
  until(wr);
  bench.clocks(1000);  // both parts of this sample are out
  const std::int64_t first = until(no_wr);
  CHECK_FALSE(bench.out().drive.dac_hi_lo);
  const std::int64_t low_end = until(wr);
  const std::int64_t second = until(no_wr);
  CHECK(bench.out().drive.dac_hi_lo);
  until(wr);
  const std::int64_t next = until(no_wr);
  CHECK(ns(static_cast<int>(low_end - first)) == figure("strobe"));
  CHECK(ns(static_cast<int>(second - first)) == figure("parts"));
  CHECK(ns(static_cast<int>(next - first)) == figure("sample"));
  const auto high = [&] { return bench.out().drive.pwm_mag; };
  const auto low = [&] { return !bench.out().drive.pwm_mag; };
  until(low);
  const std::int64_t rise = until(high);
  const std::int64_t fall = until(low);
  const std::int64_t again = until(high);
  CHECK(ns(static_cast<int>(again - rise)) == figure("pulse"));
  CHECK(bench.engine().output() == 1300);
  CHECK(ns(static_cast<int>(fall - rise)) == 1300 / 256 * figure("step"));
}
