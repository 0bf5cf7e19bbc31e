// SPDX-License-Identifier: Apache-2.0
#include "lab/machines.hpp"

#include <algorithm>
#include <stdexcept>

namespace trammel::lab {
namespace {

struct Given {
  Machines (*table)() = nullptr;
  bool whole = true;
};

Given& given() {
  static Given table;
  return table;
}

}  // namespace

void take_machines(Machines (*table)(), bool whole) { given() = {table, whole}; }

const Machines& machines() {
  static const Machines all = [] {
    if (given().table == nullptr) throw std::logic_error("lab::take_machines() was not called");
    Machines list = given().table();
    std::stable_sort(list.begin(), list.end(),
                     [](const Machine* a, const Machine* b) { return a->order < b->order; });
    return list;
  }();
  return all;
}

void need_all_machines(const std::string& machine) {
  if (!given().whole) throw NotLinked(machine);
}

const Machine& first_machine() {
  const Machine& first = *machines().front();
  if (first.order != 1) need_all_machines();
  return first;
}

}  // namespace trammel::lab
