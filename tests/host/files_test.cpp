// SPDX-License-Identifier: Apache-2.0
//
// Files that are replaced: whole, or as they were.
#include "host/files.hpp"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <string>

#include "tests/support/files.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using Catch::Contains;
namespace fs = std::filesystem;

TEST_CASE("where a file system can, a page has no name before it is whole") {
  const test::Scratch here("files_test");
  const int probe = open(here.path.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (probe < 0) {
    WARN("this file system has no files without a name");
    return;
  }
  close(probe);
  const int watch = inotify_init1(IN_NONBLOCK);
  REQUIRE(watch >= 0);
  REQUIRE(inotify_add_watch(watch, here.path.c_str(), IN_CREATE | IN_MODIFY | IN_MOVED_TO) >= 0);
  host::replace_file(here.path / "page.html", std::string(100'000, 'x'));
  alignas(inotify_event) char block[4096];
  const ssize_t size = read(watch, block, sizeof block);
  close(watch);
  std::size_t created = 0, moved = 0;
  for (ssize_t at = 0; at < size;) {
    const auto& event = *reinterpret_cast<const inotify_event*>(block + at);
    const std::string name = event.len > 0 ? event.name : "";
    INFO("event of " << name);
    if ((event.mask & IN_CREATE) != 0) ++created;
    if ((event.mask & IN_MOVED_TO) != 0 && name == "page.html") ++moved;
    CHECK_FALSE(((event.mask & IN_MODIFY) != 0 && name.rfind("page.html", 0) == 0));
    at += static_cast<ssize_t>(sizeof event + event.len);
  }
  CHECK(created == 1);
  CHECK(moved == 1);
  CHECK(test::content(here.path / "page.html") == std::string(100'000, 'x'));
}

TEST_CASE("a page that the system does not take leaves the one before, and nothing else") {
  const test::Scratch here("files_test");
  const fs::path page = here.path / "page.html";
  host::replace_file(page, "one");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit limit = before;
  limit.rlim_cur = 1000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &limit);
  int code = 0;
  const std::string said = test::refusal_of<host::WriteError>([&] {
    try {
      host::replace_file(page, std::string(1001, 'x'));
    } catch (const host::WriteError& error) {
      code = error.code;
      throw;
    }
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(said == page.string() + ": cannot be written: File too large");
  CHECK(code == EFBIG);
  CHECK(test::content(page) == "one");
  CHECK(test::entries(here.path) == 1);
}

TEST_CASE("a page replaces a regular file, through a file that did not exist") {
  const test::Scratch here("files_test");
  const fs::path page = here.path / "page.html";
  host::replace_file(page, "one");
  host::replace_file(page, "two");
  CHECK(test::content(page) == "two");
  const fs::path longest = here.path / std::string(255, 'n');
  host::replace_file(longest, "three");
  CHECK(fs::remove(longest));
  fs::create_symlink("elsewhere", here.path / "link");
  CHECK_THROWS_WITH(host::replace_file(here.path / "link", "x"), Contains("not a regular file"));
  CHECK_THROWS_WITH(host::replace_file("/dev/full", "x"), Contains("not a regular file"));
  CHECK_THROWS_WITH(host::replace_file(here.path / "none" / "page", "x"),
                    Contains("cannot be written"));
  CHECK_THROWS_WITH(host::write_text("/dev/full", "x"),
                    Contains("/dev/full: cannot be written: No space left on device"));
  CHECK_THROWS_WITH(host::write_text("/dev/full", std::string(100000, 'x')),
                    Contains("No space left on device"));
  CHECK(test::entries(here.path) == 2);
}
