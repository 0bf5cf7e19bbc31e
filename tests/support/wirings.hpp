// SPDX-License-Identifier: Apache-2.0
//
// One run in every wiring, and watched in every way: equal events, and an equal record.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <vector>

#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "tests/support/scratch.hpp"

namespace trammel::test {

// Every column of every sample, and the energy from the supply.
template <class Options, class Result>
void check_equal(const Options& options, const Result& is, const Result& wanted) {
  CHECK_FALSE(is.assertion);
  CHECK(is.end == wanted.end);
  CHECK(is.event_hash == wanted.event_hash);
  CHECK(is.supplied_J == wanted.supplied_J);
  REQUIRE(is.samples.size() == wanted.samples.size());
  const lab::ColumnTable& table = options.machine().columns();
  std::vector<double> ours, theirs;
  for (std::size_t k = 0; k < is.samples.size(); ++k) {
    table.read(options, is, k, ours);
    table.read(options, wanted, k, theirs);
    CAPTURE(k);
    REQUIRE(ours == theirs);
  }
}

// The run of `plain`, by the RTL that leaps, after those that must be equal to it.
template <class Options>
auto check_wirings(const Options& plain) {
  auto first = lab::simulate(plain);
  const auto same = [&](const char* how, auto change) {
    INFO(how);
    Options other = plain;
    change(other.run);
    const auto result = lab::simulate(other);
    check_equal(other, result, first);
    return result.evaluated;
  };
  same("SystemC", [](auto& run) { run.platform = cosim::Platform::kSystemC; });
  same("SystemC in short windows", [](auto& run) {
    run.platform = cosim::Platform::kSystemC;
    run.window_clk = 313;
  });
  same("lock-step", [](auto& run) { run.window_clk = 1; });
  same("twin", [](auto& run) { run.engine = cosim::Engine::kTwin; });
  CHECK(same("audit", [](auto& run) { run.audit = true; }) == first.evaluated);
  CHECK(same("every clock", [](auto& run) { run.leap = false; }) >= first.clocks);
  return first;
}

// The same with assertions, and with waves: of the start, in windows that begin anywhere, or both.
template <class Options>
void check_watched(const Options& plain, double window_s, double every_s) {
  const auto first = lab::simulate(plain);
  for (const int how : {0, 1, 2, 3}) {
    CAPTURE(how);
    Options other = plain;
    other.run.assertions = how == 0 || how == 3;
    if (how > 0) {
      other.run.wave = cosim::WaveFormat::kFst;
      other.run.wave_file = own_file("wirings.fst");
    }
    if (how == 2) {
      other.run.wave_end_s = window_s;
      other.run.wave_every_s = every_s;
    }
    const auto result = lab::simulate(other);
    check_equal(other, result, first);
    CHECK(result.waves.empty() == (how == 0));
    if (how == 0) CHECK(result.evaluated >= result.clocks);
    std::filesystem::remove(other.run.wave_file);
  }
}

}  // namespace trammel::test
