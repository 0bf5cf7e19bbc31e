// SPDX-License-Identifier: Apache-2.0
#include "host/child.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace trammel::host {

Child::Child(const std::vector<std::string>& words, Pipe pipe,
             const std::filesystem::path& folder) {
  int ends[2];  // to read, to write
  if (words.front().empty() || pipe2(ends, O_CLOEXEC) != 0) return;
  const int theirs = pipe == Pipe::kToInput ? 0 : 1;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (stream == theirs) {
      posix_spawn_file_actions_adddup2(&files, ends[theirs], stream);
    } else {
      posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
    }
  }
  posix_spawnattr_t how;
  posix_spawnattr_init(&how);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&how, 0);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  if (posix_spawn(&id_, arguments[0], &files, &how, arguments.data(), environ) != 0) id_ = -1;
  posix_spawnattr_destroy(&how);
  posix_spawn_file_actions_destroy(&files);
  close(ends[theirs]);
  if (id_ > 0) pipe_ = fdopen(ends[1 - theirs], theirs == 0 ? "w" : "r");
  if (pipe_ == nullptr) close(ends[1 - theirs]);
}

bool Child::ended() {
  bool good = pipe_ != nullptr;
  if (pipe_ != nullptr) good = std::fclose(pipe_) == 0;
  pipe_ = nullptr;
  if (id_ <= 0) return false;
  int status = 0;
  pid_t code = 0;
  do {
    code = waitpid(id_, &status, 0);
  } while (code < 0 && errno == EINTR);
  good = good && code == id_ && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  id_ = -1;
  return good;
}

}  // namespace trammel::host
