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
  typedef logic        [10:0] cmp_t;     // compare value of the carrier, 0..1562
  typedef logic        [11:0] gap_t;     // clocks without an event, see math/timer

  // value = mant / 2048 * 2^exp
  typedef struct packed {
    logic signed [4:0]  exp;
    logic        [10:0] mant;
  } gain_t;

  localparam int unsigned PwmPeriod = 3125;  // [clk] 16 kHz at 50 MHz
  localparam cmp_t        CmpMax    = 1562;  // top of the carrier
  localparam gap_t        GapMax    = '1;    // "no event of mine in sight"

endpackage
