// SPDX-License-Identifier: Apache-2.0
//
// The chip of the machine gantry, by RTL and by twin: the words that it shows against what the
// sensor sees, its memory, the data of an ideal sensor, and the ranges of what a trigger may name.
#include <catch2/catch.hpp>
#include <cmath>

#include "cosim/trigger.hpp"
#include "lab/record.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/session.hpp"
#include "machines/gantry/surroundings.hpp"
#include "machines/gantry/tests/by_twin.hpp"
#include "models/exact/chips/gantry_tau.hpp"
#include "models/exact/sense/calibration.hpp"
#include "tests/support/message.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::gantry;

namespace {

constexpr double kPi = 3.141592653589793;
constexpr cosim::Engine kEngines[] = {cosim::Engine::kTwin, cosim::Engine::kRtl};

}  // namespace

TEST_CASE("gantry: the words at rest are those of A and B, in each quarter of a period") {
  for (const cosim::Engine engine : kEngines) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      Options options = by_twin(0.01);
      options.run.engine = engine;
      options.axis.start = 0.2 + 1.25e-3 * (quarter + 0.1);  // of a period of 5 mm
      options.sends = "";
      const Result result = lab::simulate(options);
      const Sample last = result.samples.back();
      const double a = last.stripes[0] - 512, b = last.stripes[1] - 512;
      CAPTURE(static_cast<int>(engine), quarter, a, b, last.words.phase);
      CHECK(last.words.known);
      CHECK(last.words.codes[0] == last.stripes[0]);
      CHECK(last.words.codes[2] == last.stripes[1]);
      CHECK(std::abs(last.words.codes[quarter % 2 == 0 ? 3 : 1] - 512) <= 1);  // its derivative
      CHECK(last.words.codes[4] == 0);
      const double turn = std::atan2(b, a) / (2 * kPi);  // A is its cosine, B its sine
      const double angle = 16384 * (turn < 0 ? turn + 1 : turn);
      CHECK(last.words.phase == Approx(angle).margin(40));
      // The code that is steeper tells the angle: B about 0 and half a period, A between them.
      CHECK(last.words.region == static_cast<int>(angle + 2048) / 4096 % 4);
      CHECK(last.words.region == quarter);
    }
  }
}

TEST_CASE("gantry: the chip counts 4612 conversions in a second, at rest and in motion") {
  for (const cosim::Engine engine : kEngines) {
    Options options = by_twin(0.2);
    options.run.engine = engine;
    options.sends = "0.05:21=305";
    const Result result = lab::simulate(options);
    const Sample begin = result.samples[10], end = result.samples[result.samples.size() - 1];
    const double seconds = result.seconds(end.edge - begin.edge);
    CAPTURE(static_cast<int>(engine), begin.words.ticks, end.words.ticks);
    CHECK(end.words.ticks - begin.words.ticks == Approx(4612 * seconds).margin(1.5));
  }
}

TEST_CASE("gantry: the engine that a run asks for is the one that it has") {
  test::check_engines<Session>(by_twin(0.01), [] { return make_twin_chip({}); });
}

TEST_CASE("gantry: the memory takes a word where it is written, and shows what is asked for") {
  ChipSetup setup;
  setup.store[7] = 0x5A5A;
  Surroundings surroundings(setup);
  const auto code = [](int) { return 0; };
  exact::GantryTau::Out out;
  exact::GantryTau::In in;
  out.nv_addr_o = 7;
  out.nv_data_o = 0x1234;
  CHECK(surroundings.serve(out, in, code));
  CHECK(surroundings.nv_word() == 0x5A5A);
  out.nv_valid_o = true;
  CHECK_FALSE(surroundings.serve(out, in, code));
  CHECK(surroundings.nv_word() == 0x5A5A);
  out.nv_write_o = true;
  out.nv_valid_o = false;
  surroundings.serve(out, in, code);
  CHECK(surroundings.nv_word() == 0x5A5A);
  out.nv_valid_o = true;
  surroundings.serve(out, in, code);
  CHECK(surroundings.nv_word() == 0x1234);
  for (std::size_t k = 0; k < surroundings.store.size(); ++k) {
    CHECK(surroundings.store[k] == (k == 7 ? 0x1234 : 0));
  }
}

TEST_CASE("gantry: the data of an ideal sensor give each angle of it, and their checksum") {
  exact::Calibration data;
  const Store store = ideal_store();
  for (std::size_t k = 0; k < data.words.size(); ++k) data.words[k] = store[k];
  CHECK(exact::sealed(data).words == data.words);
  for (int region = 0; region < 4; ++region) {  // ends an eighth behind each quarter of a period
    CHECK(store[6 + static_cast<std::size_t>(region)] == 4096 * region + 2048);
  }
  for (int angle = 0; angle < 16384; angle += 37) {
    const double turn = 2 * kPi * angle / 16384;
    const std::size_t region = exact::SincosObserver::region(angle, data);
    const double level = region % 2 == 0 ? std::sin(turn) : std::cos(turn);
    const auto code = static_cast<std::uint32_t>(std::lround(512 + 400 * level));
    const int off = exact::SincosObserver::phase(code, region, data) - angle;
    CAPTURE(angle, region, code);
    CHECK(std::abs((off + 24576) % 16384 - 8192) <= 30);  // a code at an eighth is 9 of them
  }
}
