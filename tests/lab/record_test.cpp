// SPDX-License-Identifier: Apache-2.0
//
// Records: what a run tells of its end and of the runs beside it, and what its files hold.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <string>
#include <vector>

#include "lab/column.hpp"
#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "lab/report_data.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "tests/support/files.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using namespace trammel::lab;
using cosim::EndReason;

namespace {

// take(settings, what they are compared with) of scenarios that are compared, until it is false.
template <class Take>
void each_compared(const Take& take) {
  std::size_t compared = 0;
  for (const auto& file : lab::scenarios()) {
    const auto settings = lab::load_scenario(file);
    const lab::Machine& machine = settings->machine();
    if (machine.compared.companions == nullptr) continue;
    const auto wanted = machine.compared.companions(*settings);
    if (wanted.empty()) continue;
    INFO("scenario " << settings->scenario);
    ++compared;
    if (!take(*settings, wanted)) break;
  }
  CHECK(compared > 0);
}

// The run and those beside it, the first with one end and the others with another.
lab::Record short_record(const lab::Settings& settings, EndReason first, EndReason others,
                         std::size_t& runs) {
  return lab::run_by(
      [&](const lab::Settings& one, const cosim::Hooks&) {
        return test::short_result(one, ++runs == 1 ? first : others);
      },
      settings);
}

template <class Check>
void each_run(Check check) {
  for (const Machine* const machine : machines()) {
    INFO("machine " << machine->name);
    const auto settings = load_scenario(find_scenario(test::scenario_of(*machine)));
    check(*machine, test::short_run(*settings, EndReason::kDone));
  }
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) parts.emplace_back();
    else parts.back() += c;
  }
  return parts;
}

// Half of the last digit that a column prints of a value.
double half_digit(const Format& format, double value) {
  switch (format.kind) {
    case Format::Kind::kWhole: return 0.5;
    case Format::Kind::kFixed: return 0.5 * std::pow(10, -format.digits);
    case Format::Kind::kGeneral: break;
  }
  return value == 0 ? 0 : 0.5 * std::pow(10, std::floor(std::log10(std::fabs(value))) + 1 -
                                                 format.digits);
}

}  // namespace

TEST_CASE("a comparison that is stopped ends the run as interrupted, and is not kept") {
  each_compared([](const lab::Settings& settings, const auto&) {
    std::size_t runs = 0;
    const lab::Record record =
        short_record(settings, EndReason::kDone, EndReason::kStopped, runs);
    CHECK(runs == 2);
    CHECK(record.result->end == EndReason::kStopped);
    CHECK(record.verdict == settings.machine().verdict(settings, *record.result));
    CHECK(record.companions.empty());
    return false;
  });
}

TEST_CASE("figures of a companion are printed unless its machine compares them by itself") {
  CHECK(lab::Companion{"other", nullptr}.printed);
  each_compared([](const lab::Settings& settings, const auto&) {
    std::size_t runs = 0;
    const lab::Record record = short_record(settings, EndReason::kDone, EndReason::kDone, runs);
    REQUIRE_FALSE(record.companions.empty());
    const std::string text = lab::report_text(record, "", false);
    for (const lab::Record& beside : record.companions) {
      const bool told = text.find("\n  " + beside.name + ": ") != std::string::npos;
      CHECK(told == beside.printed);
      CHECK(lab::metrics_json(record)["compared"].contains(beside.name));
    }
    return true;
  });
}

