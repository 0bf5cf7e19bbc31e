// SPDX-License-Identifier: Apache-2.0
//
// Properties of rate_tick. A leap beyond next_o is an error of the caller: what it leads to is left
// out until the next reset.

module rate_tick_props
  import trammel_pkg::*;
#(
    parameter int unsigned Clock = 50_000_000,
    parameter int unsigned Rate = 4612
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic tick_o,
    input gap_t next_o,
    input logic quiescent_o,

    input logic        load,
    input logic [31:0] count,
    input logic [31:0] rest
);

  localparam int unsigned Whole = Clock / Rate;

  logic live_q = 1'b0;
  logic fair_q;  // no leap went beyond next_o
  logic was_rst_q, was_load_q, was_quiescent_q, was_tick_q, ticked_q;
  logic [31:0] was_rest_q, since_q;  // clocks since the last load
  gap_t was_next_q, was_leap_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    fair_q          <= rst_i || (fair_q && (leap_i == '0 || leap_i < next_o));
    was_rst_q       <= rst_i;
    was_load_q      <= !rst_i && load;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_tick_q      <= !rst_i && tick_o;
    was_rest_q      <= rest;
    was_next_q      <= next_o;
    was_leap_q      <= leap_i;
    since_q         <= rst_i || load ? 32'd1 : since_q + 32'd1 + 32'(leap_i);
    ticked_q        <= !rst_i && (ticked_q || load);
    if (live_q) begin
      begins_with_a_period : assert (!was_rst_q || (!tick_o && load));
      period_is_rounded_down_or_up :
      assert (!fair_q || !ticked_q || !tick_o || since_q == Whole || since_q == Whole + 32'd1);
      no_time_is_lost :
      assert (!was_load_q || count * Rate + rest == Clock + was_rest_q);
      tick_at_next : assert (!tick_o || next_o == '0);
      no_tick_within_next :
      assert (!fair_q || !was_quiescent_q || was_leap_q >= was_next_q || !tick_o ||
              was_next_q == was_leap_q + gap_t'(1));
      never_two_ticks : assert (!(was_tick_q && tick_o));
      quiescent_is_honest : assert (!was_quiescent_q || rest == was_rest_q);
      inv_rest : assert (rest < Rate);
      inv_count : assert (count <= Whole + 32'd1);
      inv_since :
      assert (!fair_q || !ticked_q || (count != '0 && since_q >= 32'd1 &&
              (since_q + count == Whole + 32'd1 || since_q + count == Whole + 32'd2)));
      inv_ticked : assert (was_rst_q || ticked_q);
      reaches_a_tick : cover (tick_o && ticked_q);
    end
  end

  // breaks begins_with_a_period: load = tick_o
  // breaks period_is_rounded_down_or_up: u_period.value_i = Width'(Whole) + Width'(carry) + Width'(carry)
  // breaks no_time_is_lost: rest_q <= load && !rst_i ? rest_q : next
  // breaks tick_at_next: next_o = next_o | gap_t'(tick_o)
  // breaks no_tick_within_next: tick_o = count == Width'(1) || count == Width'(3)
  // breaks never_two_ticks: tick_o = tick_o || count == Width'(Whole)
  // breaks quiescent_is_honest: quiescent_o = 1'b1

  // prove: set Clock=50 Rate=7
  // prove: set Clock=50000000 Rate=4612

endmodule

bind rate_tick rate_tick_props #(
    .Clock(Clock),
    .Rate (Rate)
) u_rate_tick_props (
    .*,
    .count(32'(count)),
    .rest (32'(rest_q))
);
