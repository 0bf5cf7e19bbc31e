// SPDX-License-Identifier: Apache-2.0
//
// The programs of AN-693 with each value of their setup alone, and what comes at another time than
// it was waited for.

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <utility>

#include "machines/an693/tests/fake_part.hpp"

using namespace trammel::an693_test;

namespace {

constexpr const char* kOff = "c1F d01 d00 c01 ";
constexpr const char* kClear = "c1D d00 d00 ";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

An693Setup two_speeds() {
  An693Setup setup = make_setup(An693Program::kBreakpoints);
  setup.wait_clk = 1234;
  return setup;
}

}  // namespace

TEST_CASE("an693 tells the part the width of its converter, and none where there is none") {
  for (const auto& [converter, init] : {std::pair{Lm628Converter::k12Bits, "c06 c1D d00 d00 "},
                                        {Lm628Converter::k8Bits, "c05 c1D d00 d00 "},
                                        {Lm628Converter::kNone, "c1D d00 d00 "}}) {
    An693Setup setup = make_setup(An693Program::kHold);
    setup.converter = converter;
    Bench bench(setup);
    CHECK(bench.on_timer() == std::string(init) + kFilter + "c1F d00 d00 c01 ");
  }
}

TEST_CASE("an693 names each coefficient by its own bit: kp 8, ki 4, kd 2, il 1") {
  struct Case {
    An693Filter filter;
    std::string written;
  };
  for (const auto& [filter, written] :
       {Case{{0x1234, 0x0102, 0, 0, 1}, "c1E d00 d0C d12 d34 d01 d02 c04 "},
        Case{{0x1234, 0, 0x0304, 0, 256}, "c1E dFF d0A d12 d34 d03 d04 c04 "},
        Case{{0x1234, 0, 0, 0x0506, 2}, "c1E d01 d09 d12 d34 d05 d06 c04 "},
        Case{{35, 5, 4000, 100, 4},
             "c1E d03 d0F d00 d23 d00 d05 d0F dA0 d00 d64 c04 "},
        Case{{0, 0, 0, 0, 1}, "c1E d00 d08 d00 d00 c04 "}}) {
    An693Setup setup = make_setup(An693Program::kHold);
    setup.filter = filter;
    Bench bench(setup);
    CHECK(bench.on_timer() == std::string(kInit) + written + "c1F d00 d00 c01 ");
  }
}

TEST_CASE("an693 unmasks at a breakpoint what its setup watches, and nothing else") {
  struct Case {
    std::uint32_t limit, index;
    std::string first, second;
  };
  for (const auto& [limit, index, first, second] :
       {Case{0, 0, "c1C d00 d40 ", "c1C d00 d44 "}, Case{9, 0, "c1C d00 d60 ", "c1C d00 d64 "},
        Case{0, 800, "c1C d00 d48 ", "c1C d00 d4C "},
        Case{9, 800, "c1C d00 d68 ", "c1C d00 d6C "}}) {
    An693Setup setup = two_speeds();
    setup.error_limit = limit;
    setup.index_counts = index;
    Bench bench(setup);
    CAPTURE(limit, index);
    const std::string begun = bench.on_timer();
    CHECK(has(begun, first));
    CHECK(has(begun, "c1A d00 d09 ") == (limit != 0));
    CHECK(has(begun, "c1A") == (limit != 0));
    CHECK(has(begun, "c03 ") == (index != 0));
    CHECK(bench.on_host(0x08) == kClear + std::string(index != 0 ? "c09 c03 " : ""));
    const std::string faster = bench.on_host(0x40);
    CHECK(has(faster, second));
  }
}

TEST_CASE("an693 waits its own time before STT, between steps and at the end, and not else") {
  An693Setup setup = make_setup(An693Program::kRelative);
  setup.wait_clk = 1234;
  Bench relative(setup);
  relative.on_timer();
  CHECK(relative.part.timer == 1234);
  relative.on_timer();
  CHECK(relative.part.timer == 0);
  CHECK(relative.app.mailbox().point == 1);
  relative.on_host(0x04);
  CHECK(relative.part.timer == 1234);
  CHECK_FALSE(relative.app.mailbox().done);
  setup = make_setup(An693Program::kTuning);
  setup.wait_clk = 4321;
  setup.steps = 2;
  Bench steps(setup);
  steps.on_timer();
  CHECK(steps.part.timer == 0);
  steps.on_host(0x04);
  CHECK(steps.part.timer == 4321);
  steps.on_timer();
  CHECK(steps.part.timer == 0);
  CHECK(steps.app.mailbox().point == 2);
  setup = make_setup(An693Program::kHold);
  setup.wait_clk = 77;
  Bench hold(setup);
  hold.on_timer();
  CHECK(hold.part.timer == 77);
}

