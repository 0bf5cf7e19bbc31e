// SPDX-License-Identifier: Apache-2.0
//
// Scripts of `trammel lm628` on the simulated part with its motor.

#include "machines/an693/verbs/shell.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "host/files.hpp"
#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "machines/an693/machine_members.hpp"
#include "machines/an693/verbs/verbs.hpp"
#include "tests/support/failed_assertion.hpp"

using namespace trammel;
using namespace trammel::an693;
using host::read_text;
using testbench::Arguments;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

const std::atomic<bool> kNoStop{false};

struct Played {
  std::string text, notes;
  std::vector<nlohmann::ordered_json> answers;
  std::string halt;
  cosim::EndReason end = cosim::EndReason::kDone;
  Result result;
};

Played play(const std::string& script, const Options& options = {}) {
  Shell shell(options, kNoStop);
  Played all;
  try {
    for (const Line& line : parse_script(script, "test")) {
      const Answer answer = shell.execute(line);
      all.text += answer.text;
      all.notes += answer.note;
      all.answers.push_back(answer.json);
    }
  } catch (const Halt& halt) {
    all.halt = halt.what();
    all.end = halt.end;
  }
  all.result = shell.result();
  return all;
}

nlohmann::json metrics_of(const fs::path& folder) {
  return nlohmann::json::parse(read_text(folder / "metrics.json"));
}

}  // namespace

TEST_CASE("a script of E6 gives every figure of the scenario an693-absolute") {
  Options options;
  lab::apply_file(options, lab::find_scenario("an693-absolute"));
  options.run.platform = cosim::Platform::kDirect;
  nlohmann::json wanted = lab::metrics_json(lab::run(options));
  Arguments arguments;
  arguments.scenario = "absolute";
  arguments.out = "lm628_shell_test_script";
  arguments.report = false;
  std::atomic<bool> stop{false};
  REQUIRE(lm628_shell(arguments, stop, {}) == 0);
  nlohmann::json got = metrics_of(arguments.out);
  // Energy is counted up to the end of the run, here some clocks later.
  nlohmann::json &figures = got["figures"], &others = wanted["figures"];
  const double energy = others.back()["value"];
  CHECK(figures.back()["value"].get<double>() == Approx(energy).epsilon(1e-6));
  for (auto* list : {&figures, &others}) list->erase(list->size() - 1);
  CHECK(figures == others);
  CHECK(got["motion"] == wanted["motion"]);
  CHECK(got["interrupts"] == wanted["interrupts"]);
  CHECK(got["motion"]["samples"] == 45772);
  CHECK(got["script"].size() == 12);
  CHECK(got["script"][11]["hex"] == "00001F40h");
  CHECK(got["script"][11]["value"] == 8000);
  CHECK_FALSE(got["options"].contains("filter.kp"));
  const std::string toml = read_text(arguments.out + "/run.toml");
  CHECK_THAT(toml, Contains("`./trammel lm628 script.lm628 -c run.toml` repeats this run"));
  CHECK_THAT(toml, !Catch::Contains("filter"));

  // The folder repeats itself.
  Arguments again = arguments;
  again.scenario = arguments.out + "/script.lm628";
  again.files = {arguments.out + "/run.toml"};
  again.out = "lm628_shell_test_again";
  REQUIRE(lm628_shell(again, stop, {}) == 0);
  CHECK(metrics_of(again.out)["run"]["event_hash"] == got["run"]["event_hash"]);
  fs::remove_all(arguments.out);
  fs::remove_all(again.out);
}

