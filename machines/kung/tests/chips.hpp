// SPDX-License-Identifier: Apache-2.0
//
// The verilated chips of the X-Y table, by what a test needs of them.
#pragma once

#include <memory>
#include <string>

#include "machines/kung/chip/chip.hpp"

namespace trammel::kung {

inline std::unique_ptr<KungChip> make_verilated_chip(bool leap) {
  cosim::RunOptions run;
  run.leap = leap;
  return make_verilated_chip(run);
}

inline std::unique_ptr<KungChip> make_audited_chip() {
  cosim::RunOptions run;
  run.audit = true;
  return make_verilated_chip(run);
}

inline std::unique_ptr<KungChip> make_checked_chip() {
  cosim::RunOptions run;
  run.assertions = true;
  return make_verilated_chip(run);
}

inline std::unique_ptr<KungChip> make_traced_chip(const std::string& fst_file,
                                                  const cosim::WaveWindow& window, bool leap,
                                                  bool checked) {
  cosim::RunOptions run;
  run.leap = leap;
  run.assertions = checked;
  run.wave_file = fst_file;
  return make_verilated_chip(run, window);
}

}  // namespace trammel::kung
