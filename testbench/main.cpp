// SPDX-License-Identifier: Apache-2.0
//
// The `trammel` program. Results go to stdout, all else to stderr. Exit codes: 0 ok, 1 a check
// failed, 2 usage or configuration, 3 a tool is missing, 4 an assertion of the RTL failed,
// 5 diverged or tripped, 70 internal, 130 interrupted.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <sstream>

#include "cosim/not_built.hpp"
#include "host/errors.hpp"
#include "host/text.hpp"
#include "lab/scenarios.hpp"
#include "machines/table.hpp"
#include "testbench/arguments.hpp"
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
  // Without a conversation no read or write of a file ends early.
  action.sa_flags = conversation ? 0 : static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  if (!conversation) sigaction(SIGTERM, &action, nullptr);
}

// "", such as a variable of the shell that is not set, is no name.
const CLI::Validator named(
    [](std::string& name) { return std::string(name.empty() ? "needs a name" : ""); }, "");

std::string scenario_help() {
  const std::vector<std::string> programs = trammel::lab::program_extensions();
  return fmt::format("name of a built-in scenario, or path of a .toml file{}",
                     programs.empty() ? "" : fmt::format(" or of a program ({})",
                                                         fmt::join(programs, ", ")));
}

struct CommandLine {
  CLI::App app{"Trammel: simulates motion-control ICs clock by clock, with the machine they drive"};
  tb::Arguments arguments;
  std::string topic = "scenarios";
  std::string machine;
  CLI::App* run = nullptr;
  CLI::App* list = nullptr;
  CLI::App* doctor = nullptr;
  CLI::App* report = nullptr;
  std::vector<std::pair<CLI::App*, const tb::Verb*>> of_machines;

  CommandLine() {
    app.name("trammel");
    app.require_subcommand(1);
    app.fallthrough();
    app.set_version_flag("--version", tb::version_text());
    app.add_flag("--json", arguments.json, "print exactly one JSON document");

    run = app.add_subcommand("run", "simulate a scenario and report how well the machine followed");
    add_layers(run, "scenario", scenario_help(), "output folder; default: out/<scenario>");
    add_simulation(run,
                   "event that places the window, such as `x.e > 100`, found by an untraced run "
                   "first; `trammel list signals` shows those of each machine");
    run->add_flag("--all", arguments.all,
                  "run the experiments of the first machine's source and compare them");
    add_key(run, "--engine", "run.engine", "rtl, or twin: its bit-exact C++ twin, which is faster");
    add_key(run, "--cpu", "run.cpu",
            "native firmware, or rtl: the RTL of the chip's processor runs its binary");
    add_key(run, "--platform", "run.platform",
            "systemc, or direct: without SystemC, as twins and --cpu rtl always are");
    run->add_flag("--serial", arguments.live,
                  "until Ctrl-C, in real time, with another program at the machine's serial port; "
                  "prints the port's name");
    run->add_flag("--check", arguments.check,
                  "exit 1 if a figure is outside its tolerance, 2 if none has an expected value");

    run->add_flag("--activity", arguments.activity,
                  "print the share of clocks at which each clock domain of the chip was awake");

    for (const tb::Verb& verb : tb::machine_verbs()) add_verb(verb);

    report = app.add_subcommand("report", "write the page of a run, or one that compares runs");
    report->add_option("folder", arguments.folders,
                       "folders of finished runs; default: the latest in out/");
    report->add_option("-o,--out", arguments.out,
                       "file of the page; default: report.html in the folder, or out/compare.html")
        ->check(named);

    list = app.add_subcommand("list",
                              "show scenarios, machines, or what a machine has: its keys, the "
                              "columns of its trace, the signals that can trigger");
    list->add_option("topic", topic, "default: scenarios")
        ->check(CLI::IsMember({"scenarios", "machines", "keys", "columns", "signals"}));
    list->add_option("machine", machine,
                     "whose keys, columns or signals; default: the first machine's, and the "
                     "signals of all")
        ->check(CLI::IsMember(trammel::lab::machine_names()));
    doctor = app.add_subcommand("doctor", "show versions and which tools are installed");
  }

  void add_verb(const tb::Verb& verb) {
    CLI::App* const app_verb = app.add_subcommand(verb.name, verb.help);
    add_layers(app_verb, verb.argument, verb.argument_help, verb.out_help);
    if (verb.simulates) add_simulation(app_verb, verb.trigger_help);
    for (const tb::Verb::Flag& flag : verb.flags) {
      app_verb->add_flag_callback(flag.name,
                                  [this, name = flag.name] { arguments.flags.insert(name); },
                                  flag.help);
    }
    of_machines.emplace_back(app_verb, &verb);
  }

  // An option with the value of a key, or a flag that gives it `value`.
  void add_key(CLI::App* verb, const std::string& name, const std::string& key, const char* help,
               const std::string& value = "") {
    const auto set = [this, name, key](const std::string& word) {
      arguments.keys.emplace_back(name, key + '=' + word);
    };
    if (value.empty()) {
      verb->add_option_function<std::string>(name, set, help);
    } else {
      verb->add_flag_callback(name, [set, value] { set(value); }, help);
    }
  }

  // Of every verb that takes a machine's keys.
  void add_layers(CLI::App* verb, const std::string& name, const std::string& scenario,
                  const std::string& out) {
    verb->add_option(name, arguments.scenario, scenario);
    verb->add_option("-c,--config", arguments.files, "further TOML files; later ones win");
    verb->add_option("-s,--set", arguments.assignments, "key=value; keys: `trammel list keys`");
    verb->add_option("-o,--out", arguments.out, out)->check(named);
  }

