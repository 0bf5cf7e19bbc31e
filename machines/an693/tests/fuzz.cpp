// SPDX-License-Identifier: Apache-2.0
//
// LM628 scripts of any bytes.
#include "host/errors.hpp"
#include "machines/an693/verbs/script.hpp"
#include "tests/fuzz/inputs.hpp"

namespace trammel::an693 {
namespace {

void script(const std::string& bytes) {
  try {
    for (const Line& line : parse_script(bytes, "a.lm628")) {
      const auto again = parse_line(line.text, "again");
      if (!again || again->words != line.words) fuzz::finding("does not repeat: " + line.text);
    }
  } catch (const host::ConfigError& error) {
    fuzz::check_message(error);
  }
  const std::size_t behind = bytes.find(' ') + 1;  // 0: there is no space
  completions(bytes.substr(0, behind), bytes.substr(behind));
}

}  // namespace

std::vector<fuzz::Target> fuzz() { return {{"script", script}}; }

}  // namespace trammel::an693
