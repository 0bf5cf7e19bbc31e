// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/verbs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <vector>

#include "host/files.hpp"
#include "host/text.hpp"
#include "lab/build_info.hpp"
#include "lab/layers.hpp"
#include "lab/write.hpp"
#include "machines/an693/machine_members.hpp"
#include "machines/an693/verbs/shell.hpp"
#include "testbench/run.hpp"

namespace trammel::an693 {
namespace {

namespace fs = std::filesystem;
using host::ConfigError;
using testbench::print;
using testbench::print_json;
using testbench::print_now;
using testbench::tell;
using Json = nlohmann::ordered_json;

// What was executed so far, and how that ended.
struct Transcript {
  std::string script;  // the lines
  Json answers = Json::array();
  cosim::EndReason end = cosim::EndReason::kDone;
  std::string halt;  // where it could not go on
};

// False at the command that ends it all.
bool execute(Shell& shell, const Line& line, Transcript& all, bool quiet = false) {
  if (line.command->action == Action::kQuit) return false;
  if (line.command->action != Action::kHelp) all.script += line.text + '\n';
  const Answer answer = shell.execute(line);
  all.answers.push_back(answer.json);
  if (!quiet) print_now(answer.text);
  if (!answer.note.empty()) tell(answer.note);
  return true;
}

void play(Shell& shell, const std::vector<Line>& script, Transcript& all, bool quiet) {
  try {
    for (const Line& line : script) {
      if (!execute(shell, line, all, quiet)) return;
    }
  } catch (const Halt& halt) {
    all.end = halt.end;
    all.halt = halt.what();
  }
}

// A line, or a block of lines of which `first` is the first; nothing where its end does not come.
std::optional<std::vector<Line>> typed(const ReadLine& read_line, const std::string& first) {
  const auto line = parse_line(first, "lm628");
  if (!line) return std::vector<Line>();
  int depth = depth_after(0, *line);
  if (depth == 0) return std::vector<Line>{*line};
  std::string block = first;
  while (depth > 0) {
    const std::optional<std::string> text = read_line("  ...> ");
    if (!text) return {};
    if (const auto next = parse_line(*text, "lm628")) depth = depth_after(depth, *next);
    block += '\n' + *text;
  }
  return parse_script(block, "lm628");
}

void converse(Shell& shell, const lm628::PartOptions& part, const ReadLine& read_line,
              std::atomic<bool>& stop, Transcript& all) {
  print_now(fmt::format("{} of {} MHz with a DC motor, after RST; `help` names the commands\n",
                        part.pulses() ? "LM629" : "LM628", part.clock_MHz));
  for (;;) {
    stop = false;
    const std::optional<std::string> text = read_line("lm628> ");
    if (!text && !stop) return;
    if (!text) {
      print_now("\n");
      continue;
    }
    try {  // a stop that comes right after the line ends what the line asks for
      const auto lines = typed(read_line, *text);
      if (!lines && !stop) return;
      if (!lines) print_now("\n");
      for (const Line& line : lines.value_or(std::vector<Line>())) {
        if (!execute(shell, line, all)) return;
      }
    } catch (const ConfigError& error) {
      tell(error.what());
    } catch (const Halt& halt) {
      tell(halt.what());
    }
  }
}

// The time of an event is not known in advance, and a script is not run twice.
void check_script_waves(const cosim::RunOptions& run, const std::string& out) {
  if (run.wave == cosim::WaveFormat::kNone) return;
  if (out.empty()) throw ConfigError("lm628: --wave: needs a folder for the waves (-o)");
  if (cosim::trigger_asked(run) &&
      !cosim::parse_trigger(run.wave_trigger, triggers(), run.clock_ps).known()) {
    throw ConfigError(fmt::format("lm628: --wave-trigger: \"{}\" is not known before the script "
                                  "runs; give at TIME, or --wave-window",
                                  run.wave_trigger));
  }
}

// What a script does itself, or what does not end its run.
bool of_firmware(const lab::Key& key) {
  return key.name == "program" || key.name == "run.platform" ||
         key.name == "run.diverged_counts" || key.name == "run.reached_counts" ||
         key.name == "processor.interrupt_latency_clk" ||
         key.name == "chip.error_limit_counts" || key.name == "chip.index_check" ||
         key.name.rfind("filter.", 0) == 0 || key.name.rfind("trajectory.", 0) == 0;
}

// Keys that would do nothing.
void refuse_firmware_keys(const Options& options) {
  const Options untouched;
  for (const lab::Key& key : keys()) {
    if (!of_firmware(key) || key.get(options) == key.get(untouched)) continue;
    throw ConfigError(fmt::format("lm628: {}: belongs to the programs of `trammel run an693-*`; "
                                  "here the script gives the commands",
                                  key.name));
  }
}

// The script that was asked for, and its name.
std::vector<Line> read_script(const std::string& asked, std::string& name) {
  if (asked.empty() || asked == "-") {
    return parse_script(host::read_standard_input(host::kMostWritten), "standard input");
  }
  const fs::path file = find_script(asked);
  name = file.stem().string();
  // Its name is in metrics.json, where a line of it ends the run.
  return parse_script(host::read_text(file, host::kMostWritten), host::printable(file.string()));
}

// Signals are for this thread: one that begins meanwhile has its mask.
struct SignalsBlocked {
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

