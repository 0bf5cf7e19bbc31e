// SPDX-License-Identifier: Apache-2.0
//
// Properties of edge_time for any input. clocks_q is the count that the block does without: clocks
// from the last edge to now, as long as the phase is what the ticks say (true_q).

module edge_time_props
  import trammel_pkg::*;
#(
    parameter int unsigned Period = 3125
) (
    input logic clk_i,
    input logic rst_i,

    input logic   tick_i,
    input phase_t phase_i,

    input logic [3:0] filter_i,

    input logic edge_i,
    input logic up_i,

    input logic [ 3:0] ticks_o,
    input logic [15:0] age_o,
    input logic        up_o,
    input logic        quiescent_o,

    input logic   seen_q,
    input logic   way_q,
    input phase_t phase_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_tick_q, was_quiet_q;
  logic any_q, after_q, up_q, was_up_q;  // an edge so far, one since the tick, the way of the last
  logic up_at_q;
  logic [3:0] was_ticks_q, filter_q;
  logic [15:0] was_age_q;
  logic [12:0] clock_q;    // since the tick, if true_q
  logic true_q;
  logic [16:0] clocks_q, at_tick_q;  // since the last edge
  logic [32:0] held, was_held_q;
  logic was_seen_q, was_true_q, was_full_q;
  phase_t was_phase_q;

  assign held = {seen_q, way_q, phase_q, up_o, ticks_o, age_o[12:0]};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q   <= rst_i;
    was_tick_q  <= tick_i && !rst_i;
    was_quiet_q <= quiescent_o && !rst_i;
    was_held_q  <= held;
    was_ticks_q <= ticks_o;
    was_age_q   <= age_o;
    was_up_q    <= up_o;
    filter_q    <= filter_i == '0 ? 4'd1 : filter_i;
    at_tick_q   <= clocks_q + 17'd1;
    up_at_q     <= up_q;
    clocks_q    <= edge_i ? '0 : clocks_q == '1 ? clocks_q : clocks_q + 17'd1;
    if (edge_i) up_q <= up_i;
    // The phase counts from the tick, which comes every Period clocks.
    clock_q <= tick_i ? 13'd1 : clock_q + 13'd1;
    if (rst_i) begin
      any_q   <= 1'b0;
      after_q <= 1'b0;
      true_q  <= 1'b0;
    end else begin
      if (edge_i) any_q <= 1'b1;
      if (tick_i) after_q <= edge_i;
      else if (edge_i) after_q <= 1'b1;
      if (tick_i) true_q <= edge_i ? phase_i == '0 : !any_q || true_q && clock_q == 13'(Period);
      else if (edge_i) true_q <= phase_i == clock_q && clock_q < 13'(Period);
      else if (clock_q >= 13'(Period)) true_q <= 1'b0;  // the tick is late
    end
    if (live_q) begin
      moves_at_a_tick_only :
      assert (was_tick_q || was_rst_q ||
          ticks_o == was_ticks_q && age_o == was_age_q && up_o == was_up_q);
      no_edge_yet_is_15_ticks : assert (!was_rst_q || ticks_o == '1);
      a_tick_after_an_edge_starts_at_0 :
      assert (!was_tick_q || !was_seen_q || ticks_o == '0 && up_o == up_at_q);
      ticks_count_up_to_15 :
      assert (!was_tick_q || was_seen_q ||
          ticks_o == (was_ticks_q == '1 ? was_ticks_q : was_ticks_q + 4'd1));
      age_starts_at_the_phase :
      assert (!was_tick_q || !was_seen_q ||
          age_o == 16'(Period) - 16'(was_phase_q) + 16'd2 + 16'(filter_q));
      age_grows_by_a_period :
      assert (!was_tick_q || was_seen_q ||
          age_o == (was_ticks_q == '1 ? was_age_q : was_age_q + 16'(Period)));
      age_is_the_clocks_since_the_edge :
      assert (!was_tick_q || !was_seen_q || !was_true_q || !was_full_q ||
          17'(age_o) == at_tick_q + 17'd2 + 17'(filter_q));
      quiescent_is_honest : assert (!was_quiet_q || held == was_held_q);

      inv_seen : assert (seen_q == after_q && (!seen_q || way_q == up_q));
      inv_clocks :
      assert (!seen_q || !true_q || clock_q <= 13'(Period) && phase_q < clock_q &&
          17'(phase_q) + clocks_q + 17'd1 == 17'(clock_q));

      reaches_an_old_edge : cover (ticks_o == 4'd2 && up_o);
    end
  end

  always_ff @(posedge clk_i) begin
    was_seen_q  <= seen_q;
    was_true_q  <= true_q;
    was_full_q  <= clock_q == 13'(Period);
    was_phase_q <= phase_q;
  end

  // breaks moves_at_a_tick_only: age_q <= edge_i && !rst_i ? 16'(phase_i) : next
  // breaks no_edge_yet_is_15_ticks: ticks_q <= rst_i ? '0 : next
  // breaks a_tick_after_an_edge_starts_at_0: up_q <= tick_i && seen_q && !rst_i ? up_i : next
  // breaks a_tick_after_an_edge_starts_at_0: ticks_q <= tick_i && seen_q && !rst_i ? 4'd1 : next
  // breaks ticks_count_up_to_15: moves = tick_i
  // breaks age_starts_at_the_phase, age_is_the_clocks_since_the_edge: passed = 16'(Period) + (seen_q ? 16'd2 + 16'(filter) : 16'd0)
  // breaks age_starts_at_the_phase: filter = filter_i
  // breaks age_grows_by_a_period: passed = 16'(Period) + 16'd3 + 16'(filter)
  // breaks age_is_the_clocks_since_the_edge: phase_q <= edge_i && tick_i ? phase_i + 13'd1 : next
  // breaks quiescent_is_honest: quiescent_o = !edge_i && !(tick_i && seen_q)

endmodule

bind edge_time edge_time_props #(.Period(Period)) u_edge_time_props (.*);

// prove: set Period=20
// prove: set Period=3125
