// SPDX-License-Identifier: Apache-2.0
#include "testbench/run.hpp"

#include <fmt/format.h>
#include <cstdlib>
#include <memory>

#include "testbench/an693.hpp"
#include "testbench/config.hpp"
#include "testbench/mcafee.hpp"
#include "testbench/output.hpp"
#include "testbench/paper.hpp"
#include "testbench/progress.hpp"
#include "testbench/report.hpp"
#include "testbench/report_data.hpp"
#include "testbench/report_page.hpp"
#include "testbench/waves.hpp"

namespace trammel::testbench {

template <class AnyOptions>
void apply_own_layers(AnyOptions& options, const RunArguments& arguments) {
  for (const std::string& more : arguments.files) apply_file(options, more);
  apply_environment(options, environment());
  for (const std::string& text : arguments.assignments) apply_assignment(options, text);
  const auto flag = [&](bool given, const char* assignment, const char* name) {
    if (given) apply_assignment(options, assignment, name);
  };
  flag(!arguments.engine.empty(), ("run.engine=" + arguments.engine).c_str(), "--engine");
  flag(!arguments.platform.empty(), ("run.platform=" + arguments.platform).c_str(), "--platform");
  flag(arguments.plain, "run.leap=false", "--no-leap");
  flag(arguments.audit, "run.audit=true", "--audit");
  flag(arguments.assertions, "run.assertions=true", "--assert");
}

template void apply_own_layers(kung::Options&, const RunArguments&);
template void apply_own_layers(lm628::Options&, const RunArguments&);

namespace {

namespace fs = std::filesystem;
using kung::Options;

template <class AnyOptions>
void apply_layers(AnyOptions& options, const RunArguments& arguments) {
  apply_own_layers(options, arguments);
  apply_waves(options, arguments.waves);
}

Options layered(const std::string& scenario, const RunArguments& arguments) {
  Options options;
  const fs::path file = find_scenario(scenario);
  options.scenario = file.stem().string();
  apply_file(options, file);
  apply_layers(options, arguments);
  return options;
}

// --all sets the controller itself; one that is also asked for would be lost without a word.
void refuse_controller(const RunArguments& arguments) {
  Options fc, afc;
  fc.controller = kung::Controller::kFc;
  afc.controller = kung::Controller::kAfc;
  apply_layers(fc, arguments);
  apply_layers(afc, arguments);
  if (fc.controller == afc.controller) {
    throw ConfigError("run: --all runs both controllers; controller beside it means neither");
  }
}

std::string end_cause(const Options& options, const kung::Result& result) {
  if (result.promise) return ": " + promise_text(*result.promise, options.plant.clock_ps);
  return result.end == kung::EndReason::kFault ? " by " + cause_text(result.fault) : "";
}

struct Outcome {
  Finished finished;
  nlohmann::ordered_json json;
  int code = 0;
};

Outcome run_one(Options options, const fs::path& target, const RunArguments& arguments,
                const Simulate& simulate, const std::atomic<bool>& stop) {
  finish(options);
  announce_waves(options);
  OutputFolder folder(target);
  options.run.wave_file = wave_file(folder.scratch());
  kung::Result result;
  {
    Progress progress(options.scenario);
    try {
      result = simulate(options, shown_in(progress, stop));
    } catch (const std::invalid_argument& error) {  // what only the plant can tell
      throw ConfigError(error.what());
    } catch (const kung::OptionsError& error) {
      throw ConfigError(error.what());
    }
  }
  const int waves_code = finish_waves(options, result, folder.target());
  const Metrics metrics = evaluate(options, result);
  Outcome outcome{{options, metrics, result.end}, metrics_json(options, result, metrics),
                  exit_code(result.end)};
  write_text(folder.scratch() / "metrics.json", outcome.json.dump(2) + '\n');
  write_text(folder.scratch() / "run.toml", run_toml(options));
  write_trace(folder.scratch() / "trace.csv", options, result);
  if (!write_pictures(folder.scratch(), options, result)) {
    fmt::print(stderr, "trammel: no pictures: {}\n",
               find_program("gnuplot").empty() ? "gnuplot is missing (see `trammel doctor`)"
                                               : "there is nothing to draw");
  }
  const bool page = guarded([&] {
    write_text(folder.scratch() / "detail.json", detail_json(options, result).dump() + '\n');
    if (arguments.report) write_run_page(folder.scratch());
  }) && arguments.report;
  folder.publish();

  const fs::path shown = fs::proximate(folder.target());
  if (!arguments.json && !arguments.all) {
    fmt::print("{}{}", run_report(options, result, metrics, shown.string(),
                                  page ? (shown / "report.html").string() : ""),
               waves_report(options, result, shown.string()));
  } else if (arguments.all) {
    fmt::print(stderr, "trammel: {} {}: {} in {:.1f} s\n", options.scenario,
               options.controller == kung::Controller::kFc ? "FC" : "AFC", end_text(result.end),
               result.wall_s);
  }
  tell_end(options.scenario, result.end, end_cause(options, result), shown.string());
  if (outcome.code == 0) outcome.code = waves_code;
  if (arguments.check && outcome.code == 0) {
    for (const Comparison& line : compare(options, metrics)) {
      if (line.good()) continue;
      fmt::print(stderr, "trammel: {}: {} {:.3f} {} is outside {:.3f} +- {:.3f}\n",
                 options.scenario, line.what, line.ours, line.unit, *line.expected,
                 line.tolerance);
      outcome.code = 1;
    }
  }
  return outcome;
}

int run_all(const RunArguments& arguments, const Simulate& simulate,
            const std::atomic<bool>& stop) {
  const fs::path base = target_of(arguments.out, "all");
  std::vector<Finished> finished;
  std::vector<fs::path> folders;
  auto documents = nlohmann::ordered_json::array();
  int code = 0;
  refuse_controller(arguments);
  for (const std::string scenario : {"step", "circle", "window", "star"}) {
    for (const std::string controller : {"fc", "afc"}) {
      if (stop) {
        code = 130;
        continue;
      }
      Options options = layered(scenario, arguments);
      apply_assignment(options, "controller=" + controller);
      options.scenario = scenario + '-' + controller;
      Outcome outcome = run_one(options, base / options.scenario, arguments, simulate, stop);
      finished.push_back(outcome.finished);
      folders.push_back(base / options.scenario);
      documents.push_back(outcome.json);
      code = std::max(code, outcome.code);
    }
  }
  const fs::path index = base / "index.html";
  const bool page = arguments.report && folders.size() > 1 &&
                    guarded([&] { write_comparison_page(folders, index); });
  if (arguments.json) {
    fmt::print("{}\n", documents.dump(2));
  } else {
    fmt::print("{}", experiments_report(finished));
    if (page) fmt::print("\nreport: {}\n", fs::proximate(index).string());
  }
  return code;
}

}  // namespace

template <class AnyOptions>
AnyOptions layered_machine(const fs::path& file, const RunArguments& arguments) {
  if (arguments.check) {
    throw ConfigError(fmt::format("--check: is not offered by the machine {}",
                                  machine_name<AnyOptions>()));
  }
  AnyOptions options;
  options.scenario = file.stem().string();
  apply_file(options, file);
  apply_layers(options, arguments);
  finish(options);
  return options;
}
template lm628::Options layered_machine(const fs::path&, const RunArguments&);
template mcafee::Options layered_machine(const fs::path&, const RunArguments&);

int run(const RunArguments& arguments, const Simulate& simulate, const std::atomic<bool>& stop,
        const SimulateAn693& simulate_an693, const SimulateMcafee& simulate_mcafee) {
  if (arguments.all) {
    if (!arguments.scenario.empty()) {
      throw ConfigError("run: --all runs the paper's experiments; a scenario beside it means none");
    }
    return run_all(arguments, simulate, stop);
  }
  if (arguments.scenario.empty()) {
    throw ConfigError("run: name a scenario (`trammel list` shows them) or give --all");
  }
  const fs::path file = find_scenario(arguments.scenario);
  if (machine_of(file) == machine_name<lm628::Options>()) {
    return run_an693(layered_machine<lm628::Options>(file, arguments), arguments, simulate_an693,
                     stop);
  }
  if (machine_of(file) == machine_name<mcafee::Options>()) {
    return run_mcafee(layered_machine<mcafee::Options>(file, arguments), arguments,
                      simulate_mcafee, stop);
  }
  const Options options = layered(arguments.scenario, arguments);
  const fs::path target = target_of(arguments.out, options.scenario);
  const Outcome outcome = run_one(options, target, arguments, simulate, stop);
  if (arguments.json) fmt::print("{}\n", outcome.json.dump(2));
  return outcome.code;
}

}  // namespace trammel::testbench
