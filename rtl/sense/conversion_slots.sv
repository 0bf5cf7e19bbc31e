// SPDX-License-Identifier: Apache-2.0
//
// Whose conversion is next, and what was converted (Brochier 2006, C.1 and C.18). The observer and
// the requester take turns: each has as many conversions in a row as it has slots, and one that
// asks for nothing uses none. The requester's channels go lowest first; a conversion of a channel
// that it asked for serves it, whoever it was made for.
//
// At pick_i one of observer_o and requester_o is high, or none: at the same clock.

module conversion_slots (
    input logic clk_i,
    input logic rst_i,

    input logic       pick_i,
    input logic [7:0] observer_slots_i,
    input logic [7:0] requester_slots_i,
    input logic       wants_i,           // the observer has something to ask for
    input logic [6:0] ask_i,             // by channel: pulses

    input logic       done_i,
    input logic [2:0] channel_i,
    input logic [9:0] code_i,

    output logic       observer_o,
    output logic       requester_o,
    output logic [2:0] channel_o,       // of the requester
    output logic [6:0] pending_o,
    output logic       served_o,        // a requested conversion is done, at this edge
    output logic [9:0] a_o,
    output logic [9:0] a_dot_o,
    output logic [9:0] b_o,
    output logic [9:0] b_dot_o,
    output logic [9:0] current_o,
    output logic       quiescent_o
);

  logic requester_q;  // whose turn it is
  logic [7:0] left_q;  // of it
  logic [6:0] pending_q, done_mask;
  logic [9:0] code_q[5];

  logic requests, wants_now, wants_other, may_now, may_other, take, change;
  logic [7:0] slots_now, slots_other;

  assign requests    = pending_q != '0;
  assign wants_now   = requester_q ? requests : wants_i;
  assign wants_other = requester_q ? wants_i : requests;
  assign slots_now   = requester_q ? requester_slots_i : observer_slots_i;
  assign slots_other = requester_q ? observer_slots_i : requester_slots_i;
  assign may_other   = wants_other && slots_other != '0;
  assign may_now     = wants_now && (left_q != '0 || slots_now != '0);
  // It goes on while it has slots; then the other one, then itself again.
  assign take        = pick_i && (may_other || may_now);
  assign change      = may_other && !(wants_now && left_q != '0);
  assign observer_o  = take && change == requester_q;
  assign requester_o = take && change != requester_q;

  always_comb begin
    channel_o = 3'd6;
    for (int k = 5; k >= 0; k--) if (pending_q[k]) channel_o = 3'(k);
    done_mask = '0;
    if (done_i && channel_i != 3'd7) done_mask = 7'd1 << channel_i;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      requester_q <= 1'b1;
      left_q      <= '0;
      pending_q   <= '0;
      for (int k = 0; k < 5; k++) code_q[k] <= '0;
    end else begin
      pending_q <= (pending_q & ~done_mask) | ask_i;
      if (pick_i) begin
        requester_q <= take ? requester_q != change : 1'b1;
        if (!take) left_q <= '0;
        else if (change) left_q <= slots_other - 8'd1;
        else if (left_q != '0) left_q <= left_q - 8'd1;
        else left_q <= slots_now - 8'd1;
      end
      for (int k = 0; k < 4; k++) if (done_mask[k]) code_q[k] <= code_i;
      if (done_mask[6]) code_q[4] <= code_i;
    end
  end

  assign pending_o = pending_q;
  assign served_o = (pending_q & done_mask) != '0;
  assign a_o = code_q[0];
  assign a_dot_o = code_q[1];
  assign b_o = code_q[2];
  assign b_dot_o = code_q[3];
  assign current_o = code_q[4];
  assign quiescent_o = !pick_i && !done_i && ask_i == '0;

endmodule
