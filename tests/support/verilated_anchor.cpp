// SPDX-License-Identifier: Apache-2.0
//
// Gives the library of verilated blocks a first source: it exists before any block is added.
namespace trammel::test {
extern const int kVerilatedAnchor = 0;
}
