// SPDX-License-Identifier: Apache-2.0
//
// The description of a scenario follows what later layers change of it.
#pragma once

#include "lab/settings.hpp"

namespace trammel::lab {

// `key` has another value than `before`: another path in place of the one described, or what does
// not go with the description, which is told behind it. What stands in parentheses at its end, such
// as the figures of a source, is left out then.
void note_change(Settings& settings, const Key& key, const Value& before);

}  // namespace trammel::lab
