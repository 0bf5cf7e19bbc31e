// SPDX-License-Identifier: Apache-2.0
//
// Which waves may be requested, and what is made of them, by the same rules for every machine.
#include "lab/waves.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;
using test::content;
namespace fs = std::filesystem;

namespace {

struct Scratch : test::Scratch {
  Scratch() : test::Scratch("waves_test_out") {}
};

std::unique_ptr<Settings> taken(const Machine& machine, const WaveArguments& arguments) {
  auto settings = machine.defaults();
  apply_waves(*settings, arguments);
  check_waves(*settings);
  return settings;
}

std::string message_of(const Machine& machine, const WaveArguments& arguments) {
  return test::refusal_of([&] { taken(machine, arguments); });
}

WaveArguments fst() { return {"fst", "", "", "", ""}; }

// A short run, whose trigger fired as given and whose waves are these.
testbench::Simulate ran(std::optional<cosim::Clk> trigger, std::vector<cosim::WaveSpan> spans) {
  return [=](const Settings& settings, const cosim::Hooks&) {
    auto result = test::short_result(settings, cosim::EndReason::kDone);
    result->wave_trigger = trigger;
    result->waves = spans;
    std::ofstream(settings.run.wave_file) << "waves";
    return judged(settings.clone(), std::move(result));
  };
}

int run_to(const fs::path& out, const Machine& machine, const WaveArguments& waves,
           const testbench::Simulate& simulate) {
  auto arguments = test::arguments_for(test::scenario_of(machine), out);
  arguments.waves = waves;
  arguments.report = false;
  return test::run(arguments, simulate);
}

template <class Check>
void each_machine(Check check) {
  for (const Machine* const machine : machines()) {
    CAPTURE(machine->name);
    const Scratch scratch;
    check(*machine, scratch.path);
  }
}

}  // namespace

TEST_CASE("the command line of waves sets their keys") {
  each_machine([](const Machine& machine, const fs::path&) {
    const std::string start = machine.traces.triggers().start;
    WaveArguments arguments = fst();
    arguments.window = "-1ms:3ms";
    arguments.trigger = start;
    const auto settings = taken(machine, arguments);
    CHECK(settings->run.wave == cosim::WaveFormat::kFst);
    CHECK(settings->run.wave_begin_s == Approx(-1e-3));
    CHECK(settings->run.wave_end_s == Approx(3e-3));
    CHECK(settings->run.wave_trigger == start);
    arguments = fst();
    arguments.pre = "0.5ms";
    CHECK(taken(machine, arguments)->run.wave_pre_s == Approx(0.5e-3));
    arguments = fst();
    arguments.every = "50ms";
    CHECK(taken(machine, arguments)->run.wave_every_s == Approx(0.05));
  });
}

TEST_CASE("a window reads seconds, milliseconds, microseconds and nanoseconds") {
  CHECK(parse_window("0:5ms").second == Approx(5e-3));
  CHECK(parse_window("10us:0.5").first == Approx(1e-5));
  CHECK(parse_window("20ns:1us").first == Approx(2e-8));
  for (const char* text : {"5", "0:5min", "5ms:1ms", "1ms:1ms", ":", "a:b"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_window(text), Contains("--wave-window: value"));
  }
}

TEST_CASE("every listed trigger name is accepted, and no other") {
  each_machine([](const Machine& machine, const fs::path&) {
    const cosim::TriggerForms& forms = machine.traces.triggers();
    WaveArguments arguments = fst();
    for (const std::string& name : cosim::trigger_names(forms)) {
      CAPTURE(name);
      const bool event =
          std::find(forms.events.begin(), forms.events.end(), name) != forms.events.end();
      arguments.trigger = event ? name : "change " + name;
      CHECK(message_of(machine, arguments).empty());
      arguments.trigger = (event ? name : "change " + name) + " after 1ms";
      CHECK(message_of(machine, arguments).empty());
      // For a name with a letter too many the nearest one is suggested.
      arguments.trigger = "change " + name + "q";
      CHECK_THAT(message_of(machine, arguments),
                 Contains("--wave-trigger: " + name + "q: unknown signal; did you mean "));
    }
    arguments.trigger = "qqqqqqqqqqqq > 1";
    CHECK(message_of(machine, arguments) ==
          "--wave-trigger: qqqqqqqqqqqq: unknown signal; `trammel list signals` names them all");
    arguments.trigger = "1 >";
    CHECK(message_of(machine, arguments) ==
          fmt::format("--wave-trigger: \"1 >\" is none of: {}", forms.help));
    const auto settings = machine.defaults();
    settings->run.wave = cosim::WaveFormat::kFst;
    settings->run.wave_trigger = "1 >";
    CHECK_THROWS_WITH(validate(*settings),
                      fmt::format("run.wave_trigger: \"1 >\" is none of: {}", forms.help));
  });
}

