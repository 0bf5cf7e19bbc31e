// SPDX-License-Identifier: Apache-2.0
//
// How the folder of a run comes to its place; whole programs do it in tests/system/files_test.py.
#include "host/output_folder.hpp"

#include <linux/capability.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>

#include "host/files.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using Catch::Contains;
using host::OutputFolder;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

void publish(const fs::path& target, const std::string& name, const std::string& text) {
  OutputFolder folder(target);
  put(folder.scratch() / name, text);
  folder.publish("1.2.3");
}

// What an act gives in a process that files' rights bind, also where it is root's.
bool without_capabilities(const std::function<bool()>& act) {
  const pid_t child = fork();
  if (child == 0) {
    __user_cap_header_struct head{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct none[2]{};
    const bool bound = syscall(SYS_capset, &head, none) == 0;
    _exit(bound && act() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// A scratch folder of a run to `target` that was killed.
fs::path left(const fs::path& target, const std::string& suffix) {
  const std::string name = ".a.trammel-" + suffix;
  const fs::path scratch = target.parent_path() / name;
  put(scratch / "trammel-scratch", "scratch folder of trammel: " + name + "\n");
  return scratch;
}

}  // namespace

TEST_CASE("a folder is there when it is published, and nothing is left of one that is not") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  { const OutputFolder dropped(target); }
  CHECK(test::entries(here.path) == 0);
  publish(target, "trace.csv", "first");
  CHECK(test::content(target / "trace.csv") == "first");
  CHECK(test::entries(target) == 2);  // with run.json
  CHECK(test::entries(here.path) == 1);
  CHECK_NOTHROW(host::check_whole(target));
}

TEST_CASE("a slash behind the name of a folder means nothing, whether it is there or not") {
  const test::Scratch here("output_folder_out");
  for (const char* const text : {"first", "second"}) {
    publish(here.path / "a/", "trace.csv", text);
    CHECK(test::content(here.path / "a" / "trace.csv") == text);
    CHECK(test::entries(here.path / "a") == 2);
    CHECK(test::entries(here.path) == 1);
  }
  publish(here.path / "b/c/../d/", "trace.csv", "deep");
  CHECK(test::content(here.path / "b" / "d" / "trace.csv") == "deep");
  CHECK(test::entries(here.path / "b") == 1);
}

TEST_CASE("a folder without the right to write is refused ahead of the run") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  publish(target, "trace.csv", "first");
  for (const fs::perms rights : {fs::perms::owner_read | fs::perms::owner_exec,
                                 fs::perms::owner_write | fs::perms::owner_exec,
                                 fs::perms::owner_read | fs::perms::owner_write}) {
    fs::permissions(target, rights);
    const bool refused = without_capabilities([&] {
      return test::refusal_of([&] { const OutputFolder folder(target); }) ==
             target.string() + ": --out: cannot be written: Permission denied";
    });
    INFO("rights " << static_cast<unsigned>(rights));
    CHECK(refused);
  }
  fs::permissions(target, fs::perms::owner_all);
  CHECK(without_capabilities([&] {
    return test::refusal_of([&] { const OutputFolder folder(target); }).empty();
  }));
}

TEST_CASE("a run's folder has the rights of any other new folder") {
  const test::Scratch here("output_folder_out");
  publish(here.path / "a", "trace.csv", "first");
  fs::create_directory(here.path / "b");
  CHECK(fs::status(here.path / "a").permissions() == fs::status(here.path / "b").permissions());
}

TEST_CASE("a page that was made later goes with the run that is replaced") {
  const test::Scratch here("output_folder_out");
  publish(here.path / "a", "trace.csv", "first");
  put(here.path / "a" / "report.html", "of the first");
  publish(here.path / "a", "trace.csv", "second");
  CHECK_FALSE(fs::exists(here.path / "a" / "report.html"));
}

TEST_CASE("a second run replaces what the first wrote and carries over what it did not") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  publish(target, "trace.csv", "first");
  put(target / "notes.txt", "mine");
  put(target / "more" / "notes.txt", "mine too");
  publish(here.path / "a/", "other.csv", "second");
  CHECK_FALSE(fs::exists(target / "trace.csv"));
  CHECK(test::content(target / "other.csv") == "second");
  CHECK(test::content(target / "notes.txt") == "mine");
  CHECK(test::content(target / "more" / "notes.txt") == "mine too");
  CHECK(test::entries(here.path) == 1);
}

