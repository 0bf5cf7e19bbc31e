// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/paper.hpp"
#include "machines/kung/options.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "tests/support/scenarios.hpp"

using namespace trammel;
using namespace trammel::lab;

namespace {

void take(kung::Options& options, const std::string& toml) {
  apply_text(options, toml, "some.toml", ".");
}

}  // namespace

TEST_CASE("the heading of a scenario names the paper's figures with the paper's values alone") {
  const auto heading = [](const std::string& assignment) {
    const auto settings = lab::load_scenario(lab::find_scenario("circle"));
    lab::apply_assignment(*settings, assignment);
    return settings->description;
  };
  const std::string circle = "circle of 100 mm radius at 0.5 m/s";
  for (const char* same : {"controller=fc", "plant.seed=7", "run.engine=twin",
                           "precision.adapt=off", "path.circle_ticks=628"}) {
    CAPTURE(same);
    CHECK(heading(same) == circle + " (Figs. 13, 14)");
  }
  CHECK(heading("plant.payload_kg=11") == circle + "; here plant.payload_kg = 11");
  CHECK(heading("path.feed_m_s=0.2") == circle + "; here path.feed_m_s = 0.2");
  CHECK(heading("controller=precision") == circle + "; here controller = \"precision\"");
}

TEST_CASE("under a feed profile the heading of a shape has its feed, not a constant speed") {
  const auto heading = [](const char* scenario, const std::vector<std::string>& assignments) {
    const auto settings = lab::load_scenario(lab::find_scenario(scenario));
    for (const std::string& one : assignments) lab::apply_assignment(*settings, one);
    const std::string& text = settings->description;
    return text.substr(0, text.find("; here "));
  };
  const std::string fitted = "circle of 100 mm radius at 0.661 m/s with gains that fit Table 2";
  CHECK(heading("paper-circle", {"controller=fc"}) == fitted + " (Figs. 13, 14)");
  CHECK(heading("paper-circle", {"plant.payload_kg=1"}) == fitted);
  const std::string precision = "controller=precision", feed = "path.profile=feed";
  CHECK(heading("paper-circle", {precision}) ==
        "circle of 100 mm radius at 0.5 m/s with gains that fit Table 2");
  CHECK(heading("paper-circle", {precision, "path.profile=constant"}) == fitted);
  CHECK(heading("paper-circle", {feed, "path.feed_m_s=0.2"}) ==
        "circle of 100 mm radius at 0.2 m/s with gains that fit Table 2");
  CHECK(heading("paper-window", {precision}) ==
        "window of 260 mm at 0.35 m/s with gains that fit Table 2");
  CHECK(heading("paper-star", {feed}) ==
        "star of 88 mm strokes at 0.275 m/s with gains that fit Table 2");
  kung::Options file;  // its feeds are in the file
  take(file, "description = 'mine at 3 m/s'\n[path]\nkind = 'gcode'\n");
  apply_assignment(file, precision);
  CHECK(file.description == "mine at 3 m/s; here controller = \"precision\"");
}

TEST_CASE("a scenario's description tells what was changed of what it describes, and back") {
  kung::Options options;
  take(options, "description = 'mine (Fig. 1)'\nplant.mass_kg = 5\n");
  const auto told = [&](const std::string& assignment) {
    apply_assignment(options, assignment);
    return options.description;
  };
  CHECK(told("run.max_s=7") == "mine (Fig. 1)");
  CHECK(told("plant.x.mass_kg=6") == "mine; here plant.x.mass_kg = 6");
  CHECK(told("plant.y.mass_kg=6") == "mine; here plant.mass_kg = 6");
  CHECK(told("plant.y.mass_kg=7.5") == "mine; here plant.x.mass_kg = 6, plant.y.mass_kg = 7.5");
  CHECK(told("path.kind=line") ==
        "path.kind = \"line\" in place of the scenario's \"circle\"; here plant.x.mass_kg = 6, "
        "plant.y.mass_kg = 7.5");
  CHECK(told("plant.mass_kg=5") ==
        "path.kind = \"line\" in place of the scenario's \"circle\"");
  take(options, "description = 'new (a)'\nplant.mass_kg = 8\n");
  CHECK(told("plant.mass_kg=8") == "new (a)");
  CHECK(told("plant.coulomb_N=1") == "new; here plant.coulomb_N = 1");
  take(options, "gains.kp = 0.5\n[plant]\nviscous_N_s_m = 1\npayload_kg = 2\n");
  CHECK_THAT(options.description, Catch::StartsWith("new; here plant.coulomb_N = 1, ") &&
                                      Catch::EndsWith(" and 1 more"));
}