TEST_CASE("impossible waves are refused before the run") {
  each_machine([](const Machine& machine, const fs::path&) {
    WaveArguments arguments;
    for (std::string WaveArguments::*member : {&WaveArguments::window, &WaveArguments::trigger,
                                               &WaveArguments::pre, &WaveArguments::every}) {
      arguments = {};
      arguments.*member = "1ms";
      CHECK_THAT(message_of(machine, arguments), Contains("needs --wave vcd or --wave fst"));
    }
    arguments = fst();
    arguments.window = "-1ms:1ms";
    CHECK_THAT(message_of(machine, arguments), Contains("only a window around run.wave_trigger"));
    const double longest = machine.defaults()->run.max_s;
    arguments.window = fmt::format("{0}s:{1}s", longest, longest + 1);
    CHECK_THAT(message_of(machine, arguments),
               Contains(fmt::format("value {0} is outside the run, 0..{0} s", longest)));
    arguments.window = "0:5ms";
    arguments.pre = "1ms";
    CHECK_THAT(message_of(machine, arguments), Contains("--wave-pre: is of the default window"));
    arguments.pre = "";
    arguments.every = "4ms";
    CHECK_THAT(message_of(machine, arguments),
               Contains("value 0.004 is shorter than its window of 0.005"));
    arguments.every = "4.99998ms";  // a clock less than the window
    CHECK_THAT(message_of(machine, arguments),
               Contains("value 0.00499998 is shorter than its window of 0.005"));
    for (const char* const every : {"5ms", "5.00002ms", "5"}) {  // one behind the other, or apart
      CAPTURE(every);
      arguments.every = every;
      CHECK(message_of(machine, arguments) == "");
    }
    arguments.window = "0:1ns";
    CHECK_THAT(message_of(machine, arguments), Contains("a window of 1e-09 s holds no clock"));
    arguments.window = "9ns:11ns";  // around the border between edges 0 and 1
    arguments.every = "2ns";
    CHECK_THAT(message_of(machine, arguments),
               Contains("value 2e-09 is shorter than its window of 2e-09"));
    arguments.window = "0:5ms";
    arguments.every = "5 ms";
    CHECK_THAT(message_of(machine, arguments),
               Contains("--wave-every: value \"5 ms\" is not a time"));
    arguments = {"fsdb", "", "", "", ""};
    CHECK_THAT(message_of(machine, arguments), Contains("--wave: run.wave: value \"fsdb\""));
  });
}

TEST_CASE("a trigger that never fired is one failure, and the run's record is kept") {
  each_machine([](const Machine& machine, const fs::path& base) {
    WaveArguments arguments = fst();
    arguments.trigger = machine.traces.triggers().start;
    CHECK(run_to(base / "a", machine, arguments, ran({}, {})) == 1);
    CHECK(fs::exists(base / "a" / "metrics.json"));
    CHECK_FALSE(fs::exists(base / "a" / "waves.fst"));
    CHECK_FALSE(fs::exists(base / "a" / "waves.gtkw"));
  });
}

TEST_CASE("a window after the end of the run is one failure, and the run's record is kept") {
  each_machine([](const Machine& machine, const fs::path& base) {
    WaveArguments arguments = fst();
    arguments.window = "1s:2s";
    CHECK(run_to(base / "a", machine, arguments, ran({}, {})) == 1);
    CHECK(fs::exists(base / "a" / "metrics.json"));
    CHECK_FALSE(fs::exists(base / "a" / "waves.fst"));
  });
}

TEST_CASE("a VCD that cannot be made leaves the FST and sets the exit code") {
  each_machine([](const Machine& machine, const fs::path& base) {
    WaveArguments arguments = fst();
    arguments.format = "vcd";
    CHECK(run_to(base / "a", machine, arguments, ran(100, {{90, 190}})) == 1);
    CHECK(fs::exists(base / "a" / "waves.fst"));
    CHECK_FALSE(fs::exists(base / "a" / "waves.vcd"));
  });
}

