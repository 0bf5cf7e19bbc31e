// SPDX-License-Identifier: Apache-2.0
#include <Vconversion_slots.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

#include "models/exact/sense/conversion_slots.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::ConversionSlots;
using trammel::test::Random;
using Client = ConversionSlots::Client;

namespace {

struct Bench {
  trammel::test::Rtl<Vconversion_slots> rtl;
  ConversionSlots twin;

  Bench() {
    put({});
    rtl.reset();
  }

  void put(const ConversionSlots::In& in) {
    rtl->pick_i = in.pick;
    rtl->observer_slots_i = static_cast<std::uint8_t>(in.observer_slots);
    rtl->requester_slots_i = static_cast<std::uint8_t>(in.requester_slots);
    rtl->wants_i = in.wants;
    rtl->ask_i = static_cast<std::uint8_t>(in.ask);
    rtl->done_i = in.done;
    rtl->channel_i = static_cast<std::uint8_t>(in.channel);
    rtl->code_i = static_cast<std::uint16_t>(in.code);
    rtl.eval();
  }

  Client clock(const ConversionSlots::In& in) {
    put(in);
    const Client turn = in.pick ? twin.pick(in) : Client::kNone;
    REQUIRE(bool(rtl->observer_o) == (turn == Client::kObserver));
    REQUIRE(bool(rtl->requester_o) == (turn == Client::kRequester));
    REQUIRE(bool(rtl->served_o) == twin.served(in));
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    if (turn == Client::kRequester) REQUIRE(rtl->channel_o == twin.channel());
    twin.step(in);
    rtl.tick();
    REQUIRE(rtl->pending_o == twin.pending());
    REQUIRE(rtl->a_o == twin.codes()[0]);
    REQUIRE(rtl->a_dot_o == twin.codes()[1]);
    REQUIRE(rtl->b_o == twin.codes()[2]);
    REQUIRE(rtl->b_dot_o == twin.codes()[3]);
    REQUIRE(rtl->current_o == twin.codes()[4]);
    return turn;
  }

  // Whose turn it is in n ticks: O, R or - each.
  std::string turns(int n, bool wants, std::uint32_t observer, std::uint32_t requester) {
    std::string out;
    for (int k = 0; k < n; ++k) {
      ConversionSlots::In in;
      in.pick = true;
      in.observer_slots = observer;
      in.requester_slots = requester;
      in.wants = wants;
      const Client turn = clock(in);
      out += turn == Client::kObserver ? 'O' : turn == Client::kRequester ? 'R' : '-';
    }
    return out;
  }
  void ask(std::uint32_t channels) {
    ConversionSlots::In in;
    in.ask = channels;
    clock(in);
  }
};

}  // namespace

TEST_CASE("conversion_slots: observer 2, requester 1, as the thesis sets them") {
  Bench bench;
  CHECK(bench.turns(5, true, 2, 1) == "OOOOO");  // one that asks for nothing uses no slot
  CHECK(bench.turns(3, false, 2, 1) == "---");
  bench.ask(0x40);
  CHECK(bench.turns(7, true, 2, 1) == "OOROORO");
}

TEST_CASE("conversion_slots: other numbers of slots, and none") {
  Bench bench;
  bench.ask(0x41);
  CHECK(bench.turns(8, true, 1, 3) == "ORRRORRR");
  CHECK(bench.turns(4, true, 0, 1) == "RRRR");
  CHECK(bench.turns(4, true, 3, 0) == "OOOO");
  CHECK(bench.turns(3, true, 0, 0) == "OO-");  // two slots of the turn before are left
}

TEST_CASE("conversion_slots: the lowest channel first; any conversion of a channel serves it") {
  Bench bench;
  bench.ask(0x4A);
  for (const std::uint32_t channel : {1u, 3u, 6u}) {
    CHECK(bench.twin.channel() == channel);
    ConversionSlots::In in;
    in.done = true;
    in.channel = channel;
    in.code = 100 + channel;
    CHECK(bench.twin.served(in));
    bench.clock(in);
    CHECK_FALSE(bench.twin.served(in));
  }
  CHECK(bench.twin.pending() == 0);
  CHECK(bench.rtl->current_o == 106);
}

TEST_CASE("conversion_slots agrees with its twin for any input") {
  Bench bench;
  Random random(7);
  for (int i = 0; i < 60'000; ++i) {
    ConversionSlots::In in;
    in.pick = random() % 2 == 0;
    in.observer_slots = random() % 16 == 0 ? random() % 256 : random() % 4;
    in.requester_slots = random() % 16 == 0 ? random() % 256 : random() % 4;
    in.wants = random() % 3 != 0;
    in.ask = random() % 4 == 0 ? random() & 0x7F : 0;
    in.done = random() % 2 == 0;
    in.channel = random() % 8;
    in.code = random() % 1024;
    bench.clock(in);
    if (random() % 2000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
  }
}