TEST_CASE("the built-in scenarios load, are valid and, but for sweeps and the part, the paper's") {
  int loaded = 0;
  for (const auto& file : test::scenarios_of(kung::machine())) {
    ++loaded;
    INFO(file);
    kung::Options options;
    apply_file(options, file);
    lab::validate(options);
    const bool of_paper = !options.path.is_sweep() && options.path.kind != kung::PathKind::kFeed;
    CHECK(kung::paper_experiment(options).has_value() == of_paper);
    const bool fitted = file.stem().string().rfind(kung::kFittedPrefix, 0) == 0;
    CHECK((kung::paper_experiment(options) == kung::Reading::kFitted) == fitted);
    options.gains[0].kp = 0.5;
    CHECK_FALSE(kung::paper_experiment(options));
  }
  CHECK(loaded >= 8);
}

TEST_CASE("a key of the last version for a fault sets inject.fault, in old records too") {
  for (const auto& [key, kind] : {std::pair{"trip_s", cosim::FaultKind::kTripPin},
                                  {"encoder_s", cosim::FaultKind::kEncoderJump},
                                  {"processor_s", cosim::FaultKind::kProcessorHung}}) {
    CAPTURE(key);
    const std::string name = std::string("inject.") + key;
    kung::Options record;
    take(record, "inject.trip_s = 0.0\ninject.encoder_s = 0.0\ninject.processor_s = 0.0\n");
    CHECK_FALSE(record.fault.any());
    CHECK(record.notices.empty());
    take(record, name + " = 0.05\ninject.fault = \"none\"\ninject.begin_s = 0.0\n");
    CHECK(record.fault.kind == kind);
    CHECK(record.fault.begin_s == 0.05);
    REQUIRE(record.notices.size() == 1);
    const std::string& word = cosim::fault_words()[static_cast<std::size_t>(kind)];
    CHECK_THAT(record.notices[0], Catch::Contains(name) &&
                                      Catch::Contains("-s inject.fault=" + word +
                                                      " -s inject.begin_s=0.05"));
    kung::Options again;
    take(again, run_toml(record));
    CHECK(again.notices.empty());
    CHECK(again.fault.kind == kind);
    kung::Options other = again;
    other.fault.kind = cosim::FaultKind::kGateDead;
    CHECK_THROWS_WITH(take(other, name + " = 0.1\n"), Catch::Contains("a run has one fault"));
    CHECK_THROWS_WITH(take(again, name + " = -1.0\n"), Catch::Contains("out of range 0..3600"));
    take(again, name + " = 0.0\n");
    CHECK_FALSE(again.fault.any());
  }
}

TEST_CASE("the default gains are the words of the specification") {
  const kung::AxisGains g;
  const auto same = [](fixed::Gain word, std::int32_t mant, std::int32_t exp) {
    return word.value() == fixed::Gain{mant, exp}.value();  // 1536, -1 is 768, 0
  };
  CHECK(same(kung::gain_word(g.kp), 768, 0));
  CHECK(same(kung::gain_word(g.ki), 839, -7));
  CHECK(same(kung::gain_word(g.kv), 1884, 1));
  CHECK(same(kung::gain_word(kung::eta_value(g.learning_rate, g.kp, g.ki, g.kv)), 1140, -8));
  CHECK(same(kung::gain_word(kung::current_gain_value(g.current_kp_V_A, 311, 9.6)), 1275, 2));
  CHECK(same(kung::gain_word(kung::current_gain_value(g.current_ki_V_A, 311, 9.6)), 1478, -2));
  const auto model = kung::model_words(g.omega_n_rad_s, g.zeta, 0.5e-3);
  CHECK(model.a0 == 238008);
  CHECK(model.b2 == 8140683);
}
