// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "lab/column.hpp"

namespace trammel::test {

// The columns of a trace that have this flag, in their order: "t_s x_step".
inline std::string marked(const lab::ColumnTable& table, bool lab::Column::*flag) {
  std::string all;
  for (const lab::Column& column : table.columns) {
    if (column.*flag) all += (all.empty() ? "" : " ") + column.name;
  }
  return all;
}

}  // namespace trammel::test
