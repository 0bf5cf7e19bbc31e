// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

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

// How trace.csv prints each column, and the resolution of its series on a page: "t_s .8 1e-08", of
// a whole number "call 1".
inline std::vector<std::string> formats(const lab::ColumnTable& table) {
  std::vector<std::string> all;
  for (const lab::Column& column : table.columns) {
    const int digits = column.format.digits;
    const char* const kind = column.format.kind == lab::Format::Kind::kFixed     ? " ."
                             : column.format.kind == lab::Format::Kind::kGeneral ? " g"
                                                                                 : "";
    all.push_back(column.name + (*kind == '\0' ? "" : kind + std::to_string(digits)) +
                  fmt::format(" {:g}", column.resolution));
  }
  return all;
}

}  // namespace trammel::test
