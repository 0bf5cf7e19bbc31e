// SPDX-License-Identifier: Apache-2.0
//
// The columns of trace.csv, a row each 2 kHz sample.
#pragma once

#include "lab/column.hpp"

namespace trammel::kung {

const lab::ColumnTable& columns();

}  // namespace trammel::kung
