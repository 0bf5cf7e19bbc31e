// SPDX-License-Identifier: Apache-2.0
//
// Events of the table that a trigger may name; of triggers in general, tests/cosim.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "machines/kung/chip.hpp"
#include "machines/kung/machine.hpp"

using namespace trammel;
using namespace trammel::kung;
using cosim::Trigger;
using cosim::TriggerSearch;

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

TEST_CASE("events are changes of the signals behind them") {
  CHECK(fires("drives", "y.CTRL.enable", {0, 1}) == 1);
  CHECK(fires("afc.x", "x.afc", {0, 0, 1, 1}) == 2);
  CHECK(fires("afc.x", "y.afc", {0, 0, 1, 1}) == -1);
  CHECK(fires("fault", "FAULT.code", {0, 3}) == 1);
  CHECK(fires("fault.encoder", "FAULT.code", {0, 4}) == 1);
  CHECK(fires("fault.encoder", "FAULT.code", {0, 3}) == -1);
  for (const char* text : {"fault.encodr", "afc.z", "drive", "faults"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_trigger(text), cosim::UnknownName);
  }
}
