// SPDX-License-Identifier: Apache-2.0
//
// What a trigger reads of a run of the machine larson: the word that it names, of its own axis.
#include <catch2/catch.hpp>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "machines/larson/machine.hpp"
#include "machines/larson/session.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::larson;

namespace {

using Words = std::function<std::int64_t(const Sample&)>;

}  // namespace

TEST_CASE("larson: a trigger may name a word with what it can hold, of its own axes alone") {
  struct Range {
    const char* name;
    std::int64_t high;
    bool of_axis;
  };
  for (const Range& one : {Range{"count", 0xFFFF, true}, Range{"status", 0xFFFF, true},
                           Range{"waiting", 0xFFFF, true}, Range{"call", 0xFFFFFFFF, false},
                           Range{"switches", 15, false}}) {
    const auto told = [&](const std::string& axis, std::int64_t value) {
      return test::refusal_of<std::exception>([&] {
        cosim::parse_trigger(axis + one.name + " == " + std::to_string(value), triggers());
      });
    };
    CAPTURE(one.name);
    CHECK(told("", 0) == "");
    CHECK(told("", one.high) == "");
    CHECK_THAT(told("", -1), Catch::Contains("is out of range"));
    CHECK_THAT(told("", one.high + 1), Catch::Contains("is out of range"));
    for (const char* axis : {"x.", "y."}) CHECK((told(axis, one.high) == "") == one.of_axis);
  }
}

TEST_CASE("larson: a trigger finds the first sample whose word, of its own axis, has the value") {
  const test::Scratch scratch("larson_trigger");
  const std::filesystem::path file = scratch.path / "script.table";
  std::ofstream(file) << "CALTBL\nVELTBL 4000 500\nABSTBL 60 33\nWTTBL\nRELTBL -25 -10\nWTTBL\n";
  Options options;
  options.script = file.string();
  options.run.platform = cosim::Platform::kDirect;
  options.run.engine = cosim::Engine::kTwin;
  options.start_x = 12;
  options.start_y = 31;
  options.record_ms = 0.5;
  const Result all = test::run_to<Session, Result>(options, nullptr);
  REQUIRE(all.end == cosim::EndReason::kDone);
  std::vector<std::pair<std::string, Words>> named{
      {"call", [](const Sample& s) { return std::int64_t{s.call}; }},
      {"switches", [](const Sample& s) { return std::int64_t{s.switches}; }}};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string axis = k == 0 ? "x." : "y.";
    named.emplace_back(axis + "count", [k](const Sample& s) { return s.axis[k].words & 0xFFFF; });
    named.emplace_back(axis + "status", [k](const Sample& s) { return s.axis[k].words >> 16; });
    named.emplace_back(axis + "waiting", [k](const Sample& s) { return s.axis[k].waiting; });
  }
  for (const auto& [name, of] : named) {
    // The last value that was not there before.
    std::int64_t value = 0;
    cosim::Clk edge = cosim::kNever;
    std::set<std::int64_t> before;
    for (const Sample& sample : all.samples) {
      if (!before.insert(of(sample)).second) continue;
      value = of(sample);
      edge = sample.edge;
    }
    REQUIRE(before.size() > 1);
    const std::string text = name + " == " + std::to_string(value);
    CAPTURE(text);
    cosim::TriggerSearch search(cosim::parse_trigger(text, triggers()));
    const Result found = test::run_to<Session, Result>(options, &search);
    REQUIRE(search.found());
    CHECK(*search.found() == edge);
    CHECK(found.samples.size() < all.samples.size());
  }
}
