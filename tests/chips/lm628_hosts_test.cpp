// SPDX-License-Identifier: Apache-2.0
//
// The ways in which hosts use the port of an LM628: busy before each byte or each word or fixed
// waits, status reads between the bytes of a word, events by HI or by the status byte. Each way
// plays each program, on the RTL beside its twin, and must come to the same end without command
// error.

#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "tests/chips/lm628_pair.hpp"

using trammel::exact::Opcode;
using trammel::test::as_bits;
using trammel::test::as_signed;
using trammel::test::Lm628Pair;
using Bench = trammel::test::Lm628Bench<Lm628Pair>;

namespace {

constexpr unsigned kError = 0x02, kComplete = 0x04, kIndex = 0x08, kBreakpoint = 0x40;
constexpr std::int64_t kA = 20000, kV = 200000;  // 3 counts a sample after 10 samples
constexpr std::int64_t kFar = 150;

struct Style {
  const char* name;
  bool polls = true;       // busy, before each command and word; else it waits 120 us after each
  bool each_byte = false;  // busy before the second byte of a word, too
  int looks = 0;           // status reads between the two bytes
  bool by_irq = false;     // HI tells of events
};

constexpr Style kStyles[] = {{"busy before each word"},
                             {"busy before each byte", true, true},
                             {"a status read within each word", true, false, 1},
                             {"three status reads within each word", true, false, 3},
                             {"HI, busy before each word", true, false, 0, true},
                             {"HI, busy before each byte", true, true, 0, true},
                             {"fixed waits", false},
                             {"fixed waits and HI", false, false, 0, true}};

class Host {
 public:
  explicit Host(const Style& style) : style_(style) {
    bench.follows = true;
    bench.start();
  }

  Bench bench;

  std::uint8_t status() { return bench.read(false); }

  void command(Opcode opcode, std::initializer_list<unsigned> words = {}) {
    ready();
    bench.write(false, Bench::code(opcode));
    settle();
    for (const unsigned value : words) word(value);
  }

  void trajectory(unsigned control, std::initializer_list<std::int64_t> values = {}) {
    command(Opcode::kLtrj, {control});
    for (const std::int64_t value : values) long_word(value);
  }
  void long_word(std::int64_t value) {
    const std::uint32_t bits = as_bits(value, 32);
    word(bits >> 16);
    word(bits & 0xFFFF);
  }

  std::int64_t ask(Opcode opcode) {
    command(opcode);
    const std::int64_t high = read_word();
    if (trammel::exact::words_replied(Bench::code(opcode)) == 1) return high;
    return as_signed(static_cast<std::uint64_t>(high << 16 | read_word()), 32);
  }

  // Its events: those that it waits for interrupt, where it works by interrupts.
  void enable(unsigned events) {
    if (style_.by_irq) command(Opcode::kMski, {events});
    command(Opcode::kRsti, {0});
    finish();
  }

  // Until the event; then it clears what is set.
  void wait(unsigned event) {
    const auto is_there = [&] {
      return style_.by_irq ? bench.out().hi : (status() & event) != 0;
    };
    for (int n = 0; !is_there(); ++n) {
      REQUIRE(n < 400);
      bench.sample();
    }
    REQUIRE((status() & event) != 0);
    command(Opcode::kRsti, {0});
    finish();
    REQUIRE((status() & event) == 0);
    REQUIRE_FALSE(bench.out().hi);
  }

  void finish() {  // the last word has been executed
    while ((status() & 1) != 0) bench.clocks(50);
  }

  // A filter, and the loop closed.
  void set_up() {
    command(Opcode::kPort12);
    command(Opcode::kRsti, {0});
    command(Opcode::kLfil, {0x030F, 50, 1, 1000, 100});
    command(Opcode::kUdf);
    finish();
    REQUIRE(status() == 0x80);
  }

 private:
  void ready() {
    while (style_.polls && (status() & 1) != 0) {
    }
  }
  void settle() {
    if (!style_.polls) bench.clocks(6000);
  }
  void between() {
    if (style_.each_byte) ready();
    for (int n = 0; n < style_.looks; ++n) REQUIRE((status() & 1) == 0);
  }
  void word(unsigned value) {
    ready();
    bench.write(true, static_cast<std::uint8_t>(value >> 8));
    between();
    bench.write(true, static_cast<std::uint8_t>(value));
    settle();
  }
  std::uint16_t read_word() {
    ready();
    const unsigned high = bench.read(true);
    between();
    const unsigned low = bench.read(true);
    settle();
    return static_cast<std::uint16_t>(high << 8 | low);
  }

  Style style_;
};

// What each host must see alike, in order.
using Seen = std::vector<std::int64_t>;

void play(const std::function<Seen(Host&)>& program) {
  Seen first;
  for (const Style& style : kStyles) {
    INFO(style.name);
    Host host(style);
    host.set_up();
    const Seen seen = program(host);
    host.finish();
    CHECK((host.status() & kError) == 0);
    if (first.empty()) first = seen;
    CHECK(seen == first);
  }
}

std::int64_t at_rest(Host& host) {
  host.bench.sample(2);
  CHECK(host.ask(Opcode::kRddp) == host.ask(Opcode::kRdrp));
  CHECK(host.ask(Opcode::kRddv) == 0);
  return host.ask(Opcode::kRdrp);
}

}  // namespace

