// SPDX-License-Identifier: Apache-2.0
//
// Serial2002 on a serial line (Brochier 2006, 2.2.3): up to 8 frames in wait, and 32 out.
// A frame shows 9.5 bits and 6 clocks behind the start bit of its last byte. A partial one ends
// where no byte comes for gap_i clocks.

module serial2002_port
  import trammel_pkg::*;
  import serial2002_pkg::*;
#(
    parameter int unsigned ClocksPerBit = 434
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input  logic rx_i,
    output logic tx_o,

    input  logic        send_i,
    input  frame_t      frame_i,
    output logic [ 5:0] room_o,
    output logic [15:0] refused_o,
    output logic        idle_o,     // none to send, the line at rest

    input  logic [23:0] gap_i,
    input  logic        take_i,
    output logic        waits_o,
    output frame_t      frame_o,
    output logic [15:0] lost_o,
    output logic [15:0] malformed_o,

    output gap_t next_o,
    output logic quiescent_o
);

  logic line_send, line_busy, line_valid, line_bad, line_quiescent;
  logic rx_valid, malformed, rx_quiescent, tx_quiescent, in_quiescent, out_quiescent;
  logic out_waits, out_take;
  logic [7:0] line_out, line_in;
  logic [3:0] unused_room;
  gap_t line_next, rx_next;
  logic [15:0] malformed_q;
  frame_t rx_frame, out_frame;

  serial_line #(
      .ClocksPerBit(ClocksPerBit)
  ) u_line (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .send_i     (line_send),
      .byte_i     (line_out),
      .busy_o     (line_busy),
      .valid_o    (line_valid),
      .bad_o      (line_bad),
      .byte_o     (line_in),
      .rx_i       (rx_i),
      .tx_o       (tx_o),
      .next_o     (line_next),
      .quiescent_o(line_quiescent)
  );

  serial2002_rx u_rx (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .gap_i      (gap_i),
      .valid_i    (line_valid),
      .bad_i      (line_bad),
      .byte_i     (line_in),
      .valid_o    (rx_valid),
      .frame_o    (rx_frame),
      .malformed_o(malformed),
      .next_o     (rx_next),
      .quiescent_o(rx_quiescent)
  );

  frame_fifo #(
      .Depth(8)
  ) u_in (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .push_i     (rx_valid),
      .frame_i    (rx_frame),
      .pop_i      (take_i),
      .frame_o    (frame_o),
      .waits_o    (waits_o),
      .room_o     (unused_room),
      .lost_o     (lost_o),
      .quiescent_o(in_quiescent)
  );

  frame_fifo #(
      .Depth(32)
  ) u_out (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .push_i     (send_i),
      .frame_i    (frame_i),
      .pop_i      (out_take),
      .frame_o    (out_frame),
      .waits_o    (out_waits),
      .room_o     (room_o),
      .lost_o     (refused_o),
      .quiescent_o(out_quiescent)
  );

  serial2002_tx u_tx (
      .clk_i      (clk_i),
      .rst_i      (rst_i),
      .waits_i    (out_waits),
      .frame_i    (out_frame),
      .take_o     (out_take),
      .busy_i     (line_busy),
      .send_o     (line_send),
      .byte_o     (line_out),
      .idle_o     (idle_o),
      .quiescent_o(tx_quiescent)
  );

  always_ff @(posedge clk_i) begin
    if (rst_i) malformed_q <= '0;
    else if (malformed && malformed_q != '1) malformed_q <= malformed_q + 16'd1;
  end

  assign malformed_o = malformed_q;
  assign next_o      = rx_next < line_next ? rx_next : line_next;
  assign quiescent_o = line_quiescent && rx_quiescent && tx_quiescent && in_quiescent &&
      out_quiescent;

  logic unused_bits;
  assign unused_bits = ^unused_room;

endmodule
