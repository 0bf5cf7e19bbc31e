// SPDX-License-Identifier: Apache-2.0
//
// Pages of finished runs, by the same rules for every machine: reproducible, self-contained, and
// none from an incomplete folder.
#include "lab/report_page.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "lab/machine.hpp"
#include "lab/report_data.hpp"
#include "tests/support/files.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/short_run.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;
using cosim::EndReason;
using test::content;
namespace fs = std::filesystem;

namespace {

struct Scratch : test::Scratch {
  test::NoPrograms no_pictures;
  Scratch() : test::Scratch("report_page_test_out") {}
};

int run_to(const fs::path& out, const Machine& machine, EndReason end = EndReason::kDone,
           std::vector<std::string> set = {}) {
  return test::run(test::arguments_for(test::scenario_of(machine), out, std::move(set)),
                   test::ending(end));
}

template <class Check>
void each_machine(Check check) {
  for (const Machine* const machine : machines()) {
    CAPTURE(machine->name);
    const Scratch scratch;
    check(*machine, scratch.path);
  }
}

void replace(const fs::path& file, const std::string& old, const std::string& text) {
  std::string all = content(file);
  const auto at = all.find(old);
  REQUIRE(at != std::string::npos);
  host::write_text(file, all.replace(at, old.size(), text));
}

// The page of `folder` is refused in one line that says so, and the one that is there stays.
void check_refused(const fs::path& folder, const std::string& says) {
  CAPTURE(says);
  const std::string page = content(folder / "report.html");
  try {
    write_page({folder}, folder / "report.html");
    FAIL_CHECK("the page was written");
  } catch (const host::ConfigError& error) {
    const std::string line = error.what();
    CHECK_THAT(line, Contains(says));
    CHECK(line.find('\n') == std::string::npos);
  }
  CHECK(content(folder / "report.html") == page);
  CHECK_FALSE(fs::exists(folder / "report.html.new"));
}

// What base64 of RFC 4648 and zlib hold.
std::string unpacked(const std::string& text) {
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  REQUIRE(text.size() % 4 == 0);
  std::string bytes;
  unsigned group = 1;  // its top bit says how many digits are in it
  for (const char c : text.substr(0, text.find('='))) {
    const char* const digit = std::strchr(digits, c);
    REQUIRE(digit != nullptr);
    group = group << 6 | static_cast<unsigned>(digit - digits);
    if (group >> 24 == 0) continue;
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(group >> shift);
    group = 1;
  }
  if (group >> 18 != 0) {
    bytes += {static_cast<char>(group >> 10), static_cast<char>(group >> 2)};
  } else if (group >> 12 != 0) {
    bytes += static_cast<char>(group >> 4);
  }
  std::string json(1u << 20, '\0');
  uLongf size = json.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(json.data()), &size,
                     reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) == Z_OK);
  return json.substr(0, size);
}

}  // namespace

