// SPDX-License-Identifier: Apache-2.0
#include "cosim/assertion.hpp"

#include <catch2/catch.hpp>

#include "tests/support/failed_assertion.hpp"

using trammel::cosim::take_failed_assertion;
using trammel::test::fail_assertion;

TEST_CASE("a failed assertion is reported with its label, its block's instance and its place") {
  fail_assertion("kung_xy.gen_axis[0].u_axis.u_pwm.u_pwm_props.off_at_phase_zero");
  const auto broken = take_failed_assertion();
  REQUIRE(broken);
  CHECK(broken->name == "off_at_phase_zero");
  CHECK(broken->instance == "kung_xy.gen_axis[0].u_axis.u_pwm");
  CHECK(broken->place == "drive/a_props.sv:7");
}

TEST_CASE("of several failed assertions the first counts, and only once") {
  fail_assertion("a.u_a_props.first");
  fail_assertion("a.u_a_props.second");
  CHECK(take_failed_assertion()->name == "first");
  CHECK_FALSE(take_failed_assertion());
}

TEST_CASE("a stop that is not an assertion is reported as one") {
  trammel_verilated_print("something else\n");
  vl_stop("x.sv", 3, "");
  const auto broken = take_failed_assertion();
  REQUIRE(broken);
  CHECK(broken->name == "$stop");
  CHECK(broken->instance.empty());
}
