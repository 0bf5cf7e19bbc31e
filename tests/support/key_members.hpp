// SPDX-License-Identifier: Apache-2.0
//
// Which member of a machine's options each key sets, against a list in a test: keys that are
// swapped, or of the other axis, agree with everything that is made from the same table.
#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lab/machine.hpp"

namespace trammel::test {

template <class Options>
class KeyMembers {
 public:
  // A key, and where its value is; `member` selects it from the options.
  template <class Get>
  KeyMembers& add(std::string name, Get member) {
    members_.emplace_back(std::move(name), [member](const Options& o) {
      return static_cast<double>(std::invoke(member, o));
    });
    return *this;
  }

  // Each key of the list set alone, in options that are otherwise the defaults: "" or, for each
  // that does not change its member, or changes another one, a line.
  std::string wrong() const {
    std::string all;
    const Options defaults;
    for (const auto& [name, member] : members_) {
      const auto found = lab::find_keys(defaults.machine().keys(), name);
      if (found.size() != 1) {
        all += name + " is no key\n";
        continue;
      }
      const lab::Key& key = *found.front();
      Options options;
      const double wanted = set(key, options, member(defaults));
      for (const auto& [other, get] : members_) {
        const double is = get(options);
        const double should = other == name ? wanted : get(defaults);
        if (is == should) continue;
        all += name + " = " + std::to_string(wanted) + " makes the member of " + other + " " +
               std::to_string(is) + ", wanted " + std::to_string(should) + "\n";
      }
    }
    return all;
  }

  std::size_t size() const { return members_.size(); }

 private:
  using Get = std::function<double(const Options&)>;

  // Another value than `was`; what the member then is.
  static double set(const lab::Key& key, Options& options, double was) {
    using lab::Kind;
    if (key.kind == Kind::kFlag) {
      key.set(options, lab::Value{was == 0});
      return was == 0;
    }
    if (key.kind == Kind::kChoice) {
      const auto n = (static_cast<std::size_t>(was) + 1) % key.choices.size();
      key.set(options, lab::Value{key.choices[n]});
      return static_cast<double>(n);
    }
    const double value = was == key.max ? key.min : key.max;
    if (key.kind == Kind::kInteger) {
      key.set(options, lab::Value{static_cast<std::int64_t>(value)});
    } else {
      key.set(options, lab::Value{value});
    }
    return value;
  }

  std::vector<std::pair<std::string, Get>> members_;
};

}  // namespace trammel::test
