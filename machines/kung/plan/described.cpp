// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/described.hpp"

#include <fmt/format.h>

#include "machines/kung/options.hpp"
#include "machines/kung/plan/feed.hpp"

namespace trammel::kung {

// Path, table, chip and gains are a scenario's, and so is that it runs at constant speed.
bool alters(const lab::Key& key, const lab::Value& value) {
  if (key.name == "controller") return std::get<std::string>(value) == "precision";
  if (key.name == "plant.seed") return false;
  const std::string section = key.name.substr(0, key.name.find('.'));
  return section == "path" || section == "plant" || section == "chip" || section == "gains";
}

// A description of a shape names its constant speed: under a feed profile that is the feed.
std::string reworded(const lab::Settings& settings, std::string description) {
  constexpr const char* kAt = " at ";
  const std::size_t end = description.find(" m/s");
  const std::size_t at = description.rfind(kAt, end);
  if (end == std::string::npos || at == std::string::npos) return description;
  const std::size_t begin = at + std::string(kAt).size();
  if (description.find_first_not_of("0123456789.", begin) != end) return description;
  const auto& options = static_cast<const Options&>(settings);
  const PathKind kind = options.path.kind;
  const bool shape =
      kind == PathKind::kCircle || kind == PathKind::kWindow || kind == PathKind::kStar;
  if (!shape || !feeds(options)) return description;
  return description.replace(begin, end - begin, fmt::format("{:g}", feed_m_s(options.path)));
}

}  // namespace trammel::kung
