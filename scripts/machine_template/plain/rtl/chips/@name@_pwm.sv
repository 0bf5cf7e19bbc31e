// SPDX-License-Identifier: Apache-2.0
//
// Motor chip of @name@: sign-magnitude PWM of 20 kHz and a counter of encoder edges.
@plain@ // The duty word is taken at the start of each period of 2500 clocks (50 MHz).
@contract@ // The duty word is taken at the start of each period of 2500 clocks (50 MHz). What counts by itself
@contract@ // is a math/timer, so that clocks which only count can be leapt over (docs/leap.md).

@plain@ module @name@_pwm (
@contract@ module @name@_pwm
@contract@   import trammel_pkg::*;
@contract@ (
    input logic clk,
    input logic rst,
@contract@
@contract@     input gap_t leap_i,

    input logic               enable,
    input logic signed [12:0] duty,    // clocks of a period; the sign is the direction
    input logic               enc_a,
    input logic               enc_b,

    output logic               pwm,
@plain@     output logic               direction,  // 1: backward
@contract@     output logic               direction,   // 1: backward
@plain@     output logic signed [15:0] count
@contract@     output logic signed [15:0] count,
@contract@     output gap_t               next_o,
@contract@     output logic               quiescent_o
);

  localparam logic [11:0] Last = 12'd2499;

@plain@   logic [11:0] counter;
@plain@   logic [12:0] width;
@contract@   logic [11:0] left;  // clocks of the period behind the present one
@contract@   logic [12:0] high;  // of the pulse
@plain@   logic enabled;
@contract@   logic start, enabled;
@contract@   gap_t left_next, high_next;

@plain@   // A pulse begins with its period and lasts `width` clocks.
@contract@   assign start = left == 12'd0;
@contract@
@contract@   timer #(
@contract@       .Width(12)
@contract@   ) u_left (
@contract@       .clk_i(clk),
@contract@       .rst_i(rst),
@contract@       .leap_i(leap_i),
@contract@       .load_i(start),
@contract@       .value_i(Last),
@contract@       .count_o(left),
@contract@       .next_o(left_next)
@contract@   );
@contract@
@contract@   timer #(
@contract@       .Width(13)
@contract@   ) u_high (
@contract@       .clk_i(clk),
@contract@       .rst_i(rst),
@contract@       .leap_i(leap_i),
@contract@       .load_i(start),
@contract@       .value_i(duty[12] ? -duty : duty),
@contract@       .count_o(high),
@contract@       .next_o(high_next)
@contract@   );
@contract@
  always_ff @(posedge clk) begin
    if (rst) begin
@plain@       counter   <= Last;
@plain@       width     <= 13'd0;
      direction <= 1'b0;
      enabled   <= 1'b0;
    end else begin
      enabled <= enable;
@plain@       if (counter == Last) begin
@plain@         counter   <= 12'd0;
@plain@         width     <= duty[12] ? -duty : duty;
@plain@         direction <= duty[12];
@contract@       if (start) direction <= duty[12];
@plain@       end else begin
@plain@         counter <= counter + 12'd1;
@plain@       end
    end
  end

@plain@   assign pwm = enabled && 13'(counter) < width;
@contract@   assign pwm = enabled && high != 13'd0;

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

@contract@   // No register but the timers moves at the next edge, while the pins stay as they are.
@contract@   assign quiescent_o = enabled == enable && a == {3{enc_a}} && b == {3{enc_b}};
@contract@   assign next_o = left_next < high_next ? left_next : high_next;
@contract@
endmodule
