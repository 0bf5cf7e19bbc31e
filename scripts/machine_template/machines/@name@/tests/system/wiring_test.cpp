// SPDX-License-Identifier: Apache-2.0
//
// The machine @name@ reaches its speed, with the same events in every wiring; what its chip
// does not declare is refused.
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "machines/@name@/machine_members.hpp"
#include "machines/@name@/record.hpp"

using namespace trammel;
using @name@::Options;

namespace {

Options short_run() {
  Options o;
  o.run.platform = cosim::Platform::kDirect;
  o.duration_s = 0.05;
  return o;
}

std::string refused(Options o) {
  try {
    lab::validate(o);
  } catch (const host::ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the motor reaches the speed that is asked for") {
  Options o = short_run();
  o.duration_s = 0.3;
  o.controller.speed = -40;
  const lab::Record record = lab::run(o);
  REQUIRE(record.result->end == cosim::EndReason::kDone);
  CHECK(record.figures.front().value == Approx(@name@::wanted_rev_s(o)).epsilon(0.01));
}

TEST_CASE("every wiring gives the same events") {
  const Options plain = short_run();
  const lab::Record record = lab::run(plain);
  Options systemc = plain, steps = plain, checked = plain, whole = plain;
  systemc.run.platform = cosim::Platform::kSystemC;
  steps.run.window_clk = 313;
  checked.run.assertions = true;
  whole.run.leap = false;
  for (const Options& other : {systemc, steps, checked, whole}) {
    const lab::Record same = lab::run(other);
    CHECK_FALSE(same.result->assertion);
    CHECK(same.result->event_hash == record.result->event_hash);
  }
  const bool leaps = @name@::machine().can.leap;
  CHECK((record.result->evaluated < record.result->clocks / 10) == leaps);
  CHECK(record.result->events < record.result->clocks / 100);
}

TEST_CASE("a motor without torque does not turn, which ends the run") {
  Options o = short_run();
  o.duration_s = 1;
  o.controller.speed = 100;
  o.plant.motor.supply = 1;
  o.plant.motor.inertia = 1;
  const lab::Record record = lab::run(o);
  CHECK(record.result->end == cosim::EndReason::kFault);
  CHECK(record.verdict == "tripped: the motor does not turn");
}

TEST_CASE("what the chip does not declare is refused with what is missing") {
  Options twin = short_run(), audit = short_run();
  twin.run.engine = cosim::Engine::kTwin;
  audit.run.audit = true;
  const std::string declares = "the machine @name@ declares no ";
  CHECK(refused(twin) == "run.engine: " + declares + "bit-exact twin of its chip");
  const std::string no_leap = "run.audit: " + declares +
                              "leap contract, so that no clock is leapt over and there is nothing "
                              "to compare";
  CHECK(refused(audit) == (@name@::machine().can.leap ? "" : no_leap));
}
