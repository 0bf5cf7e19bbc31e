// SPDX-License-Identifier: Apache-2.0
//
// Files that others wrote: whatever they are, they are read whole or refused with their reason.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/files.hpp"
#include "host/parse.hpp"
#include "lab/layers.hpp"
#include "lab/machine.hpp"
#include "lab/scenarios.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::lab;
using Catch::Contains;

namespace {

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

// The message for this text of a scenario, of every machine the same; "" when it is taken.
std::string refusal_of(const std::string& toml) {
  std::string message;
  for (const Machine* const machine : machines()) {
    const std::string here = test::refusal_of(
        [&] { apply_text(*machine->defaults(), toml, "a.toml", "."); });
    if (machine != machines().front()) CHECK(here == message);
    message = here;
  }
  return message;
}

std::string json_refusal(const std::string& text) {
  return test::refusal_of([&] { host::parse_object(text, "a.json"); });
}

}  // namespace

TEST_CASE("only regular files are read") {
  const test::Scratch scratch("input_test_files");
  const std::string pipe = scratch.path / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_WITH(host::read_text(pipe), pipe + ": cannot be read: it is not a regular file");
  CHECK_THROWS_WITH(load_scenario(pipe), pipe + ": cannot be read: it is not a regular file");
  CHECK_THROWS_WITH(host::read_text("/dev/zero"),
                    "/dev/zero: cannot be read: it is not a regular file");
  CHECK_THROWS_WITH(host::read_text(scratch.path),
                    scratch.path.string() + ": cannot be read: it is a folder");
  CHECK_THROWS_WITH(host::read_text("no/such"),
                    "no/such: cannot be read: No such file or directory");
}

TEST_CASE("a read that fails is not the end of a file") {
  // The system gives nothing of what is not mapped.
  CHECK_THROWS_WITH(host::read_text("/proc/self/mem"),
                    "/proc/self/mem: cannot be read: Input/output error");
}

TEST_CASE("a file is read to its limit and not beyond") {
  const test::Scratch scratch("input_test_limit");
  const std::string file = scratch.path / "a.toml";
  std::ofstream(file) << std::string(1000, '#');
  CHECK(host::read_text(file, 1000).size() == 1000);
  CHECK_THROWS_WITH(host::read_text(file, 999),
                    file + ": cannot be read: it is larger than 999 bytes");
  std::filesystem::resize_file(file, (std::uintmax_t{4} << 20) + 1);
  CHECK_THROWS_WITH(load_scenario(file), file + ": cannot be read: it is larger than 4 MiB");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // nothing of it is on the disk
  CHECK_THROWS_WITH(host::read_text(file), file + ": cannot be read: it is larger than 256 MiB");
}

TEST_CASE("lines are read with and without an end, of bounded length") {
  using Line = host::InputFile::Line;
  const test::Scratch scratch("input_test_lines");
  const std::string file = scratch.path / "lines";
  const std::string across(100000, 'x');  // longer than what is read at a time
  std::ofstream(file) << "one\n\n" << across << "\nlast";
  host::InputFile in(file, host::kMiB);
  std::string line;
  CHECK((in.line(line) == Line::kWhole && line == "one"));
  CHECK((in.line(line) == Line::kWhole && line.empty()));
  CHECK((in.line(line) == Line::kWhole && line == across));
  CHECK((in.line(line) == Line::kUnended && line == "last"));
  CHECK(in.line(line) == Line::kNone);
  std::filesystem::resize_file(file, 3 * host::kMiB);
  host::InputFile endless(file, 10 * host::kMiB);
  const auto read_all = [&] {
    while (endless.line(line) != Line::kNone) {
    }
  };
  CHECK_THROWS_WITH(read_all(), file + ": cannot be read: a line is longer than 1 MiB");
}