TEST_CASE("a folder that is no run's is refused before the run and when it is published") {
  const test::Scratch here("output_folder_out");
  put(here.path / "mine" / "notes.txt", "mine");
  const std::pair<const char*, const char*> odd[] = {
      {"list", "[]"}, {"no-list", "{\"trammel\": \"1\"}"}, {"no-name", "{\"files\": {}}"},
      {"no-files", "{\"trammel\": \"1\", \"files\": []}"}};
  for (const auto& [name, text] : odd) put(here.path / name / "run.json", text);
  put(here.path / "file", "mine");
  const auto refusal = [&](const fs::path& target) {
    return test::refusal_of([&] { const OutputFolder folder(target); });
  };
  CHECK_THAT(refusal(here.path / "mine"), Contains("holds no run"));
  for (const auto& [name, text] : odd) {
    CAPTURE(text);
    CHECK_THAT(refusal(here.path / name), Contains("holds no run"));
  }
  CHECK_THAT(refusal(here.path / "file"), Contains("is not a folder"));
  CHECK_THAT(refusal(here.path / "file" / "below"), Contains("cannot be written"));
  CHECK_THAT(refusal(fs::current_path()), Contains("current folder"));
  CHECK_THAT(refusal("/"), Contains("current folder"));

  OutputFolder late(here.path / "late");
  put(here.path / "late" / "notes.txt", "mine");
  CHECK_THROWS_WITH(late.publish("1.2.3"), Contains("holds no run"));
  CHECK(test::content(here.path / "late" / "notes.txt") == "mine");

  publish(here.path / "a", "trace.csv", "first");
  put(here.path / "a" / "table.csv", "mine");
  CHECK_THROWS_WITH(publish(here.path / "a", "table.csv", "second"),
                    Contains("table.csv there is not of the run"));
  CHECK(test::content(here.path / "a" / "table.csv") == "mine");
  CHECK(test::content(here.path / "a" / "trace.csv") == "first");
}

TEST_CASE("what killed runs have left is removed, what is in use is not") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  publish(target, "trace.csv", "first");
  fs::create_directory(here.path / ".a.trammel-begunx");
  put(here.path / ".a.trammel-markin" / "trammel-scratch", "");  // killed as it was marked
  put(left(target, "unfini") / "run" / "trace.csv", "half");
  publish(here.path / "old", "trace.csv", "older");
  put(here.path / "old" / "notes.txt", "mine");
  fs::rename(here.path / "old", left(target, "replac") / "run");
  const OutputFolder used(target);
  CHECK(test::content(target / "notes.txt") == "mine");
  CHECK(test::entries(here.path) == 2);
  const OutputFolder another(target);
  CHECK(test::entries(here.path) == 3);

  // Where a name is taken, nothing is removed.
  publish(here.path / "old", "trace.csv", "older");
  put(here.path / "old" / "notes.txt", "not the same");
  const fs::path kept = left(target, "keptxx") / "run";
  fs::rename(here.path / "old", kept);
  const OutputFolder third(target);
  CHECK(test::content(kept / "notes.txt") == "not the same");
}

TEST_CASE("a file or a link that takes the folder's place during the run is refused") {
  const test::Scratch here("output_folder_out");
  fs::create_directory(here.path / "elsewhere");
  for (const char* const target : {"elsewhere", "nowhere", ""}) {
    CAPTURE(target);
    const fs::path place = here.path / "a";
    OutputFolder late(place);
    if (*target == '\0') {
      put(place, "mine");
    } else {
      fs::create_symlink(target, place);
    }
    CHECK_THROWS_WITH(late.publish("1.2.3"), Contains("a: --out: is not a folder"));
    if (*target == '\0') CHECK(test::content(place) == "mine");
    fs::remove(place);
  }
  CHECK(test::entries(here.path / "elsewhere") == 0);
}

TEST_CASE("links in the place of a killed run's folders are not followed") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  const fs::path other = here.path / "other";
  publish(other, "trace.csv", "other");
  put(other / "notes.txt", "mine");
  for (const char* const part : {"run", "run-old"}) {
    CAPTURE(part);
    const fs::path scratch = left(target, "linked");
    fs::create_symlink(other, scratch / part);
    publish(target, "trace.csv", "first");
    CHECK(test::content(other / "notes.txt") == "mine");
    CHECK(test::entries(other) == 3);
    CHECK_FALSE(fs::exists(scratch));
    CHECK(test::entries(target) == 2);
    fs::remove_all(target);
  }
}

TEST_CASE("a run that was put aside comes back when the program was killed before the new one") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  publish(target, "trace.csv", "first");
  put(target / "notes.txt", "mine");
  const fs::path scratch = left(target, "killed");
  fs::rename(target, scratch / "run-old");
  put(scratch / "run" / "trace.csv", "second");
  { const OutputFolder next(target); }
  CHECK(test::content(target / "trace.csv") == "first");
  CHECK(test::content(target / "notes.txt") == "mine");
  CHECK(test::entries(here.path) == 1);
}

