// SPDX-License-Identifier: Apache-2.0
//
// Clock domains of kung_xy. A domain's registers move only at edges at which it is awake; the
// timers have the free-running clock and are in none.

package kung_pkg;

  typedef struct packed {
    logic gates;  // PWM and legs
    logic sense;  // encoder
    current_loop_pkg::domains_t loop;
    logic adc;
    logic position;  // command and position controller
  } axis_domains_t;

  typedef struct packed {
    logic precision;  // precision controller
    logic [1:0] gates;
    logic [1:0] sense;
    current_loop_pkg::domains_t loop;
    logic adc;
    logic position;
    logic system;  // registers, faults, watchdog
  } domains_t;

  // Of the precision controller to an axis.
  typedef struct packed {
    logic enable;  // its i_q* is the axis's
    logic done;    // that of a position tick is there
    logic signed [11:0] i_q_ref;
    logic saturated, clipped, overrun, underrun;  // pulses for STATUS
    logic read, written;  // its registers: read with `data`, written
    logic counts;         // PREC_DATA was: PREC_ADDR counts up
    logic [31:0] data;
  } precision_t;

  typedef logic signed [12:0] sum_t;  // of two phase currents

  // |current| >= limit, unless that is 0; with one carry chain for each sign.
  function automatic logic reached(sum_t current, logic [11:0] limit);
    logic signed [13:0] below;
    below = 14'(current) + $signed({2'b00, limit});
    return limit != '0 && (current >= sum_t'({1'b0, limit}) || below <= 14'sd0);
  endfunction

endpackage
