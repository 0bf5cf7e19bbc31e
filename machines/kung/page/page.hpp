// SPDX-License-Identifier: Apache-2.0
//
// What the report page needs besides figures and columns: detail.json, written and read back, and
// the contour error.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "lab/machine.hpp"
#include "machines/kung/chip/record.hpp"

namespace trammel::kung {

nlohmann::ordered_json detail_json(const Options& options, const Result& result);
lab::Page page();

}  // namespace trammel::kung
