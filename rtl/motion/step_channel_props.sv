// SPDX-License-Identifier: Apache-2.0
//
// Properties of step_channel for any input, leaps included: ticks_i may be any number.

module step_channel_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,
    input logic half_i,
    input gap_t ticks_i,
    input gap_t next_tick_i,
    input gap_t next_half_i,

    input logic        count_write_i,
    input logic [15:0] count_i,
    input logic        status_write_i,
    input logic [15:0] status_i,
    input logic        grant_i,

    input logic        step_o,
    input logic        forward_o,
    input logic        flush_o,
    input logic [15:0] count_o,
    input logic [15:0] status_o,
    input logic        irq_o,
    input gap_t        next_o,
    input logic        quiescent_o,

    input logic        low_q,
    input logic        high_q,
    input logic        buf_q,
    input logic [11:0] divider_q,
    input logic        enable_q,
    input logic        done_q,
    input logic        step_q,
    input logic        over
);

  localparam logic [15:0] Terminal = '1;

  logic live_q = 1'b0;
  logic was_rst_q, was_busy_q, was_step_q, was_latch_q, was_done_q, was_forward_q, was_low_q;
  logic was_high_q, was_buf_q, was_grant_q, was_half_q, was_tick_q, was_quiescent_q;
  logic writes_q, counts_q, was_irq_q;
  logic [15:0] was_count_q, written_q, counted_q;
  logic [11:0] was_divider_q, was_rate_q;
  logic busy, accepted, toward, begins, ends;
  gap_t was_ticks_q;
  logic [34:0] held, was_held_q;

  assign busy     = status_o[12];
  // What the edge before did with a write of the status word that says start.
  assign accepted = writes_q && written_q[12] && !was_rst_q;
  assign toward   = was_busy_q && (was_forward_q ? was_high_q : was_low_q);
  assign begins   = step_o && !was_step_q;
  assign ends     = !busy && was_busy_q && !writes_q && !was_rst_q;
  assign held     = {status_o, count_o, flush_o, done_q, step_o};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_busy_q      <= !rst_i && busy;
    was_step_q      <= !rst_i && step_o;
    was_latch_q     <= !rst_i && flush_o;
    was_done_q      <= !rst_i && done_q;
    was_irq_q       <= !rst_i && irq_o;
    was_forward_q   <= forward_o;
    was_low_q       <= low_q;
    was_high_q      <= high_q;
    was_buf_q       <= buf_q;
    was_grant_q     <= grant_i;
    was_half_q      <= half_i;
    was_tick_q      <= tick_i;
    was_quiescent_q <= !rst_i && quiescent_o;
    writes_q        <= !rst_i && status_write_i;
    counts_q        <= !rst_i && count_write_i;
    written_q       <= status_i;
    counted_q       <= count_i;
    was_count_q     <= count_o;
    was_divider_q   <= divider_q;
    was_rate_q      <= status_o[11:0];
    was_ticks_q     <= ticks_i;
    was_held_q      <= held;
    if (live_q) begin
      at_rest_from_reset :
      assert (!was_rst_q || (count_o == Terminal && !busy && !step_o && !flush_o && !irq_o &&
              status_o[11:0] == '0 && !status_o[13] && !status_o[15]));
      rate_is_as_written :
      assert (was_rst_q || status_o[11:0] == (writes_q ? written_q[11:0] : was_rate_q));
      direction_and_enable_as_written :
      assert (!writes_q || {enable_q, forward_o} == {written_q[15], written_q[13]});
      bit_14_is_a_switch : assert (status_o[14] == (low_q || high_q));
      a_step_needs_busy : assert (!begins || was_busy_q);
      no_step_at_the_terminal_count : assert (!begins || was_count_q != Terminal);
      no_step_toward_a_closed_switch : assert (!begins || !toward);
      a_step_needs_a_clear_latch : assert (!begins || !was_latch_q);
      a_step_at_a_tick : assert (!begins || was_tick_q);
      every_step_counts_one :
      assert (counts_q || was_rst_q || (was_step_q && was_tick_q) ||
              count_o == was_count_q + 16'(begins));
      count_is_as_written : assert (!counts_q || count_o == counted_q);
      divider_counts_ticks :
      assert (was_rst_q || writes_q || !was_busy_q || was_count_q == Terminal ||
              divider_q == (was_tick_q && was_divider_q == '1 ? was_rate_q
                                                              : was_divider_q + was_ticks_q));
      pulse_until_half_a_period : assert (was_rst_q || !was_step_q || was_half_q || step_o);
      start_presets_the_divider :
      assert (!accepted || was_busy_q || was_latch_q || divider_q == written_q[11:0]);
      start_starts :
      assert (!accepted || was_busy_q || was_latch_q || count_o == Terminal || busy);
      latch_refuses_both_directions :
      assert (!was_latch_q || was_rst_q || (writes_q && written_q[14]) || !busy);
      latch_until_reset :
      assert (!was_latch_q || was_rst_q || (writes_q && written_q[14]) || flush_o);
      reset_clears_the_latch : assert (!writes_q || !written_q[14] || !flush_o);
      switch_trips : assert (!toward || writes_q || was_rst_q || (!busy && flush_o && done_q));
      latch_by_a_switch_only : assert (!flush_o || was_latch_q || toward);
      ends_at_the_terminal_count_or_a_switch :
      assert (!ends || (done_q && (toward || (was_count_q == Terminal && !was_step_q))));
      ends_when_the_buffer_is_empty : assert (!ends || toward || !was_buf_q);
      stop_is_silent :
      assert (!writes_q || written_q[12] ||
              (!busy && (!done_q || was_done_q || toward || was_count_q == Terminal)));
      start_with_nothing_to_do_is_done :
      assert (!accepted || was_busy_q || was_latch_q || count_o != Terminal || (done_q && !busy));
      request_needs_enable : assert (!irq_o || enable_q);
      request_until_taken :
      assert (!was_irq_q || was_rst_q || was_grant_q || writes_q || irq_o);
      grant_takes_the_request :
      assert (!was_grant_q || !was_done_q || was_busy_q || writes_q || !irq_o);
      quiescent_is_honest :
      assert (!was_quiescent_q || was_tick_q || was_half_q || held == was_held_q);
      step_at_next : assert (!over || next_tick_i != '0 || next_o == '0);
      pulse_ends_at_next :
      assert (!(step_q && half_i) || next_half_i != '0 || next_o == '0);
      inv_latch : assert (!(flush_o && busy));
      reaches_a_step : cover (begins);
      reaches_an_end : cover (ends && !toward);
      reaches_a_trip : cover (ends && toward);
      reaches_a_wait_for_the_buffer : cover (busy && count_o == Terminal && buf_q && !step_o);
    end
  end

  // breaks at_rest_from_reset: count_q <= rst_i ? '0 : next
  // breaks rate_is_as_written: rate_d = over ? rate_d + 12'd1 : rate_d
  // breaks direction_and_enable_as_written: forward_d = busy_q ? forward_q : forward_d
  // breaks bit_14_is_a_switch: status_o = {enable_q, latch_q, forward_q, busy_q, rate_q}
  // breaks a_step_needs_busy: moving = count_q != Terminal
  // breaks no_step_at_the_terminal_count: moving = busy_q
  // breaks no_step_toward_a_closed_switch: trip = busy_q && (forward_q ? high_q && low_q : low_q)
  // breaks a_step_needs_a_clear_latch: busy_d = busy_d || (trip && forward_q)
  // breaks a_step_at_a_tick: over = moving && divider_q == '1
  // breaks every_step_counts_one: count_d = over && forward_q && !count_write_i ? count_q + 16'd2 : count_d
  // breaks count_is_as_written: count_d = over && count_write_i ? count_i + 16'd1 : count_d
  // breaks divider_counts_ticks: divider_d = over ? '0 : divider_d
  // breaks pulse_until_half_a_period: step_d = step_d && !(step_q && tick_i)
  // breaks start_presets_the_divider: divider_d = status_write_i ? divider_q : divider_d
  // breaks start_starts: busy_d = busy_d && (busy_q || forward_q)
  // breaks latch_refuses_both_directions: busy_d = busy_d || (status_write_i && status_i[12] && !status_i[13] && latch_q)
  // breaks latch_until_reset: latch_d = latch_d && !status_write_i
  // breaks reset_clears_the_latch: latch_d = latch_d || latch_q
  // breaks switch_trips: done_d = done_d && !(trip && forward_q)
  // breaks latch_by_a_switch_only: latch_d = latch_d || (status_write_i && status_i[13:12] == 2'd3 && low_q)
  // breaks ends_at_the_terminal_count_or_a_switch: ended = busy_q && !moving && !buf_q
  // breaks ends_when_the_buffer_is_empty: ended = busy_q && !moving && !step_q
  // breaks stop_is_silent: busy_d = busy_d || (status_write_i && busy_q && moving)
  // breaks start_with_nothing_to_do_is_done: done_d = done_d && !(status_write_i && forward_q)
  // breaks request_needs_enable: irq_o = done_q
  // breaks request_until_taken: done_d = done_d && !(count_write_i && !trip)
  // breaks grant_takes_the_request: done_d = done_d || (done_q && low_q)
  // breaks quiescent_is_honest: quiescent_o = quiescent_o || ended
  // breaks step_at_next: to_step = to_step + 32'(count_q[0])
  // breaks pulse_ends_at_next: next_o = moving ? gap_t'(to_step[11:0]) : GapMax

endmodule

bind step_channel step_channel_props u_step_channel_props (.*);
