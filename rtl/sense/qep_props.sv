// SPDX-License-Identifier: Apache-2.0
//
// Properties of qep, for any input. The model decodes by the position in the Gray code and filters
// by a history of samples; what holds for legal motion is stated in terms of the pins alone.

module qep_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic [3:0] filter_i,
    input logic       preset_i,
    input count_t     preset_value_i,
    input logic       clear_error_i,

    input logic enc_a_i,
    input logic enc_b_i,
    input logic enc_z_i,

    input count_t count_o,
    input logic   dir_o,
    input logic   edge_o,
    input logic   up_o,
    input count_t index_latch_o,
    input logic   index_seen_o,
    input logic   error_o,
    input logic   quiescent_o,

    input logic [2:0] meta_q,
    input logic [2:0] sync_q,
    input logic [2:0] line_q,
    input logic [2:0] prev_q,
    input logic [2:0] start_q,

    input logic [3:0] same_a,
    input logic [3:0] same_b,
    input logic [3:0] same_z
);

  localparam int unsigned Depth = 19;
  typedef logic [Depth-1:0] history_t;  // of a line, the newest sample in bit 0

  logic live_q = 1'b0;
  logic was_rst_q, was_live_q, was_preset_q, was_clear_q, was_error_q, was_seen_q, was_dir_q;
  logic was_quiescent_q, was_edge_q, was_up_q;
  logic [1:0] adopt_q;  // clocks left during which the lines are adopted
  logic adopted;
  logic [3:0] n, n_q, n_qq;  // length of the filter: now, 1 and 2 edges ago
  history_t [2:0] pins_q;  // Z, B, A
  logic [2:0] differ, model_q, before_q;  // lines of the model, and one clock earlier
  count_t count_q, preset_q, was_count_q, was_latch_q;
  logic [1:0] moved, moved_q;  // steps in the Gray code modulo 4
  logic index, index_q;
  logic [2:0][4:0] run_q;  // equal samples, from that of the second flip-flop back, or fewer
  logic [2:0] sure_q;  // the line is its pin delayed: rested once, no level too short since
  logic [1:0] legal;  // steps of the pins, one latency ago: 0, 1, 3 are legal
  logic [1:0] full;  // as many equal samples as the filter needs, before the line changed
  logic [53:0] state, was_state_q;  // all registers except the lines
  logic [23:0] lines, was_lines_q;

  // Position in the Gray code: AB = 00, 10, 11, 01 are 0, 1, 2, 3.
  function automatic logic [1:0] place(logic b, logic a);
    return {b, a ^ b};
  endfunction

  // The first `many` bits equal `level`.
  function automatic logic all(history_t history, logic [3:0] many, logic level);
    all = 1'b1;
    for (int unsigned k = 0; k < 15; k++) all &= k >= 32'(many) || history[k] == level;
  endfunction

  // Exactly `same` samples before that of the second flip-flop differ from the line.
  function automatic logic counted(logic [3:0] same, history_t history, logic line);
    counted = same != 4'd15 && history[5'(same)+5'd2] == line;
    for (int unsigned k = 0; k < 15; k++) counted &= k >= 32'(same) || history[k+2] != line;
  endfunction

  function automatic logic ran(logic [4:0] run, history_t history);
    ran = run >= 5'd1 && run <= 5'd18;
    for (int unsigned k = 1; k < 18; k++) ran &= k >= 32'(run) || history[k+1] == history[1];
  endfunction

  // The line is its pin delayed, and changes at most once in as many samples as the filter takes.
  function automatic logic delayed(history_t history, logic line, logic prev, logic [3:0] many);
    history_t changes;
    changes = ((history ^ history >> 1) >> 1) & ~('1 << many);
    return line == history[5'(many)+5'd1] && prev == history[5'(many)+5'd2] &&
        (changes & (changes - 19'd1)) == '0;
  endfunction

  assign n       = filter_i == '0 ? 4'd1 : filter_i;
  assign adopted = adopt_q == '0;
  assign moved   = adopted ? place(model_q[1], model_q[0]) - place(before_q[1], before_q[0]) : '0;
  assign index   = adopted && model_q[2] && !before_q[2];

  for (genvar i = 0; i < 3; i++) begin : gen_line
    assign differ[i] = all(pins_q[i] >> 1, n, !model_q[i]);
  end

  for (genvar i = 0; i < 2; i++) begin : gen_code
    assign full[i] = all(pins_q[i] >> 3, n_qq, pins_q[i][3]);
  end

  assign legal = place(pins_q[1][5'(n_q) + 5'd2], pins_q[0][5'(n_q) + 5'd2]) -
      place(pins_q[1][5'(n_q) + 5'd3], pins_q[0][5'(n_q) + 5'd3]);
  assign state = {start_q, count_o, dir_o, index_latch_o, index_seen_o, error_o};
  assign lines = {meta_q, sync_q, line_q, prev_q, same_a, same_b, same_z};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_live_q      <= !rst_i && adopted;
    was_preset_q    <= preset_i;
    was_clear_q     <= clear_error_i;
    was_error_q     <= !rst_i && error_o;
    was_seen_q      <= !rst_i && index_seen_o;
    was_dir_q       <= dir_o;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_edge_q      <= !rst_i && edge_o;
    was_up_q        <= up_o;
    was_count_q     <= count_o;
    was_latch_q     <= index_latch_o;
    was_state_q     <= state;
    was_lines_q     <= lines;
    n_q             <= n;
    n_qq            <= n_q;
    preset_q        <= preset_value_i;
    moved_q         <= rst_i ? '0 : moved;
    index_q         <= !rst_i && index;
    if (rst_i) adopt_q <= 2'd3;
    else if (!adopted) adopt_q <= adopt_q - 2'd1;
    before_q <= adopted ? model_q : {pins_q[2][1], pins_q[1][1], pins_q[0][1]};
    for (int i = 0; i < 3; i++) begin
      pins_q[i] <= {pins_q[i][Depth-2:0], i == 0 ? enc_a_i : i == 1 ? enc_b_i : enc_z_i};
      if (!live_q) pins_q[i][1] <= meta_q[i];  // meta_q has no reset
      if (rst_i || !adopted || differ[i]) model_q[i] <= pins_q[i][1];
      if (pins_q[i][0] != pins_q[i][1]) run_q[i] <= 5'd1;
      else if (run_q[i] != 5'd18) run_q[i] <= run_q[i] + 5'd1;
      sure_q[i] <= run_q[i] >= 5'(n) + 5'd3 ||
          (sure_q[i] && (pins_q[i][0] == pins_q[i][1] || run_q[i] >= 5'(n)));
      if (rst_i || !adopted || n != n_q) begin
        run_q[i]  <= 5'd1;
        sure_q[i] <= 1'b0;
      end
    end
    if (rst_i) count_q <= '0;
    else if (preset_i) count_q <= preset_value_i;
    else if (moved[0]) count_q <= moved[1] ? count_q - 24'sd1 : count_q + 24'sd1;
    if (live_q) begin
      count_is_that_of_the_model : assert (count_o == count_q);
      preset_wins : assert (was_rst_q || !was_preset_q || count_o == preset_q);
      legal_motion_is_counted :
      assert (sure_q[1:0] != '1 || was_preset_q ||
              count_o == (!legal[0] ? was_count_q :
                          legal[1] ? was_count_q - 24'sd1 : was_count_q + 24'sd1));
      illegal_step_is_an_error : assert (sure_q[1:0] != '1 || legal != 2'd2 || error_o);
      no_error_without_illegal_step : assert (!error_o || was_error_q || moved_q == 2'd2);
      error_kept_until_cleared : assert (!was_error_q || was_clear_q || error_o);
      short_pulse_is_ignored :
      assert (was_preset_q || !was_live_q || count_o == was_count_q || full != '0);
      direction_of_the_last_step :
      assert (was_rst_q || dir_o == (moved_q[0] ? !moved_q[1] : was_dir_q));
      an_edge_is_a_step_of_the_count :
      assert (was_rst_q || was_edge_q == (!was_preset_q && count_o != was_count_q));
      a_step_goes_the_way_of_its_edge :
      assert (!was_edge_q || count_o == (was_up_q ? was_count_q + 24'sd1 : was_count_q - 24'sd1));
      index_latches_the_count : assert (!index_q || (index_latch_o == count_o && index_seen_o));
      latch_holds : assert (was_rst_q || index_q || index_latch_o == was_latch_q);
      index_kept_until_cleared :
      assert (index_seen_o == (index_q || (was_seen_q && !was_clear_q)));
      start_is_silent : assert (was_live_q || (!error_o && !index_seen_o));
      start_keeps_the_count :
      assert (was_live_q || was_rst_q || was_preset_q || count_o == was_count_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (state == was_state_q && lines == was_lines_q));
      inv_start : assert (start_q == (adopt_q == 2'd3 ? 3'd0 : adopt_q == 2'd2 ? 3'd1 :
                                      adopt_q == 2'd1 ? 3'd3 : 3'd7));
      inv_lines : assert (was_rst_q || (model_q == line_q && before_q == prev_q));
      inv_samples :
      assert (was_rst_q || (counted(same_a, pins_q[0], line_q[0]) &&
                            counted(same_b, pins_q[1], line_q[1]) &&
                            counted(same_z, pins_q[2], line_q[2])));
      inv_pins : assert (meta_q == {pins_q[2][0], pins_q[1][0], pins_q[0][0]} &&
                         sync_q == {pins_q[2][1], pins_q[1][1], pins_q[0][1]});
      inv_run_a : assert (ran(run_q[0], pins_q[0]));
      inv_run_b : assert (ran(run_q[1], pins_q[1]));
      inv_run_z : assert (ran(run_q[2], pins_q[2]));
      inv_sure_a : assert (!sure_q[0] || delayed(pins_q[0], line_q[0], prev_q[0], n_q));
      inv_sure_b : assert (!sure_q[1] || delayed(pins_q[1], line_q[1], prev_q[1], n_q));
      reaches_step_down : cover (moved_q == 2'd3 && n_q == 4'd3);
      reaches_error : cover (error_o && !was_error_q && sure_q[1:0] == '1);
      reaches_legal : cover (sure_q[1:0] == '1 && legal == 2'd1 && count_o == 24'sd3);
      reaches_index : cover (index_latch_o == 24'sd2);
    end
  end

  // prove: depth 5
  // prove: leap inv_start

  // breaks count_is_that_of_the_model: count_d = step && !preset_i ? count_q + {{22{!up}}, 2'b11} : count_d
  // breaks preset_wins: count_d = preset_i && step ? count_q + {{23{!up}}, 1'b1} : count_d
  // breaks legal_motion_is_counted: last = last + 4'd1
  // breaks legal_motion_is_counted: up = line_q[A] != prev_q[A]
  // breaks illegal_step_is_an_error: both = live && line_q[Z] != prev_q[A] && line_q[B] != prev_q[B]
  // breaks no_error_without_illegal_step: error_q <= next || (index && !rst_i)
  // breaks error_kept_until_cleared: error_q <= !rst_i && (both || (error_q && !step))
  // breaks short_pulse_is_ignored: gen_line[0].same_q <= next == '0 ? next : next + 4'd1
  // breaks short_pulse_is_ignored: gen_line[0].same_q <= rst_i || !live || gen_line[0].same_q >= last ? next : meta_q[0] == line_q[0] ? '0 : gen_line[0].same_q + 4'd1
  // breaks direction_of_the_last_step: dir_q <= up && !rst_i
  // breaks an_edge_is_a_step_of_the_count: edge_o = step
  // breaks a_step_goes_the_way_of_its_edge: up_o = dir_q
  // breaks index_latches_the_count: latch_q <= index && !rst_i ? count_q : next
  // breaks latch_holds: latch_q <= line_q[Z] && !rst_i ? count_d : next
  // breaks index_kept_until_cleared: seen_q <= !rst_i && (index || (seen_q && !preset_i))
  // breaks start_is_silent: index = line_q[Z] && !prev_q[Z]
  // breaks start_keeps_the_count: step = (line_q[A] != prev_q[A]) != (line_q[B] != prev_q[B])
  // breaks quiescent_is_honest: quiescent_o = live && pin == meta_q && meta_q == sync_q && sync_q == line_q && held == '0 && !preset_i && !(clear_error_i && (seen_q || error_q))

endmodule

bind qep qep_props u_qep_props (
    .*,
    .same_a(gen_line[0].same_q),
    .same_b(gen_line[1].same_q),
    .same_z(gen_line[2].same_q)
);
