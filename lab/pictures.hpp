// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a run: machines/<name>/pictures/*.gp, scripts of gnuplot that read the run's files.
#pragma once

#include <filesystem>

#include "lab/record.hpp"

namespace trammel::lab {

// Runs them in the folder of a run. Their variables are every setting (path.kind is path_kind), the
// title, and the samples worth drawing: from `first` to `last`, of which one in `step` makes a
// picture that is not heavy, and the times `from` and `to` [s] of both. False when gnuplot is
// missing or fails, or there are no two samples.
bool draw_pictures(const Record& record, const std::filesystem::path& folder);

}  // namespace trammel::lab
