// SPDX-License-Identifier: Apache-2.0
//
// Properties of frame_fifo for any input. One frame of any place in the order is followed.

module frame_fifo_props
  import serial2002_pkg::*;
#(
    parameter int unsigned Depth = 8
) (
    input logic clk_i,
    input logic rst_i,

    input logic                   push_i,
    input frame_t                 frame_i,
    input logic                   pop_i,
    input frame_t                 frame_o,
    input logic                   waits_o,
    input logic [$clog2(Depth):0] room_o,
    input logic [15:0]            lost_o,
    input logic                   quiescent_o,

    input logic [$clog2(Depth):0] head,
    input logic [$clog2(Depth):0] tail,
    input frame_t                 frames[Depth]
);

  localparam int unsigned Bits = $clog2(Depth);
  typedef logic [Bits:0] number_t;

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, was_pop_q, was_waits_q, was_push_q;
  number_t held_q, was_room_q;  // frames that wait
  frame_t was_frame_q, was_pushed_q;
  logic [15:0] lost_q;

  // A frame that was pushed when `ahead_q` others waited, until it shows.
  logic follows_q;
  number_t ahead_q;
  frame_t followed_q;
  logic accepted;
  logic [Bits-1:0] place;

  assign place    = Bits'(head + ahead_q);
  assign accepted = push_i && held_q != number_t'(Depth);

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_pop_q       <= !rst_i && pop_i;
    was_push_q      <= !rst_i && push_i;
    was_waits_q     <= waits_o;
    was_room_q      <= room_o;
    was_frame_q     <= frame_o;
    was_pushed_q    <= frame_i;
    held_q          <= rst_i ? '0 : held_q + number_t'(accepted) -
        number_t'(pop_i && held_q != '0);
    if (rst_i) lost_q <= '0;
    else if (push_i && !accepted && lost_q != '1) lost_q <= lost_q + 16'd1;
    if (rst_i) begin
      follows_q <= 1'b0;
    end else if (!follows_q) begin
      follows_q  <= accepted;
      ahead_q    <= held_q - number_t'(pop_i && held_q != '0);
      followed_q <= frame_i;
    end else if (pop_i) begin
      if (ahead_q == '0) follows_q <= 1'b0;
      else ahead_q <= ahead_q - number_t'(1);
    end
    if (live_q) begin
      empty_from_reset : assert (!was_rst_q || (!waits_o && room_o == number_t'(Depth)));
      room_is_what_is_not_held : assert (room_o == number_t'(Depth) - held_q);
      waits_while_held : assert (waits_o == (held_q != '0));
      frames_in_their_order : assert (!follows_q || ahead_q != '0 || frame_o == followed_q);
      oldest_stays_until_popped :
      assert (was_rst_q || !was_waits_q || was_pop_q || frame_o == was_frame_q);
      shows_nothing_when_empty : assert (waits_o || frame_o == '0);
      refused_are_counted : assert (lost_o == lost_q);
      a_frame_into_an_empty_one_shows :
      assert (was_rst_q || was_waits_q || !was_push_q || frame_o == was_pushed_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (frame_o == was_frame_q && room_o == was_room_q));
      inv_held : assert (held_q <= number_t'(Depth));
      inv_pointers : assert (tail - head == held_q);
      inv_ahead : assert (!follows_q || (ahead_q < held_q && frames[place] == followed_q));
      reaches_full : cover (room_o == '0);
    end
  end

  // breaks empty_from_reset: tail_q <= rst_i ? head_q : next
  // breaks room_is_what_is_not_held: room_o = room_o - (Bits + 1)'(waits_o)
  // breaks waits_while_held: waits_o = head_q[0] != tail_q[0]
  // breaks frames_in_their_order: frame_o = waits_o ? frames[tail_q[Bits-1:0] - Bits'(1)] : '0
  // breaks oldest_stays_until_popped: head_q <= next + (Bits + 1)'(push_i && full && !rst_i)
  // breaks shows_nothing_when_empty: frame_o = frames[head_q[Bits-1:0]]
  // breaks refused_are_counted: lost_q <= push_i && !rst_i ? lost_q + 16'd1 : next
  // breaks a_frame_into_an_empty_one_shows: frame_o = {frame_o.kind, frame_o.channel, frame_o.value & 32'h7FFFFFFF}
  // breaks quiescent_is_honest: quiescent_o = !push_i

  // prove: set Depth=4

endmodule

bind frame_fifo frame_fifo_props #(.Depth(Depth)) u_frame_fifo_props (
    .*,
    .head(head_q),
    .tail(tail_q)
);
