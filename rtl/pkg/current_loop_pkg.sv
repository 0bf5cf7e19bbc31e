// SPDX-License-Identifier: Apache-2.0
//
// Clock domains of the current loop. A domain's registers move only at edges at which it is awake.

package current_loop_pkg;

  typedef struct packed {
    logic svpwm;   // inverse Park and modulation
    logic pi;      // controllers and their limit
    logic rotate;  // sine and Park
    logic angle;   // Clarke and the loop's own registers
  } domains_t;

endpackage
