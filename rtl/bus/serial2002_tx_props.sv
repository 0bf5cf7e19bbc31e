// SPDX-License-Identifier: Apache-2.0
//
// Properties of serial2002_tx. Promises about bytes are of frames that the caller holds from the
// begin to take_o.

module serial2002_tx_props
  import serial2002_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic       waits_i,
    input frame_t     frame_i,
    input logic       take_o,
    input logic       busy_i,
    input logic       send_o,
    input logic [7:0] byte_o,
    input logic       idle_o,
    input logic       quiescent_o,

    input logic       sends_q,
    input logic [2:0] left_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_take_q, was_sends_q, was_idle_q, was_waits_q;
  logic held_q;  // the frame is the one that it began with
  logic [2:0] sent_q, length, was_left_q;  // bytes of the frame
  frame_t frame_q;
  logic [41:0] bits_q;  // of the leading bytes that were sent
  logic held;

  assign held = held_q && frame_i == frame_q;

  always_comb begin
    length = 3'd6;
    if (frame_i.value < 32'd1 << 30) length = 3'd5;
    if (frame_i.value < 32'd1 << 23) length = 3'd4;
    if (frame_i.value < 32'd1 << 16) length = 3'd3;
    if (frame_i.value < 32'd1 << 9) length = 3'd2;
    if (!frame_i.kind[2]) length = 3'd1;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_take_q      <= !rst_i && take_o;
    was_sends_q     <= sends_q;
    was_left_q      <= left_q;
    was_idle_q      <= !rst_i && !sends_q;
    was_waits_q     <= waits_i;
    if (!sends_q) frame_q <= frame_i;
    held_q <= !sends_q || held;
    if (rst_i || take_o || !sends_q) begin
      sent_q <= '0;
      bits_q <= '0;
    end else if (send_o) begin
      sent_q <= sent_q + 3'd1;
      bits_q <= {bits_q[34:0], byte_o[6:0]};
    end
    if (live_q) begin
      quiet_from_reset : assert (!was_rst_q || !send_o);
      sends_into_a_free_line_only : assert (!send_o || !busy_i);
      begins_when_a_frame_waits : assert (!was_idle_q || sends_q == was_waits_q);
      taken_with_the_last_byte : assert (!send_o || take_o == !byte_o[7]);
      fewest_bytes : assert (!take_o || !held || sent_q + 3'd1 == length);
      last_byte_has_the_channel : assert (!take_o || byte_o[4:0] == frame_i.channel);
      bytes_are_the_value :
      assert (!take_o || !held || !frame_i.kind[2] ||
              {bits_q, byte_o[6:5]} == 44'(frame_i.value));
      command_in_one_byte :
      assert (!take_o || !held || frame_i.kind[2] || byte_o[6:5] == frame_i.kind[1:0]);
      idle_without_frames_only : assert (!idle_o || (!sends_q && !waits_i && !busy_i));
      a_frame_ends_with_its_take : assert (was_rst_q || !was_take_q || !sends_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (sends_q == was_sends_q && left_q == was_left_q));
      inv_left : assert (!sends_q || left_q <= 3'd5);
      inv_sent : assert (!sends_q || !held || sent_q + left_q + 3'd1 == length);
      inv_bits :
      assert (!sends_q || !held || !frame_i.kind[2] ||
              bits_q == 42'(({10'd0, frame_i.value} >> 2) >> (6'd7 * 6'(left_q))));
      reaches_six_bytes : cover (take_o && sent_q == 3'd5);
    end
  end

  // breaks quiet_from_reset: sends_q <= rst_i ? waits_i : next
  // breaks sends_into_a_free_line_only: send_o = sends_q
  // breaks begins_when_a_frame_waits: sends_q <= next && (sends_q || !busy_i)
  // breaks taken_with_the_last_byte: take_o = send_o && left_q <= 3'd1
  // breaks fewest_bytes: leads = leads == 3'd3 ? 3'd4 : leads
  // breaks last_byte_has_the_channel: byte_o = byte_o ^ 8'h01
  // breaks bytes_are_the_value: bits = {3'd0, frame_i.value} >> 1
  // breaks command_in_one_byte: byte_o = byte_o ^ 8'h20
  // breaks idle_without_frames_only: idle_o = !sends_q && !busy_i
  // breaks a_frame_ends_with_its_take: sends_q <= next || (take_o && waits_i && !rst_i)
  // breaks quiescent_is_honest: quiescent_o = sends_q || !waits_i

endmodule

bind serial2002_tx serial2002_tx_props u_serial2002_tx_props (.*);
