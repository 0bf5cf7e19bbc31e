// SPDX-License-Identifier: Apache-2.0
//
// A run's folder comes to its place also where the file system cannot exchange two names.
#include <catch2/catch.hpp>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/output_folder.hpp"
#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

int refused_with = EINVAL;

void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

void publish(const fs::path& target, const std::string& name, const std::string& text) {
  host::OutputFolder folder(target);
  put(folder.scratch() / name, text);
  folder.publish("1.2.3");
}

}  // namespace

// In the place of the C library's: what a file system says that has no flags of rename, or a
// kernel that does not know the call.
extern "C" int renameat2(int, const char*, int, const char*, unsigned) noexcept {
  errno = refused_with;
  return -1;
}

TEST_CASE("without an exchange of names a run replaces another one and leaves nothing beside it") {
  for (const int code : {EINVAL, ENOSYS}) {
    CAPTURE(code);
    refused_with = code;
    const test::Scratch here("output_folder_exchange_out");
    const fs::path target = here.path / "a";
    publish(target, "trace.csv", "first");
    CHECK(test::content(target / "trace.csv") == "first");
    put(target / "notes.txt", "mine");
    publish(target, "other.csv", "second");
    CHECK_FALSE(fs::exists(target / "trace.csv"));
    CHECK(test::content(target / "other.csv") == "second");
    CHECK(test::content(target / "notes.txt") == "mine");
    CHECK_NOTHROW(host::check_whole(target));
    CHECK(test::entries(target) == 3);  // with run.json
    CHECK(test::entries(here.path) == 1);
  }
}

TEST_CASE("without an exchange of names nothing is put onto what is there") {
  refused_with = EINVAL;
  const test::Scratch here("output_folder_exchange_out");
  const fs::path target = here.path / "a";
  host::OutputFolder late(target);
  put(target, "mine");
  CHECK_THROWS_WITH(late.publish("1.2.3"), Contains("a: --out: is not a folder"));
  CHECK(test::content(target) == "mine");
  fs::remove(target);
  fs::create_symlink("nowhere", target);
  CHECK_THROWS_WITH(late.publish("1.2.3"), Contains("a: --out: is not a folder"));
  CHECK(fs::is_symlink(target));
}

TEST_CASE("any other refusal of the file system is told, and the run that was there stays") {
  const test::Scratch here("output_folder_exchange_out");
  const fs::path target = here.path / "a";
  refused_with = EINVAL;
  publish(target, "trace.csv", "first");
  for (const auto& [code, why] : {std::pair{EROFS, "Read-only file system"},
                                  {EACCES, "Permission denied"}}) {
    refused_with = code;
    CHECK_THROWS_WITH(publish(target, "trace.csv", "second"),
                      Contains(std::string("a: --out: cannot be written: ") + why));
    CHECK(test::content(target / "trace.csv") == "first");
    CHECK_THROWS_WITH(publish(here.path / "b", "trace.csv", "second"),
                      Contains(std::string("b: --out: cannot be written: ") + why));
    CHECK(test::entries(here.path) == 1);
  }
}
