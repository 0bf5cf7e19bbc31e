// SPDX-License-Identifier: Apache-2.0
//
// Motor chip of @name@: sign-magnitude PWM of 20 kHz and a counter of encoder edges.
// The duty word is taken at the start of each period of 2500 clocks (50 MHz). What counts by itself
// is a math/timer, so that clocks which only count can be leapt over (docs/leap.md).

module @name@_pwm
  import trammel_pkg::*;
(
    input logic clk,
    input logic rst,

    input gap_t leap_i,

    input logic               enable,
    input logic signed [12:0] duty,    // clocks of a period; the sign is the direction
    input logic               enc_a,
    input logic               enc_b,

    output logic               pwm,
    output logic               direction,   // 1: backward
    output logic signed [15:0] count,
    output gap_t               next_o,
    output logic               quiescent_o
);

  localparam logic [11:0] Last = 12'd2499;

  logic [11:0] left;  // clocks of the period behind the present one
  logic [12:0] high;  // of the pulse
  logic start, enabled;
  gap_t left_next, high_next;

  assign start = left == 12'd0;

  timer #(
      .Width(12)
  ) u_left (
      .clk_i(clk),
      .rst_i(rst),
      .leap_i(leap_i),
      .load_i(start),
      .value_i(Last),
      .count_o(left),
      .next_o(left_next)
  );

  timer #(
      .Width(13)
  ) u_high (
      .clk_i(clk),
      .rst_i(rst),
      .leap_i(leap_i),
      .load_i(start),
      .value_i(duty[12] ? -duty : duty),
      .count_o(high),
      .next_o(high_next)
  );

  always_ff @(posedge clk) begin
    if (rst) begin
      direction <= 1'b0;
      enabled   <= 1'b0;
    end else begin
      enabled <= enable;
      if (start) direction <= duty[12];
    end
  end

  assign pwm = enabled && high != 13'd0;

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

  // No register but the timers moves at the next edge, while the pins stay as they are.
  assign quiescent_o = enabled == enable && a == {3{enc_a}} && b == {3{enc_b}};
  assign next_o = left_next < high_next ? left_next : high_next;

endmodule
