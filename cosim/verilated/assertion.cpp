// SPDX-License-Identifier: Apache-2.0
#include "cosim/assertion.hpp"

#include <cstdarg>
#include <cstdio>
#include <filesystem>

#include "cosim/verilated/hooks.hpp"

namespace trammel::cosim {
namespace {

struct Seen {
  std::string text;  // printed last
  std::optional<FailedAssertion> first;
};

Seen& seen() {
  thread_local Seen state;
  return state;
}

// "[0] %Error: pwm_props.sv:40: Assertion failed in top.u_pwm.u_pwm_props.label: 'assert' failed."
FailedAssertion parse(const std::string& text, const std::string& file, int line) {
  FailedAssertion broken;
  namespace fs = std::filesystem;
  broken.place = (fs::path(file).parent_path().filename() / fs::path(file).filename()).string() +
                 ':' + std::to_string(line);
  const std::string before = "Assertion failed in ";
  const auto begin = text.find(before);
  const auto end = text.find(": ", begin);
  if (begin == std::string::npos || end == std::string::npos) {
    broken.name = "$stop";
    return broken;
  }
  std::string path = text.substr(begin + before.size(), end - begin - before.size());
  const auto take_last = [&path] {
    const auto dot = path.rfind('.');
    const std::string last = dot == std::string::npos ? path : path.substr(dot + 1);
    path.resize(dot == std::string::npos ? 0 : dot);
    return last;
  };
  broken.name = take_last();
  take_last();  // the properties; what they are bound to made the assertion
  broken.instance = path;
  return broken;
}

}  // namespace

std::optional<FailedAssertion> take_failed_assertion() {
  std::optional<FailedAssertion> broken;
  std::swap(broken, seen().first);
  return broken;
}

}  // namespace trammel::cosim

extern "C" int trammel_verilated_print(const char* format, ...) {
  char text[1024];
  std::va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  trammel::cosim::seen().text = text;
  // A failed assertion is reported by whoever takes it.
  if (trammel::cosim::seen().text.find("Assertion failed in ") == std::string::npos) {
    std::fputs(text, stderr);
  }
  return length;
}

// Verilator's way to end a simulation, here only for assertions.
void vl_stop(const char* file, int line, const char*) {
  auto& state = trammel::cosim::seen();
  if (!state.first) state.first = trammel::cosim::parse(state.text, file, line);
}
