// SPDX-License-Identifier: Apache-2.0
//
// Properties of serial2002_rx for any bytes and gaps; clocks passed by leaps count. A leap beyond
// next_o is an error of the caller, and so is one in which a byte comes: what these lead to is left
// out until the next reset.

module serial2002_rx_props
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
    input logic       valid_o,
    input frame_t     frame_o,
    input logic       malformed_o,
    input gap_t       next_o,
    input logic       quiescent_o,

    input logic [ 2:0] leads_q,
    input logic [29:0] value_q,
    input logic        wrong_q,
    input logic [GapWidth-1:0] gap_count
);

  typedef logic [GapWidth:0] wide_t;

  logic live_q = 1'b0;
  logic was_rst_q, was_end_q, was_good_q, was_quiescent_q, was_silent_q, spoiled_q, long_q;
  logic fair_q, silent;
  logic [GapWidth-1:0] within_q;  // clocks from the last byte to the next, longest; 0: any
  wide_t since_q;  // that byte
  logic [2:0] leading_q;   // leading bytes so far, 6 at most
  logic [41:0] bits_q;     // of them
  logic [6:0] was_byte_q;
  logic [2:0] was_leading_q;
  logic [31:0] was_value_q;
  frame_t was_frame_q;
  logic [1:0] was_pulses_q;
  logic over;

  // More than 32 bits with the two of the last byte.
  assign over = leading_q > 3'd5 || (leading_q == 3'd5 && bits_q[34:30] != '0);

  assign silent = leading_q != '0 && within_q != '0 && since_q == wide_t'(within_q) && !valid_i;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    fair_q          <= rst_i || (fair_q && (leap_i == '0 || (leap_i < next_o && quiescent_o)));
    was_silent_q    <= !rst_i && silent;
    if (rst_i || valid_i) begin
      within_q <= gap_i;
      since_q  <= wide_t'(1);
    end else if (leading_q != '0 && within_q != '0) begin
      since_q <= since_q + wide_t'(1) + wide_t'(leap_i);
    end
    was_rst_q       <= rst_i;
    was_end_q       <= !rst_i && valid_i && !byte_i[7];
    was_good_q      <= !spoiled_q && !bad_i && !over && !long_q;
    was_byte_q      <= byte_i[6:0];
    was_leading_q   <= leading_q;
    was_value_q     <= {bits_q[29:0], byte_i[6:5]};
    was_frame_q     <= frame_o;
    was_pulses_q    <= {valid_o, malformed_o};
    was_quiescent_q <= !rst_i && quiescent_o;
    if (rst_i || silent || (valid_i && !byte_i[7])) begin
      leading_q <= '0;
      bits_q    <= '0;
      spoiled_q <= 1'b0;
      long_q    <= 1'b0;
    end else if (valid_i) begin
      if (leading_q != 3'd6) leading_q <= leading_q + 3'd1;
      bits_q    <= {bits_q[34:0], byte_i[6:0]};
      spoiled_q <= spoiled_q || bad_i;
      long_q    <= long_q || over;
    end
    if (live_q && fair_q) begin
      nothing_from_reset : assert (!was_rst_q || (!valid_o && !malformed_o));
      a_frame_for_each_good_end : assert (valid_o == (was_end_q && was_good_q));
      an_error_for_each_bad_end_and_gap :
      assert (malformed_o == ((was_end_q && !was_good_q) || was_silent_q));
      value_of_all_its_bits :
      assert (!valid_o || frame_o.value == (was_leading_q == '0 ? '0 : was_value_q));
      kind_by_the_number_of_bytes :
      assert (!valid_o || frame_o.kind == (was_leading_q == '0 ? {1'b0, was_byte_q[6:5]} :
                                           KindValue));
      channel_of_the_last_byte : assert (!valid_o || frame_o.channel == was_byte_q[4:0]);
      frame_stays_until_the_next : assert (was_rst_q || was_end_q || frame_o == was_frame_q);
      inv_since :
      assert (leading_q == '0 || within_q == '0 || since_q <= wide_t'(within_q));
      quiescent_is_honest :
      assert (!was_quiescent_q || ({valid_o, malformed_o} == was_pulses_q &&
              frame_o == was_frame_q));
      inv_gap :
      assert (leading_q == '0 || within_q == '0 ? gap_count == '0 :
              wide_t'(gap_count) + since_q == wide_t'(within_q) + wide_t'(1));
      inv_leads : assert (leads_q == (leading_q == 3'd6 ? 3'd5 : leading_q));
      inv_value : assert (value_q == bits_q[29:0]);
      inv_wrong : assert (wrong_q == (spoiled_q || long_q || over));
      inv_bits : assert (leading_q >= 3'd6 || (bits_q >> (6'd7 * 6'(leading_q))) == '0);
      inv_long : assert (!long_q || leading_q >= 3'd6);
      reaches_a_gap : cover (was_silent_q);
      reaches_32_bits : cover (valid_o && frame_o.value == 32'hFFFF_FFFF);
    end
  end

  // breaks nothing_from_reset: valid_q <= rst_i ? valid_i : next
  // breaks a_frame_for_each_good_end: over = byte_i[7] && leads_q == 3'd4
  // breaks an_error_for_each_bad_end_and_gap: wrong = wrong_q || over
  // breaks an_error_for_each_bad_end_and_gap: silent = gap_count == GapWidth'(2) && !valid_i
  // breaks value_of_all_its_bits: value_q <= next & 30'h0FFFFFFF
  // breaks kind_by_the_number_of_bytes: frame_q <= valid_i && !byte_i[7] && !rst_i ? {1'b0, byte_i[6:5], frame.channel, frame.value} : next
  // breaks channel_of_the_last_byte: frame_q <= next | frame_t'(valid_i && !rst_i ? 40'd1 << 32 : 40'd0)
  // breaks frame_stays_until_the_next: frame_q <= valid_i && !rst_i ? frame : next
  // breaks quiescent_is_honest: quiescent_o = !valid_i

  // prove: set GapWidth=4

endmodule

bind serial2002_rx serial2002_rx_props #(
    .GapWidth(GapWidth)
) u_serial2002_rx_props (.*);
