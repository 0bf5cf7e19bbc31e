// SPDX-License-Identifier: Apache-2.0
//
// Gives the laboratory the machines that a test program is linked with.
#include "machines/table.hpp"

namespace trammel::test {
namespace {

const bool kGiven = [] {
  lab::take_machines(linked_machines);
  return true;
}();

}  // namespace
}  // namespace trammel::test
