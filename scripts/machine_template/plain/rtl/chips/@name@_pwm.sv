// SPDX-License-Identifier: Apache-2.0
//
// Motor chip of @name@: sign-magnitude PWM of 20 kHz and a counter of encoder edges.
// The duty word is taken at the start of each period of 2500 clocks (50 MHz).

module @name@_pwm (
    input logic clk,
    input logic rst,

    input logic               enable,
    input logic signed [12:0] duty,    // clocks of a period; the sign is the direction
    input logic               enc_a,
    input logic               enc_b,

    output logic               pwm,
    output logic               direction,  // 1: backward
    output logic signed [15:0] count
);

  localparam logic [11:0] Last = 12'd2499;

  logic [11:0] counter;
  logic [12:0] width;
  logic enabled;

  // A pulse begins with its period and lasts `width` clocks.
  always_ff @(posedge clk) begin
    if (rst) begin
      counter   <= Last;
      width     <= 13'd0;
      direction <= 1'b0;
      enabled   <= 1'b0;
    end else begin
      enabled <= enable;
      if (counter == Last) begin
        counter   <= 12'd0;
        width     <= duty[12] ? -duty : duty;
        direction <= duty[12];
      end else begin
        counter <= counter + 12'd1;
      end
    end
  end

  assign pwm = enabled && 13'(counter) < width;

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

endmodule
