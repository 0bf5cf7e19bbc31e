// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_time; clocks passed by leaps count. After a leap beyond next_o, an error of
// the caller, distances are known again from the next sample on.

module lm628_time_props
  import trammel_pkg::*;
  import lm628_pkg::*;
#(
    parameter int unsigned Inc = 4
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic begin_o,
    input logic ready_o,
    input logic sample_o,
    input logic open_o,
    input logic commit_o,
    input gap_t next_o,
    input logic quiescent_o,

    input logic [16:0] count,
    input logic [ 2:0] state_q,
    input logic [$clog2(Inc)-1:0] rest_q
);

  localparam int unsigned Lead = 24 / Inc + 4;
  localparam logic [31:0] Routine = lm628_clocks(Inc, 8000) - 1;  // its last clock
  localparam logic [15:0] Sample = 16'(25 * 2048 / Inc);  // rounded down
  localparam logic [15:0] Commit = 16'(lm628_clocks(Inc, 400) - 1 - Lead);  // after the sample
  localparam logic [15:0] Opens  = 16'(32'(Commit) - Lm628Run);
  localparam logic [15:0] Closes = 16'(32'(Sample) - Lm628Run - 1 - Lead);
  localparam int unsigned Step = 25 * 2048 % Inc;

  logic live_q = 1'b0;
  logic was_rst_q, was_ready_q, was_begin_q, was_quiescent_q;
  logic [12:0] passed, passed_q;  // clocks passed by an edge: 1 + leap
  gap_t was_next_q;
  logic known_q;  // there was a sample, and no leap beyond next_o since
  logic [15:0] since_q;  // clocks since then
  logic begun_q;  // no leap beyond next_o since the reset
  logic [31:0] begun_since_q;  // clocks since then
  logic [2:0] was_state_q;
  logic [$clog2(Inc)-1:0] was_rest_q;
  logic event_now, longer;  // one of the pulses; the present sample is a clock longer

  assign passed    = 13'(leap_i) + 13'd1;
  assign event_now = begin_o || sample_o || commit_o;
  assign longer    = 32'(rest_q) + Step >= Inc;

  logic was_longer_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_ready_q     <= !rst_i && ready_o;
    was_begin_q     <= !rst_i && begin_o;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_next_q      <= next_o;
    passed_q        <= passed;
    was_state_q     <= state_q;
    was_rest_q      <= rest_q;
    if (open_o) was_longer_q <= longer;
    since_q <= sample_o ? 16'd1 : since_q + 16'(passed);
    known_q <= !rst_i && (known_q || sample_o) && (leap_i == '0 || leap_i < next_o);
    begun_since_q <= rst_i ? '0 : begun_since_q + 32'(passed);
    begun_q <= rst_i || (begun_q && (leap_i == '0 || leap_i < next_o));
    if (live_q) begin
      not_ready_from_reset : assert (!was_rst_q || (!ready_o && !open_o && !event_now));
      ready_after_its_pulse_only :
      assert (was_rst_q || ready_o == (was_ready_q || was_begin_q));
      routine_of_8000_ticks :
      assert (!begun_q || ready_o || begin_o == (begun_since_q == Routine));
      commit_at_tick_400 : assert (!known_q || commit_o == (since_q == Commit));
      sample_every_2048_ticks :
      assert (!known_q || sample_o == (since_q == Sample + 16'(was_longer_q)));
      open_where_a_command_ends_in_ticks_400_to_2047 :
      assert (!known_q || open_o == (since_q > Opens - 16'd1 && since_q < Closes));
      pulses_need_readiness : assert (!sample_o && !commit_o && !open_o || ready_o);
      no_pulse_within_next : assert (was_rst_q || passed_q > 13'(was_next_q) || !event_now);
      quiescent_is_honest :
      assert (!was_quiescent_q || (state_q == was_state_q && rest_q == was_rest_q));
      inv_state : assert (state_q <= 3'd5 && 32'(rest_q) < Inc);
      inv_start : assert (state_q != 3'd0 || (count == '0 && (!begun_q || begun_since_q == '0)));
      inv_reset : assert (!begun_q || state_q != 3'd1 || 32'(count) + begun_since_q == Routine);
      inv_rest : assert (Step != 0 || 32'(rest_q) == Inc - 1);
      inv_known : assert (!known_q || ready_o);
      inv_compute : assert (!known_q || state_q != 3'd3 || 16'(count) + since_q + 16'd1 == Opens);
      inv_settle : assert (!known_q || state_q != 3'd4 || 16'(count) + since_q == Commit);
      inv_open : assert (!known_q || state_q != 3'd5 || 16'(count) + since_q + 16'd1 == Closes);
      inv_before :
      assert (!known_q || state_q != 3'd2 || 16'(count) + since_q == Sample + 16'(was_longer_q));
      reaches_commit : cover (!rst_i && commit_o && !was_rst_q);
    end
  end

  // breaks not_ready_from_reset: state_q <= rst_i ? StOpen : next
  // breaks ready_after_its_pulse_only: begin_o = state_q == StStart && last
  // breaks routine_of_8000_ticks: Reset = Reset - 17'd1
  // breaks commit_at_tick_400: Settle = Settle + 17'd1
  // breaks sample_every_2048_ticks: Open = Open + 17'd1
  // breaks open_where_a_command_ends_in_ticks_400_to_2047: Compute = Compute - 17'd1
  // breaks pulses_need_readiness: sample_o = state_q <= StBefore && last
  // breaks no_pulse_within_next: u_part.leap_i = leap_i << 1
  // breaks quiescent_is_honest: quiescent_o = !commit_o

  // prove: set Inc=10
  // prove: set Inc=4
  // prove: set Inc=3

endmodule

bind lm628_time lm628_time_props #(.Inc(Inc)) u_lm628_time_props (
    .*,
    .state_q(3'(state_q))
);
