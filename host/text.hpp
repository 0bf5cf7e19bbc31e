// SPDX-License-Identifier: Apache-2.0
//
// What a terminal is shown of texts that others wrote, and how errors are told.
#pragma once

#include <cstddef>
#include <exception>
#include <string>

namespace trammel::host {

// With \u001b for a control character and \xff for a byte that is not UTF-8.
std::string printable(const std::string& text);

// The same for text of several lines: newlines and tabulators stay.
std::string printable_lines(const std::string& text);

// A key, value or name in a message: printable, cut behind `most` characters.
std::string shown(const std::string& text, std::size_t most = 120);

// A message as one line of bounded length: a word that is longer than any name of a file is cut,
// and what is still too much is left out in the middle.
std::string one_line(const std::string& message);

// 0.0018 -> "1.8 ms"; in s, ms or us.
std::string time_text(double s, int digits = 9);

// Its text; of std::bad_alloc which memory did not suffice.
std::string reason_of(const std::exception& error);

}  // namespace trammel::host
