// SPDX-License-Identifier: Apache-2.0
//
// The programs of AN-693 send the bytes of the application note; a part that is always ready, with
// a status set by the test, stands in for the LM628.

#include "sw_nios/apps/an693/an693.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "machines/an693/tests/fake_part.hpp"

using namespace trammel::an693_test;

TEST_CASE("an693 E1 strobes RST, waits 1.5 ms and initialises the part") {
  FakePart part;
  part.states = {0x84, 0x80};
  An693App app(make_setup(An693Program::kHold));
  app.start(part);
  CHECK(part.log == "R ");
  CHECK(part.timer == 75'000);
}

TEST_CASE("an693 E1 resets again a part whose status is wrong, and gives up after three attempts") {
  An693App app(make_setup(An693Program::kHold));
  FakePart part;
  part.states = {0x00};
  app.start(part);
  part.irq = lm628_map::kIrqTimer;
  app.isr(part);
  app.isr(part);
  CHECK(part.log == "R R R ");
  app.isr(part);
  CHECK(part.log == "R R R ");  // such a part gets no command
  CHECK(failure_of(app) == An693Failure::kReset);
  CHECK(app.mailbox().done);
  CHECK(part.timer == 0);
}

TEST_CASE("an693 E1 takes 84h or C4h after the reset, then 80h or C0h, and no other status") {
  struct Case {
    std::uint8_t reset, cleared;
    bool taken;
  };
  for (const Case& one : {Case{0x84, 0x80, true}, Case{0xC4, 0x80, true}, Case{0x84, 0xC0, true},
                          Case{0xC4, 0xC0, true}, Case{0x80, 0x80, false}, Case{0x84, 0x84, false},
                          Case{0xC4, 0x40, false}, Case{0x04, 0x80, false}}) {
    CAPTURE(int{one.reset}, int{one.cleared});
    An693App app(make_setup(An693Program::kHold));
    FakePart part;
    app.start(part);
    part.log.clear();
    part.irq = lm628_map::kIrqTimer;
    part.states = {one.reset, one.cleared};
    app.isr(part);
    // Otherwise reset again. What the part got is shown where it is not that.
    CAPTURE(part.log);
    const bool reset_again = part.log.find('R') != std::string::npos;
    const bool filter_loaded = part.log.find(kFilter) != std::string::npos;
    CHECK(reset_again == !one.taken);
    CHECK(filter_loaded == one.taken);
  }
}

TEST_CASE("an693 E2 and E5 load kp = 10 and close the loop where the shaft is") {
  Bench bench(make_setup(An693Program::kHold));
  CHECK(bench.on_timer() == std::string(kInit) + kFilter + "c1F d00 d00 c01 ");
  CHECK(bench.on_host(0x04) == "c1D d00 d00 ");
  CHECK_FALSE(bench.app.mailbox().done);
  CHECK(bench.on_timer() == "c08 c0A ");
  CHECK(bench.app.mailbox().done);
}

TEST_CASE("an693 E6 moves to 8 000") {
  Bench bench(make_setup(An693Program::kAbsolute));
  CHECK(bench.on_timer() == std::string(kInit) + kFilter +
                                "c1F d00 d2A d00 d00 d00 d02 d00 d00 d34 d6E d00 d00 d1F d40 c01 ");
  CHECK(bench.on_host(0x04) == "c1D d00 d00 ");
  CHECK(bench.part.timer == 5'000'000);
  CHECK(bench.on_timer() == "c08 c0A ");
  CHECK(bench.app.mailbox().done);
}

TEST_CASE("an693 E7 loads a distance, waits and starts") {
  An693Setup setup = make_setup(An693Program::kRelative);
  setup.acceleration = 0x11;
  setup.velocity = 0x41893;
  setup.position = 120000;
  Bench bench(setup);
  CHECK(bench.on_timer() == std::string(kInit) + kFilter +
                                "c1F d00 d2B d00 d00 d00 d11 d00 d04 d18 d93 d00 d01 dD4 dC0 ");
  CHECK(bench.on_timer() == "c01 ");
}

TEST_CASE("an693 E8 and E4 change speed at two breakpoints and stop smoothly") {
  An693Setup setup = make_setup(An693Program::kBreakpoints);
  setup.acceleration = 0x11;
  setup.velocity = 0x20C4A;
  Bench bench(setup);
  CHECK(bench.on_timer() == std::string(kInit) + kFilter +
                                "c1C d00 d40 c20 d00 d01 d38 d80 "
                                "c1F d18 d28 d00 d00 d00 d11 d00 d02 d0C d4A c01 ");
  CHECK(bench.on_host(0x40) ==
        "c1D d00 d00 c20 d00 d02 d71 d00 c1F d18 d0C d00 d02 d0C d4A c01 c1C d00 d44 ");
  CHECK(bench.on_host(0x40) == "c1D d00 d00 c1F d04 d00 c01 ");
  CHECK(bench.on_host(0x04) == "c1D d00 d00 ");
  CHECK(bench.on_timer() == "c08 c0A ");
  CHECK(bench.app.mailbox().point == 3);
}

TEST_CASE("an693 E3 moves with the acceleration already loaded") {
  FakePart part;
  part.states = {0x80};
  Lm628Port port(part);
  an693_move(port, 0x346E, -2);
  CHECK(part.log == "c1F d00 d0A d00 d00 d34 d6E dFF dFF dFF dFE c01 ");
}

TEST_CASE("an693 E4 turns the motor off, stops abruptly or smoothly") {
  for (const auto& [stop, word] : {std::pair{An693Stop::kOff, "d01"}, {An693Stop::kAbrupt, "d02"},
                                   {An693Stop::kSmooth, "d04"}}) {
    FakePart part;
    part.states = {0x80};
    Lm628Port port(part);
    an693_stop(port, stop);
    CHECK(part.log == std::string("c1F ") + word + " d00 c01 ");
  }
}

TEST_CASE("an693 E9 steps there and back as many times as asked") {
  An693Setup setup = make_setup(An693Program::kTuning);
  setup.acceleration = setup.velocity = 0x3FFFFFFF;
  setup.position = 50;
  setup.steps = 5;
  Bench bench(setup);
  const std::string fast = "c1F d00 d2B d3F dFF dFF dFF d3F dFF dFF dFF ";
  CHECK(bench.on_timer() == std::string(kInit) + kFilter + fast + "d00 d00 d00 d32 c01 ");
  for (int step = 1; step < 5; ++step) {
    CAPTURE(step);
    CHECK(bench.on_host(0x04) == "c1D d00 d00 ");
    CHECK(bench.on_timer() ==
          fast + (step % 2 == 0 ? "d00 d00 d00 d32 c01 " : "dFF dFF dFF dCE c01 "));
    CHECK_FALSE(bench.app.mailbox().done);
  }
  bench.on_host(0x04);
  bench.on_timer();
  CHECK(bench.app.mailbox().done);
}

TEST_CASE("an693 turns the motor off at a position error, and stops at a command error") {
  for (const bool position : {true, false}) {
    Bench bench(make_setup(An693Program::kAbsolute));
    bench.on_timer();
    CHECK(bench.on_host(position ? 0x20 : 0x02) == "c1D d00 d00 c1F d01 d00 c01 ");
    CHECK(failure_of(bench.app) ==
          (position ? An693Failure::kPositionError : An693Failure::kCommandError));
  }
}

TEST_CASE("an index that is not a turn from the one before ends an693 with its motor off") {
  An693Setup setup = make_setup(An693Program::kAbsolute);
  setup.index_counts = 4000;
  for (const bool lost : {false, true}) {
    CAPTURE(lost);
    Bench bench(setup);
    bench.on_timer();
    bench.part.reply = {0, 0, 0x0F, 0xA0};  // 4000
    bench.on_host(0x08);
    REQUIRE(failure_of(bench.app) == An693Failure::kNone);
    bench.part.reply = {0, 0, 0x1F, static_cast<std::uint8_t>(lost ? 0x3D : 0x3E)};  // 8000 - 2
    const std::string end = bench.on_host(0x08);
    CHECK(failure_of(bench.app) == (lost ? An693Failure::kIndex : An693Failure::kNone));
    CHECK((end.find("c1F d01 d00 c01 ") != std::string::npos) == lost);
  }
  Bench bench(setup);  // whose move ends more than a turn behind its last index
  bench.on_timer();
  bench.on_host(0x04);
  bench.part.reply = {0, 0, 0x1F, 0x40, 0xFF, 0xFF, 0xF0, 0x5D};  // 8000, -4003
  bench.on_timer();
  CHECK(failure_of(bench.app) == An693Failure::kIndex);
}

TEST_CASE("indexes are a turn apart in both directions, and across the end of the numbers") {
  FakePart part;
  part.states = {0x80};
  Lm628Port port(part);
  const auto lost = [&](Lm628Index& index, std::int32_t at) {
    const auto bits = static_cast<std::uint32_t>(at);
    for (const int shift : {24, 16, 8, 0}) {
      part.reply.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
    return index.lost_at_index(port);
  };
  Lm628Index index(800);
  CHECK_FALSE(lost(index, -300));  // the first one is anywhere in the turn around the start
  CHECK_FALSE(lost(index, -1100));
  CHECK_FALSE(lost(index, -1100));  // turned back
  CHECK_FALSE(lost(index, -298));
  CHECK(lost(index, 496));
  CHECK_FALSE(index.lost_before(1298));
  CHECK(index.lost_before(1299));
  Lm628Index far(800);
  CHECK(lost(far, 2147483000));
  CHECK_FALSE(lost(far, -2147483496));  // 800 farther
}

TEST_CASE("an index may be two counts off where it was or a turn from there, and no count more") {
  FakePart part;
  part.states = {0x80};
  Lm628Port port(part);
  const auto lost = [&](Lm628Index& index, std::int32_t at) {
    for (const int shift : {24, 16, 8, 0}) {
      part.reply.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(at) >> shift));
    }
    return index.lost_at_index(port);
  };
  for (const std::int32_t sign : {-1, 1}) {
    for (const std::int32_t way : {0, 2, 3, 797, 798, 800, 802, 803}) {
      CAPTURE(sign, way);
      Lm628Index first(800), next(800);
      CHECK(lost(first, sign * way) == (way == 803));
      CHECK_FALSE(lost(next, 100));
      CHECK(lost(next, 100 + sign * way) == (way == 3 || way == 797 || way == 803));
      CHECK(first.lost_before(sign * (way + 802)) == false);
      CHECK(first.lost_before(sign * (way + 803)));
    }
  }
}

