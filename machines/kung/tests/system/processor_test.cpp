// SPDX-License-Identifier: Apache-2.0
//
// Clocks that native firmware takes: those of the core of kung_soc, but for what the core computes
// at some points only. With the processor that was assumed before the core was measured, the runs
// of that time.
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "machines/kung/chip/soc.hpp"
#include "machines/kung/run/session.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

Options scenario(const std::string& name) {
  auto settings = lab::load_scenario(lab::find_scenario(name));
  lab::validate(*settings);
  return static_cast<const Options&>(*settings);
}

// Of each service routine, the clocks from the interrupt line to the end of each transfer.
struct Routines final : cosim::Observer {
  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override {
    if ((stop.why & cosim::kIrq) != 0) {
      all.emplace_back();
      rose = stop.edge;
    }
    if ((stop.why & cosim::kBusDone) != 0 && !all.empty()) all.back().push_back(stop.edge - rose);
  }
  std::vector<std::vector<cosim::Clk>> all;
  cosim::Clk rose = 0;
};

// Those of points: start-up and arming have other transfers.
std::vector<std::vector<cosim::Clk>> points_of(Options options, Cpu cpu) {
  constexpr std::size_t kTransfers = 14;
  options.cpu = cpu;
  options.run.max_s = 0.3;
  Session session(options, {});
  Routines routines;
  session.loop().watch(routines);
  const auto finished = [&session] { return session.finished(); };
  if (cpu == Cpu::kRtl) {
    cosim::CoreRun(session.loop(), *session.core(), session.end(), finished,
                   [](const cosim::CoreTrap&) {}).run();
  } else {
    cosim::run_direct(session.loop(), session.firmware(), session.timing(), session.end(),
                      finished);
  }
  std::vector<std::vector<cosim::Clk>> points;
  for (auto& one : routines.all) {
    if (one.size() == kTransfers) points.push_back(std::move(one));
  }
  return points;
}

std::uint64_t events(Options options) {
  options.run.engine = Engine::kTwin;
  options.run.platform = Platform::kDirect;
  Session session(options, {});
  test::run_through(session);
  return static_cast<const Result&>(*session.result()).event_hash;
}

struct Known {
  const char* scenario;
  Controller controller;
  std::uint64_t before, now;
};

// Version 5 of the register map moved them: ID is read. With 4 in its place they are as before.
constexpr std::array<Known, 12> kKnown{
    {{"circle", Controller::kFc, 0x8324b82ffc4226e8, 0xe22943c25f193404},
     {"circle", Controller::kAfc, 0x40dedd37440ef3c2, 0x22d3ce64284cc37d},
     {"window", Controller::kFc, 0x68334abed70193c3, 0x69c1d7efb737ac8f},
     {"window", Controller::kAfc, 0x50abd7b2bb6a1137, 0xdd89dd5566ed9712},
     {"star", Controller::kFc, 0x32a3262947b34ebc, 0x2c9ba8e70130e8e2},
     {"star", Controller::kAfc, 0x5384347d1f396375, 0x608d9e1a1e86878e},
     {"step", Controller::kFc, 0x174a2706e8712a8d, 0x567824924ec98cf3},
     {"step", Controller::kAfc, 0x5383ca8b106aa879, 0xdc41254dd4931ace},
     {"response", Controller::kFc, 0xe2128cf1e5c7c1ed, 0xb1c36dd40a12a5ca},
     {"response", Controller::kAfc, 0xee323260f82c4def, 0x4dd15668968f1f71},
     {"response-current", Controller::kFc, 0x2c270b7d2028bc92, 0x2c270b7d2028bc92},
     {"response-current", Controller::kAfc, 0x2c270b7d2028bc92, 0x2c270b7d2028bc92}}};

}  // namespace

TEST_CASE("transfers of native firmware end when those of the core do") {
  if (core_image().empty()) return;  // built without the cross compiler
  const Options options = scenario("circle");
  const auto core = points_of(options, Cpu::kRtl), native = points_of(options, Cpu::kNative);
  REQUIRE(core.size() > 50);
  REQUIRE(native.size() > 50);
  for (std::size_t n = 0; n < 50; ++n) {
    CAPTURE(n);
    CHECK(native[n][0] == core[n][0]);
    CHECK(std::abs(native[n][1] - core[n][1]) <= 1);
    for (std::size_t t = 2; t < native[n].size(); ++t) {
      CAPTURE(t);
      CHECK(std::abs(native[n][t] - core[n][t]) < 300);  // 6 us
    }
  }
}

TEST_CASE("built-in scenarios have the events that are known of them, and those of before") {
  for (const Known& known : kKnown) {
    CAPTURE(known.scenario, static_cast<int>(known.controller));
    Options options = scenario(known.scenario);
    options.controller = known.controller;
    CHECK(events(options) == known.now);
    options.processor.access_clk = 8;
    options.processor.interrupt_latency_clk = 100;
    options.point_clk = 0;
    CHECK(events(options) == known.before);
  }
}
