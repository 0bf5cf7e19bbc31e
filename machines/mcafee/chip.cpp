// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/chip.hpp"

namespace trammel::mcafee {

// Of the units that trammel_chip() makes.
std::unique_ptr<McafeeChip> make_chip_of_6MHz(const cosim::RunOptions& run,
                                              const std::optional<cosim::WaveWindow>& window);
std::unique_ptr<McafeeChip> make_chip_of_8MHz(const cosim::RunOptions& run,
                                              const std::optional<cosim::WaveWindow>& window);

std::unique_ptr<McafeeChip> make_verilated_chip(const cosim::RunOptions& run,
                                                const std::optional<cosim::WaveWindow>& window,
                                                int clock_MHz) {
  return (clock_MHz == 8 ? make_chip_of_8MHz : make_chip_of_6MHz)(run, window);
}

}  // namespace trammel::mcafee