TEST_CASE("what is read is printed in hexadecimal and in its unit") {
  const Played run = play("RDSTAT\nRSTI 0\nRDRP\nRDDV\nRDSIGS\nPORT12\nRDSIGS\nRDSUM\nRDRV\nRDIP");
  CHECK(run.halt.empty());
  CHECK(run.text ==
        "RDSTAT  84h  motor off, trajectory complete\n"
        "RDRP    00000000h  0 counts\n"
        "RDDV    00000000h  0.000000 counts/sample\n"
        "RDSIGS  0180h  8-bit output, motor off\n"
        "RDSIGS  0080h  motor off\n"
        "RDSUM   0000h  0 256 counts\n"
        "RDRV    0000h  0 counts/sample\n"
        "RDIP    00000000h  0 counts\n");
  CHECK(run.answers[0]["bits"] == "motor off, trajectory complete");
  CHECK(run.answers[3]["unit"] == "counts/sample");
}

TEST_CASE("a failed assertion ends a script and names the line at which it was seen") {
  Options options;
  options.run.assertions = true;
  Shell shell(options, kNoStop);
  const auto script = parse_script("RDRP\nRDDP\nRDRV", "test");
  shell.execute(script[0]);
  test::fail_assertion("lm628.u_port.u_lm628_port_props.busy_ends");
  CHECK_THROWS_WITH(shell.execute(script[1]),
                    Contains("test:2: assertion failed: busy_ends of lm628.u_port at 0.0"));
  CHECK_THROWS_AS(shell.execute(script[2]), Halt);
  CHECK(shell.result().assertion);
}

TEST_CASE("an audited script gives the same answers as any other") {
  Options options;
  options.run.audit = true;
  const std::string script =
      "PORT12\nLFIL 8 50\nUDF\nLTRJ 002Ah 9000 90000 300\nSTT\nwait 5 ms\nRDRP";
  const Played audited = play(script, options);
  CHECK(audited.halt.empty());
  CHECK_FALSE(audited.result.assertion);
  CHECK(audited.text == play(script).text);
}

TEST_CASE("negative values come back as they were sent") {
  const Played run = play(
      "PORT12\nRSTI 0\nLFIL 030Ah 50 1000\nUDF\nLTRJ 002Bh 1000 100000h -300\nSTT\nwait 5 ms\n"
      "RDDV\nRDRV\nRSTI 0\nwait complete 1 s\nwait 0.1 s\nRDDP\nRDRP\npins\nstatus");
  CHECK(run.halt.empty());
  CHECK_THAT(run.text, Contains("RDDV    FFFFB1E0h  -0.305176 counts/sample\n"));
  CHECK_THAT(run.text, Contains("RDDP    FFFFFED4h  -300 counts\n"));
  CHECK_THAT(run.text, Contains("HI 1  A "));
  CHECK_THAT(run.text, Contains("  2 trajectory complete   1"));
  CHECK_THAT(run.text, Contains("  0 busy                  0"));
  CHECK(run.result.desired == -300);
  CHECK(run.result.real == -300);
}

TEST_CASE("the part's own rules apply: a command while data are due is its error, not ours") {
  const Played run = play(
      "RSTI 0\nbyte c 1Eh\nwait 1 ms\nbyte d 0\nbyte c 0Ah\nwait 1 ms\nread d\nread d\nRDSTAT");
  CHECK(run.halt.empty());
  CHECK_THAT(run.text, Contains("read    00h  0\n"));
  CHECK_THAT(run.text, Contains("RDSTAT  83h  motor off, command error, busy\n"));
}

TEST_CASE("a wait ignores a bit that RSTI is about to clear, and ends on one already set") {
  const Played late = play("RSTI 0\nwait complete 10 ms");
  CHECK(late.end == cosim::EndReason::kTimeout);
  CHECK(late.halt == "test:2: wait complete 10 ms: not within 0.01 s; status 80h");
  const Played set = play("wait complete 10 ms");
  CHECK(set.halt.empty());
  CHECK(set.answers[0]["waited_s"].get<double>() < 1e-5);
  const Played high = play("PORT12\nLTRJ 0\nSTT\nwait hi 10 ms\nRSTI 0\nwait hi 10 ms");
  CHECK_THAT(high.text, Contains("wait hi 10 ms: after "));
  CHECK_THAT(high.halt, Contains("test:6: wait hi 10 ms: not within 0.01 s"));
}

