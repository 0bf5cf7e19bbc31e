// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/verbs/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <vector>

#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"
#include "machines/an693/machine.hpp"
#include "machines/an693/verbs/shell.hpp"
#include "lab/files.hpp"
#include "testbench/run.hpp"

namespace trammel::an693 {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr char kHere[] = "lm628";  // where a line is from that somebody typed

// What was executed so far, and how that ended.
struct Conversation {
  std::string script;  // the lines
  Json answers = Json::array();
  cosim::EndReason end = cosim::EndReason::kDone;
  std::string halt;  // where it could not go on
};

using testbench::tell;

void execute(Lm628Shell& shell, const Lm628Line& line, Conversation& all, bool quiet) {
  if (line.word->action != Lm628Action::kHelp) all.script += line.text + '\n';
  const Lm628Answer answer = shell.execute(line);
  all.answers.push_back(answer.json);
  if (!quiet) fmt::print("{}", answer.text);
  if (!answer.note.empty()) tell(answer.note);
  std::fflush(stdout);
}

void play(Lm628Shell& shell, const std::vector<Lm628Line>& script, Conversation& all, bool quiet) {
  try {
    for (const Lm628Line& line : script) {
      if (line.word->action == Lm628Action::kQuit) return;
      execute(shell, line, all, quiet);
    }
  } catch (const Lm628Halt& halt) {
    all.end = halt.end;
    all.halt = halt.what();
    tell(halt.what());
  }
}

void converse(Lm628Shell& shell, const ReadLine& read_line, std::atomic<bool>& stop,
              Conversation& all) {
  fmt::print("LM628 of 8 MHz with a DC motor, after RST; `help` names the commands\n");
  for (;;) {
    stop = false;
    const std::optional<std::string> text = read_line("lm628> ");
    if (!text && stop) {
      fmt::print("\n");
      continue;
    }
    if (!text) return;  // one right behind the line stays for what it asks
    try {
      const auto line = parse_lm628_line(*text, kHere);
      if (!line) continue;
      if (line->word->action == Lm628Action::kQuit) return;
      execute(shell, *line, all, false);
    } catch (const lab::ConfigError& error) {
      tell(error.what());
    } catch (const Lm628Halt& halt) {
      tell(halt.what());
    }
  }
}

// Nobody knows beforehand when an event comes, and there is no second run.
void check_script_waves(const cosim::RunBasics& run, const std::string& out) {
  if (run.wave == cosim::WaveFormat::kNone) return;
  if (out.empty()) throw lab::ConfigError("lm628: --wave: needs a folder for the waves (-o)");
  if (cosim::trigger_asked(run) &&
      !cosim::parse_trigger(run.wave_trigger, triggers()).known()) {
    throw lab::ConfigError(
        fmt::format("lm628: --wave-trigger: \"{}\" is not known before the script "
                    "runs; give at TIME, or --wave-window",
                    run.wave_trigger));
  }
}

// What a script does itself, or what does not end its run.
bool of_firmware(const lab::Key& key) {
  return key.name == "program" || key.name == "run.platform" ||
         key.name == "run.diverged_counts" || key.name == "processor.interrupt_latency_clk" ||
         key.name.rfind("filter.", 0) == 0 || key.name.rfind("trajectory.", 0) == 0;
}

// A key that would do nothing.
void refuse_firmware_keys(const Options& options) {
  const Options untouched;
  for (const lab::Key& key : keys()) {
    if (!of_firmware(key) || key.get(options) == key.get(untouched)) continue;
    throw lab::ConfigError(fmt::format("lm628: {}: is of the programs of `trammel run an693-*`; "
                                       "here the commands are at the port", key.name));
  }
}

std::string read_script(const std::string& name, std::string& source, std::string& stem) {
  if (name.empty() || name == "-") {
    source = "standard input";
    return {std::istreambuf_iterator<char>(std::cin), {}};
  }
  const fs::path file = find_lm628_script(name);
  source = file.string();
  stem = file.stem().string();
  return lab::read_text(file);
}

}  // namespace

bool is_conversation(const testbench::Arguments& arguments) {
  return arguments.scenario.empty() && isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
}

int lm628_shell(const testbench::Arguments& arguments, std::atomic<bool>& stop,
                const ReadLine& read_line) {
  const bool talks = static_cast<bool>(read_line);
  if (talks && arguments.json) throw lab::ConfigError("lm628: --json: needs a script");
  const auto settings = std::make_shared<Options>();
  Options& options = *settings;
  options.scenario = "lm628";
  std::vector<Lm628Line> lines;
  if (!talks) {
    std::string source;
    const std::string text = read_script(arguments.scenario, source, options.scenario);
    lines = parse_lm628_script(text, source);
  }
  testbench::apply_layers(options, arguments);
  refuse_firmware_keys(options);
  lab::validate(options);
  check_script_waves(options.run, arguments.out);
  if (const auto notice = lab::waves_notice(options)) tell(*notice);
  options.run.platform = cosim::Platform::kDirect;  // the host is this program
  std::optional<lab::OutputFolder> folder;
  if (!arguments.out.empty()) {
    folder.emplace(arguments.out);
    options.run.wave_file = lab::wave_file(folder->scratch());
  }

  Conversation all;
  auto result = std::make_unique<Result>();
  {
    // Signals are for this thread: one that the chip begins has its mask.
    sigset_t all_signals, before;
    sigfillset(&all_signals);
    pthread_sigmask(SIG_BLOCK, &all_signals, &before);
    Lm628Shell shell(options, stop);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (talks) {
      converse(shell, read_line, stop, all);
    } else {
      play(shell, lines, all, arguments.json);
    }
    *result = shell.result();
  }  // its waves are whole
  result->end = result->promise ? cosim::EndReason::kPromise : all.end;
  result->fault = all.halt;
  const int code = lab::exit_code(result->end);
  if (!folder && !arguments.json) return code;
  const lab::Record record = lab::judged(settings, std::move(result));
  const std::string again = folder                       ? "script.lm628 -c run.toml"
                            : arguments.scenario.empty() ? "-"
                                                         : lab::shell_word(arguments.scenario);
  const lab::Origin origin{"./trammel lm628 " + again, of_firmware, {{"script", all.answers}},
                           {{"script.lm628", all.script}}};
  const Json json = lab::metrics_json(record, origin);
  if (arguments.json) fmt::print("{}\n", json.dump(2));
  if (!folder) return code;
  const lab::Written written = lab::write_record(record, *folder, json, origin, arguments.report);
  folder->publish();
  for (const std::string& note : written.notes) tell(note);
  if (!arguments.json) {
    const std::string shown = fs::proximate(folder->target()).string();
    fmt::print("{}", lab::report_text(record, shown, written.page));
  }
  return code == 0 && !written.waves ? 1 : code;
}

}  // namespace trammel::an693
