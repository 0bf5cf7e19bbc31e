// SPDX-License-Identifier: Apache-2.0
//
// Bytes of Serial2002 frames (Brochier 2006, 2.2.3; serial2002_rx has the forms). A value takes as
// few bytes as it can: 2 below 2^9, 3 below 2^16, 4 below 2^23, 5 below 2^30, else 6.
//
// A frame is held by the caller until take_o, which comes with its last byte.

module serial2002_tx
  import serial2002_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input  logic   waits_i,
    input  frame_t frame_i,
    output logic   take_o,

    input  logic       busy_i,  // of the line
    output logic       send_o,
    output logic [7:0] byte_o,

    output logic idle_o,
    output logic quiescent_o
);

  logic sends_q;
  logic [2:0] left_q, leads;
  logic [34:0] bits;

  assign bits = {3'd0, frame_i.value} >> 2;

  always_comb begin
    leads = 3'd1;
    if (frame_i.value[31:9] != '0) leads = 3'd2;
    if (frame_i.value[31:16] != '0) leads = 3'd3;
    if (frame_i.value[31:23] != '0) leads = 3'd4;
    if (frame_i.value[31:30] != '0) leads = 3'd5;
    if (!frame_i.kind[2]) leads = '0;
  end

  always_comb begin
    unique case (left_q)
      3'd0: byte_o = {1'b0, frame_i.kind[2] ? frame_i.value[1:0] : frame_i.kind[1:0],
                      frame_i.channel};
      3'd1: byte_o = {1'b1, bits[6:0]};
      3'd2: byte_o = {1'b1, bits[13:7]};
      3'd3: byte_o = {1'b1, bits[20:14]};
      3'd4: byte_o = {1'b1, bits[27:21]};
      default: byte_o = {1'b1, bits[34:28]};
    endcase
  end

  assign send_o = sends_q && !busy_i;
  assign take_o = send_o && left_q == '0;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      sends_q <= 1'b0;
      left_q  <= '0;
    end else if (!sends_q) begin
      sends_q <= waits_i;
      if (waits_i) left_q <= leads;
    end else if (send_o) begin
      if (left_q == '0) sends_q <= 1'b0;
      else left_q <= left_q - 3'd1;
    end
  end

  assign idle_o      = !sends_q && !waits_i && !busy_i;
  assign quiescent_o = !send_o && (sends_q || !waits_i);

endmodule
