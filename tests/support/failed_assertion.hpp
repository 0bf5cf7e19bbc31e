// SPDX-License-Identifier: Apache-2.0
//
// An assertion failed by hand: what Verilator's code calls when one fails.
#pragma once

#include "cosim/verilated/hooks.hpp"

void vl_stop(const char* file, int line, const char* scope);

namespace trammel::test {

inline void fail_assertion(const char* path) {
  trammel_verilated_print("[0] %%Error: a_props.sv:7: Assertion failed in %s: 'assert' failed.\n",
                          path);
  vl_stop("/somewhere/rtl/drive/a_props.sv", 7, "");
}

}  // namespace trammel::test