TEST_CASE("a broken assertion is told with its instance, or else as of the chip") {
  cosim::FailedAssertion assertion{"no_shoot_through", "chip.u_leg", "leg.sv:7", 50000};
  CHECK(lab::assertion_text(assertion, 20'000) ==
        "no_shoot_through of chip.u_leg at 0.00100000 s, clock 50000 (leg.sv:7)");
  assertion.instance.clear();
  CHECK(lab::assertion_text(assertion, 20'000) ==
        "no_shoot_through of the chip at 0.00100000 s, clock 50000 (leg.sv:7)");
}

TEST_CASE("what ended a run is told by its fault, or its promise before that") {
  struct Result final : cosim::RunResult {
    std::string fault;
    std::string fault_text() const override { return fault; }
  } result;
  result.end = EndReason::kFault;
  CHECK(lab::cause_text(result) == "");
  result.fault = "a limit";
  CHECK(lab::cause_text(result) == " by a limit");
  result.end = EndReason::kMissed;
  CHECK(lab::cause_text(result) == ": a limit");
  result.assertion = {"no_shoot_through", "", "leg.sv:7", 50000};
  CHECK(lab::cause_text(result) == ": " + lab::assertion_text(*result.assertion, result.clock_ps));
}

TEST_CASE("each end of a run has its own word and the exit code of its kind") {
  const struct {
    EndReason end;
    const char* text;
    int code;
  } ends[] = {{EndReason::kDone, "done", 0},
              {EndReason::kFault, "tripped", 5},
              {EndReason::kDiverged, "diverged", 5},
              {EndReason::kMissed, "missed", 5},
              {EndReason::kTimeout, "timeout", 5},
              {EndReason::kStopped, "interrupted", 130},
              {EndReason::kAssertion, "assertion failed", 4}};
  for (const auto& one : ends) {
    INFO("the end that is called " << one.text);
    CHECK(std::string(lab::end_text(one.end)) == one.text);
    CHECK(lab::exit_code(one.end) == one.code);
  }
}

TEST_CASE("a run that did not end well is compared with nothing") {
  std::size_t compared = 0;
  each_compared([&](const lab::Settings& settings, const auto& wanted) {
    for (const EndReason end : {EndReason::kDone, EndReason::kFault, EndReason::kDiverged,
                                EndReason::kMissed, EndReason::kTimeout, EndReason::kStopped,
                                EndReason::kAssertion}) {
      INFO("a run that ended as " << lab::end_text(end));
      std::size_t runs = 0;
      const lab::Record record = short_record(settings, end, EndReason::kDone, runs);
      const bool compares = end == EndReason::kDone;
      CHECK(runs == (compares ? 1 + wanted.size() : 1));
      CHECK(record.result->end == end);
      REQUIRE(record.companions.size() == (compares ? wanted.size() : 0));
      for (std::size_t k = 0; k < record.companions.size(); ++k) {
        CHECK(record.companions[k].name == wanted[k].name);
      }
    }
    return ++compared < 3;
  });
}

TEST_CASE("trace.csv holds each value of the record, in its column, to the digits of it") {
  each_run([](const Machine& machine, const Record& record) {
    const test::Scratch scratch("trace_test_out");
    const std::filesystem::path file = scratch.path / "trace.csv";
    write_trace(file, record);
    const std::vector<std::string> lines = split(test::content(file), '\n');
    const std::vector<Column>& columns = machine.columns().columns;
    const std::size_t samples = record.result->sample_count();
    REQUIRE(samples > 15);
    REQUIRE(lines.size() == samples + 2);  // names, and nothing behind the last
    CHECK(lines.back().empty());
    const std::vector<std::string> names = split(lines[0], ',');
    REQUIRE(names.size() == columns.size());
    for (std::size_t n = 0; n < names.size(); ++n) CHECK(names[n] == columns[n].name);
    std::vector<double> values;
    for (std::size_t k = 0; k < samples; ++k) {
      machine.columns().read(*record.settings, *record.result, k, values);
      const std::vector<std::string> fields = split(lines[k + 1], ',');
      REQUIRE(fields.size() == values.size());
      for (std::size_t n = 0; n < fields.size(); ++n) {
        INFO("sample " << k << ", column " << names[n] << ": \"" << fields[n] << "\" of "
                       << fmt::format("{:.17g}", values[n]));
        char* end = nullptr;
        const double printed = std::strtod(fields[n].c_str(), &end);
        REQUIRE((!fields[n].empty() && *end == '\0'));
        REQUIRE(std::fabs(printed - values[n]) <=
                half_digit(columns[n].format, values[n]) * (1 + 1e-6) +
                    1e-15 * std::fabs(values[n]));
      }
    }
  });
}

TEST_CASE("a column that has a unit is named after it, and printed as finely as a page shows it") {
  // A word of a chip has the name of the word.
  const std::map<std::string, std::string> end_of{
      {"m", "_m"},     {"mm", "_mm"},         {"s", "_s"},           {"V", "_V"},
      {"A", "_A"},     {"N", "_N"},           {"m/s", "_m_s"},       {"mm/s", "_mm_s"},
      {"step", "step"}, {"step/s", "_step_s"}, {"rad/s", "_rad_s"},  {"rad", "_rad"},
      {"N m", "_N_m"}};
  for (const Machine* const machine : machines()) {
    std::vector<std::string> names;
    for (const Column& column : machine->columns().columns) {
      INFO("machine " << machine->name << ", column " << column.name << " [" << column.unit
                      << "]");
      CHECK(std::count(names.begin(), names.end(), column.name) == 0);
      names.push_back(column.name);
      CHECK_FALSE(column.help.empty());
      CHECK(column.resolution > 0);
      const auto end = end_of.find(column.unit);
      if (end != end_of.end()) {
        const std::string& unit = end->second;
        REQUIRE(column.name.size() >= unit.size());
        CHECK(column.name.substr(column.name.size() - unit.size()) == unit);
      } else {
        for (const auto& [name, tail] : end_of) {
          const bool ends = column.name.size() > tail.size() &&
                            column.name.substr(column.name.size() - tail.size()) == tail;
          INFO("ends as one in " << name);
          CHECK_FALSE(ends);
        }
      }
      if (column.format.kind == Format::Kind::kWhole) CHECK(column.resolution >= 1);
      if (column.format.kind == Format::Kind::kFixed) {
        // The page drops two digits at most, so that neither of the two can be coarse unseen.
        CHECK(std::pow(10, -column.format.digits) <= column.resolution * (1 + 1e-9));
        CHECK(column.resolution <= 100 * std::pow(10, -column.format.digits) * (1 + 1e-9));
      }
    }
  }
}

TEST_CASE("metrics.json tells clocks, times and hash of its run, and each setting") {
  each_run([](const Machine& machine, const Record& record) {
    cosim::RunResult& result = *record.result;
    result.clocks = 3'000'000;
    result.evaluated = 120'000;
    result.wall_s = 0.25;
    result.event_hash = 0x0123'4567'89AB'CDEF;
    result.activity = {{"slow", 11}, {"fast", 22}};
    const auto json = metrics_json(record);
    const auto& run = json["run"];
    CHECK(run["samples"] == result.sample_count());
    CHECK(run["clock_ps"] == 20000);
    CHECK(run["clocks"] == 3'000'000);
    CHECK(run["clocks_evaluated"] == 120'000);
    CHECK(run["simulated_s"].get<double>() == Approx(0.06));
    CHECK(run["wall_s"] == 0.25);
    CHECK(run["clocks_per_s"].get<double>() == Approx(12e6));
    CHECK(run["real_time_factor"].get<double>() == Approx(0.24));
    CHECK(run["event_hash"] == "0123456789abcdef");
    CHECK(run["activity"]["slow"] == 11);
    CHECK(run["activity"]["fast"] == 22);
    CHECK(json["machine"] == machine.name);
    CHECK_FALSE(json.contains("injected"));
    for (const Key& key : machine.keys()) {
      INFO("setting " << key.name);
      REQUIRE(json["options"].contains(key.name));
      CHECK(json["options"][key.name] == value_json(key.get(*record.settings)));
    }
    std::size_t figures = 0;
    for (const auto& figure : json["figures"]) {
      INFO("figure " << figure["id"]);
      REQUIRE(figures < record.figures.size());
      const Figure& is = record.figures[figures++];
      CHECK(figure["id"] == is.id);
      CHECK(figure["unit"] == is.unit);
      CHECK(figure["value"] == is.value);
    }
    CHECK(figures == record.figures.size());
  });
}

TEST_CASE("an injected fault is told from its own begin, each span on its own") {
  each_run([](const Machine&, const Record& record) {
    cosim::RunResult& result = *record.result;
    result.clocks = 10'000'000;
    cosim::FaultReport& report = result.fault_report;
    report.begin = 1'000'000;
    report.detected = 1'250'000;
    report.off = 1'300'050;
    report.by = "a check";
    report.stopping = 4.25;
    report.unit = "ell";
    report.peak_A = 7.5;
    report.at_stop = true;
    auto json = metrics_json(record)["injected"];
    CHECK(json["begin_s"].get<double>() == Approx(0.02));
    CHECK(json["detected_after_s"].get<double>() == Approx(0.005));
    CHECK(json["off_after_s"].get<double>() == Approx(0.006001));
    CHECK(json["detected_by"] == "a check");
    CHECK(json["stopping"] == 4.25);
    CHECK(json["peak_A"] == 7.5);
    CHECK(json["at_stop"] == true);
    const auto says = [&](const std::string& text) {
      CHECK_THAT(report_text(record, "out", false), Catch::Contains(text));
    };
    says("at 0.02 s: noticed 5 ms later: a check; outputs off 1 ms later, at rest after "
         "4.25 ell");
    report.stopping = 1071.234;
    says("outputs off 1 ms later, at rest after 1071 ell");
    report.off = cosim::kNever;
    says("noticed 5 ms later: a check; outputs not off");
    CHECK(metrics_json(record)["injected"]["off_after_s"].is_null());
    report.detected = cosim::kNever;
    says("at 0.02 s: not noticed");
    CHECK(metrics_json(record)["injected"]["detected_after_s"].is_null());
    result.clocks = report.begin;
    says("at 0.02 s: the run had ended by then");
    result.clocks = report.begin + 1;
    says("at 0.02 s: not noticed");
  });
}

TEST_CASE("what is read at the end tells clocks, speed and shares of the run") {
  each_run([](const Machine& machine, Record record) {
    cosim::RunResult& result = *record.result;
    result.clocks = 4'000'000;
    result.evaluated = 100'000;
    result.events = 50'000;
    result.wall_s = 0.5;
    const auto says = [&](const std::string& text) {
      CHECK_THAT(report_text(record, "the/folder", true), Catch::Contains(text));
    };
    says("simulated 0.080 s = 4000000 clocks in 0.50 s: real-time factor 0.160\n");
    says("results in the/folder\n");
    says("report: the/folder/report.html\n");
    const auto by = [&](cosim::Engine engine) {
      const auto settings = record.settings->clone();
      settings->run.engine = engine;
      record.settings = settings->clone();
    };
    by(cosim::Engine::kTwin);
    says("  twin engine: 2.5 % of the clocks hold an event\n");
    by(cosim::Engine::kRtl);
    says(machine.can.leap ? "  2.5 % of the clocks evaluated, the others leapt over\n"
                          : "1.25 % hold an event here, so at most 80 times fewer\n");
    result.activity = {{"slow", 1'000'000}};
    CHECK_THAT(activity_text(result), Catch::Contains("slow          25.0000 %"));
  });
}