TEST_CASE("the record names the waves, their view, their windows and the trigger's time") {
  each_machine([](const Machine& machine, const fs::path& base) {
    WaveArguments arguments = fst();
    arguments.trigger = machine.traces.triggers().start + std::string(" after 1us");
    CHECK(run_to(base / "a", machine, arguments, ran(50000, {{40000, 140000}})) == 0);
    CHECK(content(base / "a" / "waves.fst") == "waves");
    const auto json = nlohmann::json::parse(content(base / "a" / "metrics.json"));
    CHECK(json["waves"]["file"] == "waves.fst");
    CHECK(json["waves"]["trigger"] == arguments.trigger);
    CHECK(json["waves"]["trigger_s"] == Approx(1e-3));
    CHECK(json["waves"]["windows"] == 1);
    CHECK(json["waves"]["windows_s"][0][1] == Approx(2.8e-3));
    const std::string view = content(base / "a" / "waves.gtkw");
    CHECK_THAT(view, Contains("[dumpfile] \"" + (base / "a" / "waves.fst").string() + '"'));
    CHECK_THAT(view, Contains("[timestart] 800000\n"));
    CHECK_THAT(view, Contains(" 1000000 -1 -1"));  // the trigger is the marker, in ns
    CHECK_THAT(view, Contains("\n@28\n"));
  });
}

TEST_CASE("a run says how large its waves will be when they are long") {
  each_machine([](const Machine& machine, const fs::path&) {
    const auto settings = machine.defaults();
    CHECK_FALSE(waves_notice(*settings));
    settings->run.wave = cosim::WaveFormat::kFst;
    CHECK_FALSE(waves_notice(*settings));
    settings->run.wave_end_s = 0.5;
    const double mega = 0.5 * machine.traces.fst_bytes_s / 1e6;
    CHECK(waves_notice(*settings) == fmt::format("waves of 500 ms take about {:.2g} MB", mega));
    settings->run.wave_every_s = 1;
    CHECK(waves_notice(*settings) ==
          fmt::format("waves take about {:.2g} MB a second of the run", mega));
  });
}

TEST_CASE("a VCD is told by its own size, and refused where no program makes it") {
  const Scratch scratch;
  std::ofstream(scratch.path / "fst2vcd") << "#!/bin/sh\n";
  fs::permissions(scratch.path / "fst2vcd", fs::perms::owner_all);
  for (const Machine* const machine : machines()) {
    const auto settings = machine->defaults();
    settings->run.wave = cosim::WaveFormat::kVcd;
    settings->run.wave_end_s = 0.5;
    {
      const test::NoPrograms none;
      CHECK_THROWS_AS(waves_notice(*settings), host::ToolMissing);
    }
    const test::Variable path("PATH", scratch.path.c_str());
    const double mega_s = machine->traces.vcd_bytes_s / 1e6;
    CHECK(waves_notice(*settings) ==
          fmt::format("waves of 500 ms take about {:.2g} MB", 0.5 * mega_s));
    settings->run.wave_every_s = 2;
    CHECK(waves_notice(*settings) ==
          fmt::format("waves take about {:.2g} MB a second of the run", 0.25 * mega_s));
    CHECK(machine->traces.vcd_bytes_s > machine->traces.fst_bytes_s);
  }
}

TEST_CASE("a program has made no VCD that ends badly, whatever it wrote, or writes nothing") {
  const Scratch scratch;
  const test::Variable path("PATH", scratch.path.c_str());
  const fs::path fst = scratch.path / "a.fst", vcd = scratch.path / "a.vcd";
  for (const char* const end : {"exit 1", "kill -9 $$", "exit 0"}) {
    CAPTURE(end);
    std::ofstream(fst) << "waves";
    std::ofstream(scratch.path / "fst2vcd") << "#!/bin/sh\necho \"$*\"\n" << end << '\n';
    fs::permissions(scratch.path / "fst2vcd", fs::perms::owner_all);
    const bool good = std::string(end) == "exit 0";
    CHECK(fst_to_vcd(fst, vcd) == good);
    CHECK(fs::exists(fst) == !good);
    CHECK(fs::exists(vcd) == good);
  }
  CHECK(content(vcd) == "-f " + fst.string() + '\n');
  std::ofstream(fst) << "waves";
  std::ofstream(scratch.path / "fst2vcd") << "#!/bin/sh\n";
  CHECK_FALSE(fst_to_vcd(fst, vcd));
  CHECK((fs::exists(fst) && !fs::exists(vcd)));
}

