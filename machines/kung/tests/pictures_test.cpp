// SPDX-License-Identifier: Apache-2.0
//
// What the scripts of the pictures are told: a program in gnuplot's place keeps it.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "lab/output_folder.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "machines/kung/machine.hpp"
#include "tests/support/files.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;

namespace {

// Of a path that is counted from sample 10 on.
std::string told(const test::Scratch& scratch, std::uint32_t samples) {
  auto result = std::make_unique<kung::Result>();
  result->points = 1;
  result->first_tick = 10;
  result->end_tick = 10 + samples;
  for (std::uint32_t n = 0; n < 15 + samples; ++n) {
    kung::Sample one;
    one.tick = n;
    one.edge = 25'000 * cosim::Clk{n};
    result->samples.push_back(one);
  }
  lab::Record record;
  record.settings = lab::load_scenario(lab::find_scenario("circle"));
  record.result = std::move(result);
  lab::OutputFolder folder(scratch.path / "run");
  const lab::Written written = lab::write_record(record, folder, {}, {}, false);
  CHECK(written.notes.empty());
  return test::content(folder.scratch() / "told");
}

}  // namespace

TEST_CASE("a picture has at most 6000 points, of the samples that count") {
  const test::Scratch scratch("pictures_test_out");
  const test::NoPrograms none;
  std::ofstream(scratch.path / "gnuplot") << "#!/bin/sh\nexec /bin/cat >> told\n";
  chmod((scratch.path / "gnuplot").c_str(), 0755);
  setenv("PATH", scratch.path.c_str(), 1);
  const struct {
    std::uint32_t samples;
    const char* variables;
  } runs[] = {
      {2, "first = 10\nlast = 11\nstep = 1\nfrom = 0.005\nto = "},
      {5999, "first = 10\nlast = 6008\nstep = 1\nfrom = 0.005\nto = "},
      {6000, "first = 10\nlast = 6009\nstep = 2\nfrom = 0.005\nto = "},
      {12'001, "first = 10\nlast = 12010\nstep = 3\nfrom = 0.005\nto = "},
  };
  for (const auto& [samples, variables] : runs) {
    INFO(samples << " samples");
    CHECK_THAT(told(scratch, samples), Catch::Matchers::Contains(variables));
  }
}