TEST_CASE("every kind of host finds the part, loads it and reads back what it loaded") {
  play([](Host& host) {
    host.enable(kComplete);
    host.trajectory(0x002A, {kA, kV, kFar});
    host.command(Opcode::kStt);
    host.wait(kComplete);
    Seen seen{at_rest(host), host.ask(Opcode::kRdsigs) & 0x7FFF, host.ask(Opcode::kRdsum)};
    CHECK(seen[0] == kFar);
    CHECK(seen[1] == 0x0400);  // on target
    CHECK(host.bench.engine().filter().kp == 50);
    CHECK(host.bench.engine().filter().il == 100);
    host.trajectory(0x002B, {kA / 2, kV * 2, -2 * kFar});
    host.command(Opcode::kStt);
    host.wait(kComplete);
    seen.push_back(at_rest(host));
    CHECK(seen.back() == -kFar);
    return seen;
  });
}

TEST_CASE("every kind of host meets breakpoint and index on the way") {
  play([](Host& host) {
    host.enable(kBreakpoint | kIndex);
    host.bench.set_index(120);
    host.command(Opcode::kSbpa);
    host.long_word(40);
    host.command(Opcode::kSip);
    host.trajectory(0x1828, {kA, kV});
    host.command(Opcode::kStt);
    host.wait(kBreakpoint);
    const std::int64_t at = host.ask(Opcode::kRdrp);
    CHECK(at >= 40);
    CHECK(at < 120);
    host.wait(kIndex);
    const Seen seen{host.ask(Opcode::kRdip)};
    CHECK(seen[0] == 120);
    host.enable(kComplete);
    host.trajectory(0x0400);
    host.command(Opcode::kStt);
    host.wait(kComplete);
    CHECK(at_rest(host) > 120);
    return seen;
  });
}

TEST_CASE("every kind of host goes on after a stop by STT alone") {
  for (const unsigned stop : {0x0400u, 0x0200u, 0x0100u}) {
    CAPTURE(stop);
    play([stop](Host& host) {
      host.enable(kComplete);
      host.trajectory(0x002A, {kA, kV, kFar});
      host.command(Opcode::kStt);
      host.bench.sample(25);
      host.trajectory(stop);
      host.command(Opcode::kStt);
      host.wait(kComplete);
      host.bench.sample(2);
      const std::int64_t on_its_way = at_rest(host);
      CHECK(on_its_way > 10);
      CHECK(on_its_way < kFar);
      CHECK(((host.status() & 0x80) != 0) == (stop == 0x0100));
      host.command(Opcode::kStt);
      host.wait(kComplete);
      CHECK((host.status() & 0x80) == 0);
      const Seen seen{at_rest(host)};
      CHECK(seen[0] == kFar);
      return seen;
    });
  }
}

TEST_CASE("every kind of host may define home in motion: the shaft ends where it was to end") {
  for (const bool again : {false, true}) {
    CAPTURE(again);
    play([again](Host& host) {
      host.enable(kComplete);
      host.trajectory(0x002A, {kA, kV, kFar});
      host.command(Opcode::kStt);
      host.bench.sample(20);
      host.bench.follows = false;  // the shaft rests for a moment, so that its place is known
      host.bench.sample(2);
      const std::int64_t home = host.bench.position();
      host.command(Opcode::kDfh);
      host.finish();
      CHECK(home > 10);
      if (again) host.command(Opcode::kStt);
      for (int n = 0; (host.status() & kComplete) == 0; ++n) {
        REQUIRE(n < 400);
        host.bench.sample();
        host.bench.move_to(home + (host.bench.engine().desired().position >> 16));
      }
      host.bench.sample(2);
      CHECK(host.ask(Opcode::kRdrp) == (again ? kFar : kFar - home));
      const Seen seen{again ? host.bench.position() - home : host.bench.position()};
      CHECK(seen[0] == kFar);
      return seen;
    });
  }
}

TEST_CASE("every kind of host can stop with an acceleration preloaded, which a later STT takes") {
  play([](Host& host) {
    host.enable(kComplete);
    host.trajectory(0x1828, {kA, kV});
    host.command(Opcode::kStt);
    host.bench.sample(20);
    REQUIRE(host.ask(Opcode::kRddv) == kV);
    host.trajectory(0x1820, {kA * 4});
    CHECK((host.ask(Opcode::kRdsigs) & 0x4000) != 0);
    host.trajectory(0x0400);
    host.command(Opcode::kStt);
    int ramp = 0;
    for (; host.bench.engine().desired().speed != 0 && ramp < 50; ++ramp) host.bench.sample();
    CHECK(ramp >= kV / kA - 2);  // the acceleration in use
    host.wait(kComplete);
    CHECK((host.ask(Opcode::kRdsigs) & 0x4000) != 0);
    host.trajectory(0x1808, {kV});
    host.command(Opcode::kStt);
    host.finish();
    host.bench.sample(4);
    const Seen seen{host.bench.engine().desired().speed, host.ask(Opcode::kRdsigs) & 0x4000};
    CHECK(seen[0] >= kA * 4 * 2);
    CHECK(seen[1] == 0);
    return Seen{seen[1]};
  });
}
