// SPDX-License-Identifier: Apache-2.0
#include "host/parse.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

#include "host/errors.hpp"

namespace trammel::host {
namespace {

using nlohmann::ordered_json;

[[noreturn]] void refuse_json(const std::filesystem::path& file, const std::string& what) {
  throw ConfigError(fmt::format("{}: is corrupt: {}", file.string(), what));
}

// Where a string of TOML ends that begins at `at`: behind its quotes, or at the end of its line
// where it lacks them.
std::size_t string_end(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = text.substr(at, 3);
  const bool lines = three.size() == 3 && three[1] == quote && three[2] == quote;
  for (std::size_t k = at + (lines ? 3 : 1); k < text.size(); ++k) {
    if (text[k] == '\\' && quote == '"') {
      ++k;
    } else if (lines ? text.substr(k, 3) == three : text[k] == quote) {
      return k + (lines ? 3 : 1);
    } else if (!lines && text[k] == '\n') {
      return k;
    }
  }
  return text.size();
}

}  // namespace

void check_depth(const std::string& toml, const std::string& source) {
  const std::string_view text = toml;
  int line = 1, open = 0, parts = 0;
  for (std::size_t k = 0; k < text.size();) {
    const char c = text[k];
    std::size_t next = k + 1;
    if (c == '"' || c == '\'') {
      next = string_end(text, k);
    } else if (c == '#') {
      next = std::min(text.find('\n', k), text.size());
    }
    for (std::size_t n = k; n < next; ++n) line += n < text.size() && text[n] == '\n' ? 1 : 0;
    if (c == '[' || c == '{') ++open;
    if ((c == ']' || c == '}') && open > 0) --open;
    parts = c == '.' ? parts + 1 : std::string_view("=,[]{}\n").find(c) < 7 ? 0 : parts;
    if (open > kDeepest || parts >= kDeepest) {
      throw ConfigError(fmt::format("{}:{}: nested deeper than {} parts", source, line, kDeepest));
    }
    k = next;
  }
}

ordered_json parse_object(const std::string& text, const std::filesystem::path& file) {
  using Event = ordered_json::parse_event_t;
  std::vector<std::size_t> members(kDeepest + 2);  // so far, of the object at each depth
  const auto check = [&](int depth, Event event, ordered_json&) {
    if (depth > kDeepest) refuse_json(file, fmt::format("nested deeper than {} parts", kDeepest));
    if (event == Event::object_start) members[static_cast<std::size_t>(depth) + 1] = 0;
    if (event == Event::key && ++members[static_cast<std::size_t>(depth)] > kMostMembers) {
      refuse_json(file, fmt::format("an object of more than {} members", kMostMembers));
    }
    return true;
  };
  try {
    ordered_json json = ordered_json::parse(text, check);
    if (json.is_object()) return json;
  } catch (const ordered_json::parse_error& error) {
    refuse_json(file, fmt::format("no JSON at byte {}", error.byte));
  } catch (const ordered_json::out_of_range&) {
    refuse_json(file, "a number that is too large");
  }
  refuse_json(file, "not a JSON object");
}

}  // namespace trammel::host
