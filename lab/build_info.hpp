// SPDX-License-Identifier: Apache-2.0
//
// What was built, from what and where. Constants of a unit that is generated at every build
// (build_info.cmake), so that a commit compiles nothing else again.
#pragma once

namespace trammel::lab {

extern const char* const kVersion;
extern const char* const kCommit;
extern const char* const kVerilator;
extern const char* const kSystemC;
extern const char* const kCompiler;
extern const char* const kBuild;
extern const char* const kMachineFolder;
extern const char* const kViewFolder;

}  // namespace trammel::lab
