// SPDX-License-Identifier: Apache-2.0
//
// Put before Verilator's runtime when it is compiled: what it prints goes through here, because
// standard output is for results.
#pragma once

#ifdef __cplusplus
extern "C"
#endif
int trammel_verilated_print(const char* format, ...) __attribute__((format(printf, 1, 2)));

#define VL_PRINTF trammel_verilated_print
