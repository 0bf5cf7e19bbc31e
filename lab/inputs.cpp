// SPDX-License-Identifier: Apache-2.0
#include "lab/inputs.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "host/files.hpp"
#include "lab/machine.hpp"

namespace trammel::lab {
namespace fs = std::filesystem;
namespace {

// "" where the key names none.
std::string file_of(const Settings& settings, const Key& key) {
  return key.kind == Kind::kFile ? std::get<std::string>(key.get(settings)) : "";
}

// path.gcode_file.ngc: no other file of a run has such a name.
std::string copy_name(const Key& key, const fs::path& file) {
  constexpr std::size_t kLongest = 8;
  const std::string extension = file.extension().string();
  const bool plain = extension.size() <= kLongest &&
                     std::all_of(extension.begin(), extension.end(), [](unsigned char c) {
                       return c == '.' || (c < 0x80 && std::isalnum(c) != 0);
                     });
  return key.name + (plain ? extension : "");
}

}  // namespace

void copy_inputs(const Settings& settings, const fs::path& folder) {
  constexpr std::uintmax_t kMost = 16 * host::kMiB;  // as their readers have it
  for (const Key& key : settings.machine().keys()) {
    const std::string file = file_of(settings, key);
    if (file.empty() || fs::exists(folder / copy_name(key, file))) continue;
    std::string text;
    try {
      text = host::read_text(file, kMost);
    } catch (const host::ConfigError&) {
      continue;
    }
    host::write_text(folder / copy_name(key, file), text);
  }
}

std::unique_ptr<Settings> with_copies(const Settings& settings, const fs::path& folder) {
  auto all = settings.clone();
  for (const Key& key : settings.machine().keys()) {
    const std::string file = file_of(settings, key);
    if (file.empty() || !fs::exists(folder / copy_name(key, file))) continue;
    key.set(*all, copy_name(key, file));
  }
  return all;
}

}  // namespace trammel::lab
