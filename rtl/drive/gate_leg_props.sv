// SPDX-License-Identifier: Apache-2.0
//
// Properties of gate_leg for any input. Clocks passed by leaps count; a turn-on is exact as long as
// no leap went beyond next_o, an error of the caller, and never too early in any case.

module gate_leg_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic       enable_i,
    input logic       trip_i,
    input logic [9:0] dead_time_i,

    input logic on_i,

    input logic hi_o,
    input logic lo_o,
    input gap_t next_o,
    input logic quiescent_o,

    input logic [9:0] count,
    input logic       allowed_q,
    input logic       side_q
);

  localparam logic [12:0] Long = 13'd2047;  // clocks; more than any dead time

  logic live_q = 1'b0;
  logic was_rst_q, was_hi_q, was_lo_q;
  logic told, told_q, want_q;  // gates allowed; at the previous edge, and the upper one wanted
  logic edge_e;  // a side is wanted that was not at the previous edge
  logic [9:0] dead_q;  // dead time of the latest edge E
  logic [12:0] passed, since_q;  // clocks passed by an edge; those since E
  logic exact_q;  // no leap beyond next_o since E
  logic time_up;
  logic was_quiescent_q, was_allowed_q, was_side_q;
  logic calm_q, calm;  // quiescent, and the inputs of the previous edge
  gap_t was_next_q;

  assign told    = enable_i && !trip_i;
  assign edge_e  = told && (!told_q || on_i != want_q);
  assign passed  = 13'(leap_i) + 13'd1;
  assign time_up = since_q >= 13'(dead_q) && since_q != '0;
  assign calm    = calm_q && !rst_i && told == told_q && on_i == want_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_hi_q        <= hi_o;
    was_lo_q        <= lo_o;
    told_q          <= !rst_i && told;
    want_q          <= on_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    calm_q          <= !rst_i && quiescent_o && (leap_i == '0 || leap_i < next_o);
    was_next_q      <= next_o - leap_i;
    was_allowed_q   <= allowed_q;
    was_side_q      <= side_q;
    if (edge_e) begin
      dead_q  <= dead_time_i;
      since_q <= '0;
      exact_q <= leap_i == '0;
    end else begin
      since_q <= since_q + passed >= Long ? Long : since_q + passed;
      exact_q <= exact_q && (leap_i == '0 || leap_i < next_o);
    end
    if (live_q) begin
      no_shoot_through : assert (!(hi_o && lo_o));
      off_from_reset : assert (!was_rst_q || (!hi_o && !lo_o));
      off_when_told : assert (told_q || (!hi_o && !lo_o));
      only_the_wanted_gate : assert ((!hi_o || want_q) && (!lo_o || !want_q));
      break_before_make : assert (rst_i || !(was_hi_q && lo_o) && !(was_lo_q && hi_o));
      dead_time_at_least : assert ((!hi_o && !lo_o) || time_up);
      dead_time_exactly : assert (!told_q || !exact_q || (hi_o || lo_o) == time_up);
      next_is_quiet :
      assert (!calm || was_next_q == '0 || was_next_q == 12'd1 || quiescent_o);
      quiescent_is_honest :
      assert (!was_quiescent_q || (hi_o == was_hi_q && lo_o == was_lo_q &&
                                   allowed_q == was_allowed_q && side_q == was_side_q));
      inv_wish : assert (allowed_q == told_q && (!told_q || side_q == want_q));
      inv_count :
      assert (!told_q || 13'(count) == (since_q < 13'(dead_q) ? 13'(dead_q) - since_q : '0) ||
              !exact_q);
      inv_count_late : assert (!told_q || 13'(count) + since_q >= 13'(dead_q));
      reaches_high : cover (hi_o);
      reaches_low : cover (lo_o && leap_i == '0);
      reaches_swap : cover (!was_hi_q && hi_o && dead_q == 10'd5 && exact_q && passed == 13'd1);
    end
  end

  // breaks no_shoot_through: lo_d = ready
  // breaks off_from_reset: hi_q <= rst_i ? on_i : next
  // breaks off_when_told: allowed = enable_i
  // breaks only_the_wanted_gate: hi_d = ready && !on_i
  // breaks break_before_make: ready = allowed && count <= 10'd1
  // breaks dead_time_at_least: ready = allowed && !change && count <= 10'd2
  // breaks dead_time_at_least: u_dead_time.load_i = allowed && change && on_i
  // breaks dead_time_exactly: ready = allowed && !change && count == 10'd0
  // breaks next_is_quiet: u_dead_time.leap_i = leap_i << 1
  // breaks quiescent_is_honest: quiescent_o = side_d == side_q && hi_d == hi_q && lo_d == lo_q

endmodule

bind gate_leg gate_leg_props u_gate_leg_props (.*);
