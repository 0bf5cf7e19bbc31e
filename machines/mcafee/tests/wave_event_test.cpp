// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <string>

#include "cosim/trigger.hpp"
#include "machines/mcafee/machine.hpp"

using namespace trammel;
using namespace trammel::cosim;

namespace {

Trigger parsed(const std::string& text) { return parse_trigger(text, mcafee::triggers()); }

}  // namespace

TEST_CASE("words of both axes and of the path are events") {
  CHECK_NOTHROW(parsed("x.e > 3"));
  CHECK_NOTHROW(parsed("y.e > 3"));
  CHECK_NOTHROW(parsed("row == 1"));
  CHECK_THROWS_AS(parsed("x.row == 1"), UnknownName);
  CHECK_THROWS_WITH(parsed("x.e > 40000"),
                    "x.e: value 40000 is out of range -32768..32767");
}

TEST_CASE("every name that is listed is accepted as an event") {
  for (const std::string& name : trigger_names(mcafee::triggers())) {
    INFO(name);
    const bool event = name == "drive" || name == "hi" || name == "irq";
    CHECK_NOTHROW(parsed(event ? name : "change " + name));
  }
}
