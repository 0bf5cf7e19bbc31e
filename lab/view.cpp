// SPDX-License-Identifier: Apache-2.0
#include "lab/view.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdint>
#include <map>
#include <sstream>
#include <string_view>
#include <toml++/toml.h>
#include <utility>
#include <variant>
#include <vector>

#include "lab/machine.hpp"

namespace trammel::lab {
namespace {

// Flags of a trace, as a save file of GTKWave has them.
constexpr std::uint64_t kHex = 0x22, kUnsigned = 0x24, kBits = 0x28, kOctal = 0x30, kSigned = 0x420,
                   kLevel = 0x8024, kCurve = 0x8420, kBlank = 0x20000, kFilter = 0x4000,
                   kPoint = 0x40000000, kGroup = 0x800200, kEndOfGroup = 0x1000200,
                   kClosed = 0x400000,
                        kEndOfClosed = 0x1401200, kEnum = 0x100000028;
const std::map<std::string, std::uint64_t> kShown{{"hex", kHex},       {"bits", kBits},
                                             {"octal", kOctal},   {"signed", kSigned},
                                             {"level", kLevel},   {"curve", kCurve},
                                             {"enum", kEnum}};

struct Axis {
  std::string name;  // "X"; "": of the whole chip
  std::string path;  // of its scope
};

class View {
 public:
  View(const Settings& settings, const toml::table& table, std::string source, std::string filter)
      : settings_(settings),
        table_(table),
        source_(std::move(source)),
        filter_(std::move(filter)) {}

  Views make() {
    const Machine& machine = settings_.machine();
    top_ = table_["top"].value_or(std::string());
    if (top_.empty()) wrong("top: the name of the chip is missing");
    text_ = fmt::format("[*] {}: {}\n[size] 1600 1000\n[pos] -1 -1\n[treeopen] {}.\n",
                        machine.name, machine.title, top_);
    for (const std::string& scope : strings("open")) {
      text_ += fmt::format("[treeopen] {}.{}.\n", top_, scope);
    }
    text_ += "[sst_width] 220\n[signals_width] 270\n[sst_expanded] 1\n[sst_vpaned_height] 300\n";
    add_groups("groups", {});
    bool first = true;
    for (const auto& axis : lists("axes")) {
      if (axis.size() != 2) wrong("axes: an axis has a name and a scope");
      add_groups("of_each_axis", {axis[0], axis[1]}, !std::exchange(first, false));
    }
    add_groups("more", {});
    return {text_, surfer_};
  }

 private:
  [[noreturn]] void wrong(const std::string& what) const {
    throw host::ConfigError(source_ + ": " + what);
  }

  static std::vector<std::string> strings_of(const toml::array* array) {
    std::vector<std::string> all;
    if (array == nullptr) return all;
    for (const auto& one : *array) all.push_back(one.value_or(std::string()));
    return all;
  }
  std::vector<std::string> strings(const char* key) const {
    return strings_of(table_[key].as_array());
  }
  std::vector<std::vector<std::string>> lists(const char* key) const {
    std::vector<std::vector<std::string>> all;
    if (const toml::array* const array = table_[key].as_array()) {
      for (const auto& one : *array) all.push_back(strings_of(one.as_array()));
    }
    return all;
  }

  // Groups: a name, "-" before it where it is closed, and its signals.
  void add_groups(const char* key, const Axis& axis, bool closed = false) {
    for (const auto& group : lists(key)) {
      if (group.empty()) wrong(fmt::format("{}: a group has no name", key));
      const bool own = group[0].rfind('-', 0) == 0;
      std::string name = group[0].substr(own ? 1 : 0);
      if (!axis.name.empty()) name = axis.name + (name.empty() ? "" : " ") + name;
      const std::uint64_t flag = own || closed ? kClosed : 0;
      surfer_ += fmt::format("divider_add \"{}\"\n", name);
      if (!name.empty()) text_ += fmt::format("@{:x}\n-{}\n", kGroup | flag, name);
      for (std::size_t n = 1; n < group.size(); ++n) add_signal(group[n], axis);
      if (name.empty()) continue;
      text_ += fmt::format("@{:x}\n-{}\n", flag == 0 ? kEndOfGroup : kEndOfClosed, name);
    }
  }

