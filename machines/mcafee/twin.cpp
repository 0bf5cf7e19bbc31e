// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/twin.hpp"

namespace trammel::mcafee {

std::unique_ptr<McafeeChip> make_twin_chip(int clock_MHz) {
  return std::make_unique<TwinChip>(clock_MHz);
}

}  // namespace trammel::mcafee
