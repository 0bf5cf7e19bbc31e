// SPDX-License-Identifier: Apache-2.0
//
// The view that is made of a machine's waves.
#include <catch2/catch.hpp>
#include <string>

#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/view.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;
using Catch::EndsWith;

namespace {

std::string view(const std::string& toml, const std::string& filter = "/bin/py") {
  const auto settings = machines().front()->defaults();
  settings->run.max_s = 40;
  return make_views(*settings, toml, "v.toml", filter).gtkwave;
}

}  // namespace

TEST_CASE("signals of a view are shown as their words say, in groups that may be closed") {
  CHECK_THAT(view("top = \"t\"\ngroups = [\n"
                  "[\"A\", \"clk\", \"n[3:0] #2\", \"pc: u.pc_q[9:0] hex\"],\n"
                  "[\"-B\", \"x: m[0][7:0] curve Q4\"]]\nmore = [[\"\", \"irq\"]]\n"),
             EndsWith("@800200\n-A\n@28\n+{clk} t.clk\n@24\n[color] 2\n+{n} t.n[3:0]\n"
                      "@22\n+{pc} t.u.pc_q[9:0]\n@1000200\n-A\n"
                      "@c00200\n-B\n@40008420\n[fpshift_count] 4\n+{x} t.m[0][7:0]\n@20000\n-\n"
                      "@1401200\n-B\n@28\n+{irq} t.irq\n"));
}

TEST_CASE("each axis has the groups of an axis in its own scope, those of the second are closed") {
  CHECK_THAT(view("top = \"t\"\naxes = [[\"X\", \"u[0]\"], [\"Y\", \"u[1]\"]]\n"
                  "of_each_axis = [[\"loop\", \"i[1:0] signed\"]]\n"),
             EndsWith("@800200\n-X loop\n@420\n+{i} t.u[0].i[1:0]\n@1000200\n-X loop\n"
                      "@c00200\n-Y loop\n@420\n+{i} t.u[1].i[1:0]\n@1401200\n-Y loop\n"));
}

TEST_CASE("a signal with a unit is scaled by numbers and keys, one filter a scale") {
  const std::string toml = "top = \"t\"\nunits.mm_q = [3, \"run.max_s\", \"/run.max_s\", 0.5]\n"
                           "groups = [[\"\", \"a[1:0] signed mm_q\", \"b[1:0] mm_q\"]]\n";
  const std::string scaled = view(toml);
  CHECK_THAT(scaled, Contains("@4420\n^>1 /bin/py -cimport sys;[print('%.4g mm'%(int(v)*1.5) if"));
  CHECK_THAT(scaled, Contains("@4024\n^>1 /bin/py"));
  CHECK_THAT(view(toml, ""), EndsWith("@420\n+{a} t.a[1:0]\n@24\n+{b} t.b[1:0]\n"));
}

TEST_CASE("Surfer has the same groups and signals, each in its form, and memories as scopes") {
  const std::string toml =
      "top = \"t\"\naxes = [[\"X\", \"u[0]\"]]\ngroups = [[\"-A\", \"clk\", \"n[3:0] hex\"]]\n"
      "of_each_axis = [[\"loop\", \"m: m[2][7:0] signed Q4\", \"a[1:0] level\"]]\n";
  CHECK(make_views(*machines().front()->defaults(), toml, "v.toml", "").surfer ==
        "divider_add \"A\"\nvariable_add t.clk\nvariable_add t.n\nitem_set_format Hexadecimal\n"
        "divider_add \"X loop\"\nvariable_add t.u[0].m.[2]\nitem_set_format Signed\n"
        "variable_add t.u[0].a\nitem_set_format Unsigned\n");
}

TEST_CASE("a view that cannot be made is refused with its file and what is wrong") {
  CHECK_THROWS_WITH(view("top = 1 2\n"), Contains("v.toml:1: "));
  CHECK_THROWS_WITH(view(""), "v.toml: top: the name of the chip is missing");
  CHECK_THROWS_WITH(view("top = \"t\"\ngroups = [[\"A\", \"a[1:0] V\"]]\n"),
                    "v.toml: a[1:0] V: V is no unit of this file");
  CHECK_THROWS_WITH(view("top = \"t\"\nunits.V = [\"no.key\"]\ngroups = [[\"A\", \"a[1:0] V\"]]\n"),
                    "v.toml: units: no.key is no key of the machine");
}
