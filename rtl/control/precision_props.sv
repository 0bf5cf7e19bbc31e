// SPDX-License-Identifier: Apache-2.0
//
// Properties of precision for any input, any stored word and any product. clock_q counts the clocks
// of the run, from which follow the instruction and the axis of each stage.

module precision_props
  import trammel_pkg::*;
  import precision_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic tick_i,

    input logic [1:0] enable_i,
    input logic [1:0] reset_i,

    input logic        busy_o,
    input logic        done_o,
    input logic        overrun_o,
    input logic  [1:0] saturated_o,
    input logic  [1:0] clipped_o,
    input word_t [1:0] i_q_ref_o,
    input logic        quiescent_o,

    input logic       store_quiescent,
    input logic       knots_quiescent,

    input logic       start,
    input logic       knot,
    input logic [1:0] asked_q,
    input logic [1:0] resetting_q,
    input logic       taken,
    input logic       coast,
    input logic       hold,

    input logic       running_q,
    input logic       axis_q,
    input logic       reads_q,
    input logic       factors_q,
    input logic       multiplies_q,
    input logic       sums_q,
    input logic       fits_q,
    input logic [7:0] pc_q,
    input instr_t     instr_q,
    input instr_t     factor_q,
    input add_e       add_multiply_q,
    input logic [2:0] minus_q,
    input effect_t    effect_multiply_q,
    input effect_t    effect_sum_q,
    input effect_t    effect_q,

    input logic              write,
    input logic [6:0]        write_addr,
    input sum_t              result,
    input factor_t           f_q,
    input logic              only,
    input sum_t              total_q,
    input logic              saturates
);

  localparam logic [8:0] All = 9'(2 * Size);
  localparam logic [8:0] Drain = 9'd5;  // clocks from the last fetch of Y to its fit

  logic live_q = 1'b0;
  logic [8:0] clock_q;  // of the run, from 1; 0: none
  logic whole_q;        // from the first instruction, at a knot or in reset
  logic was_rst_q, was_last_q;
  logic [8:0] last;
  logic [7:0] entry;

  assign entry = whole_q ? 8'd0 : 8'(Tick);
  assign last  = (whole_q ? All : All - 9'(2 * Tick)) + Drain;

  // Index of the instruction in the stage that begins at this clock of the run.
  function automatic logic [7:0] at(logic [8:0] clock, logic [8:0] stage, logic [7:0] from);
    return from + 8'((clock - stage) >> 1);
  endfunction

  function automatic logic in_stage(logic [8:0] clock, logic [8:0] stage, logic [8:0] end_of_run);
    return clock >= stage && clock <= end_of_run - 9'd6 + stage;
  endfunction

  logic [7:0] read_at, factor_at, multiply_at, sum_at, fit_at;
  logic fit_axis;
  assign read_at     = at(clock_q, 9'd2, entry);
  assign factor_at   = at(clock_q, 9'd3, entry);
  assign multiply_at = at(clock_q, 9'd4, entry);
  assign sum_at      = at(clock_q, 9'd5, entry);
  assign fit_at      = at(clock_q, 9'd6, entry);
  assign fit_axis    = clock_q[0];

  // The program's instruction in each stage, passed on from the first.
  instr_t due, due_factor_q;
  add_e add_due_q;
  logic [2:0] added_q;
  effect_t effect_due_multiply_q, effect_due_sum_q, due_q;
  assign due = Program[read_at];

  always_ff @(posedge clk_i) begin
    due_factor_q <= due;
    add_due_q    <= due_factor_q.add;
    added_q      <= add_due_q[2:0];
    effect_due_multiply_q <= due_factor_q.effect;
    effect_due_sum_q      <= effect_due_multiply_q;
    due_q                 <= effect_due_sum_q;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q   <= rst_i;
    was_last_q  <= !rst_i && clock_q == last && clock_q != '0;
    if (rst_i) begin
      clock_q <= '0;
    end else if (start) begin
      clock_q <= 9'd1;
      whole_q <= knot || (asked_q | reset_i | ~enable_i) != '0;
    end else if (clock_q != '0) begin
      clock_q <= clock_q == last ? '0 : clock_q + 9'd1;
    end
    if (live_q) begin
      done_after_229_clocks_or_277 : assert (done_o == was_last_q);
      busy_from_start_to_done : assert (busy_o == (clock_q != '0));
      a_tick_starts_the_law :
      assert (start == (tick_i && enable_i != '0 && clock_q == '0));
      lost_tick_is_an_overrun :
      assert (overrun_o == (tick_i && enable_i != '0 && clock_q != '0));
      words_move_in_their_step_only :
      assert (!write || clock_q >= 9'd6 && due_q.store != Never &&
          write_addr == {fit_axis, due_q.write});
      every_step_stores_what_it_must :
      assert (clock_q < 9'd6 || due_q.store != Always || write);
      knot_words_move_at_a_knot_or_in_reset_only :
      assert (!write || due_q.store inside {Always, InReset} ||
          taken || coast || hold || resetting_q[fit_axis]);
      in_reset_only_0_is_stored :
      assert (!write || !resetting_q[fit_axis] || effect_q.store == InReset || result == '0);
      flags_with_done_only : assert (done_o || {saturated_o, clipped_o} == '0);

      inv_clock : assert (clock_q <= last);
      inv_stages :
      assert ({running_q, reads_q, factors_q, multiplies_q, sums_q, fits_q} == (clock_q == '0 ? '0 :
          {clock_q <= last - 9'd5, in_stage(clock_q, 9'd2, last),
           in_stage(clock_q, 9'd3, last), in_stage(clock_q, 9'd4, last),
           in_stage(clock_q, 9'd5, last), in_stage(clock_q, 9'd6, last)}));
      inv_axis : assert (axis_q == (clock_q == '0 ? was_last_q : !clock_q[0]));
      inv_pc : assert (!running_q || pc_q == at(clock_q, 9'd1, entry));
      inv_read : assert (!reads_q || instr_q == due);
      inv_factor : assert (!factors_q || factor_q == due_factor_q);
      inv_multiply :
      assert (!multiplies_q || add_multiply_q == add_due_q &&
          effect_multiply_q == effect_due_multiply_q);
      inv_sum :
      assert (!sums_q || minus_q == added_q && effect_sum_q == effect_due_sum_q);
      inv_fit : assert (!fits_q || effect_q == due_q);
      inv_due_factor : assert (!factors_q || due_factor_q == Program[factor_at]);
      inv_due_multiply :
      assert (!multiplies_q || add_due_q == Program[multiply_at].add &&
          effect_due_multiply_q == Program[multiply_at].effect);
      inv_due_sum :
      assert (!sums_q || added_q == Program[sum_at].add[2:0] &&
          effect_due_sum_q == Program[sum_at].effect);
      inv_due_fit : assert (!fits_q || due_q == Program[fit_at].effect);

      reaches_done : cover (done_o && clock_q == '0);
      reaches_overrun : cover (overrun_o && clock_q == 9'd20);
    end
  end

  // ---- i_q*, and nothing while quiescent ----

  word_t [1:0] was_i_q_q;
  logic was_quiescent_q, was_off_q, idle;
  logic [11:0] state, was_state_q;

  assign idle  = clock_q == '0 && !was_last_q && store_quiescent && knots_quiescent;
  assign state = {asked_q, resetting_q, axis_q, pc_q[6:0]};

  always_ff @(posedge clk_i) begin
    was_i_q_q       <= i_q_ref_o;
    was_quiescent_q <= quiescent_o && !rst_i;
    was_off_q       <= enable_i == '0 && !start && !rst_i;
    was_state_q     <= state;
    if (live_q) begin
      both_i_q_move_with_done_only : assert (done_o || was_rst_q || i_q_ref_o == was_i_q_q);
      without_an_axis_nothing_wakes_it :
      assert (!was_off_q || enable_i != '0 || !idle || quiescent_o);
      quiescent_is_honest :
      assert (!was_quiescent_q || state == was_state_q && !write && !busy_o && !done_o);
    end
  end

  // ---- operand and saturation ----

  function automatic sum_t clipped(sum_t x, int unsigned n);
    if (x >>> (n - 1) == '0 || ~x >>> (n - 1) == '0) return x;
    return x[SumWidth-1] ? -(sum_t'(1) <<< (n - 1)) : (sum_t'(1) <<< (n - 1)) - sum_t'(1);
  endfunction

  function automatic sum_t fitted(sum_t x, fit_e fit);
    unique case (fit)
      Low:     return x > sum_t'(0) ? '0 : x;
      High:    return x < sum_t'(0) ? '0 : x;
      Sat35:   return clipped(x, 35);
      Sat24:   return clipped(x, 24);
      Sat20:   return clipped(x, 20);
      Sat18:   return clipped(x, 18);
      Sat12:   return clipped(x, 12);
      default: return x;
    endcase
  endfunction

  logic was_factors_q, was_only_q;
  sum_t expected;

  assign expected = resetting_q[fit_axis] && effect_q.store != InReset ? '0 :
      fitted(total_q, effect_q.fit);

  always_ff @(posedge clk_i) begin
    was_factors_q <= factors_q;
    was_only_q    <= only;
    if (live_q) begin
      a_condition_that_is_off_makes_0 : assert (!was_factors_q || was_only_q || f_q == '0);
      result_is_the_fitted_sum : assert (!fits_q || result == expected);
      saturation_is_seen :
      assert (!fits_q ||
          saturates == (effect_q.fit[4] && fitted(total_q, effect_q.fit) != total_q));
    end
  end

  // breaks done_after_229_clocks_or_277: done_q <= !rst_i && fits_q && !axis_q
  // breaks busy_from_start_to_done: busy_o = running_q || reads_q || factors_q || multiplies_q || sums_q
  // breaks a_tick_starts_the_law: start = tick_i && !busy_o
  // breaks lost_tick_is_an_overrun: overrun_o = tick_i && busy_o
  // breaks words_move_in_their_step_only: write = fits_q
  // breaks every_step_stores_what_it_must: write = write && effect_q.note != NoteV
  // breaks knot_words_move_at_a_knot_or_in_reset_only: write = fits_q && effect_q.store != Never
  // breaks in_reset_only_0_is_stored: forced = (effect_q.fit[6] && !below) || (effect_q.fit[5] && below)
  // breaks flags_with_done_only: clipped_o = clipped_q
  // breaks both_i_q_move_with_done_only: i_q_ref_q <= fits_q && !rst_i ? {result[11:0], i_q_x_q} : next
  // breaks without_an_axis_nothing_wakes_it: quiescent_o = quiescent_o && !tick_i
  // breaks quiescent_is_honest: quiescent_o = !busy_o && !done_q && store_quiescent && knots_quiescent
  // breaks a_condition_that_is_off_makes_0: f_q <= factors_q ? f : next
  // breaks result_is_the_fitted_sum, in_reset_only_0_is_stored: forced = 1'b0
  // breaks saturation_is_seen: saturates = effect_q.fit[4] && above

endmodule

bind precision precision_props u_precision_props (
    .*,
    .write_addr({!axis_q, effect_q.write})
);

// prove: cut precision_store precision_knots
// prove: frames 300
// prove: free $mul
// prove: depth 3
// prove: leap inv_axis busy_from_start_to_done done_after_229_clocks_or_277
