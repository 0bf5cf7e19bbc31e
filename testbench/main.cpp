// SPDX-License-Identifier: Apache-2.0
//
// The `trammel` program. Results go to stdout, all else to stderr. Exit codes: 0 ok, 1 a check
// failed, 2 usage or configuration, 3 a tool is missing, 4 a promise of the RTL was broken,
// 5 diverged or tripped, 70 internal, 130 interrupted.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "cosim/kung/trigger.hpp"
#include "cosim/wave_event.hpp"
#include "systemc/machines/an693.hpp"
#include "systemc/machines/kung.hpp"
#include "systemc/machines/mcafee.hpp"
#include "testbench/config.hpp"
#include "testbench/doctor.hpp"
#include "testbench/lm628.hpp"
#include "testbench/mcafee.hpp"
#include "testbench/report_page.hpp"
#include "testbench/run.hpp"

namespace {

namespace tb = trammel::testbench;

std::atomic<bool> g_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

void on_interrupt(int) { g_stop = true; }

// The first Ctrl-C asks the run to end with what it has; a second one ends the program. In a
// conversation each one ends a wait.
void catch_interrupts(bool conversation = false) {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = conversation ? 0 : static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  if (!conversation) sigaction(SIGTERM, &action, nullptr);
}

struct CommandLine {
  CLI::App app{"Trammel: motion-control ICs, clock by clock, with the machine they drive"};
  tb::RunArguments run_arguments;
  std::string topic = "scenarios";
  std::string machine = "kung";
  CLI::App* run = nullptr;
  CLI::App* list = nullptr;
  CLI::App* doctor = nullptr;
  CLI::App* report = nullptr;
  CLI::App* lm628 = nullptr;
  CLI::App* track = nullptr;
  tb::ReportArguments report_arguments;

  CommandLine() {
    app.name("trammel");
    app.require_subcommand(1);
    app.fallthrough();
    app.set_version_flag("--version", tb::version_text());
    app.add_flag("--json", run_arguments.json, "print exactly one JSON document");

    run = app.add_subcommand("run", "simulate a scenario and show whether the table followed");
    add_layers(run, "scenario", "built-in name or path of a .toml file",
               "output folder, default out/<scenario>");
    add_simulation(run);
    run->add_flag("--all", run_arguments.all, "the paper's eight experiments");
    run->add_option("--engine", run_arguments.engine, "rtl, or twin: its bit-exact twins, fast");
    run->add_option("--platform", run_arguments.platform, "systemc or direct");
    run->add_flag("--check", run_arguments.check, "exit 1 when a figure is out of tolerance");

    lm628 = app.add_subcommand("lm628", "the commands of an LM628 with its motor: a script, or a "
                                        "conversation");
    add_layers(lm628, "script",
               "built-in name, file, or - for standard input; none on a terminal: a "
               "conversation, in which `help` names the commands",
               "write what `trammel run` writes into this folder, and script.lm628");
    add_simulation(lm628);

    report = app.add_subcommand("report", "a page of a run, or one that compares runs");
    report->add_option("folder", report_arguments.folders,
                       "of finished runs; none: the latest in out/");
    report->add_option("-o,--out", report_arguments.out,
                       "the page; default report.html in the folder, or out/compare.html");

    track = app.add_subcommand("track", "the table of a path of the machine mcafee, as CSV");
    add_layers(track, "scenario", "scenario with the path, default mcafee-stage3",
               "file of the table; default: standard output");
    track->add_flag("--listing", run_arguments.listing,
                    "rows as McAfee's listing has them in memory: bytes C CC Vx Vy dY dX");

    list = app.add_subcommand("list", "scenarios, every parameter with unit and range, or signals");
    list->add_option("topic", topic, "scenarios, keys or signals (for --wave-trigger)")
        ->check(CLI::IsMember({"scenarios", "keys", "signals"}));
    list->add_option("machine", machine, "whose keys")
        ->check(CLI::IsMember(tb::machines()));
    doctor = app.add_subcommand("doctor", "what is here and what is missing");
  }

  // Of every verb that takes a machine's keys.
  void add_layers(CLI::App* verb, const char* name, const char* scenario, const char* out) {
    verb->add_option(name, run_arguments.scenario, scenario);
    verb->add_option("-c,--config", run_arguments.files, "more TOML files, later ones win");
    verb->add_option("-s,--set", run_arguments.assignments, "key=value (`trammel list keys`)");
    verb->add_option("-o,--out", run_arguments.out, out);
  }

