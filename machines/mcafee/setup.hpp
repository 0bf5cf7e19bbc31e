// SPDX-License-Identifier: Apache-2.0
//
// What the program is told: the options in its own units, and the rows of a table that outlives it;
// and how much of it is done.
#pragma once

#include "machines/mcafee/options.hpp"

namespace trammel::mcafee {

Table followed_table(const Options& options);  // of Stage III; else there is none
sw::McafeeSetup setup_of(const Options& options, const Table& table);

// At reading or row `point`, X being at `x` [count].
double share_done(const Options& options, const Table& table, std::uint32_t point, std::int32_t x);

}  // namespace trammel::mcafee