TEST_CASE("folders of the user's are not taken for scratch folders") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  publish(target, "trace.csv", "first");
  put(here.path / ".a.trammel-backup" / "notes.txt", "mine");
  put(here.path / ".a.trammel-backups" / "trammel-scratch",
      "scratch folder of trammel: .a.trammel-backups\n");
  put(here.path / ".a.trammel-copied" / "trammel-scratch",
      test::content(left(target, "origin") / "trammel-scratch"));
  put(here.path / ".a.trammel-emptyx" / "trammel-scratch", "");
  put(here.path / ".a.trammel-emptyx" / "notes.txt", "mine");
  fs::copy(target, here.path / ".a.trammel-runrun");
  put(left(target, "shared") / "notes.txt", "mine");
  publish(target, "trace.csv", "second");
  CHECK(test::content(here.path / ".a.trammel-backup" / "notes.txt") == "mine");
  CHECK(test::entries(here.path / ".a.trammel-backups") == 1);
  CHECK(test::entries(here.path / ".a.trammel-copied") == 1);
  CHECK(test::entries(here.path / ".a.trammel-emptyx") == 2);
  CHECK(test::entries(here.path / ".a.trammel-runrun") == 2);
  CHECK(test::content(here.path / ".a.trammel-shared" / "notes.txt") == "mine");
  CHECK_FALSE(fs::exists(here.path / ".a.trammel-origin"));
}

TEST_CASE("a folder with the name of a run's file is the user's") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  publish(target, "trace.csv", "first");
  put(target / "report.html" / "notes.txt", "mine");
  publish(target, "trace.csv", "second");
  CHECK(test::content(target / "report.html" / "notes.txt") == "mine");
  CHECK_THROWS_WITH(publish(target, "report.html", "page"),
                    Contains("report.html there is not of the run"));
  CHECK(test::content(target / "report.html" / "notes.txt") == "mine");
  CHECK(test::content(target / "trace.csv") == "second");
}

TEST_CASE("files of a record keep their names where the list of them is missing too") {
  const test::Scratch here("output_folder_out");
  put(here.path / "trace.csv", "first");
  CHECK_THROWS_WITH(host::write_result_file(here.path / "trace.csv", "another"),
                    Contains("trace.csv: --out: is a file of a run's record"));
  CHECK(test::content(here.path / "trace.csv") == "first");
  put(here.path / "page.html", "first");
  host::write_result_file(here.path / "page.html", "another");
  CHECK(test::content(here.path / "page.html") == "another");
  CHECK(test::entries(here.path) == 2);
}

TEST_CASE("a file that is missing or not the run's is named") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  publish(target, "trace.csv", "first");
  for (const char* name : {"trace.csv", "run.json"}) {
    CAPTURE(name);
    CHECK_THROWS_WITH(host::write_result_file(target / name, "another"),
                      Contains(std::string(name) + ": --out: is a file of a run's record"));
  }
  CHECK(test::content(target / "trace.csv") == "first");
  CHECK_NOTHROW(host::check_result_file(target / "report.html"));
  CHECK_NOTHROW(host::check_result_file(target / "notes.txt"));
  CHECK_THROWS_WITH(host::check_result_file(target), Contains("--out: is a folder; name a file"));
  put(target / "trace.csv", "FIRST");
  CHECK_THROWS_WITH(host::check_whole(target), Contains("trace.csv: is not what the run wrote"));
  fs::remove(target / "trace.csv");
  CHECK_THROWS_WITH(host::check_whole(target), Contains("trace.csv: is missing"));
  fs::remove(target / "run.json");
  CHECK_NOTHROW(host::check_whole(target));
}

TEST_CASE("a change of one byte anywhere in a long file is seen") {
  const test::Scratch here("output_folder_out");
  const fs::path target = here.path / "a";
  const std::string whole(200'000, 'x');  // some blocks of 64 KiB
  publish(target, "trace.csv", whole);
  CHECK_NOTHROW(host::check_whole(target));
  for (const std::size_t at : {0, 65'535, 65'536, 140'000, 199'999}) {
    std::string changed = whole;
    changed[at] = 'y';
    put(target / "trace.csv", changed);
    CAPTURE(at);
    CHECK_THROWS_WITH(host::check_whole(target), Contains("trace.csv: is not what the run wrote"));
  }
  put(target / "trace.csv", whole);
  CHECK_NOTHROW(host::check_whole(target));
}
