// SPDX-License-Identifier: Apache-2.0
//
// Properties of kung_axis whatever the registers hold and whatever its controllers give: those are
// free here, only the table's write path, the PWM and the legs are in the proof.

module kung_axis_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input gap_t leap_i,

    input logic        tick_cur_i,
    input logic        tick_pos_i,
    input logic        trip_i,
    input logic        locked_i,
    input logic [11:0] current_limit_i,
    input logic [ 9:0] dead_time_min_i,

    input logic [2:0] gate_hi_o,
    input logic [2:0] gate_lo_o,
    input logic       over_current_o,
    input logic       stroke_o,
    input gap_t       next_o,
    input logic       quiescent_o,

    // fields of the registers
    input logic               enable,
    input logic               current_loop,
    input logic               position_loop,
    input logic        [ 9:0] dead_time_clk,
    input logic signed [11:0] iq_manual,
    input logic               stroke_en,
    input logic signed [23:0] stroke_min,
    input logic signed [23:0] stroke_max,
    input logic               wr_ack,

    input logic       preset,
    input count_t     count,
    input count_t     x_p_q,
    input count_t     count_cur_q,
    input word_t      iq_afc,
    input logic       precise,  // i_q* is the precision controller's
    input word_t      iq_precise,
    input logic       done_precise,
    input logic       done_o,
    input logic       afc_start,
    input logic       afc_done,
    input word_t      i_q_ref_q,
    input word_t      i_a,
    input word_t      i_b,
    input logic       loop_clear,
    input logic       afc_busy,
    input logic       tab_write,
    input logic       tab_written,  // of TAB_DATA, all its bytes
    input logic       tab_ignored,  // some of them
    input logic       preset_written,
    input count_t     tab_value,
    input count_t     tab_data_q,
    input logic       tab_pending_q,
    input gap_t       pwm_next,
    input gap_t       leg_next_0,
    input gap_t       leg_next_1,
    input gap_t       leg_next_2,
    input logic [2:0] allowed_q,
    input logic [9:0] count_0,
    input logic [9:0] count_1,
    input logic [9:0] count_2
);

  localparam logic [12:0] Long = 13'd2047;  // clocks; more than any dead time

  logic live_q = 1'b0;
  logic was_rst_q;

  // ---- gates: since_q counts clocks since the leg last had a gate on ----

  logic told, told_q;
  logic [2:0] any, was_any_q, was_hi_q, was_lo_q, early, late, hot;
  logic [9:0] dead;  // the larger of both registers
  logic [12:0] passed;
  logic [12:0] since_q[3];
  logic [9:0] need_q[3];  // least dead time required in those clocks
  logic [9:0] counts[3];

  assign told   = enable && !trip_i;
  assign any    = gate_hi_o | gate_lo_o;
  assign dead   = dead_time_clk > dead_time_min_i ? dead_time_clk : dead_time_min_i;
  assign passed = 13'(leap_i) + 13'd1;
  assign counts = '{count_0, count_1, count_2};

  always_comb begin
    for (int unsigned n = 0; n < 3; n++) begin
      early[n] = any[n] && !was_any_q[n] && since_q[n] < 13'(need_q[n]);
      hot[n]   = any[n] && counts[n] != '0;
      late[n]  = told_q && !any[n] && 13'(counts[n]) + since_q[n] < 13'(need_q[n]);
    end
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q <= rst_i;
    told_q    <= !rst_i && told;
    was_any_q <= any;
    was_hi_q  <= gate_hi_o;
    was_lo_q  <= gate_lo_o;
    for (int unsigned n = 0; n < 3; n++) begin
      if (rst_i || any[n]) begin
        since_q[n] <= '0;
        need_q[n]  <= dead;
      end else begin
        since_q[n] <= since_q[n] + passed >= Long ? Long : since_q[n] + passed;
        if (dead < need_q[n]) need_q[n] <= dead;
      end
    end
    if (live_q) begin
      no_shoot_through : assert ((gate_hi_o & gate_lo_o) == '0);
      gates_off_from_reset : assert (!was_rst_q || any == '0);
      gates_off_unless_enabled_and_untripped : assert (told_q || any == '0);
      dead_time_is_at_least_both_registers : assert (early == '0);
      no_side_to_side_without_a_pause :
      assert (was_rst_q || ((was_hi_q & gate_lo_o) | (was_lo_q & gate_hi_o)) == '0);
      inv_told : assert (allowed_q == {3{told_q}});
      inv_on : assert (hot == '0);
      inv_since : assert (since_q[0] <= Long && since_q[1] <= Long && since_q[2] <= Long);
      inv_count_0 : assert (!late[0]);
      inv_count_1 : assert (!late[1]);
      inv_count_2 : assert (!late[2]);
      reaches_gates : cover (gate_hi_o == 3'b001 && gate_lo_o == 3'b110);
    end
  end

  // ---- latches of the ticks ----

  word_t chosen_q, was_i_q_q;
  count_t count_q, was_count_cur_q, was_x_p_q;
  logic tick_q, tick_pos_q;

  always_ff @(posedge clk_i) begin
    chosen_q        <= !position_loop ? iq_manual : precise ? iq_precise : iq_afc;
    count_q         <= count;
    tick_q          <= tick_cur_i;
    tick_pos_q      <= tick_cur_i && tick_pos_i;
    was_i_q_q       <= i_q_ref_q;
    was_count_cur_q <= count_cur_q;
    was_x_p_q       <= x_p_q;
    if (live_q && !was_rst_q) begin
      i_q_is_the_chosen_one_of_the_tick :
      assert (i_q_ref_q == (tick_q ? chosen_q : was_i_q_q));
      angle_is_that_of_the_tick : assert (count_cur_q == (tick_q ? count_q : was_count_cur_q));
      position_is_that_of_the_tick : assert (x_p_q == (tick_pos_q ? count_q : was_x_p_q));
    end
    if (live_q) begin
      position_controller_starts_unless_precise :
      assert (precise ? !afc_start : afc_start == tick_pos_i);
      done_is_that_of_the_chosen_one : assert (done_o == (precise ? done_precise : afc_done));
      current_loop_rests_unless_closed : assert (loop_clear || told && current_loop);
    end
  end

  // ---- causes of a trip ----

  logic signed [13:0] limit, a, b, c;

  assign limit = {2'b00, current_limit_i};
  assign a = 14'(i_a);
  assign b = 14'(i_b);
  assign c = -a - b;

  always_ff @(posedge clk_i) begin
    if (live_q) begin
      over_current_of_any_phase :
      assert (over_current_o == (limit != '0 &&
          (a >= limit || -a >= limit || b >= limit || -b >= limit || c >= limit || -c >= limit)));
      stroke_is_watched_when_enabled :
      assert (stroke_o == (stroke_en && !(count >= stroke_min && count <= stroke_max)));
    end
  end

  // ---- table writes and quiescence ----

  logic asked_q;
  count_t asked_value_q;
  logic was_quiescent_q;
  logic [66:0] state, was_state_q;

  assign state = {gate_hi_o, gate_lo_o, tab_pending_q, x_p_q, count_cur_q, i_q_ref_q};

  always_ff @(posedge clk_i) begin
    was_quiescent_q <= !rst_i && quiescent_o && !tab_written;  // the bus is open then
    was_state_q     <= state;
    if (rst_i) asked_q <= 1'b0;
    else if (tab_written) asked_q <= 1'b1;
    else if (!afc_busy) asked_q <= 1'b0;
    if (tab_written) asked_value_q <= tab_value;
    if (live_q) begin
      table_write_waits_for_the_controller_only :
      assert (wr_ack == (asked_q && !afc_busy || tab_ignored));
      table_write_has_its_value : assert (!tab_write || asked_q && tab_data_q == asked_value_q);
      next_is_the_least :
      assert (next_o <= pwm_next && next_o <= leg_next_0 && next_o <= leg_next_1 &&
          next_o <= leg_next_2);
      quiescent_is_honest :
      assert (!was_quiescent_q || state == was_state_q);
      preset_only_while_unlocked : assert (!preset || !locked_i);
      preset_by_whole_words_only : assert (!preset || preset_written);
      inv_asked : assert (tab_pending_q == asked_q && (!asked_q || tab_data_q == asked_value_q));
      reaches_waiting_write : cover (asked_q && afc_busy);
    end
  end

  // breaks no_shoot_through (gate_leg): lo_d = ready
  // breaks gates_off_from_reset (gate_leg): hi_q <= rst_i ? on_i : next
  // breaks gates_off_unless_enabled_and_untripped: gen_leg[0].u_leg.trip_i = 1'b0
  // breaks dead_time_is_at_least_both_registers: dead_time = regs_i.deadtime.clk.value
  // breaks no_side_to_side_without_a_pause (gate_leg): ready = allowed && count <= 10'd1
  // breaks i_q_is_the_chosen_one_of_the_tick: iq_ref = !regs_i.ctrl.position_loop.value ? iq_afc : word_t'(regs_i.iq_manual.value.value)
  // breaks i_q_is_the_chosen_one_of_the_tick: iq_position = iq_afc
  // breaks position_controller_starts_unless_precise: afc_start = tick_pos_i
  // breaks done_is_that_of_the_chosen_one: done_o = afc_done || precision_i.done
  // breaks angle_is_that_of_the_tick: count_cur_q <= tick_cur_i && !rst_i ? x_p_q : next
  // breaks position_is_that_of_the_tick: x_p_q <= tick_cur_i && !rst_i ? count : next
  // breaks current_loop_rests_unless_closed: loop_clear = !regs_i.ctrl.enable.value || !regs_i.ctrl.current_loop.value
  // breaks over_current_of_any_phase: over_current_o = reached(sum_t'(i_a), current_limit_i) || reached(sum_t'(i_b), current_limit_i) || reached(sum_t'(i_a) - sum_t'(i_b), current_limit_i)
  // breaks stroke_is_watched_when_enabled: stroke_o = regs_i.stroke_en.enable.value && (count < count_t'(regs_i.stroke_min.value.value) || count >= count_t'(regs_i.stroke_max.value.value))
  // breaks table_write_waits_for_the_controller_only: tab_write = tab_pending_q
  // breaks table_write_has_its_value: tab_data_q <= rst_i ? next : tab_data_q
  // breaks table_write_has_its_value: tab_in_part = 1'b0
  // breaks preset_only_while_unlocked, preset_by_whole_words_only: preset = preset_write
  // breaks next_is_the_least: next_o = leg_next[2] > next_o ? leg_next[2] : next_o
  // breaks quiescent_is_honest: quiescent_o = qep_quiescent && !wake_regs_o && command_quiescent && afc_quiescent && !tick_cur_i && adc_quiescent && loop_awake == '0 && pwm_quiescent && leg_quiescent == '1

endmodule

bind kung_axis kung_axis_props u_kung_axis_props (
    .*,
    .enable(regs_i.ctrl.enable.value),
    .current_loop(regs_i.ctrl.current_loop.value),
    .position_loop(regs_i.ctrl.position_loop.value),
    .dead_time_clk(regs_i.deadtime.clk.value),
    .iq_manual(regs_i.iq_manual.value.value),
    .stroke_en(regs_i.stroke_en.enable.value),
    .stroke_min(regs_i.stroke_min.value.value),
    .stroke_max(regs_i.stroke_max.value.value),
    .wr_ack(regs_o.tab_data.wr_ack),
    .tab_written(regs_i.tab_data.req && regs_i.tab_data.req_is_wr &&
                 regs_i.tab_data.wr_biten.value == '1),
    .tab_ignored(regs_i.tab_data.req && regs_i.tab_data.req_is_wr &&
                 regs_i.tab_data.wr_biten.value != '1),
    .preset_written(regs_i.pos_preset.req && regs_i.pos_preset.req_is_wr &&
                    regs_i.pos_preset.wr_biten.value == '1),
    .precise(precision_i.enable),
    .iq_precise(precision_i.i_q_ref),
    .done_precise(precision_i.done),
    .leg_next_0(leg_next[0]),
    .leg_next_1(leg_next[1]),
    .leg_next_2(leg_next[2]),
    .allowed_q({gen_leg[2].u_leg.allowed_q, gen_leg[1].u_leg.allowed_q,
                gen_leg[0].u_leg.allowed_q}),
    .count_0(gen_leg[0].u_leg.count),
    .count_1(gen_leg[1].u_leg.count),
    .count_2(gen_leg[2].u_leg.count)
);

// prove: cut afc current_loop adc_if qep command
