// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <map>

#include "cosim/trigger_search.hpp"
#include "cosim/wave_plan.hpp"
#include "machines/kung/chip.hpp"
#include "machines/kung/machine.hpp"

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;
using cosim::Trigger;
using cosim::TriggerSearch;
using cosim::UnknownName;

namespace {

Trigger parse_trigger(const std::string& text) { return cosim::parse_trigger(text, triggers()); }

// A chip of which only the named signals move.
struct FakeChip final : SignalReader {
  std::map<std::string, std::int64_t> values;  // "x.e", "TICK"
  std::int64_t read(std::size_t signal, int axis) const override {
    const Signal& s = signals()[signal];
    const auto found =
        values.find((s.of_axis ? (axis == 0 ? "x." : "y.") : "") + std::string(s.name));
    return found == values.end() ? 0 : found->second;
  }
};

// Edge at which `text` fires when `name` takes these values at edges 0, 1, 2, ...; -1 = never.
cosim::Clk fires(const std::string& text, const std::string& name,
                 const std::vector<std::int64_t>& values) {
  TriggerSearch search(parse_trigger(text));
  FakeChip chip;
  cosim::Clk edge = 0;
  for (const std::int64_t value : values) {
    chip.values[name] = value;
    search.after(edge++, chip);
  }
  return search.found().value_or(-1);
}

}  // namespace

TEST_CASE("a comparison fires when it becomes true, not while it holds from reset on") {
  CHECK(fires("x.e > 100", "x.e", {0, 100, 101, 0, 200}) == 2);
  CHECK(fires("x.e > 100", "x.e", {200, 200, 50, 101}) == 3);
  CHECK(fires("x.e > 100", "x.e", {200, 200}) == -1);
  CHECK(fires("y.i_q_ref < -500", "y.i_q_ref", {0, -500, -501}) == 2);
  CHECK(fires("x.e >= 100", "x.e", {0, 100}) == 1);
  CHECK(fires("x.e <= -3", "x.e", {0, -2, -3}) == 2);
  CHECK(fires("TICK == 5", "TICK", {3, 4, 5, 6}) == 2);
  CHECK(fires("TICK != 3", "TICK", {3, 3, 4}) == 2);
  CHECK(fires("x.STATUS == 0x1e01", "x.STATUS", {0, 0x1e01}) == 1);
}

TEST_CASE("a name without an axis means either axis, with one only that") {
  CHECK(fires("e > 100", "y.e", {0, 101}) == 1);
  CHECK(fires("y.e > 100", "y.e", {0, 101}) == 1);
  CHECK(fires("x.e > 100", "y.e", {0, 101}) == -1);
}

TEST_CASE("edges rise, fall or change") {
  CHECK(fires("rise x.CTRL.enable", "x.CTRL.enable", {1, 0, 0, 1}) == 3);
  CHECK(fires("fall x.CTRL.enable", "x.CTRL.enable", {0, 1, 1, 0}) == 3);
  CHECK(fires("change x.step", "x.step", {4, 4, 3}) == 2);
}

TEST_CASE("events are changes of the signals behind them") {
  CHECK(fires("drives", "y.CTRL.enable", {0, 1}) == 1);
  CHECK(fires("afc.x", "x.afc", {0, 0, 1, 1}) == 2);
  CHECK(fires("afc.x", "y.afc", {0, 0, 1, 1}) == -1);
  CHECK(fires("fault", "FAULT.code", {0, 3}) == 1);
  CHECK(fires("fault.encoder", "FAULT.code", {0, 4}) == 1);
  CHECK(fires("fault.encoder", "FAULT.code", {0, 3}) == -1);
}

TEST_CASE("a trigger held back by after still sees the values before") {
  CHECK(fires("rise irq after 60ns", "irq", {0, 1, 0, 1, 0, 1}) == 3);
  CHECK(fires("x.e > 0 after 40ns", "x.e", {0, 1, 1, 1}) == -1);  // it was true before
  CHECK(fires("x.e > 0 after 0.00006ms", "x.e", {0, 1, 0, 1}) == 3);
}

TEST_CASE("a time needs no search") {
  const Trigger trigger = parse_trigger(" at 10ms ");
  CHECK(trigger.when == Trigger::When::kAt);
  CHECK(trigger.edge == 500000);
}

TEST_CASE("what holds in reset does not fire when the reset ends") {
  TriggerSearch search(parse_trigger("fall irq"));
  FakeChip chip;
  chip.values["irq"] = 1;
  search.after(-1, chip);
  chip.values["irq"] = 0;
  search.after(0, chip);
  CHECK_FALSE(search.found());
}

TEST_CASE("an unknown name is distinguished from a malformed expression") {
  for (const char* text : {"x.ee > 3", "z.e > 3", "x.TICK == 3", "fault.encodr", "afc.z", "drive",
                           "rise x.CTRL.enabl", "faults"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_trigger(text), UnknownName);
  }
  for (const char* text : {"", "x.e", "x.e >", "> 3", "x.e > 1.5", "x.e => 3", "x.e > 3 after",
                           "rise", "at", "x.e > 3 and y.e > 3", "x.e > 3\n4"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_trigger(text), Contains("is none of: drives, afc, fault"));
  }
}

TEST_CASE("impossible values and times are refused with their range") {
  CHECK_THROWS_WITH(parse_trigger("x.e > 4000"), "x.e: value 4000 is out of range -2048..2047");
  CHECK_THROWS_WITH(parse_trigger("STATUS == -1"), "STATUS: value -1 is out of range 0..32767");
  CHECK_THROWS_WITH(parse_trigger("x.e > 99999999999999999999"), Contains("is out of range"));
  CHECK_THROWS_WITH(parse_trigger("at 5min"), Contains("value 5min is not a time"));
  CHECK_THROWS_WITH(parse_trigger("fault after -1ms"), Contains("value -1ms is not a time"));
  CHECK_THROWS_WITH(parse_trigger("at nan"), Contains("is not a time"));
  CHECK_THROWS_WITH(parse_trigger("at 1ms after 2ms"), Contains("exclude each other"));
}

TEST_CASE("every name in the list of signals is accepted") {
  for (const std::string& name : cosim::trigger_names(triggers())) {
    INFO(name);
    const bool event = name.rfind("fault", 0) == 0 || name.rfind("drives", 0) == 0 ||
                       name == "afc" || name == "afc.x" || name == "afc.y";
    CHECK_NOTHROW(parse_trigger(event ? name : "change " + name));
  }
}

TEST_CASE("times carry their unit") {
  CHECK(*cosim::parse_time("5") == 5);
  CHECK(*cosim::parse_time("5s") == 5);
  CHECK(*cosim::parse_time("-5ms") == Approx(-5e-3));
  CHECK(*cosim::parse_time("2.5us") == Approx(2.5e-6));
  CHECK(*cosim::parse_time("20ns") == Approx(20e-9));
  for (const char* text : {"", "ms", "5 ms", "5min", "inf", "5msx"}) {
    CHECK_FALSE(cosim::parse_time(text));
  }
}