TEST_CASE("windows are told by the first and the last, and listed up to a hundred") {
  for (const Machine* const machine : machines()) {
    const auto settings = machine->defaults();
    settings->run.wave = cosim::WaveFormat::kVcd;
    cosim::RunResult result;
    CHECK(waves_text(*settings, result, "out") == "");
    result.waves = {{50000, 100000}};
    CHECK(waves_text(*settings, result, "out") ==
          "  waves of 1 ms to 2 ms; to look at them: gtkwave out/waves.gtkw\n");
    result.waves.push_back({200000, 250000});
    result.waves.push_back({350000, 400000});
    CHECK_THAT(waves_text(*settings, result, "out"),
               Contains("waves of 1 ms to 2 ms and 2 more windows, the last from 7 ms; to look"));
    result.wave_trigger = 75000;
    for (const auto& [text, told] : {std::pair{"at 1500us", ""},
                                     {machine->traces.triggers().start,
                                      ", found in an untraced run before this one"}}) {
      settings->run.wave_trigger = text;
      CHECK_THAT(waves_text(*settings, result, "out"),
                 Catch::StartsWith(fmt::format("  trigger `{}` at 1.5 ms (clock 75000){}\n", text,
                                               told)));
    }
    CHECK(waves_json(*settings, result)["file"] == "waves.vcd");
    for (const std::size_t count : {100u, 101u}) {
      result.waves.assign(count, {50000, 100000});
      const auto json = waves_json(*settings, result);
      CHECK(json["windows"] == count);
      CHECK(json["windows_s"].size() == 100);
    }
  }
}

TEST_CASE("keys of a window are held to each other as the options are") {
  for (const Machine* const machine : machines()) {
    const auto settings = machine->defaults();
    settings->run.wave = cosim::WaveFormat::kFst;
    settings->run.wave_begin_s = settings->run.wave_end_s = 0.01;
    CHECK_THROWS_WITH(check_waves(*settings),
                      "run.wave_end_s: value 0.01 must be above run.wave_begin_s = 0.01");
    settings->run.wave_end_s = 0.02;
    CHECK_NOTHROW(check_waves(*settings));
  }
}

TEST_CASE("of a folder that no line can name a view names the file alone") {
  cosim::RunResult result;
  result.waves = {{0, 10000}};
  for (const char* const folder : {"/a\nb", "/a\"b"}) {
    CHECK_THAT(placed_view("", fs::path(folder) / "waves.fst", result),
               Catch::StartsWith("[dumpfile] \"waves.fst\"\n[savefile] \"waves.gtkw\"\n"));
  }
}

TEST_CASE("a run that was interrupted before its window has no other reason for none") {
  each_machine([](const Machine& machine, const fs::path& base) {
    WaveArguments arguments = fst();
    arguments.window = "1s:2s";
    std::string told;
    for (const auto& [end, why] :
         {std::pair{cosim::EndReason::kStopped, "no waves: the run was interrupted; the run's"},
          {cosim::EndReason::kDone, "no waves: their window lies outside the run, 0..20 ms;"}}) {
      const testbench::Simulate simulate = [end = end](const Settings& settings,
                                                       const cosim::Hooks&) {
        return judged(settings.clone(), test::short_result(settings, end));
      };
      told = test::on_stderr([&] { run_to(base / "a", machine, arguments, simulate); });
      CHECK_THAT(told, Contains(why));
    }
  });
}

TEST_CASE("a view names the windows by markers and keeps nothing of another file") {
  cosim::RunResult result;
  result.waves = {{0, 10000}, {2500000, 2510000}};
  const std::string view = placed_view(
      "[dumpfile] \"old\"\n[savefile] \"old\"\n[timestart] 7\n*-3.0 5 5\n[size] 1 1\n@28\na.b\n",
      "/o/waves.vcd", result);
  CHECK_THAT(view, Contains("[dumpfile] \"/o/waves.vcd\"\n[savefile] \"/o/waves.gtkw\"\n"));
  CHECK_THAT(view, Contains(" -1 0 50000000 -1 -1"));
  CHECK_THAT(view, Contains("[size] 1 1\n@28\na.b\n"));
  CHECK_THAT(view, !Contains("old") && !Contains("*-3.0"));
}

TEST_CASE("a view shows the whole of its first window, a longer one smaller") {
  const struct {
    cosim::Clk begin, end;
    const char* zoom;  // powers of 2; 209 clocks of 20 ns are 800 of its 1045 / 200 ns
  } cases[] = {{0, 209, "*-9.643856 -1"},
               {1000, 1418, "*-10.643856 -1"},
               {0, 209 * 1024, "*-19.643856 -1"},
               {-209, 0, "*-9.643856 -1"}};
  for (const auto& one : cases) {
    cosim::RunResult result;
    result.waves = {{one.begin, one.end}};
    CAPTURE(one.begin, one.end);
    CHECK_THAT(placed_view("", "/o/waves.vcd", result), Contains(one.zoom));
  }
}

TEST_CASE("a file that is not FST gives no VCD and is kept") {
  const Scratch scratch;
  const fs::path file = scratch.path / "it's.fst";
  std::ofstream(file) << "not waves";
  CHECK_FALSE(fst_to_vcd(file, scratch.path / "it's.vcd"));
  CHECK(fs::exists(file));
  CHECK_FALSE(fs::exists(scratch.path / "it's.vcd"));
}
