// SPDX-License-Identifier: Apache-2.0
//
// Number formats shared by all layers (specification section 3).
// Words are two's complement; "Qn" means n fractional bits.

package trammel_pkg;

  typedef logic signed [11:0] word_t;    // errors, speeds, currents, voltages
  typedef logic signed [23:0] count_t;   // positions [counts], integrators, stored rules
  typedef logic signed [31:0] model_t;   // reference model position, Q14 of a count
  typedef logic        [11:0] member_t;  // memberships and rule weights, 2048 = 1.0
  typedef logic        [9:0]  angle_t;   // 1024 = one electrical revolution
  typedef logic        [11:0] cmp_t;     // compare value, 0 to the top of the carrier
  typedef logic        [12:0] phase_t;   // [clk] within the period of the carrier
  typedef logic        [ 1:0] carrier_t; // frequency of the carrier
  typedef phase_t      [ 3:0] periods_t; // of all carriers, by carrier_t
  typedef logic        [11:0] gap_t;     // clocks without an event, see math/timer

  // value = mant / 2048 * 2^exp
  typedef struct packed {
    logic signed [4:0]  exp;
    logic        [10:0] mant;
  } gain_t;

  localparam gap_t GapMax = '1;  // "no event of mine in sight"

  localparam carrier_t Carrier16kHz = 2'd0;
  localparam carrier_t Carrier8kHz  = 2'd1;
  localparam carrier_t Carrier20kHz = 2'd2;
  localparam carrier_t Carrier40kHz = 2'd3;

  // Whether each carrier has a whole number of clocks, enough of them for the current loop, and no
  // more than the words of the modulation hold.
  function automatic logic makes_carriers(int unsigned clock_hz);
    return clock_hz % 32'd80_000 == 32'd0 && clock_hz >= 32'd8_000_000 &&
        clock_hz <= 32'd55_360_000;
  endfunction

  // Periods of the carriers [clk], for a constant.
  function automatic periods_t pwm_periods(int unsigned clock_hz);
    return {13'(clock_hz / 32'd40_000), 13'(clock_hz / 32'd20_000), 13'(clock_hz / 32'd8_000),
            13'(clock_hz / 32'd16_000)};
  endfunction

  // Top of a carrier: half its period.
  function automatic cmp_t cmp_max(phase_t period);
    return cmp_t'(period >> 1);
  endfunction

endpackage
