// SPDX-License-Identifier: Apache-2.0
//
// Empty: CMake compiles the headers that most tests include with a unit (tests/CMakeLists.txt).
