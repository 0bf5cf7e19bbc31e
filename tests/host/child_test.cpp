// SPDX-License-Identifier: Apache-2.0
//
// Programs that are joined by a pipe: what they get, what is known of their end, what is left.
#include "host/child.hpp"

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/files.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using host::Child;
using Pipe = host::Child::Pipe;

namespace {

std::vector<std::string> shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

std::string all_of(std::FILE* pipe) {
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  return text;
}

// Nothing is left that has ended and that nobody has waited for.
bool no_child_is_left() { return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

}  // namespace

TEST_CASE("a program has ended well with exit code 0, and in no other way") {
  for (const Pipe pipe : {Pipe::kToInput, Pipe::kFromOutput}) {
    for (const auto& [script, good] :
         {std::pair{"exit 0", true}, {"exit 1", false}, {"kill -9 $$", false}}) {
      CAPTURE(script);
      Child child(shell(script), pipe);
      REQUIRE(child.pipe() != nullptr);
      CHECK(child.ended() == good);
      CHECK(child.pipe() == nullptr);
      CHECK_FALSE(child.ended());  // there is none any more
    }
  }
  CHECK(no_child_is_left());
}

TEST_CASE("a program that cannot be started has no pipe, has not ended well, and leaves nothing") {
  const std::size_t before = test::entries("/proc/self/fd");
  for (const char* const name : {"", "/no/such/program", "/dev/null", "/"}) {
    CAPTURE(name);
    for (const Pipe pipe : {Pipe::kToInput, Pipe::kFromOutput}) {
      Child child({name}, pipe);
      CHECK(child.pipe() == nullptr);
      CHECK_FALSE(child.ended());
    }
  }
  CHECK(test::entries("/proc/self/fd") == before);
  CHECK(no_child_is_left());
}

TEST_CASE("a program that is dropped is waited for, and its pipe is closed") {
  const test::Scratch scratch("child_test_out");
  const std::size_t before = test::entries("/proc/self/fd");
  const std::string file = scratch.path / "taken";
  {
    const Child child(shell("cat > '" + file + "'"), Pipe::kToInput);
    REQUIRE(child.pipe() != nullptr);
    std::fputs("all of it", child.pipe());
  }
  CHECK(test::content(file) == "all of it");
  CHECK(test::entries("/proc/self/fd") == before);
  CHECK(no_child_is_left());
}

TEST_CASE("a program works in its folder, with our pipe and no other stream of ours") {
  const test::Scratch scratch("child_test_out");
  std::string read, shown;
  const std::string streams = "pwd -P; readlink /proc/$$/fd/0 /proc/$$/fd/2; echo lost >&2; "
                              "read -r line || echo no input";
  shown = test::on_stderr([&] {
    Child child(shell(streams), Pipe::kFromOutput, scratch.path);
    REQUIRE(child.pipe() != nullptr);
    read = all_of(child.pipe());
    CHECK(child.ended());
  });
  CHECK(read == scratch.path.string() + "\n/dev/null\n/dev/null\nno input\n");
  CHECK(shown == "");
  shown = test::on_stdout([&] {
    Child child(shell("read -r line; echo lost; echo \"$line\" > line"), Pipe::kToInput,
                scratch.path);
    REQUIRE(child.pipe() != nullptr);
    std::fputs("a line\n", child.pipe());
    CHECK(child.ended());
  });
  CHECK(test::content(scratch.path / "line") == "a line\n");
  CHECK(shown == "");
}

TEST_CASE("of two programs at once each one's input ends by itself") {
  Child first(shell("cat"), Pipe::kToInput), second(shell("cat"), Pipe::kToInput);
  REQUIRE(first.pipe() != nullptr);
  REQUIRE(second.pipe() != nullptr);
  CHECK(first.ended());
  CHECK(second.ended());
}

TEST_CASE("a program is in a process group of its own") {
  Child child(shell("read -r id name state parent group rest < /proc/$$/stat; "
                    "[ \"$group\" = \"$$\" ]"),
              Pipe::kFromOutput);
  REQUIRE(child.pipe() != nullptr);
  CHECK(child.ended());
}