  // Of every verb that simulates.
  void add_simulation(CLI::App* verb) {
    verb->add_flag("--no-leap", run_arguments.plain, "evaluate every clock; the same events");
    verb->add_flag("--audit", run_arguments.audit,
                   "a plain and a leaping chip in step, every register compared; exit 4 at the "
                   "first that differs");
    verb->add_flag("--assert", run_arguments.assertions,
                   "look at the promises of the RTL; exit 4 when one is broken; 50 times slower");
    add_waves(verb);
    verb->add_flag_callback("--no-report", [this] { run_arguments.report = false; },
                            "without report.html");
  }

  void add_waves(CLI::App* verb) {
    tb::WaveArguments& waves = run_arguments.waves;
    verb->add_option("--wave", waves.format, "signal traces: vcd or fst");
    verb->add_option("--wave-window", waves.window,
                     "a:b from the start of the run, or from the trigger (-1ms:2ms); default: 2 ms "
                     "around the trigger, or from where the drives start");
    const bool of_script = verb->get_name() == "lm628";  // it runs once
    verb->add_option("--wave-trigger", waves.trigger,
                     of_script ? "at TIME"
                               : fmt::format("begin at an event, found in an untraced run before. "
                                             "kung: {}; names: `trammel list signals`. an693, "
                                             "mcafee: {}",
                                             trammel::kung::kTriggerForms,
                                             trammel::cosim::kWaveEvents));
    verb->add_option("--wave-pre", waves.pre, "before the trigger, default 0.2ms");
    verb->add_option("--wave-every", waves.every,
                     "the window again in each such period, for instance 50ms");
  }
};

// Verbs of the program and of the launcher that started it.
std::vector<std::string> verbs(const CLI::App& app) {
  std::vector<std::string> all;
  for (const CLI::App* verb : app.get_subcommands({})) all.push_back(verb->get_name());
  const char* const launcher = std::getenv("TRAMMEL_VERBS");
  std::istringstream more(launcher == nullptr ? "" : launcher);
  for (std::string verb; more >> verb;) all.push_back(verb);
  return all;
}

int perform(const CommandLine& line) {
  if (line.list->parsed()) {
    return tb::list(line.topic, line.machine, line.run_arguments.json);
  }
  if (line.doctor->parsed()) return tb::doctor(line.run_arguments.json);
  if (line.report->parsed()) {
    tb::ReportArguments arguments = line.report_arguments;
    arguments.json = line.run_arguments.json;
    return tb::report(arguments);
  }
  if (line.lm628->parsed()) {
    const bool conversation = tb::is_conversation(line.run_arguments);
    catch_interrupts(conversation);
    return tb::lm628_shell(line.run_arguments, g_stop,
                           conversation ? tb::terminal_lines(g_stop) : tb::ReadLine());
  }
  if (line.track->parsed()) return tb::track(line.run_arguments);
  catch_interrupts();
  return tb::run(line.run_arguments, trammel::kung::simulate, g_stop, trammel::lm628::simulate,
                 trammel::mcafee::simulate);
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line;
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const std::string verb = argc > 1 ? argv[1] : "-";
    const std::vector<std::string> known = verbs(line.app);
    if (std::find(known.begin(), known.end(), verb) == known.end() && verb.rfind('-', 0) != 0) {
      const std::string near = tb::suggest(verb, known);
      fmt::print(stderr, "trammel: {}: unknown verb{}; see trammel --help\n", verb,
                 near.empty() ? "" : fmt::format(", did you mean {}?", near));
      return 2;
    }
    if (error.get_exit_code() == 0) return line.app.exit(error);  // help and version
    fmt::print(stderr, "trammel: {}; see trammel {}--help\n", error.what(),
               verb.rfind('-', 0) == 0 ? "" : verb + ' ');
    return 2;
  }
  try {
    return perform(line);
  } catch (const tb::ConfigError& error) {
    fmt::print(stderr, "trammel: {}\n", error.what());
    return 2;
  } catch (const std::system_error& error) {  // of a disk
    fmt::print(stderr, "trammel: {}\n", error.what());
    return 2;
  } catch (const tb::ToolMissing& error) {
    fmt::print(stderr, "trammel: {}\n", error.what());
    return 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "trammel: internal error: {}\n", error.what());
    return 70;
  }
}
