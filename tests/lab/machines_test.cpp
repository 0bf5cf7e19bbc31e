// SPDX-License-Identifier: Apache-2.0
//
// A program of one machine knows that there are others: it asks for the program that has them.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/machines.hpp"
#include "lab/scenarios.hpp"
#include "machines/table.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;

namespace {

lab::Machines last_alone() { return {lab::Machines(linked_machines()).back()}; }

std::string lacking(const std::filesystem::path& file) {
  try {
    lab::machine_of(file);
  } catch (const lab::NotLinked& error) {
    return error.machine.empty() ? "all" : error.machine;
  }
  return "nothing";
}

}  // namespace

TEST_CASE("a program of one machine names the program that a scenario needs") {
  const test::Scratch scratch("machines_test_out");
  lab::take_machines(last_alone, false);
  std::filesystem::create_directories(scratch.path / "later/scenarios");
  lab::take_data_from(scratch.path.string());
  const auto written = [&](const std::string& text) {
    std::ofstream(scratch.path / "x.toml") << text;
    return scratch.path / "x.toml";
  };
  CHECK(lacking(written("machine = '" + lab::machines().front()->name + "'\n")) == "nothing");
  CHECK(lacking(written("machine = 'later'\n")) == "later");
  CHECK(lacking(written("machine = 'none'\n")) == "all");
  CHECK(lacking(written("machine = '../later'\n")) == "all");
  CHECK(lacking(written("machine = ''\n")) == "all");
  // The first machine is the one of files without a name.
  const bool first = lab::machines().front()->order == 1;
  CHECK(lacking(written("path.kind = 'circle'\n")) == (first ? "nothing" : "all"));
}
