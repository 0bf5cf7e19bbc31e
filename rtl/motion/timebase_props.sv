// SPDX-License-Identifier: Apache-2.0
//
// Properties of timebase; clocks passed by leaps count. After a leap beyond next_o, an error of the
// caller, the distance of ticks is known again from the next tick on.

module timebase_props
  import trammel_pkg::*;
#(
    parameter int unsigned ClockHz = 50_000_000
) (
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input carrier_t   carrier_i,
    input logic [1:0] rate_i,
    input logic [7:0] irq_period_i,

    input carrier_t    carrier_o,
    input phase_t      phase_o,
    input phase_t      rest_o,
    input logic        tick_cur_o,
    input logic        tick_pos_o,
    input logic        tick_irq_o,
    input logic [31:0] tick_count_o,
    input gap_t        next_o,
    input logic        quiescent_o,

    input phase_t     count,
    input logic [5:0] cur_q,
    input logic [7:0] irq_q
);

  localparam periods_t Periods = pwm_periods(ClockHz);

  logic live_q = 1'b0;
  logic was_rst_q, was_cur_q, was_pos_q, was_quiescent_q;
  logic [12:0] passed, passed_q;  // clocks passed by an edge: 1 + leap
  gap_t was_next_q;
  phase_t was_phase_q;
  logic allowed;  // the leap stays within next_o
  logic known_q;  // no leap beyond next_o since the last tick
  logic [12:0] since_q;  // clocks since the last tick_cur
  carrier_t used_q;  // carrier of the last tick_cur
  phase_t used_period;  // its period
  logic [12:0] left;  // clocks until the one before the next tick_cur
  logic [6:0] cur_seen_q, cur_due_q;  // tick_cur since the last tick_pos; the number that is due
  logic [8:0] pos_q, period_q;  // tick_pos since the last tick_irq; the number that is due
  logic [31:0] was_tick_count_q;
  logic [15:0] slow, was_slow_q;  // registers outside the timer, tick_count_o apart

  assign passed  = 13'(leap_i) + 13'd1;
  assign allowed = leap_i == '0 || leap_i < next_o;
  assign slow    = {carrier_o, cur_q, irq_q};
  assign used_period = Periods[used_q];
  assign left    = used_period - since_q - 13'd1;

  // tick_cur for a tick_pos
  function automatic logic [6:0] ticks(carrier_t carrier, logic [1:0] rate);
    logic [6:0] in_ms;
    in_ms = 7'(16'(ClockHz / 32'd1000) / 16'(Periods[carrier]));
    return rate == 2'd0 ? in_ms : rate == 2'd1 ? in_ms / 7'd2 : in_ms / 7'd4;
  endfunction

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q        <= rst_i;
    was_cur_q        <= tick_cur_o;
    was_pos_q        <= tick_pos_o;
    was_quiescent_q  <= !rst_i && quiescent_o;
    passed_q         <= passed;
    was_next_q       <= next_o;
    was_phase_q      <= phase_o;
    was_tick_count_q <= tick_count_o;
    was_slow_q       <= slow;
    known_q          <= allowed && (known_q || tick_cur_o || rst_i);
    since_q          <= tick_cur_o ? 13'd1 : since_q + passed;
    if (rst_i) begin
      known_q  <= 1'b1;
      since_q  <= Periods[Carrier16kHz];
      used_q     <= Carrier16kHz;
      cur_seen_q <= '0;
      cur_due_q  <= '0;
      pos_q    <= 9'd0;
      period_q <= 9'd0;
    end else begin
      if (tick_cur_o) begin
        used_q     <= carrier_i;
        cur_seen_q <= cur_seen_q + 7'd1;
      end
      if (tick_pos_o) begin
        cur_seen_q <= 7'd1;
        cur_due_q  <= ticks(carrier_i, rate_i);
      end
      if (tick_pos_o) pos_q <= pos_q + 9'd1;
      if (tick_irq_o) begin
        pos_q    <= 9'd1;
        period_q <= irq_period_i == '0 ? 9'd1 : 9'(irq_period_i);
      end
    end
    if (live_q) begin
      starts_with_all_ticks : assert (!was_rst_q || (phase_o == '0 && tick_irq_o));
      tick_every_period : assert (!known_q || tick_cur_o == (since_q == used_period));
      carrier_is_that_of_the_tick : assert (carrier_o == used_q);
      phase_within_period : assert (phase_o < Periods[carrier_o]);
      rest_is_the_period_less_the_phase : assert (rest_o == Periods[carrier_o] - phase_o);
      phase_counts_clocks :
      assert (was_rst_q || !known_q || tick_cur_o ||
              phase_o == (was_cur_q ? 13'd1 : was_phase_q + passed_q));
      tick_at_phase_zero : assert (tick_cur_o == (phase_o == '0));
      position_after_its_ticks :
      assert (tick_pos_o == (tick_cur_o && cur_seen_q == cur_due_q));
      interrupt_every_period : assert (tick_irq_o == (tick_pos_o && pos_q == period_q));
      counts_position_ticks :
      assert (tick_count_o == (was_rst_q ? '0 : was_tick_count_q + 32'(was_pos_q)));
      no_tick_within_next : assert (was_rst_q || passed_q > 13'(was_next_q) || !tick_cur_o);
      next_falls_by_the_clocks :
      assert (was_rst_q || passed_q > 13'(was_next_q) ||
              13'(next_o) == 13'(was_next_q) - passed_q ||
              was_next_q == GapMax - 12'd1 && 13'(next_o) > 13'(was_next_q) - passed_q);
      next_is_the_clocks_to_the_tick :
      assert (!known_q || next_o == (tick_cur_o ? '0 : left > 13'd4094 ? 12'd4094 : 12'(left)));
      quiescent_is_honest :
      assert (!was_quiescent_q || (slow == was_slow_q && tick_count_o == was_tick_count_q));
      inv_timer : assert (count < Periods[carrier_o]);
      inv_since : assert (!known_q || 14'(count) + 14'(since_q) == 14'(used_period));
      inv_position : assert (cur_seen_q + 7'(cur_q) == cur_due_q);
      inv_interrupt : assert (pos_q + 9'(irq_q) == period_q);
      reaches_tick : cover (!was_rst_q && known_q && tick_cur_o && passed_q == 13'd1);
      reaches_position : cover (known_q && tick_pos_o && tick_count_o == 32'd1 && !tick_irq_o);
    end
  end

  // breaks starts_with_all_ticks: irq_q <= rst_i ? irq_d : next
  // breaks tick_every_period, next_is_the_clocks_to_the_tick: u_phase.value_i = Periods[carrier_i]
  // breaks carrier_is_that_of_the_tick: carrier_q <= tick_pos_o && !rst_i || rst_i ? next : carrier_q
  // breaks phase_within_period: u_phase.value_i = Periods[carrier_i] + 13'd1
  // breaks phase_counts_clocks, no_tick_within_next: u_phase.leap_i = leap_i << 1
  // breaks rest_is_the_period_less_the_phase: rest_o = count
  // breaks tick_at_phase_zero: phase_o = period - count
  // breaks position_after_its_ticks: tick_pos_o = tick_cur_o && cur_q[1:0] == 2'd0
  // breaks position_after_its_ticks: cur_d = cur_d | {5'd0, tick_pos_o && rate_i == 2'd3}
  // breaks interrupt_every_period: irq_d = tick_irq_o && irq_period_i != '0 ? irq_period_i : irq_d
  // breaks counts_position_ticks: tick_count_q <= tick_pos_o && !tick_irq_o && !rst_i ? tick_count_q : next
  // breaks next_falls_by_the_clocks (timer): count_q <= rst_i || load_i || count > step + Wide'(9) ? next : '0
  // breaks quiescent_is_honest: quiescent_o = !tick_irq_o

  // prove: leap phase_within_period
  // prove: set ClockHz=50000000
  // prove: set ClockHz=48000000

endmodule

bind timebase timebase_props #(.ClockHz(ClockHz)) u_timebase_props (.*);
