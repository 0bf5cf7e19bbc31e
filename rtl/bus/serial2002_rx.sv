// SPDX-License-Identifier: Apache-2.0
//
// Frames of Serial2002 from bytes (Brochier 2006, 2.2.3).
//
//   0 kk ccccc                       clear bit, set bit, poll bit, poll channel (kk)
//   1 vvvvvvv ... 0 vv ccccc         a value: 1 to 5 leading bytes, highest bits first
//
// Of 5 leading bytes the first carries 3 at most: 32 bits. A longer frame, and one with a bad byte,
// is dropped up to its last byte, and is one error. So is one whose next byte does not come within
// gap_i clocks of the last: the byte behind it begins a frame. A gap of 0 never ends. One clock
// from the last byte to frame_o.

module serial2002_rx
  import trammel_pkg::*;
  import serial2002_pkg::*;
#(
    parameter int unsigned GapWidth = 24
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic [GapWidth-1:0] gap_i,

    input logic       valid_i,
    input logic       bad_i,
    input logic [7:0] byte_i,

    output logic   valid_o,      // one clock
    output frame_t frame_o,
    output logic   malformed_o,  // one clock
    output gap_t   next_o,
    output logic   quiescent_o
);

  logic [2:0] leads_q;
  logic [29:0] value_q;
  logic wrong_q, valid_q, malformed_q, wrong, over, silent;
  logic [GapWidth-1:0] gap_count;
  frame_t frame_q, frame;

  timer #(
      .Width(GapWidth)
  ) u_gap (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (valid_i),
      .value_i(byte_i[7] ? gap_i : '0),
      .count_o(gap_count),
      .next_o (next_o)
  );

  assign over  = byte_i[7] && (leads_q == 3'd5 || (leads_q == 3'd4 && value_q[27:23] != '0));
  assign wrong = wrong_q || bad_i || over;
  assign silent = gap_count == GapWidth'(1) && !valid_i;

  always_comb begin
    frame = '{kind: {1'b0, byte_i[6:5]}, channel: byte_i[4:0], value: '0};
    if (leads_q != '0) begin
      frame.kind  = KindValue;
      frame.value = {value_q, byte_i[6:5]};
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      leads_q     <= '0;
      value_q     <= '0;
      wrong_q     <= 1'b0;
      valid_q     <= 1'b0;
      malformed_q <= 1'b0;
      frame_q     <= '0;
    end else begin
      valid_q     <= valid_i && !byte_i[7] && !wrong;
      malformed_q <= (valid_i && !byte_i[7] && wrong) || silent;
      if (valid_i && byte_i[7]) begin
        wrong_q <= wrong;
        value_q <= {value_q[22:0], byte_i[6:0]};
        if (leads_q != 3'd5) leads_q <= leads_q + 3'd1;
      end else if (valid_i || silent) begin
        wrong_q <= 1'b0;
        value_q <= '0;
        leads_q <= '0;
        if (valid_i) frame_q <= frame;
      end
    end
  end

  assign valid_o     = valid_q;
  assign malformed_o = malformed_q;
  assign frame_o     = frame_q;
  assign quiescent_o = !valid_i && !valid_q && !malformed_q && !silent;

endmodule
