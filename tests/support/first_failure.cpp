// SPDX-License-Identifier: Apache-2.0
//
// The first failed case of a block's unit test leaves waves, by scripts/tool unit-waves; a mutant,
// which is to fail, does not.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#ifdef TRAMMEL_WAVES
#include "tests/support/waves.hpp"
#endif

namespace {

namespace fs = std::filesystem;

class FirstFailure : public Catch::TestEventListenerBase {
 public:
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    if (failed_) return;  // that of the failure is kept
    name_ = info.name;
    file_ = info.lineInfo.file;
  }

  bool assertionEnded(const Catch::AssertionStats& stats) override {
    if (stats.assertionResult.isOk() || failed_) return false;
    failed_ = true;
#ifdef TRAMMEL_WAVES
    trammel::test::note_failure();
#endif
    return false;
  }

  void testRunEnded(const Catch::TestRunStats&) override {
#ifndef TRAMMEL_WAVES
    const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
    // Of unit-waves itself, which would call itself without end.
    if (is_set("TRAMMEL_FAILED") || is_set("TRAMMEL_WAVES")) return;
    if (failed_ && !is_set("TRAMMEL_MUTANT")) show();
#endif
  }

 private:
  // The folder of the sources, from that of this program on upwards; of a block's test only.
  void show() const {
    const fs::path test = file_, layer = test.parent_path().filename();
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    const fs::path catch_main = program.parent_path() / "libtrammel_catch_main.a";
    const bool linked = fs::exists(catch_main, none);
    for (fs::path at = program; at.has_relative_path();) {
      at = at.parent_path();
      const fs::path tool = at / "scripts" / "tool";
      if (!fs::exists(tool, none)) continue;
      if (layer == "boards" || !fs::is_directory(at / "rtl" / layer, none)) return;
      const pid_t child = fork();
      if (child == 0) {
        execl(tool.c_str(), tool.c_str(), "unit-waves", (layer / test.filename()).c_str(),
              name_.c_str(), linked ? catch_main.c_str() : nullptr, nullptr);
        _exit(127);
      }
      if (child > 0) waitpid(child, nullptr, 0);
      return;
    }
  }

  bool failed_ = false;
  std::string name_, file_;
};

CATCH_REGISTER_LISTENER(FirstFailure)

}  // namespace

namespace trammel::test {
extern const bool kFirstFailure;
const bool kFirstFailure = true;
}  // namespace trammel::test