TEST_CASE("an693 gives up on a part that stays busy, after its first command or later") {
  for (const bool at_once : {true, false}) {
    Bench bench(make_setup(An693Program::kAbsolute));
    if (at_once) bench.part.busy_polls = Lm628Port::kPollLimit + 1;
    bench.on_timer();
    bench.part.busy_polls = Lm628Port::kPollLimit + 1;
    if (!at_once) bench.on_host(0x04);
    CHECK(failure_of(bench.app) == An693Failure::kBusy);
    CHECK(bench.app.mailbox().done);
    bench.part.busy_polls = 0;
    CHECK(bench.on_timer().empty());
  }
}

TEST_CASE("lm628 driver polls busy before each command and word, and gives up on a stuck part") {
  FakePart part;
  part.states = {0x80};
  part.busy_polls = 3;
  Lm628Port port(part);
  port.command(Lm628Command::kLtrj, 0x002A);
  port.long_word(-2);
  CHECK(part.log == "c1F d00 d2A dFF dFF dFF dFE ");
  CHECK(part.written_busy == 0);
  part.busy_polls = Lm628Port::kPollLimit + 1;
  port.command(Lm628Command::kStt);
  port.command(Lm628Command::kStt);
  CHECK(port.stuck());
  CHECK(part.log == "c1F d00 d2A dFF dFF dFF dFE c01 ");
}