TEST_CASE("a report made again from its folder is the same, byte for byte") {
  each_machine([](const Machine& machine, const fs::path& base) {
    const fs::path folder = base / "a";
    REQUIRE(run_to(folder, machine) == 0);
    const std::string first = content(folder / "report.html");
    CHECK(first.size() > 50'000);
    fs::remove(folder / "report.html");
    write_page({folder}, folder / "report.html");
    CHECK(content(folder / "report.html") == first);
  });
}

TEST_CASE("a page holds every column of the trace, and skips samples where there are too many") {
  each_machine([](const Machine& machine, const fs::path& base) {
    REQUIRE(run_to(base / "a", machine) == 0);
    const RunFolder run = read_run(base / "a");
    CHECK(run.machine == &machine);
    CHECK(run.rows == run.metrics["run"]["samples"]);
    REQUIRE(run.rows - run.first > 15);
    const PageSeries all = page_series(run, false, 100000);
    CHECK(all.count == run.rows - run.first);
    CHECK(all.stride == 1);
    std::vector<std::string> names;
    for (const auto& channel : all.channels) names.push_back(channel["name"]);
    std::vector<std::string> compared;
    for (const Column& column : machine.columns().columns) {
      CHECK(std::count(names.begin(), names.end(), column.name) == 1);
      if (column.compared) compared.push_back(column.name);
    }
    for (const auto& channel : all.channels) {
      const Json steps = Json::parse(unpacked(channel["data"]));
      REQUIRE(steps.size() == all.count);
      const Series& values = run.columns.at(channel["name"]);
      const double lsb = channel["lsb"];
      double value = 0;
      for (std::size_t k = 0; k < all.count; ++k) {
        value += steps[k].get<double>();
        REQUIRE(std::abs(value * lsb - values[run.first + k]) <= 0.5001 * lsb);
      }
    }
    const PageSeries few = page_series(run, true, 15);
    CHECK(few.channels.size() >= compared.size());
    CHECK(few.channels.size() < all.channels.size());
    CHECK(few.count <= 15);
    CHECK(few.stride == (run.rows - run.first + 14) / 15);
    CHECK(few.count == (run.rows - run.first + few.stride - 1) / few.stride);
  });
}

TEST_CASE("where samples are passed over, the bits of flags are kept, and of others the first") {
  for (const Machine* const machine : machines()) {
    RunFolder run;
    run.machine = machine;
    run.first = 2;
    run.rows = 2 + 20;
    for (const Column& column : machine->columns().columns) {
      Series& values = run.columns[column.name];
      for (std::size_t k = 0; k < run.rows; ++k) {
        const double word = k % 5 == 3 ? 0 : static_cast<double>(1 << k % 7);
        values.push_back(column.bits || k != 12 ? word * column.resolution : -1e30);
      }
    }
    const PageSeries page = page_series(run, false, 4);
    CHECK(page.stride == 5);
    CHECK(page.count == 4);
    for (const auto& channel : page.channels) {
      const std::string name = channel["name"];
      const auto& all = machine->columns().columns;
      const auto column = std::find_if(all.begin(), all.end(),
                                       [&](const Column& one) { return one.name == name; });
      if (column == all.end()) continue;  // derived
      const Json steps = Json::parse(unpacked(channel["data"]));
      REQUIRE(steps.size() == 4);
      std::int64_t value = 0;
      for (std::size_t group = 0; group < 4; ++group) {
        value += steps[group].get<std::int64_t>();
        std::int64_t expected = 0;
        for (std::size_t k = 2 + 5 * group; k < 2 + 5 * (group + 1); ++k) {
          const std::int64_t word = k % 5 == 3 ? 0 : 1 << k % 7;
          if (column->bits) expected |= word;
          if (!column->bits && k == 2 + 5 * group) expected = k == 12 ? -(1LL << 50) : word;
        }
        INFO(machine->name << ": column " << name << ", samples " << 2 + 5 * group << "..");
        CHECK(value == expected);
      }
    }
  }
}

TEST_CASE("no name of a run can end the script that carries it") {
  each_machine([](const Machine& machine, const fs::path& base) {
    REQUIRE(run_to(base / "a", machine, EndReason::kDone,
                   {"description=</script><b> &", "name=p&q<r@DATA@"}) == 0);
    const std::string page = content(base / "a" / "report.html");
    CHECK(page.find("</script><b>") == std::string::npos);
    CHECK(page.find("\\u003c/script>\\u003cb>") != std::string::npos);
    CHECK(page.find("p&amp;q&lt;r&#64;DATA&#64;") != std::string::npos);
  });
}

TEST_CASE("a page holds no address to load from") {
  each_machine([](const Machine& machine, const fs::path& base) {
    REQUIRE(run_to(base / "a", machine) == 0);
    const std::string page = content(base / "a" / "report.html");
    for (const char* loads :
         {"src=\"", "@import", "url(http", "fetch(", "<link rel=\"stylesheet"}) {
      CAPTURE(loads);
      CHECK(page.find(loads) == std::string::npos);
    }
  });
}

TEST_CASE("runs have a page however they ended, without samples too") {
  each_machine([](const Machine& machine, const fs::path& base) {
    for (const EndReason end : {EndReason::kFault, EndReason::kDiverged, EndReason::kTimeout,
                                EndReason::kStopped, EndReason::kAssertion}) {
      CAPTURE(end_text(end));
      run_to(base / end_text(end), machine, end);
      CHECK(fs::exists(base / end_text(end) / "report.html"));
    }
    std::atomic<bool> stop{true};  // before the first sample
    const auto arguments = test::arguments_for(test::scenario_of(machine), base / "none",
                                               {"run.engine=twin"});
    CHECK(testbench::run(arguments, stop) == 130);
    CHECK(read_run(base / "none").rows <= 1);
    CHECK(fs::exists(base / "none" / "report.html"));
  });
}

TEST_CASE("a run is never lost because its report failed") {
  each_machine([](const Machine& machine, const fs::path& base) {
    const testbench::Simulate simulate = [](const Settings& settings, const cosim::Hooks&) {
      Record record = test::short_run(settings, EndReason::kDone);
      record.figures.back().value = std::numeric_limits<double>::quiet_NaN();  // null in JSON
      record.figures.back().digits = 3;
      return record;
    };
    CHECK(test::run(test::arguments_for(test::scenario_of(machine), base / "a"), simulate) == 2);
    CHECK(fs::exists(base / "a" / "metrics.json"));
    CHECK(fs::exists(base / "a" / "trace.csv"));
    CHECK_FALSE(fs::exists(base / "a" / "report.html"));
  });
}

TEST_CASE("a corrupt folder is one line that names the file, and the old page stays") {
  each_machine([](const Machine& machine, const fs::path& base) {
    const fs::path folder = base / "a";
    REQUIRE(run_to(folder, machine) == 0);
    const fs::path trace_file = folder / "trace.csv";
    const fs::path metrics_file = folder / "metrics.json";
    const std::string trace = content(trace_file);
    const std::string metrics = content(metrics_file);
    const std::size_t rows = read_run(folder).rows;

    host::write_text(trace_file, trace.substr(0, trace.size() / 2));
    check_refused(folder, "trace.csv: is corrupt: line ");
    host::write_text(trace_file, trace.substr(0, trace.rfind('\n', trace.size() - 2) + 1));
    check_refused(folder, "trace.csv: is corrupt: " + std::to_string(rows - 1) +
                              " samples, but the run recorded " + std::to_string(rows));
    for (std::size_t cut = 1; cut <= 3; ++cut) {  // what is left may still read as numbers
      INFO("without its last " << cut << " bytes");
      host::write_text(trace_file, trace.substr(0, trace.size() - cut));
      check_refused(folder, "trace.csv: is corrupt: line " + std::to_string(rows + 1) + " ");
    }
    host::write_text(trace_file, trace);
    replace(trace_file, machine.columns().columns[1].name, "medal");
    check_refused(folder, "trace.csv: is corrupt: line 1 does not name the columns of a trace");
    for (const char* value : {"nan", "inf", "-inf", "1e999", "one", ""}) {  // in its last column
      const std::size_t comma = trace.find_last_of(',');
      INFO("value \"" << value << '"');
      host::write_text(trace_file, trace.substr(0, comma + 1) + value + '\n');
      check_refused(folder, "trace.csv: is corrupt: line " + std::to_string(rows + 1) +
                                " does not hold ");
    }
    host::write_text(trace_file, "");
    check_refused(folder, "trace.csv: is corrupt: line 1 ");
    fs::remove(trace_file);
    check_refused(folder, "trace.csv: is missing: not a folder that `trammel run` wrote");
    fs::create_directory(trace_file);
    check_refused(folder, "trace.csv: cannot be read");
    fs::remove(trace_file);
    host::write_text(trace_file, trace);

    host::write_text(metrics_file, metrics.substr(0, metrics.size() / 2));
    check_refused(folder, "metrics.json: is corrupt: no JSON at byte ");
    host::write_text(metrics_file, "[]");
    check_refused(folder, "metrics.json: is corrupt: not a JSON object");
    host::write_text(metrics_file, metrics);
    replace(metrics_file, "\"machine\":", "\"moschine\":");
    check_refused(folder, "metrics.json: names no machine: written by an older trammel");
    host::write_text(metrics_file, metrics);
    replace(metrics_file, "\"machine\": \"" + machine.name, "\"machine\": \"other");
    check_refused(folder,
                  fmt::format("metrics.json: is of the machine \"other\", which this trammel does "
                              "not have; it has {}",
                              fmt::join(machine_names(), ", ")));
    host::write_text(metrics_file, metrics);
    replace(metrics_file, "\"id\":", "\"di\":");
    check_refused(folder,
                  "metrics.json: is corrupt: /figures does not hold id, name, unit and value");
    host::write_text(metrics_file, metrics);
    write_page({folder}, folder / "report.html");
    CHECK_THROWS_WITH(write_page({base / "b"}, base / "b.html"), Contains("b: no such folder"));
    CHECK_THROWS_WITH(write_page({trace_file}, base / "b.html"),
                      Contains("trace.csv: is not a folder"));
  });
}

TEST_CASE("the latest run is that whose metrics were written last, of whatever name") {
  const Scratch scratch;
  CHECK_THROWS_WITH(latest_run(scratch.path), Contains("report: no run in "));
  const auto now = fs::file_time_type::clock::now();
  const auto put = [&](const char* name, int ago_s) {
    fs::create_directories(scratch.path / name);
    host::write_text(scratch.path / name / "metrics.json", "{}");
    fs::last_write_time(scratch.path / name / "metrics.json", now - std::chrono::seconds(ago_s));
  };
  put("a", 30);
  CHECK(latest_run(scratch.path) == scratch.path / "a");
  put("c", 20);
  put("b", 10);
  put(".d", 0);  // a scratch folder
  fs::create_directories(scratch.path / "e");  // without metrics.json
  CHECK(latest_run(scratch.path) == scratch.path / "b");
  put("a", 0);
  CHECK(latest_run(scratch.path) == scratch.path / "a");
}

TEST_CASE("every missing member that a machine's page needs is named") {
  each_machine([](const Machine& machine, const fs::path& base) {
    const fs::path folder = base / "a";
    REQUIRE(run_to(folder, machine) == 0);
    const auto metrics = Json::parse(content(folder / "metrics.json"));
    std::vector<std::string> members{"/scenario",        "/end",           "/command",
                                     "/verdict",         "/run/samples",   "/run/simulated_s",
                                     "/run/clocks",      "/run/clock_ps",  "/run/event_hash",
                                     "/options",         "/versions",      "/figures"};
    for (const auto* list : {&machine.page.texts, &machine.page.counts, &machine.page.numbers,
                             &machine.page.objects, &machine.page.arrays}) {
      members.insert(members.end(), list->begin(), list->end());
    }
    for (const std::string& member : members) {
      const Json::json_pointer place(member);
      Json less = metrics;
      REQUIRE(less.contains(place));
      less[place] = nullptr;
      host::write_text(folder / "metrics.json", less.dump());
      check_refused(folder, "metrics.json: is corrupt: " + member + " has the wrong type");
      less = metrics;
      less[place.parent_pointer()].erase(place.back());
      host::write_text(folder / "metrics.json", less.dump());
      check_refused(folder, "metrics.json: is corrupt: " + member + " is missing");
    }
  });
}

TEST_CASE("runs of one machine are compared on one page, at most twelve of them") {
  each_machine([](const Machine& machine, const fs::path& base) {
    const fs::path a = base / "one" / "a";
    const fs::path b = base / "two" / "a";
    REQUIRE(run_to(a, machine) == 0);
    REQUIRE(run_to(b, machine, EndReason::kDone, {"processor.access_clk=9"}) == 0);
    const fs::path file = base / "compare.html";
    write_page({a, b}, file);
    const std::string page = content(file);
    CHECK(page.find("\"label\":\"one/a\"") != std::string::npos);
    CHECK(page.find("\"label\":\"two/a\"") != std::string::npos);
    CHECK(page.find("\"page\":\"two/a/report.html\"") != std::string::npos);
    const fs::path c = base / "third" / "one" / "a";
    fs::create_directories(c.parent_path());
    fs::copy(a, c, fs::copy_options::recursive);
    write_page({a, b, c}, file);  // the third is told from the first by the whole of its path
    for (const std::string& label : {std::string("one/a"), std::string("two/a"), c.string()}) {
      INFO("label " << label);
      CHECK(content(file).find("\"label\":\"" + label + '"') != std::string::npos);
    }
    write_page({a, b}, file);
    write_page(std::vector<fs::path>(12, a), base / "twelve.html");
    CHECK(fs::exists(base / "twelve.html"));
    CHECK_THROWS_WITH(write_page(std::vector<fs::path>(13, a), file),
                      Contains("at most 12"));
    for (const Machine* const other : machines()) {
      if (other == &machine) continue;
      REQUIRE(run_to(base / "three", *other) == 0);
      CHECK_THROWS_WITH(write_page({a, base / "three"}, file),
                        Contains("only runs of one machine can be compared"));
    }
    CHECK(content(file) == page);
  });
}
