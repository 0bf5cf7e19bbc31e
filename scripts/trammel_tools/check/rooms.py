# SPDX-License-Identifier: Apache-2.0
"""The folders of the program's C++ code."""

# From the lowest up: each includes and links itself and those before it, or fewer of them.
ROOMS = ("host", "models", "sw_nios", "paths", "cosim", "systemc", "lab", "parts", "machines",
         "testbench")
