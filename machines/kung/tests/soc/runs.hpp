// SPDX-License-Identifier: Apache-2.0
//
// Runs with the processor's RTL, with all that it transfers and all changes of the gates.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/session.hpp"
#include "machines/kung/tests/soc/transfer.hpp"

namespace trammel::test {

using namespace kung;

inline constexpr double kClockHz = 50e6;
inline constexpr cosim::Clk kClocksPerBit = 434;  // of the serial port: 115,200 baud
inline constexpr cosim::Clk kTripsWithin = 4;  // from the pin to the gates (chips/kung_xy.md)

inline Options scenario(const std::string& name) {
  auto settings = lab::load_scenario(lab::find_scenario(name));
  lab::validate(*settings);
  auto options = static_cast<const Options&>(*settings);
  options.cpu = Cpu::kRtl;
  return options;
}

// A line: its rehearsal, with the drives off, takes the core less time than that of a circle.
inline Options line() {
  Options options = scenario("circle");
  options.path.kind = PathKind::kLine;
  options.path.line_start_x_m = options.path.line_start_y_m = 0.1;
  options.path.line_end_x_m = options.path.line_end_y_m = 0.13;
  options.path.line_ticks = 100;
  return options;
}

struct DriveEdges final : cosim::Observer {
  void on(const cosim::Stop& stop, const cosim::Chip& chip, const cosim::Plant&) override {
    if ((stop.why & cosim::kDrive) != 0) all.emplace_back(stop.edge, chip.drive());
  }
  std::vector<std::pair<cosim::Clk, cosim::Lines>> all;
};

struct Ran {
  std::vector<Transfer> transfers;
  std::vector<std::pair<cosim::Clk, cosim::Lines>> drive;
  cosim::CoreTimes times;
  Result result;
  std::string moved;
  std::optional<cosim::CoreTrap> trap;
};

// `own` is a core in the place of the session's.
inline Ran run(const Options& options, cosim::Clk end = 0, cosim::SerialHost* host = nullptr,
               SocCore* own = nullptr) {
  Session session(options, {});
  SocCore& soc = own != nullptr ? *own : dynamic_cast<SocCore&>(*session.core());
  if (host != nullptr) soc.connect(*host);
  RecordedCore core(soc);
  DriveEdges drive;
  std::optional<cosim::CoreTrap> trap;
  session.loop().watch(drive);
  cosim::CoreRun run(session.loop(), core, end == 0 ? session.end() : end,
                     [&] { return session.finished(); },
                     [&](const cosim::CoreTrap& at) {
                       trap = at;
                       session.trapped(at);
                     });
  run.run();
  session.core_ran(run.times());
  const auto result = session.result();
  return {std::move(core.transfers), std::move(drive.all), run.times(),
          std::move(static_cast<Result&>(*result)), soc.moved(), trap};
}

// Bytes of any value, one behind the other; what comes back.
struct Noise {
  explicit Noise(unsigned seed) : random(seed) {}
  std::mt19937 random;
  long sent = 0;
  std::string heard;
  cosim::SerialHost host{kClocksPerBit,
                         [this](cosim::Clk) -> std::optional<unsigned char> {
                           ++sent;
                           return static_cast<unsigned char>(random() & 0xFFu);
                         },
                         [this](unsigned char byte) { heard += static_cast<char>(byte); }};
};

// Equal writes of native firmware fed the reads of a run.
inline std::size_t native_writes(const Options& options, const std::vector<Transfer>& transfers) {
  const auto plan = plan_of(options);
  sw::KungApp app(plan->setup);
  Replay replay(transfers);
  return replay.run(app);
}

}  // namespace trammel::test