TEST_CASE("a scenario that is nested deeper than any is refused, not followed") {
  const std::string deep = "a.toml:2: nested deeper than 64 parts";
  for (const int count : {64, 50000}) {
    CAPTURE(count);
    CHECK(refusal_of("\na = " + repeated("[", count + 1)) == deep);
    CHECK(refusal_of("\na = " + repeated("{a = ", count + 1)) == deep);
    CHECK(refusal_of("\na" + repeated(".a", count) + " = 1\n") == deep);
    CHECK(refusal_of("\n[a" + repeated(" . 'a'", count) + "]\n") == deep);
  }
  CHECK(refusal_of("\na = ['\\', " + repeated("[", 64)) == deep);  // no escape: it ends there
  // None of these is nested.
  const std::string dots = repeated(".", 100), open = repeated("[", 100);
  CHECK(refusal_of("description = \"" + dots + open + "\\\"" + open + "\"\n").empty());
  CHECK(refusal_of("description = '" + dots + open + "'  # " + dots + open + "\n").empty());
  CHECK(refusal_of("description = \"\"\"\n" + dots + "\"\"\n" + open + "\"\"\"\n").empty());
  CHECK(refusal_of("description = '''" + dots + "''\n" + open + "'''\n").empty());
  CHECK_THAT(refusal_of("a = " + repeated("[", 64) + repeated("]", 64) + "\n"),
             Contains("unknown key"));
  CHECK_THAT(refusal_of("a = [" + repeated("1.5, ", 100) + "]\n"), Contains("unknown key"));
  CHECK_THAT(refusal_of("a" + repeated(".a", 63) + " = 1\n"), Contains("unknown key"));
}

TEST_CASE("unknown keys are found in time however many there are, and told in short") {
  std::string many;
  for (int k = 0; k < 50000; ++k) many += "k" + std::to_string(k) + " = 1\n";
  const auto begin = std::chrono::steady_clock::now();
  CHECK_THAT(refusal_of(many), Contains("unknown key"));
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
  CHECK(refusal_of(std::string(3000000, 'k') + " = 1\n").size() < 250);
  CHECK(refusal_of("run.max_s = \"" + std::string(5000, 'k') + "\"\n").size() < 250);
}

TEST_CASE("JSON that is nested deeper or wider than any of a run is refused") {
  CHECK(json_refusal("{\"a\": [1, {\"b\": null}]}").empty());
  CHECK(json_refusal("{\"a\": " + repeated("[", 100000)) ==
        "a.json: is corrupt: nested deeper than 64 parts");
  CHECK(json_refusal(repeated("{\"a\": ", 100000)) ==
        "a.json: is corrupt: nested deeper than 64 parts");
  std::string wide;
  for (int k = 0; k < 5000; ++k) wide += (k > 0 ? ",\"" : "{\"") + std::to_string(k) + "\":[{}]";
  CHECK(json_refusal(wide + "}") == "a.json: is corrupt: an object of more than 4096 members");
  std::string widest = "{\"0\":1";
  for (int k = 1; k < 4096; ++k) widest += ",\"" + std::to_string(k) + "\":1";
  CHECK(json_refusal(widest + "}").empty());
  CHECK(json_refusal(widest + ",\"4096\":1}") ==
        "a.json: is corrupt: an object of more than 4096 members");
  // Many objects are not one that is wide, in turn or in each other's place.
  std::string many;
  for (int k = 0; k < 3000; ++k) {
    many += (k > 0 ? ",{" : "{\"a\":[{") + std::string("\"b\":1,\"c\":2}");
  }
  CHECK(json_refusal(many + "]}") == "");
  std::string two;
  for (int k = 0; k < 4096; ++k) two += (k > 0 ? ",\"" : "\"") + std::to_string(k) + "\":0";
  CHECK(json_refusal("{\"a\": {" + two + "}, \"b\": {" + two + "}}") == "");
  CHECK(json_refusal("[1]") == "a.json: is corrupt: not a JSON object");
  CHECK(json_refusal("{\"a\": 1") == "a.json: is corrupt: no JSON at byte 8");
  CHECK(json_refusal("{\"a\": 1e999}") == "a.json: is corrupt: a number that is too large");
}