  // "LABEL: PATH[HIGH:LOW] WORD ..."; words are how it is shown, "#3" a colour, "Q16" a binary
  // point, or a unit.
  void add_signal(const std::string& signal, const Axis& axis) {
    const auto colon = signal.find(": ");
    std::istringstream words(colon == std::string::npos ? signal : signal.substr(colon + 2));
    std::string path, word, point, colour, unit;
    words >> path;
    const bool one_bit = path.find(':') == std::string::npos;
    const std::string label =
        colon == std::string::npos ? path.substr(0, path.find('[')) : signal.substr(0, colon);
    std::uint64_t flags = one_bit ? kBits : kUnsigned;
    while (words >> word) {
      if (const auto shown = kShown.find(word); shown != kShown.end()) {
        flags = shown->second;
      } else if (word[0] == '#') {
        colour = word.substr(1);
      } else if (word[0] == 'Q' && word.size() > 1 && std::isdigit(word[1]) != 0) {
        point = word.substr(1);
      } else {
        unit = filtered(word, signal, axis);
      }
    }
    const std::string scope = top_ + '.' + (axis.path.empty() ? "" : axis.path + '.');
    add_to_surfer(scope + path, flags);
    const bool analog = flags == kCurve || flags == kLevel;
    if (!unit.empty()) flags |= kFilter;
    if (unit.empty() && !point.empty()) flags |= kPoint;
    text_ += fmt::format("@{:x}\n{}", flags, unit);
    if ((flags & kPoint) != 0) text_ += fmt::format("[fpshift_count] {}\n", point);
    if (!colour.empty()) text_ += fmt::format("[color] {}\n", colour);
    text_ += fmt::format("+{{{}}} {}{}\n", label, scope, path);
    if (analog) text_ += fmt::format("@{:x}\n-\n", kBlank);
  }

  // Surfer names no bits, and an element of a memory is a scope of its own, m.[3].
  void add_to_surfer(const std::string& name, std::uint64_t flags) {
    std::string path = name.substr(0, name.back() == ']' ? name.rfind('[') : name.size());
    if (path.back() == ']') path.insert(path.rfind('['), ".");
    surfer_ += fmt::format("variable_add {}\n", path);
    const char* const format = flags == kHex                        ? "Hexadecimal"
                               : flags == kOctal                    ? "Octal"
                               : flags == kSigned || flags == kCurve ? "Signed"
                               : flags == kBits || flags == kEnum   ? ""
                                                                    : "Unsigned";
    if (*format != '\0') surfer_ += fmt::format("item_set_format {}\n", format);
  }

  // The line of a save file that names the filter of a unit; "" without a filter.
  std::string filtered(const std::string& unit, const std::string& signal, const Axis& axis) {
    const toml::array* const parts = table_["units"][unit].as_array();
    if (parts == nullptr) wrong(fmt::format("{}: {} is no unit of this file", signal, unit));
    if (filter_.empty()) return "";
    const std::string script = fmt::format(
        "import sys;[print('%.4g {0}'%(int(v)*{1:.9g}) if v.strip('-\\n').isdigit() else "
        "v.strip(),flush=True) for v in iter(sys.stdin.readline,'')]",
        unit.substr(0, unit.find('_')), scale(*parts, axis));
    const auto number = filters_.emplace(script, filters_.size() + 1).first->second;
    return fmt::format("^>{} {} -c{}\n", number, filter_, script);
  }

  // A product of numbers and of keys of the settings, those behind "/" as divisors.
  double scale(const toml::array& parts, const Axis& axis) const {
    double product = 1;
    for (const auto& part : parts) {
      if (const auto number = part.value<double>()) {
        product *= *number;
        continue;
      }
      std::string name = part.value_or(std::string());
      const bool divides = name.rfind('/', 0) == 0;
      if (divides) name.erase(0, 1);
      if (const auto at = name.find("{axis}"); at != std::string::npos) {
        name.replace(at, 6, axis.name.empty() ? "" : std::string(1, static_cast<char>(
                                std::tolower(static_cast<unsigned char>(axis.name[0])))));
      }
      const auto found = find_keys(settings_.machine().keys(), name);
      if (found.size() != 1) wrong(fmt::format("units: {} is no key of the machine", name));
      const Value value = found[0]->get(settings_);
      const auto* const whole = std::get_if<std::int64_t>(&value);
      const auto* const real = std::get_if<double>(&value);
      if (whole == nullptr && real == nullptr) wrong(fmt::format("units: {} is no number", name));
      const double is = real != nullptr ? *real : static_cast<double>(*whole);
      product *= divides ? 1 / is : is;
    }
    return product;
  }

  const Settings& settings_;
  const toml::table& table_;
  std::string source_, filter_, top_, text_, surfer_;
  std::map<std::string, std::size_t> filters_;
};

}  // namespace

Views make_views(const Settings& settings, const std::string& toml, const std::string& source,
                 const std::string& filter) {
  toml::table table;
  try {
    table = toml::parse(toml, source);
  } catch (const toml::parse_error& error) {
    throw host::ConfigError(fmt::format("{}:{}: {}", source, error.source().begin.line,
                                        std::string(error.description())));
  }
  return View(settings, table, source, filter).make();
}

}  // namespace trammel::lab
