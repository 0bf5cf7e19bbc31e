// SPDX-License-Identifier: Apache-2.0
//
// Properties of step_clock; clocks passed by leaps count. Time is counted beside the block in units
// of which a clock has Inc and a period Mod, from reset on.

module step_clock_props
  import trammel_pkg::*;
#(
    parameter int unsigned Inc = 3,
    parameter int unsigned Mod = 625,
    parameter int unsigned Width = 10
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic tick_o,
    input logic half_o,
    input gap_t ticks_o,
    input gap_t next_tick_o,
    input gap_t next_half_o,
    input logic quiescent_o,

    input logic [Width-1:0] acc_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_plain_q, was_tick_q, was_half_q;
  logic [Width-1:0] was_acc_q;
  gap_t was_next_tick_q, was_next_half_q, was_leap_q, was_ticks_q;
  logic [9:0] since_q;  // clocks since the last tick
  logic known_q;  // no leap has passed one since

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_plain_q     <= !rst_i && leap_i == '0;
    was_tick_q      <= tick_o;
    was_half_q      <= half_o;
    was_next_tick_q <= next_tick_o;
    was_next_half_q <= next_half_o;
    was_leap_q      <= leap_i;
    was_ticks_q     <= ticks_o;
    was_acc_q       <= acc_q;
    since_q         <= rst_i || tick_o ? 10'd1 : since_q + 10'd1 + 10'(leap_i);
    known_q         <= rst_i || (tick_o ? leap_i == '0 : known_q && ticks_o == '0);
    if (live_q) begin
      starts_a_period : assert (!was_rst_q || (next_tick_o == gap_t'((Mod - 1) / Inc) && !tick_o));
      one_tick_or_none_without_a_leap : assert (leap_i != '0 || ticks_o == gap_t'(tick_o));
      a_tick_every_period :
      assert (!known_q || (since_q <= 10'((Mod + Inc - 1) / Inc) &&
              (!tick_o || since_q >= 10'(Mod / Inc))));
      half_between_ticks : assert (!(half_o && tick_o));
      ticks_and_phase_are_the_time :
      assert (was_rst_q || 32'(acc_q) + 32'(was_ticks_q) * Mod ==
              32'(was_acc_q) + Inc * (32'(was_leap_q) + 32'd1));
      no_tick_before_next : assert (ticks_o == '0 || next_tick_o <= leap_i);
      tick_at_next : assert (tick_o == (next_tick_o == '0));
      next_tick_falls_by_one :
      assert (!was_plain_q || was_tick_q || next_tick_o == was_next_tick_q - gap_t'(1));
      half_at_next : assert (!half_o || next_half_o == '0);
      next_half_falls_by_one :
      assert (!was_plain_q || was_half_q || was_tick_q ||
              next_half_o == was_next_half_q - gap_t'(1));
      never_in_the_way : assert (quiescent_o);
      inv_acc : assert (32'(acc_q) < Mod);
      inv_since : assert (!known_q || (32'(acc_q) >= Inc * (32'(since_q) - 32'd1) &&
                                       32'(acc_q) < Inc * 32'(since_q)));
      reaches_a_tick : cover (tick_o && known_q && !was_rst_q);
      reaches_many_ticks : cover (ticks_o > gap_t'(5));
    end
  end

  // breaks starts_a_period: acc_q <= rst_i ? Width'(1) << 3 : next
  // breaks one_tick_or_none_without_a_leap: ticks_o = ticks_o | gap_t'(half_o)
  // breaks a_tick_every_period, next_tick_falls_by_one: acc_d = half_o && leap_i == '0 ? acc_d + Width'(4 * Inc) : acc_d
  // breaks half_between_ticks: first = 1'b1
  // breaks ticks_and_phase_are_the_time: ticks_o = ticks_o - gap_t'(leap_i[11] && ticks_o > 12'd19)
  // breaks no_tick_before_next: next_tick_o = next_tick_o + gap_t'(leap_i == 12'd1)
  // breaks tick_at_next: tick_o = acc >= Wide'(Mod - Inc) + Wide'(1)
  // breaks half_at_next: next_half_o = next_half_o + gap_t'(1)
  // breaks next_half_falls_by_one: next_half_o = next_half_o & ~gap_t'(3)
  // breaks never_in_the_way: quiescent_o = !tick_o

  // prove: leap inv_acc

endmodule

bind step_clock step_clock_props #(
    .Inc  (Inc),
    .Mod  (Mod),
    .Width($clog2(Mod))
) u_step_clock_props (.*);
