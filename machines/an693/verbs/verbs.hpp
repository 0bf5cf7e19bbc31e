// SPDX-License-Identifier: Apache-2.0
//
// The verb `lm628`: a script or a conversation at the port of a simulated LM628 with its motor.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "testbench/arguments.hpp"

namespace trammel::an693 {

// Shows a prompt and gives what was typed; nothing at the end of input.
using ReadLine = std::function<std::optional<std::string>(const std::string& prompt)>;

// Of a terminal, with history, line editing and completion of mnemonics. `stop` ends the line.
ReadLine terminal_lines(const std::atomic<bool>& stop);

// `arguments.scenario` is the script: a built-in name, a file, "" or "-" for standard input. With
// `read_line` it is a conversation, in which a set `stop` ends a wait and is then cleared; without,
// it ends the run. The exit code.
int lm628_shell(const testbench::Arguments& arguments, std::atomic<bool>& stop,
                const ReadLine& read_line);

}  // namespace trammel::an693
