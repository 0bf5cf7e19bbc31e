// SPDX-License-Identifier: Apache-2.0
#include "testbench/run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "host/files.hpp"
#include "host/output_folder.hpp"
#include "host/text.hpp"
#include "lab/build_info.hpp"
#include "lab/inputs.hpp"
#include "lab/layers.hpp"
#include "lab/machines.hpp"
#include "lab/report_page.hpp"
#include "lab/scenarios.hpp"
#include "lab/write.hpp"

namespace trammel::testbench {

namespace {

// Next to the scenario, so that all else that is asked for lies above it.
void apply_live(lab::Settings& settings) {
  if (settings.machine().live.empty()) {
    lab::need_all_machines();
    std::vector<std::string> names;
    for (const lab::Machine* machine : lab::machines()) {
      if (!machine->live.empty()) names.push_back(machine->name);
    }
    throw host::ConfigError(fmt::format(
        "--serial: the machine {} has no port for another program; permitted: scenarios of {}",
        settings.machine().name, fmt::join(names, ", ")));
  }
  for (const std::string& text : settings.machine().live) lab::apply_assignment(settings, text);
  settings.set_by.clear();  // of the user's own there is none yet
}

}  // namespace

void apply_layers(lab::Settings& settings, const Arguments& arguments) {
  if (arguments.live) apply_live(settings);
  for (const std::string& more : arguments.files) lab::apply_file(settings, more);
  lab::apply_environment(settings, lab::environment());
  for (const std::string& text : arguments.assignments) lab::apply_assignment(settings, text);
  for (const auto& [option, text] : arguments.keys) {
    lab::apply_assignment(settings, text, option);
  }
  lab::apply_waves(settings, arguments.waves);
}

std::unique_ptr<lab::Settings> layered(const std::filesystem::path& file,
                                       const Arguments& arguments) {
  auto settings = lab::load_scenario(file);
  apply_layers(*settings, arguments);
  lab::validate(*settings);
  return settings;
}

int late_stop(const std::string& name, const std::string& folder, const std::atomic<bool>& stop) {
  if (!stop) return 0;
  tell(fmt::format("{}: interrupted after the run; record kept in {}", name, folder));
  return 130;
}

namespace {

namespace fs = std::filesystem;

// A line that rewrites itself while a run goes on, on a terminal only.
class Progress {
 public:
  explicit Progress(std::string name) : name_(std::move(name)) {}
  ~Progress() {
    if (drawn_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void operator()(double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    drawn_ = true;
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    const double left = fraction > 0 ? elapsed * (1 - fraction) / fraction : 0;
    std::fputs(fmt::format("\r\033[K{} {:3.0f} %  {:.0f} s left", name_, 100 * fraction, left)
                   .c_str(),
               stderr);
    std::fflush(stderr);
  }

 private:
  std::string name_;
  bool shown_ = isatty(STDERR_FILENO) != 0;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
};

// A line for a run that did not end as it should; the exit code.
int tell_end(const lab::Record& record, const std::string& name, const std::string& folder) {
  const int code = lab::exit_code(record.result->end);
  if (code != 0) {
    tell(fmt::format("{}: {}{}; record kept in {}", name, lab::end_text(record.result->end),
                     lab::cause_text(*record.result), folder));
  }
  return code;
}

struct Outcome {
  lab::Record record;
  nlohmann::ordered_json json;
  int code = 0;
};

// 1 with a line for each figure that lies outside its tolerance; 2 when nothing is expected.
int check(const lab::Record& record) {
  const std::string& scenario = record.settings->scenario;
  if (!lab::any_expected(record.figures)) {
    tell(scenario + ": --check: no figure of this scenario has an expected value with these "
                    "settings");
    return 2;
  }
  const std::vector<std::string> lines = lab::outside(record.figures);
  for (const std::string& line : lines) tell(scenario + ": " + line);
  return lines.empty() ? 0 : 1;
}

Outcome run_one(lab::Settings& settings, const fs::path& target, const Arguments& arguments,
                const Simulate& simulate, const std::atomic<bool>& stop) {
  host::OutputFolder folder(target);  // refused in one line, ahead of what is told of the run
  for (const std::string& notice : settings.notices) tell(notice);
  if (const auto notice = lab::waves_notice(settings)) tell(*notice);
  if (settings.machine().texts.warnings != nullptr) {
    tell_warnings(settings.scenario, settings.machine().texts.warnings(settings));
  }
  settings.run.wave_file = lab::wave_file(folder.scratch());
  lab::copy_inputs(settings, folder.scratch());  // as they are now, not when the run has ended
  Outcome outcome;
  {
    Progress progress(settings.scenario);
    cosim::Hooks hooks;
    hooks.progress = [&progress](double fraction) { progress(fraction); };
    hooks.stop = &stop;
    outcome.record = simulate(settings, hooks);
  }
  const lab::Record& record = outcome.record;
  lab::Origin origin;
  origin.folder = folder.target();
  outcome.json = lab::metrics_json(record, origin);
  const lab::Written written =
      lab::write_record(record, folder, outcome.json, origin, arguments.report);
  folder.publish(lab::kVersion);
  for (const std::string& note : written.notes) tell(note);

  const std::string shown = fs::proximate(folder.target()).string();
  if (arguments.all) {
    tell(fmt::format("{}: {} in {:.1f} s", settings.scenario, record.verdict,
                     record.result->wall_s));
  } else if (!arguments.json) {
    print(lab::report_text(record, shown, written.page));
    if (arguments.activity) print(lab::activity_text(*record.result));
  }
  outcome.code = tell_end(record, settings.scenario, shown);
  for (const lab::Record& beside : record.companions) {
    const int code = tell_end(beside, settings.scenario + ", " + beside.name, shown);
    if (outcome.code == 0) outcome.code = code;
  }
  if (outcome.code == 0) outcome.code = late_stop(settings.scenario, shown, stop);
  if (outcome.code == 0) outcome.code = written.code;
  if (outcome.code == 0 && arguments.check) outcome.code = check(record);
  return outcome;
}

// An experiment sets some keys itself; another value asked for them would be lost silently.
std::unique_ptr<lab::Settings> settings_of(const lab::Experiment& experiment,
                                           const Arguments& arguments) {
  auto settings = lab::load_scenario(lab::find_scenario(experiment.scenario));
  for (const std::string& text : experiment.assignments) lab::apply_assignment(*settings, text);
  const auto own = settings->clone();
  apply_layers(*settings, arguments);
  for (const std::string& text : experiment.assignments) {
    const std::string name = text.substr(0, text.find('='));
    for (const lab::Key* key : lab::find_keys(settings->machine().keys(), name)) {
      if (key->get(*settings) == key->get(*own)) continue;
      throw host::ConfigError(fmt::format("run: --all sets {0} itself; do not set it as well",
                                          name));
    }
  }
  settings->scenario = experiment.name;
  lab::validate(*settings);
  return settings;
}

// Before the first of the runs: what is there must be of runs of --all.
void check_all(const fs::path& base, const std::vector<lab::Experiment>& experiments) {
  const auto refuse = [&base](const char* why) {
    throw host::ConfigError(fmt::format("{}: --out: {}", base.string(), why));
  };
  const fs::file_status there = fs::symlink_status(base);
  if (!fs::exists(there)) return;
  if (!fs::is_directory(fs::status(base))) refuse("is not a folder");
  // What a killed run has left is hidden, and its next one removes it.
  bool any = std::all_of(fs::directory_iterator(base), {}, [](const fs::directory_entry& entry) {
    return entry.path().filename().native().front() == '.';
  });
  for (const lab::Experiment& experiment : experiments) {
    host::check_replaceable(fs::canonical(base) / experiment.name);
    any = any || fs::exists(base / experiment.name);
  }
  if (!any) refuse("is not empty and holds no runs of --all: name another folder");
  for (const lab::Experiment& experiment : experiments) {
    const fs::path page = base / experiment.page;
    if (fs::exists(fs::symlink_status(page)) && !lab::is_page(page)) {
      refuse((experiment.page + " there is no page of runs; move it away").c_str());
    }
  }
}

int run_all(const lab::Machine& machine, const Arguments& arguments, const Simulate& simulate,
            const std::atomic<bool>& stop) {
  const fs::path base = host::target_of(arguments.out, "all");
  std::vector<Outcome> outcomes;
  std::vector<std::pair<fs::path, std::vector<fs::path>>> pages;  // and their runs
  auto documents = nlohmann::ordered_json::array();
  int code = 0;
  const std::vector<lab::Experiment>& experiments = machine.experiments.list;
  for (const lab::Experiment& experiment : experiments) settings_of(experiment, arguments);
  check_all(base, experiments);
  for (const lab::Experiment& experiment : experiments) {
    if (stop) {
      code = 130;
      continue;
    }
    const auto settings = settings_of(experiment, arguments);
    const fs::path folder = base / experiment.name;
    if (pages.empty() || pages.back().first != base / experiment.page) {
      pages.emplace_back(base / experiment.page, std::vector<fs::path>());
    }
    pages.back().second.push_back(folder);
    outcomes.push_back(run_one(*settings, folder, arguments, simulate, stop));
    documents.push_back(outcomes.back().json);
    code = std::max(code, outcomes.back().code);
  }
  std::string written;
  for (const auto& [page, folders] : pages) {
    if (!arguments.report || folders.size() < 2) continue;
    try {
      lab::write_page(folders, page);
      written += fmt::format("{} {}", written.empty() ? "" : ",", fs::proximate(page).string());
    } catch (const std::exception& error) {
      tell(fmt::format("no report: {}; the results are kept", host::reason_of(error)));
      if (code == 0) code = 2;
    }
  }
  if (arguments.json) {
    print_json(documents);
    return code;
  }
  std::vector<const lab::Record*> records;
  for (const Outcome& outcome : outcomes) records.push_back(&outcome.record);
  print(machine.experiments.text(records));
  if (!written.empty()) print(fmt::format("\nreport:{}\n", written));
  return code;
}

}  // namespace

int run(const Arguments& arguments, const std::atomic<bool>& stop, const Simulate& simulate) {
  if (arguments.all) {
    if (!arguments.scenario.empty()) {
      throw host::ConfigError(
          "run: --all runs the experiments of the source and takes no scenario");
    }
    lab::first_machine();  // in the program of another machine there is more to see
    const auto& all = lab::machines();
    const auto found = std::find_if(all.begin(), all.end(), [](const lab::Machine* machine) {
      return !machine->experiments.list.empty();
    });
    if (found == all.end()) lab::need_all_machines();
    if (found == all.end()) throw host::ConfigError("run: --all: no machine names experiments");
    return run_all(**found, arguments, simulate, stop);
  }
  if (arguments.scenario.empty()) {
    throw host::ConfigError("run: name a scenario (`trammel list` shows them) or give --all");
  }
  const auto settings = layered(lab::find_scenario(arguments.scenario), arguments);
  const fs::path target = host::target_of(arguments.out, settings->scenario);
  const Outcome outcome = run_one(*settings, target, arguments, simulate, stop);
  if (arguments.json) print_json(outcome.json);
  return outcome.code;
}

int report(const Arguments& arguments) {
  std::vector<fs::path> folders(arguments.folders.begin(), arguments.folders.end());
  if (folders.empty()) folders.push_back(lab::latest_run("out"));
  fs::path file = arguments.out;
  if (file.empty()) {
    file = folders.size() == 1 ? folders.front() / "report.html" : fs::path("out/compare.html");
  }
  lab::write_page(folders, file);
  if (arguments.json) {
    const nlohmann::ordered_json json{{"page", file.string()}, {"bytes", fs::file_size(file)}};
    print_json(json);
  } else {
    print(file.string() + '\n');
  }
  return 0;
}

void hand_over(const std::string& program, char** argv) {
  const char* const launcher = std::getenv("TRAMMEL_LAUNCHER");
  if (launcher == nullptr) return;
  setenv("TRAMMEL_PROGRAM", program.c_str(), 1);
  execv(launcher, argv);
}

}  // namespace trammel::testbench
