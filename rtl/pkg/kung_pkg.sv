// SPDX-License-Identifier: Apache-2.0
//
// Clock domains of kung_xy. A domain's registers move only at edges at which it is awake; the
// timers have the free-running clock and are in none.

package kung_pkg;

  typedef struct packed {
    logic svpwm;   // inverse Park and modulation
    logic pi;      // controllers and their limit
    logic rotate;  // sine and Park
    logic angle;   // Clarke and the loop's own registers
  } loop_domains_t;

  typedef struct packed {
    logic gates;  // PWM and legs
    logic sense;  // encoder
    loop_domains_t loop;
    logic adc;
    logic position;  // command and position controller
  } axis_domains_t;

  typedef struct packed {
    logic [1:0] gates;
    logic [1:0] sense;
    loop_domains_t loop;
    logic adc;
    logic position;
    logic system;  // registers, faults, watchdog
  } domains_t;

endpackage