TEST_CASE("an693 reports the desired position by RDDP and the real one by RDRP") {
  for (const bool negative : {false, true}) {
    Bench bench(make_setup(An693Program::kAbsolute));
    bench.on_timer();
    bench.on_host(0x04);
    if (negative) {
      bench.part.reply = {0xFF, 0xFE, 0x80, 0x01, 0xFF, 0xFF, 0xFF, 0x7F};
    } else {
      bench.part.reply = {0x00, 0x01, 0x80, 0x02, 0x00, 0x00, 0x80, 0x81};
    }
    CHECK(bench.on_timer() == "c08 c0A ");
    CHECK(bench.app.mailbox().desired[0] == (negative ? -98'303 : 98'306));
    CHECK(bench.app.mailbox().real[0] == (negative ? -129 : 32'897));
    CHECK(bench.app.mailbox().desired[1] == 0);
    CHECK(bench.app.mailbox().real[1] == 0);
    CHECK(failure_of(bench.app) == An693Failure::kNone);
  }
}

TEST_CASE("an693 clears what interrupted, and goes on at the event it waits for alone") {
  Bench bench(two_speeds());
  bench.on_timer();
  for (const int status : {0x00, 0x04, 0x08, 0x10, 0x80}) {
    CAPTURE(status);
    CHECK(bench.on_host(static_cast<std::uint8_t>(status)) == kClear);  // the first speed stays
    CHECK(bench.app.mailbox().point == 1);
  }
  bench.on_host(0x40);
  CHECK(bench.on_host(0x04) == kClear);  // the second one, too
  CHECK(bench.app.mailbox().point == 2);
  bench.on_host(0x40);
  CHECK(bench.on_host(0x40) == kClear);  // it stops already
  CHECK(bench.app.mailbox().point == 3);
  CHECK(bench.part.timer == 0);
  bench.on_host(0x04);
  CHECK(bench.part.timer == 1234);
  CHECK_FALSE(bench.app.mailbox().done);
}

TEST_CASE("an693 takes the part's interrupt first, and leaves the timer's for the next one") {
  Bench bench(make_setup(An693Program::kHold));
  bench.on_timer();
  bench.part.states = {0x04, 0x80};
  bench.part.irq = lm628_map::kIrqHost | lm628_map::kIrqTimer;
  bench.part.log.clear();
  bench.app.isr(bench.part);
  CHECK(bench.part.log == kClear);
  CHECK(bench.part.timer == 5'000'000);
  bench.part.irq = 0;  // nothing asks
  bench.part.log.clear();
  bench.app.isr(bench.part);
  CHECK(bench.part.log.empty());
  CHECK(bench.part.timer == 5'000'000);
}

TEST_CASE("an error of the part ends an693 in its last wait too, and the first one is told") {
  struct Case {
    std::uint8_t status, then;
    An693Failure failure;
  };
  for (const auto& [status, then, failure] :
       {Case{0x20, 0x02, An693Failure::kPositionError},
        Case{0x02, 0x20, An693Failure::kCommandError},
        Case{0x22, 0x02, An693Failure::kPositionError}}) {
    Bench bench(make_setup(An693Program::kAbsolute));
    bench.on_timer();
    bench.on_host(0x04);
    REQUIRE(bench.part.timer == 5'000'000);
    CAPTURE(int{status});
    CHECK(bench.on_host(status) == std::string(kClear) + kOff);
    CHECK(bench.part.timer == 0);
    CHECK(bench.app.mailbox().done == 1);
    CHECK(failure_of(bench.app) == failure);
    CHECK(bench.on_host(then) == kClear);
    CHECK(failure_of(bench.app) == failure);
    CHECK(bench.on_timer().empty());
    CHECK(bench.app.mailbox().real[0] == 0);
  }
}

TEST_CASE("an693 goes on with a part that its second or third reset brings to the right status") {
  for (const int wrong : {1, 2}) {
    Bench bench(make_setup(An693Program::kHold));
    CAPTURE(wrong);
    for (int n = 0; n < wrong; ++n) {
      bench.part.states = {0x00};
      CHECK(bench.on_timer() == "R ");
      CHECK(bench.part.timer == 75'000);
    }
    bench.part.states = {0xC4, 0x80};
    CHECK(bench.on_timer() == std::string(kInit) + kFilter + "c1F d00 d00 c01 ");
    CHECK(failure_of(bench.app) == An693Failure::kNone);
  }
}