TEST_CASE("nothing hangs: a part busy with its reset, the longest run, an interrupt") {
  CHECK(play("byte c 0\nRDRP\nRESET\nRDRP\nrst\nRDRP").halt.empty());
  CHECK(play("wait 0 s\nSTT\nwait 2 samples\nwait hi 0 s").halt.empty());
  CHECK_THAT(play("wait hi 0 s").halt, Contains("test:1: wait hi 0 s: not within 0 s"));
  Options options;
  options.run.max_s = 0.1;
  const Played ended = play("wait 200 s", options);
  CHECK(ended.end == cosim::EndReason::kTimeout);
  CHECK(ended.halt == "test:1: run.max_s = 0.1 s of simulated time are over");
  const std::atomic<bool> stop{true};
  Shell shell(options, stop);
  CHECK_THROWS_WITH(shell.execute(*parse_line("wait 1 s", "test:1")),
                    Contains("test:1: interrupted at "));
}

TEST_CASE("keys of the firmware's programs are refused, as they would have no effect") {
  for (const char* key : {"filter.kp=1", "trajectory.steps=2", "program=tuning",
                          "chip.error_limit_counts=9", "chip.index_check=true"}) {
    CAPTURE(key);
    Arguments arguments;
    arguments.scenario = "absolute";
    arguments.assignments = {key};
    std::atomic<bool> stop{false};
    CHECK_THROWS_WITH(lm628_shell(arguments, stop, {}),
                      Contains("belongs to the programs of `trammel run an693-*`"));
  }
}

TEST_CASE("a fault of a place that the machine lacks is refused") {
  Arguments arguments;
  arguments.scenario = "absolute";
  arguments.assignments = {"inject.fault=converter_stuck"};
  std::atomic<bool> stop{false};
  CHECK_THROWS_WITH(lm628_shell(arguments, stop, {}),
                    Contains("inject.fault: value \"converter_stuck\" is not one of none, "));
}

TEST_CASE("exit codes: 0 done, 2 refused before anything is simulated, 5 a wait timed out") {
  std::atomic<bool> stop{false};
  Arguments arguments;
  arguments.report = false;
  const fs::path file = "lm628_shell_test.lm628";
  const auto code = [&](const std::string& script) {
    host::write_text(file, script);
    arguments.scenario = "./" + file.string();
    return lm628_shell(arguments, stop, {});
  };
  CHECK(code("RDRP\nquit\nwait hi 1 ms\n") == 0);
  CHECK(code("wait hi 1 ms\n") == 5);
  arguments.out = "lm628_shell_test_codes";
  CHECK_THROWS_AS(code("RDRP\nSTT 1\n"), host::ConfigError);
  CHECK_FALSE(fs::exists(arguments.out));
  CHECK(code("STT\nwait hi 1 ms\n") == 0);  // without PORT12 the part moves, the motor does not
  CHECK(code("wait hi 1 ms\n") == 5);
  CHECK(metrics_of(arguments.out)["end"] == "timeout");
  stop = true;
  CHECK(code("RDRP\n") == 130);
  fs::remove_all(arguments.out);
  fs::remove(file);
}

TEST_CASE("a session goes on after errors, and Ctrl-C ends a wait but not the session") {
  std::atomic<bool> stop{false};
  Arguments arguments;
  arguments.out = "lm628_shell_test_typed";
  arguments.report = false;
  const std::vector<std::string> typed{"RDR", "help STT", "wait hi 1 ms", "wait 1 s", "RDRP", "",
                                       "quit", "RDDP"};
  std::size_t at = 0;
  const ReadLine read_line = [&](const std::string& prompt) -> std::optional<std::string> {
    CHECK(prompt == "lm628> ");
    return typed[at++];
  };
  CHECK(lm628_shell(arguments, stop, read_line) == 0);
  CHECK(at == 7);
  CHECK(read_text(arguments.out + "/script.lm628") == "wait hi 1 ms\nwait 1 s\nRDRP\n");
  arguments.json = true;
  CHECK_THROWS_WITH(lm628_shell(arguments, stop, read_line), Contains("--json: needs a script"));
  fs::remove_all(arguments.out);
}

