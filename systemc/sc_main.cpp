// SPDX-License-Identifier: Apache-2.0
//
// The SystemC library wants this symbol; our programs have a main() of their own and elaborate there.
#include <systemc>

int sc_main(int, char**) { return 1; }
