// SPDX-License-Identifier: Apache-2.0
#include "parts/lm628/chip.hpp"

namespace trammel::lm628 {

// Of the units that trammel_chip() makes.
std::unique_ptr<Lm628Chip> make_chip_of_6MHz(const cosim::RunOptions& run,
                                             const std::optional<cosim::WaveWindow>& window,
                                             const PartOptions& part);
std::unique_ptr<Lm628Chip> make_chip_of_8MHz(const cosim::RunOptions& run,
                                             const std::optional<cosim::WaveWindow>& window,
                                             const PartOptions& part);

std::unique_ptr<Lm628Chip> make_verilated_chip(const cosim::RunOptions& run,
                                               const std::optional<cosim::WaveWindow>& window,
                                               const PartOptions& part) {
  return (part.clock_MHz == 6 ? make_chip_of_6MHz : make_chip_of_8MHz)(run, window, part);
}

}  // namespace trammel::lm628
