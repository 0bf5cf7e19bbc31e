// SPDX-License-Identifier: Apache-2.0
#include "testbench/lm628.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <vector>

#include "cosim/wave_event.hpp"
#include "testbench/an693.hpp"
#include "testbench/config.hpp"
#include "testbench/lm628_shell.hpp"
#include "testbench/output.hpp"

namespace trammel::testbench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr char kHere[] = "lm628";  // where a line is from that somebody typed

// What was executed so far, and how that ended.
struct Conversation {
  An693Script script{"", Json::array()};
  cosim::EndReason end = cosim::EndReason::kDone;
  std::string halt;  // where it could not go on
};

void tell(const std::string& text) {
  fmt::print(stderr, "trammel: {}\n", text);
}

void execute(Lm628Shell& shell, const Lm628Line& line, Conversation& all, bool quiet) {
  if (line.word->action != Lm628Action::kHelp) all.script.text += line.text + '\n';
  const Lm628Answer answer = shell.execute(line);
  all.script.answers.push_back(answer.json);
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
    } catch (const ConfigError& error) {
      tell(error.what());
    } catch (const Lm628Halt& halt) {
      tell(halt.what());
    }
  }
}

// Nobody knows beforehand when an event comes, and there is no second run.
void check_script_waves(const cosim::RunBasics& run, const std::string& out) {
  if (run.wave == cosim::WaveFormat::kNone) return;
  if (out.empty()) throw ConfigError("lm628: --wave: needs a folder for the waves (-o)");
  if (cosim::trigger_asked(run) &&
      !cosim::parse_wave_event(run.wave_trigger, lm628::signals()).known()) {
    throw ConfigError(fmt::format("lm628: --wave-trigger: \"{}\" is not known before the script "
                                  "runs; give at TIME, or --wave-window",
                                  run.wave_trigger));
  }
}

// A key that would do nothing.
void refuse_firmware_keys(const lm628::Options& options) {
  const lm628::Options untouched;
  for (const auto& key : keys_of<lm628::Options>()) {
    if (!of_firmware(key)) continue;
    if (value_text(key.get(options)) == value_text(key.get(untouched))) continue;
    throw ConfigError(fmt::format("lm628: {}: is of the programs of `trammel run an693-*`; here "
                                  "the commands are at the port", key.name));
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
  return read_text(file);
}

}  // namespace

bool is_conversation(const RunArguments& arguments) {
  return arguments.scenario.empty() && isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
}

int lm628_shell(const RunArguments& arguments, std::atomic<bool>& stop,
                const ReadLine& read_line) {
  const bool talks = static_cast<bool>(read_line);
  if (talks && arguments.json) throw ConfigError("lm628: --json: needs a script");
  lm628::Options options;
  options.scenario = "lm628";
  std::vector<Lm628Line> lines;
  if (!talks) {
    std::string source;
    const std::string text = read_script(arguments.scenario, source, options.scenario);
    lines = parse_lm628_script(text, source);
  }
  apply_own_layers(options, arguments);
  apply_waves(options, arguments.waves);
  refuse_firmware_keys(options);
  finish(options);
  check_script_waves(options.run, arguments.out);
  announce_waves(options);
  options.run.platform = cosim::Platform::kDirect;  // the host is this program
  std::optional<OutputFolder> folder;
  if (!arguments.out.empty()) {
    folder.emplace(arguments.out);
    options.run.wave_file = wave_file(folder->scratch());
  }

  Conversation all;
  lm628::Result result;
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
    result = shell.result();
  }  // its waves are whole
  result.end = result.promise ? cosim::EndReason::kPromise : all.end;
  result.fault = all.halt;
  if (!folder && !arguments.json) return exit_code(result.end);
  const int waves_code = folder ? finish_waves(options, result, folder->target()) : 0;
  const An693Metrics metrics = evaluate(options, result);
  const std::string again = folder                       ? "script.lm628 -c run.toml"
                            : arguments.scenario.empty() ? "-"
                                                         : shell_word(arguments.scenario);
  const Json json = an693_json(options, result, metrics, "./trammel lm628 " + again, &all.script);
  if (arguments.json) fmt::print("{}\n", json.dump(2));
  if (folder) {
    const bool page = write_an693_files(folder->scratch(), options, result, json, &all.script,
                                        arguments.report);
    folder->publish();
    const fs::path target = fs::proximate(folder->target());
    if (!arguments.json) {
      fmt::print("{}", an693_report(options, result, metrics, target.string(),
                                    page ? (target / "report.html").string() : ""));
    }
  }
  const int code = exit_code(result.end);
  return code != 0 ? code : waves_code;
}

}  // namespace trammel::testbench
