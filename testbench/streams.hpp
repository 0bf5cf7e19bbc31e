// SPDX-License-Identifier: Apache-2.0
//
// Standard output takes results and nothing else; messages go to standard error.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace trammel::testbench {

// To be called before a file is opened: none takes the place of a standard stream that is closed.
// From then on a reader that goes away is no signal.
void guard_streams();

// Control characters and what is not UTF-8 are told as such, here and in messages: texts of others
// do not reach the terminal.
void print(const std::string& result);
void print_now(const std::string& result);  // for a reader that answers it
void print_json(const nlohmann::ordered_json& document);

// A line that begins with "trammel: ". Where standard error does not take it, it is lost.
void tell(const std::string& message);

// The first of them, and how many more there are.
void tell_warnings(const std::string& of, const std::vector<std::string>& warnings);

// The exit code of the program whose work ended with `code`: 2 with a message when standard output
// did not take a result. A reader that went away wanted no more: that is no error.
int settled(int code);

}  // namespace trammel::testbench