  sigset_t before;
};

// Nothing piped and no script: a person.
bool is_conversation(const testbench::Arguments& arguments) {
  return arguments.scenario.empty() && isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
}

int perform(const testbench::Arguments& arguments, std::atomic<bool>& stop) {
  return lm628_shell(arguments, stop,
                     is_conversation(arguments) ? terminal_lines(stop) : ReadLine());
}

}  // namespace

int lm628_shell(const testbench::Arguments& arguments, std::atomic<bool>& stop,
                const ReadLine& read_line) {
  const bool talks = static_cast<bool>(read_line);
  if (talks && arguments.json) throw ConfigError("lm628: --json: needs a script");
  const auto settings = std::make_shared<Options>();
  Options& options = *settings;
  options.scenario = "lm628";
  std::vector<Line> script;
  if (!talks) script = read_script(arguments.scenario, options.scenario);
  testbench::apply_layers(options, arguments);
  refuse_firmware_keys(options);
  lab::validate(options);
  check_script_waves(options.run, arguments.out);
  if (const auto notice = lab::waves_notice(options)) tell(*notice);
  options.run.platform = cosim::Platform::kDirect;  // the host is this program
  std::optional<host::OutputFolder> folder;
  if (!arguments.out.empty()) {
    folder.emplace(arguments.out);
    options.run.wave_file = lab::wave_file(folder->scratch());
  }

  Transcript all;
  auto result = std::make_unique<Result>();
  {
    std::optional<Shell> shell;
    lab::with_config_errors([&] {
      const SignalsBlocked blocked;
      shell.emplace(options, stop);
    });
    if (talks) {
      converse(*shell, options.part, read_line, stop, all);
    } else {
      play(*shell, script, all, arguments.json);
    }
    *result = shell->result();
  }  // its waves are whole
  result->end = result->assertion ? cosim::EndReason::kAssertion : all.end;
  result->fault = all.halt;
  const int code = lab::exit_code(result->end);
  // Why the script ended is told when its record is there: where that fails, this is the error.
  if (!folder && !all.halt.empty()) tell(all.halt);
  if (!folder && !arguments.json) return code;
  const lab::Record record = lab::judged(settings, std::move(result));
  const std::string again = folder                       ? "script.lm628 -c run.toml"
                            : arguments.scenario.empty() ? "-"
                                                         : host::shell_word(arguments.scenario);
  const lab::Origin origin{"./trammel lm628 " + again, of_firmware, {{"script", all.answers}},
                           {{"script.lm628", all.script}}};
  const Json json = lab::metrics_json(record, origin);
  if (arguments.json) print_json(json);
  if (!folder) return code;
  const lab::Written written = lab::write_record(record, *folder, json, origin, arguments.report);
  folder->publish(lab::kVersion);
  for (const std::string& note : written.notes) tell(note);
  if (!all.halt.empty()) tell(all.halt);
  const std::string shown = fs::proximate(folder->target()).string();
  if (!arguments.json) print(lab::report_text(record, shown, written.page));
  if (code != 0) return code;
  const int late = talks ? 0 : testbench::late_stop(options.scenario, shown, stop);
  return late != 0 ? late : written.code;
}

std::vector<testbench::Verb> verbs() {
  testbench::Verb verb;
  verb.name = "lm628";
  verb.help = "send commands to an LM628 with its motor, from a script or typed at a prompt";
  verb.argument = "script";
  verb.argument_help =
      "built-in name, file, or - for standard input; none on a terminal: a prompt, at which `help` "
      "names the commands, and wait, torque and repeat";
  verb.out_help = "folder for the files that `trammel run` writes, and script.lm628";
  verb.simulates = true;
  verb.trigger_help = "at TIME";  // a script runs once, so that no event is known before
  verb.is_conversation = is_conversation;
  verb.perform = perform;
  return {verb};
}

}  // namespace trammel::an693
