// SPDX-License-Identifier: Apache-2.0
//
// The detailed record of a run: steps that end at the chip's words, gates with their dead time.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "machines/kung/chip/pins.hpp"
#include "machines/kung/chip/record.hpp"
#include "machines/kung/page/page.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

Options piece() {
  Options options;
  options.reached_m = 1;  // it ends while the table is still under way
  options.run.platform = Platform::kDirect;
  options.path.kind = PathKind::kLine;
  options.path.line_end_x_m = 0.11;
  options.path.line_end_y_m = 0.12;
  options.path.line_ticks = 40;
  return options;
}

bool gate(cosim::Lines gates, int bit) { return ((gates >> bit) & 1u) != 0; }

// Shortest time from one gate of a leg off to the other on, within the window [clk].
cosim::Clk shortest_dead_time(const GateWindow& window, int axis) {
  cosim::Clk shortest = cosim::kNever;
  for (int phase = 0; phase < 3; ++phase) {
    cosim::Clk off_since = cosim::kNever;
    for (const GateEdge& edge : window.edges) {
      const bool hi = gate(edge.gates, gate_hi(axis, phase));
      const bool lo = gate(edge.gates, gate_lo(axis, phase));
      REQUIRE_FALSE((hi && lo));
      if (!hi && !lo) {
        if (off_since == cosim::kNever) off_since = edge.edge;
      } else if (off_since != cosim::kNever) {
        if (off_since > window.begin) shortest = std::min(shortest, edge.edge - off_since);
        off_since = cosim::kNever;
      }
    }
  }
  return shortest;
}

}  // namespace

TEST_CASE("the fastest sample's steps end with the words of the chip") {
  const Options options = piece();
  const Result result = simulate(options, {});
  REQUIRE(result.end == EndReason::kDone);
  const Moment& moment = result.snapshot.moment;
  double fastest = 0;
  for (const Sample& sample : result.samples) {
    if (sample.edge + 6250 > result.clocks) continue;  // its window was never complete
    for (const AxisSample& axis : sample.axis) fastest = std::max(fastest, axis.v_true_m_s);
  }
  REQUIRE(moment.tick > 0);
  const Sample sample = result.samples[moment.tick - result.samples.front().tick];
  CHECK(sample.edge == moment.edge);
  CHECK(std::max(sample.axis[0].v_true_m_s, sample.axis[1].v_true_m_s) == fastest);
  CHECK(sample.axis[1].u == moment.end[1].u);
  // detail_json computes the steps and throws where they end elsewhere.
  const auto json = detail_json(options, result);
  CHECK(json["moment"]["y"]["steps"][29][1] == moment.end[1].i_q_ref);
  CHECK(result.snapshot.rules_first[1] != result.snapshot.rules_last[1]);
  CHECK(result.snapshot.rules_first[1][24] == 0);
}

TEST_CASE("the window holds two PWM periods from the sample on, with the dead time set") {
  Options options = piece();
  options.chip.axis[1].dead_time_ns = 1000;
  const GateWindow gates = simulate(options, {}).snapshot.gates;
  CHECK(gates.end - gates.begin == 6250);
  CHECK(gates.trip == cosim::kNever);
  CHECK(gates.edges.size() > 20);
  CHECK(shortest_dead_time(gates, 0) == 100);
  CHECK(shortest_dead_time(gates, 1) == 50);
  // The upper switch goes off at the falling side of the carrier: phase 3125 - CMP, registered
  // twice on its way to the pin.
  REQUIRE(gates.compare.size() == 2);
  for (int period = 0; period < 2; ++period) {
    const auto cmp = gates.compare[static_cast<std::size_t>(period)][1][0];
    const cosim::Clk off = gates.begin + 3125 * period + 3125 - cmp + 1;
    bool found = false;
    for (const GateEdge& edge : gates.edges) {
      found = found || (edge.edge == off && !gate(edge.gates, gate_hi(1, 0)));
    }
    CAPTURE(period, cmp, off - gates.begin);
    CHECK(found);
  }
}

TEST_CASE("after a trip the window lies around the edge that turned the gates off") {
  Options options = piece();
  options.fault = {cosim::FaultKind::kTripPin, 0.03};
  const Result result = simulate(options, {});
  REQUIRE(result.end == EndReason::kFault);
  const GateWindow& gates = result.snapshot.gates;
  CHECK(gates.trip >= 1'500'000);
  CHECK(gates.trip < 1'500'010);
  CHECK(gates.begin == gates.trip - 3125);
  CHECK(gates.end == gates.trip + 3125);
  CHECK(gates.edges.size() > 5);
  CHECK(gates.edges.back().edge == gates.trip);
  CHECK(gates.edges.back().gates == 0);
  CHECK(gates.edges.front().gates != 0);
}

TEST_CASE("a window of a trip ends with a run that ends before it") {
  Options options = piece();
  options.fault = {cosim::FaultKind::kTripPin, 0.03};
  options.run.max_s = 0.03004;
  const Result result = simulate(options, {});
  const GateWindow& gates = result.snapshot.gates;
  REQUIRE(gates.trip >= 1'500'000);
  REQUIRE(result.clocks < gates.trip + 3125);
  CHECK(gates.end == result.clocks);
  CHECK(gates.begin == gates.trip - 3125);
  CHECK(gates.edges.back().edge < gates.end);
}
