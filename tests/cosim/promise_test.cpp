// SPDX-License-Identifier: Apache-2.0
#include "cosim/promise.hpp"

#include <catch2/catch.hpp>

#include "tests/support/broken_promise.hpp"

using trammel::cosim::take_broken_promise;
using trammel::test::break_promise;

TEST_CASE("a failed assertion is reported with its label, its block's instance and its place") {
  break_promise("kung_xy.gen_axis[0].u_axis.u_pwm.u_pwm_props.off_at_phase_zero");
  const auto broken = take_broken_promise();
  REQUIRE(broken);
  CHECK(broken->name == "off_at_phase_zero");
  CHECK(broken->instance == "kung_xy.gen_axis[0].u_axis.u_pwm");
  CHECK(broken->place == "drive/a_props.sv:7");
}

TEST_CASE("of several failed assertions the first counts, and only once") {
  break_promise("a.u_a_props.first");
  break_promise("a.u_a_props.second");
  CHECK(take_broken_promise()->name == "first");
  CHECK_FALSE(take_broken_promise());
}

TEST_CASE("a stop that is not an assertion is reported as one") {
  trammel_verilated_print("something else\n");
  vl_stop("x.sv", 3, "");
  const auto broken = take_broken_promise();
  REQUIRE(broken);
  CHECK(broken->name == "$stop");
  CHECK(broken->instance.empty());
}