TEST_CASE("Ctrl-C right after a line stops its command, at the prompt it only drops the line") {
  std::atomic<bool> stop{false};
  Arguments arguments;
  arguments.out = "lm628_shell_test_stopped";
  int at = 0;
  const ReadLine read_line = [&](const std::string&) -> std::optional<std::string> {
    stop = at < 2;
    switch (at++) {
      case 0: return std::nullopt;
      case 1: return "wait 50 s";
      case 2: return "RDRP";
      default: return std::nullopt;  // Ctrl-D
    }
  };
  arguments.report = false;
  CHECK(lm628_shell(arguments, stop, read_line) == 0);
  CHECK(at == 4);
  const auto metrics = metrics_of(arguments.out);
  CHECK(metrics["run"]["simulated_s"].get<double>() < 1);
  CHECK(read_text(arguments.out + "/script.lm628") == "wait 50 s\nRDRP\n");
  fs::remove_all(arguments.out);
}

TEST_CASE("repeat moves there and back, and its lines stand in the transcript as executed") {
  const Played run = play(
      "PORT12\nLFIL 030Ah 50 1000\nUDF\nLTRJ 0028h 100000 1000000\nRSTI 0\nrepeat 3\n"
      "LTRJ 0003h 100\nSTT\nwait complete\nRSTI 0\nend\nRDDP\n");
  CHECK(run.halt.empty());
  CHECK(run.answers.size() == 5 + 3 * 4 + 1);
  CHECK(run.answers.back()["value"] == 300);
}

TEST_CASE("a script waits for breakpoint, index and position error, and may wait in vain") {
  const std::string begin =
      "PORT12\nRSTI 0\nLFIL 030Ah 50 1000\nUDF\nLTRJ 0028h 1000 100000\n";
  const Played found = play(begin +
                            "SBPA 300\nSIP\nLTRJ 0002h 4300\nSTT\nwait breakpoint\nRDRP\n"
                            "wait index\nRDIP\nLPES 50\ntorque 2\nwait error 1 s\nRDSTAT");
  CHECK(found.halt.empty());
  REQUIRE(found.answers.size() == 17);
  CHECK(found.answers[10]["value"].get<double>() >= 300);
  CHECK(found.answers[10]["value"].get<double>() < 320);
  CHECK(found.answers[12]["value"] == 4000);
  CHECK_THAT(found.answers[16]["bits"].get<std::string>(), Contains("motor off"));
  CHECK_THAT(found.answers[16]["bits"].get<std::string>(), Contains("position error"));
  for (const std::string event : {"breakpoint", "index", "error"}) {
    const Played vain = play(begin + "STT\nwait complete\nwait " + event + " 5 ms");
    CHECK(vain.end == cosim::EndReason::kTimeout);
    CHECK_THAT(vain.halt, Contains("test:8: wait " + event + " 5 ms: not within 0.005 s; status "));
  }
}

// At rest kp e / 32768 of the supply drives the current that bears the load.
TEST_CASE("a load in mid-run deflects the shaft as the same load from the beginning does") {
  const std::string hold = "PORT12\nLFIL 030Ah 100 1000\nUDF\nLTRJ 0\nSTT\n";
  const Played stepped = play(hold + "wait 0.2 s\nRDRP\ntorque 0.05\nwait 1 s\nRDRP\ntorque 0\n"
                                     "wait 1 s\nRDRP\ntorque -0.05\nwait 1 s\nRDRP");
  CHECK(stepped.halt.empty());
  const auto value = [](const Played& run, std::size_t k) {
    return run.answers[k]["value"].get<double>();
  };
  const double expected = 0.05 / 0.05 * 2.0 / 24 * 32768 / 100;  // T / k R / supply
  CHECK(value(stepped, 6) == 0);
  CHECK(value(stepped, 9) == Approx(-expected).margin(2));
  CHECK(value(stepped, 12) == Approx(0).margin(2));
  CHECK(value(stepped, 15) == Approx(expected).margin(2));
  Options options;
  options.plant.motor.external_torque = 0.05;
  const Played constant = play(hold + "wait 1.2 s\nRDRP", options);
  CHECK(value(constant, 6) == Approx(value(stepped, 9)).margin(1));
  CHECK(play(hold + "torque 0.05\nwait 20 ms\nRDRP\npins").text ==
        play(hold + "torque 0.05\nwait 20 ms\nRDRP\npins").text);
}

