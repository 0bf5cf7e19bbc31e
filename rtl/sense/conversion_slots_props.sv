// SPDX-License-Identifier: Apache-2.0
//
// Properties of conversion_slots for any input.

module conversion_slots_props (
    input logic clk_i,
    input logic rst_i,

    input logic       pick_i,
    input logic [7:0] observer_slots_i,
    input logic [7:0] requester_slots_i,
    input logic       wants_i,
    input logic [6:0] ask_i,
    input logic       done_i,
    input logic [2:0] channel_i,
    input logic [9:0] code_i,

    input logic       observer_o,
    input logic       requester_o,
    input logic [2:0] channel_o,
    input logic [6:0] pending_o,
    input logic       served_o,
    input logic [9:0] a_o,
    input logic [9:0] a_dot_o,
    input logic [9:0] b_o,
    input logic [9:0] b_dot_o,
    input logic [9:0] current_o,
    input logic       quiescent_o,

    input logic       requester_q,
    input logic [7:0] left_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_quiescent_q, observer_q, was_done_q;
  logic [6:0] asked_q, mask;
  logic [2:0] was_channel_q;
  logic [9:0] was_code_q;
  logic [49:0] codes, was_codes_q;
  logic [8:0] was_turn_q;

  assign codes = {a_o, a_dot_o, b_o, b_dot_o, current_o};
  assign mask  = done_i && channel_i != 3'd7 ? 7'd1 << channel_i : '0;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_done_q      <= !rst_i && done_i;
    was_channel_q   <= channel_i;
    was_code_q      <= code_i;
    was_codes_q     <= codes;
    was_turn_q      <= {requester_q, left_q};
    asked_q         <= rst_i ? '0 : (asked_q & ~mask) | ask_i;
    observer_q      <= observer_o;
    if (live_q) begin
      nothing_asked_from_reset : assert (!was_rst_q || (pending_o == '0 && codes == '0));
      never_both : assert (!(observer_o && requester_o));
      a_turn_at_a_pick_only : assert (pick_i || (!observer_o && !requester_o));
      only_who_wants : assert ((!observer_o || wants_i) && (!requester_o || pending_o != '0));
      who_wants_and_has_slots_waits_for_no_idle_one :
      assert (!pick_i || !wants_i || observer_slots_i == '0 || observer_o || requester_o);
      requests_wait_for_no_idle_observer :
      assert (!pick_i || pending_o == '0 || requester_slots_i == '0 || observer_o || requester_o);
      lowest_channel_first :
      assert (pending_o == '0 || (pending_o[channel_o] &&
              (pending_o & ((7'd1 << channel_o) - 7'd1)) == '0));
      asked_until_converted : assert (was_rst_q || pending_o == asked_q);
      served_by_any_conversion : assert (served_o == ((pending_o & mask) != '0));
      code_of_the_channel :
      assert (was_rst_q || !was_done_q || ((was_channel_q != 3'd0 || a_o == was_code_q) &&
              (was_channel_q != 3'd1 || a_dot_o == was_code_q) &&
              (was_channel_q != 3'd2 || b_o == was_code_q) &&
              (was_channel_q != 3'd3 || b_dot_o == was_code_q) &&
              (was_channel_q != 3'd6 || current_o == was_code_q)));
      codes_hold : assert (was_rst_q || was_done_q || codes == was_codes_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (pending_o == asked_q && codes == was_codes_q &&
              {requester_q, left_q} == was_turn_q));
      inv_asked : assert (was_rst_q || asked_q == pending_o);
      reaches_the_requester_between : cover (observer_q && requester_o && wants_i);
    end
  end

  // breaks nothing_asked_from_reset: pending_q <= next | (rst_i ? 7'd1 : 7'd0)
  // breaks never_both: requester_o = take
  // breaks a_turn_at_a_pick_only: take = may_other || may_now
  // breaks only_who_wants: wants_other = 1'b1
  // breaks who_wants_and_has_slots_waits_for_no_idle_one: may_now = wants_now && left_q != '0
  // breaks requests_wait_for_no_idle_observer: may_other = wants_other && slots_other > 8'd1
  // breaks lowest_channel_first: channel_o = channel_o | 3'd1
  // breaks asked_until_converted: pending_q <= done_i && !rst_i ? ask_i : next
  // breaks served_by_any_conversion: served_o = done_i && pending_q[channel_o]
  // breaks code_of_the_channel: done_mask = done_i && channel_i == 3'd6 ? '0 : done_mask
  // breaks codes_hold: done_mask = done_mask | 7'(pick_i)
  // breaks quiescent_is_honest: quiescent_o = !done_i && ask_i == '0

endmodule

bind conversion_slots conversion_slots_props u_conversion_slots_props (.*);