  // Of every verb that simulates.
  void add_simulation(CLI::App* verb, const std::string& trigger) {
    add_key(verb, "--no-leap", "run.leap", "evaluate every clock; the events are the same",
            "false");
    add_key(verb, "--audit", "run.audit",
            "run a leaping chip and one that evaluates every clock in lock step; exit 4 at the "
            "first register that differs",
            "true");
    add_key(verb, "--assert", "run.assertions",
            "check the assertions of the RTL in every clock, 50 times slower; exit 4 if one fails",
            "true");
    trammel::lab::WaveArguments& waves = arguments.waves;
    verb->add_option("--wave", waves.format, "trace signals: vcd or fst");
    verb->add_option("--wave-window", waves.window,
                     "begin:end from the start of the run or from the trigger, such as -1ms:2ms; "
                     "default: 2 ms around the trigger, or from when the drives start");
    verb->add_option("--wave-trigger", waves.trigger, trigger);
    verb->add_option("--wave-pre", waves.pre,
                     "part of the default window before the trigger; default: 0.2ms");
    verb->add_option("--wave-every", waves.every,
                     "repeat the window with this period, such as 50ms");
    verb->add_flag_callback("--no-report", [this] { arguments.report = false; },
                            "do not write report.html");
  }
};

bool is_in(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string> own_verbs(const CLI::App& app) {
  std::vector<std::string> all;
  for (const CLI::App* verb : app.get_subcommands({})) all.push_back(verb->get_name());
  return all;
}

// Verbs of the program and of the launcher that started it.
std::vector<std::string> verbs(const CLI::App& app) {
  std::vector<std::string> all = own_verbs(app);
  const char* const launcher = std::getenv("TRAMMEL_VERBS");
  std::istringstream more(launcher == nullptr ? "" : launcher);
  for (std::string verb; more >> verb;) all.push_back(verb);
  return all;
}

int perform(const CommandLine& line) {
  if (line.list->parsed()) return tb::list(line.topic, line.machine, line.arguments.json);
  if (line.doctor->parsed()) return tb::doctor(line.arguments.json);
  if (line.report->parsed()) return tb::report(line.arguments);
  for (const auto& [parsed, verb] : line.of_machines) {
    if (!parsed->parsed()) continue;
    // What does not simulate keeps nothing of a part of its work: a signal ends it at once.
    const bool talks = verb->is_conversation != nullptr && verb->is_conversation(line.arguments);
    if (verb->simulates) catch_interrupts(talks);
    return verb->perform(line.arguments, g_stop);
  }
  catch_interrupts();
  return tb::run(line.arguments, g_stop);
}

int fail(const std::exception& error, int code, const char* kind = "") {
  tb::tell(kind + trammel::host::reason_of(error));
  return code;
}

int run_line(CommandLine& line, int argc, char** argv) {
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const std::string verb = argc > 1 ? argv[1] : "-";
    const std::vector<std::string> known = verbs(line.app);
    if (!is_in(known, verb) && verb.rfind('-', 0) != 0) {
      const std::string near = trammel::lab::suggest(verb, known);
      tb::tell(fmt::format("{}: unknown verb{}; see trammel --help", verb,
                           near.empty() ? "" : fmt::format(", did you mean {}?", near)));
      return 2;
    }
    if (!is_in(own_verbs(line.app), verb) && is_in(known, verb)) {
      trammel::lab::need_all_machines();  // a verb of another machine
    }
    if (error.get_exit_code() == 0) {  // help and version
      std::ostringstream text;
      line.app.exit(error, text, text);
      tb::print(text.str());
      return 0;
    }
    tb::tell(fmt::format("{}; see trammel {}--help", error.what(),
                         verb.rfind('-', 0) == 0 ? "" : verb + ' '));
    return 2;
  }
  return perform(line);
}

// Reports the error that is being handled; its exit code.
int failed() {
  try {
    throw;
  } catch (const trammel::host::ConfigError& error) {
    return fail(error, 2);
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string of = error.path1().string();
    trammel::testbench::tell(
        fmt::format("{}: {}", of.empty() ? "current folder" : of, error.code().message()));
    return 2;
  } catch (const std::system_error& error) {  // of a disk
    return fail(error, 2);
  } catch (const std::bad_alloc& error) {
    return fail(error, 2);
  } catch (const trammel::host::ToolMissing& error) {
    return fail(error, 3);
  } catch (const std::exception& error) {
    return fail(error, 70, "internal error: ");
  }
}

// All but what becomes of standard output at the end.
int run_program(int argc, char** argv) {
  try {
    CommandLine line;
    return run_line(line, argc, argv);
  } catch (const trammel::cosim::NotBuilt& error) {
    tb::hand_over("trammel_" + trammel::lab::machines().front()->name + "_watched", argv);
    return fail(error, 3);
  } catch (const trammel::lab::NotLinked& error) {
    tb::hand_over(error.machine.empty() ? "trammel" : "trammel_" + error.machine, argv);
    return fail(error, 3);
  } catch (const std::exception&) {
    return failed();
  }
}

std::unique_ptr<char[]> g_reserve;  // memory for the message of an error that ends the program

}  // namespace

int main(int argc, char** argv) {
  g_reserve = std::make_unique<char[]>(1 << 16);
  std::set_terminate([] {  // destructors of JSON values take memory, and may not throw
    g_reserve.reset();
    std::_Exit(std::current_exception() ? failed() : 70);
  });
  tb::guard_streams();
  trammel::lab::take_machines(trammel::linked_machines, trammel::all_are_linked());
  return tb::settled(run_program(argc, argv));
}