TEST_CASE("a load at the clock of an encoder's edge loses no count") {
  Options options;
  options.run.engine = cosim::Engine::kTwin;
  Bench bench(options, [](const Sample&) { return false; });
  bench.loop().advance(80'000, 0);  // the reset routine is over
  bench.load(-1);
  for (int n = 0; n < 40; ++n) {
    bench.loop().advance(bench.plant().axis().next(), 0);
    REQUIRE(bench.plant().axis().next() == bench.chip().now());
    bench.load(n % 2 == 0 ? -0.9 : -1);
  }
  bench.load(0);
  bench.loop().advance(bench.chip().now() + 100'000'000, 0);  // the shorted motor brakes
  CHECK(bench.plant().axis().count() > 40);
  CHECK(bench.chip().words().actual == bench.plant().axis().count());
}

TEST_CASE("a script with loads gives the same run on RTL and twin") {
  Options rtl, twin;
  rtl.run.engine = cosim::Engine::kRtl;
  twin.run.engine = cosim::Engine::kTwin;
  const std::string script = read_text(find_script("load"));
  const Played a = play(script, rtl), b = play(script, twin);
  CHECK(a.halt.empty());
  CHECK(a.text == b.text);
  CHECK(a.result.event_hash == b.result.event_hash);
  CHECK(a.result.samples.size() > 3000);
}

TEST_CASE("a block is typed line by line, and Ctrl-C or a mistake drops it") {
  std::atomic<bool> stop{false};
  Arguments arguments;
  arguments.out = "lm628_shell_test_block";
  arguments.report = false;
  const std::vector<std::string> typed{"repeat 2", "RDRP", "", "end",  "repeat 2", "RDR",
                                       "end",      "repeat 3", "^C", "RDDP", "repeat 9"};
  std::string prompts;
  std::size_t at = 0;
  const ReadLine read_line = [&](const std::string& prompt) -> std::optional<std::string> {
    prompts += prompt[0];
    if (at == typed.size()) return std::nullopt;
    stop = typed[at] == "^C";
    return stop ? (++at, std::nullopt) : std::optional(typed[at++]);
  };
  CHECK(lm628_shell(arguments, stop, read_line) == 0);
  CHECK(prompts == "l   l ll ll ");
  CHECK(read_text(arguments.out + "/script.lm628") == "RDRP\nRDRP\nRDDP\n");
  fs::remove_all(arguments.out);
}

TEST_CASE("STT tells of an output that is not its converter's, whatever has set it last") {
  Options options;
  for (const int bits : {8, 12}) {
    options.part.dac_bits = bits;
    const std::string eight = bits == 8 ? "" : "the motor gets nothing before PORT12";
    const std::string twelve = bits == 12 ? "" : "the converter of 8 bits needs PORT8";
    const auto noted = [&](const std::string& before, const std::string& what) {
      CAPTURE(bits, before);
      CHECK(play(before + "\nSTT", options).notes ==
            (what.empty() ? "" : "test:3: STT: " + what));
    };
    noted("RSTI 0\nRSTI 0", eight);
    noted("RSTI 0\nPORT12", twelve);
    for (const char* back : {"PORT8", "RESET", "rst"}) {
      noted("PORT12\n" + std::string(back), eight);
    }
    noted("rst\nPORT12", twelve);
  }
  options.part.variant = lm628::Variant::kLm629;
  CHECK(play("STT", options).notes == "");
}
