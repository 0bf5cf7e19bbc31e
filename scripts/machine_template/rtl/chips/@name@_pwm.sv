// SPDX-License-Identifier: Apache-2.0
//
// Motor chip of @name@: sign-magnitude PWM of 20 kHz and a counter of encoder edges.
// The duty word is taken at the start of each period of 2500 clocks (50 MHz).
@c@ // What counts by itself is a math/timer, so that clocks which only count can be leapt over
@c@ // (docs/leap.md).

@p@ module @name@_pwm (
@c@ module @name@_pwm
@c@   import trammel_pkg::*;
@c@ (
    input logic clk,
    input logic rst,
@c@
@c@     input gap_t leap_i,

    input logic               enable,
    input logic signed [12:0] duty,    // clocks of a period; the sign is the direction
    input logic               enc_a,
    input logic               enc_b,

    output logic               pwm,
@p@     output logic               direction,  // 1: backward
@c@     output logic               direction,   // 1: backward
@p@     output logic signed [15:0] count
@c@     output logic signed [15:0] count,
@c@     output gap_t               next_o,
@c@     output logic               quiescent_o
);

  localparam logic [11:0] Last = 12'd2499;

@p@   logic [11:0] counter;
@p@   logic [12:0] width;
@c@   logic [11:0] left;  // clocks of the period behind the present one
@c@   logic [12:0] high;  // of the pulse
@p@   logic enabled;
@c@   logic start, enabled;
@c@   gap_t left_next, high_next;

@p@   // A pulse begins with its period and lasts `width` clocks.
@c@   assign start = left == 12'd0;
@c@
@c@   timer #(
@c@       .Width(12)
@c@   ) u_left (
@c@       .clk_i(clk),
@c@       .rst_i(rst),
@c@       .leap_i(leap_i),
@c@       .load_i(start),
@c@       .value_i(Last),
@c@       .count_o(left),
@c@       .next_o(left_next)
@c@   );
@c@
@c@   timer #(
@c@       .Width(13)
@c@   ) u_high (
@c@       .clk_i(clk),
@c@       .rst_i(rst),
@c@       .leap_i(leap_i),
@c@       .load_i(start),
@c@       .value_i(duty[12] ? -duty : duty),
@c@       .count_o(high),
@c@       .next_o(high_next)
@c@   );
@c@
  always_ff @(posedge clk) begin
    if (rst) begin
@p@       counter   <= Last;
@p@       width     <= 13'd0;
      direction <= 1'b0;
      enabled   <= 1'b0;
    end else begin
      enabled <= enable;
@p@       if (counter == Last) begin
@p@         counter   <= 12'd0;
@p@         width     <= duty[12] ? -duty : duty;
@p@         direction <= duty[12];
@c@       if (start) direction <= duty[12];
@p@       end else begin
@p@         counter <= counter + 12'd1;
@p@       end
    end
  end

@p@   assign pwm = enabled && 13'(counter) < width;
@c@   assign pwm = enabled && high != 13'd0;

  // Each edge of one of the two lines is a count; A leads when the shaft turns forward.
  logic [2:0] a, b;
  logic moved, forward;

  assign moved   = (a[1] != a[2]) != (b[1] != b[2]);
  assign forward = a[1] != b[2];

  always_ff @(posedge clk) begin
    a <= {a[1:0], enc_a};
    b <= {b[1:0], enc_b};
    if (rst) count <= 16'sd0;
    else if (moved) count <= forward ? count + 16'sd1 : count - 16'sd1;
  end

@c@   // No register but the timers moves at the next edge, while the pins stay as they are.
@c@   assign quiescent_o = enabled == enable && a == {3{enc_a}} && b == {3{enc_b}};
@c@   assign next_o = left_next < high_next ? left_next : high_next;
@c@
endmodule
