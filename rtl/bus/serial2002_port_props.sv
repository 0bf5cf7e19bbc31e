// SPDX-License-Identifier: Apache-2.0
//
// Properties of serial2002_port. Its frames in waiting are cut: what they give is free.

module serial2002_port_props
  import trammel_pkg::*;
  import serial2002_pkg::*;
#(
    parameter int unsigned ClocksPerBit = 434
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        rx_i,
    input logic        tx_o,
    input logic        send_i,
    input frame_t      frame_i,
    input logic [ 5:0] room_o,
    input logic [15:0] refused_o,
    input logic        idle_o,
    input logic        take_i,
    input logic        waits_o,
    input frame_t      frame_o,
    input logic [15:0] lost_o,
    input logic [15:0] malformed_o,
    input gap_t        next_o,
    input logic        quiescent_o,

    input logic line_busy,
    input logic out_waits,
    input logic malformed,
    input logic rx_valid
);

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_tx_q, was_malformed_q;
  logic [15:0] was_count_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o && leap_i < next_o;
    was_tx_q        <= tx_o;
    was_malformed_q <= !rst_i && malformed;
    was_count_q     <= malformed_o;
    if (live_q) begin
      quiet_from_reset : assert (!was_rst_q || (tx_o && malformed_o == '0));
      idle_means_a_line_at_rest : assert (!idle_o || (tx_o && !line_busy && !out_waits));
      malformed_frames_are_counted :
      assert (was_rst_q || malformed_o == was_count_q + 16'(was_malformed_q &&
              was_count_q != '1));
      good_or_malformed_never_both : assert (!(malformed && rx_valid));
      quiescent_holds_the_line :
      assert (!was_quiescent_q || (tx_o == was_tx_q && malformed_o == was_count_q));
      reaches_a_malformed_frame : cover (malformed);
      reaches_a_frame : cover (rx_valid);
    end
  end

  logic unused_inputs;
  assign unused_inputs = ^{rx_i, send_i, frame_i, room_o, refused_o, take_i, waits_o, frame_o,
                           lost_o, ClocksPerBit};

  // breaks quiet_from_reset: malformed_q <= rst_i ? malformed_q : next
  // breaks idle_means_a_line_at_rest: u_tx.busy_i = 1'b0
  // breaks malformed_frames_are_counted: malformed_q <= next - 16'(malformed && !rst_i)
  // breaks good_or_malformed_never_both (serial2002_rx): malformed_o = malformed_q || valid_q
  // breaks quiescent_holds_the_line: rx_quiescent = 1'b1

  // prove: cut frame_fifo
  // prove: set ClocksPerBit=4

endmodule

bind serial2002_port serial2002_port_props #(
    .ClocksPerBit(ClocksPerBit)
) u_serial2002_port_props (.*);
