// SPDX-License-Identifier: Apache-2.0
//
// One axis of kung_xy: encoder, converters, position and current controllers, inverter gates.
//
//   edges after that of a tick of the carrier
//   0        count and i_q* latched, compare values taken, converter started
//   65       currents taken, current loop runs
//   132      compare values for the next tick
//   edges after that of a position tick
//   1..70    position controller with the count of this tick; its i_q* acts from the next
//            tick of the carrier on

module kung_axis
  import trammel_pkg::*;
  import kung_pkg::*;
  import kung_xy_regs_pkg::axis_regs__in_t;
  import kung_xy_regs_pkg::axis_regs__out_t;
(
    input logic clk_i,
    input axis_domains_t clock_en_i,
    input logic rst_i,

    input gap_t leap_i,

    input carrier_t    carrier_i,
    input logic        tick_cur_i,
    input logic        tick_pos_i,
    input phase_t      phase_i,
    input phase_t      rest_i,

    input logic        trip_i,
    input logic        locked_i,
    input logic        commit_i,
    input logic [11:0] current_limit_i,
    input logic [ 9:0] dead_time_min_i,

    input  axis_regs__out_t regs_i,
    output axis_regs__in_t  regs_o,

    input  logic enc_a_i,
    input  logic enc_b_i,
    input  logic enc_z_i,
    input  logic adc_sdata_a_i,
    input  logic adc_sdata_b_i,
    output logic adc_cs_n_o,
    output logic adc_sclk_o,

    output logic   edge_o,  // of the encoder, see kung_precision
    output logic   up_o,
    output count_t count_cur_o,
    input  precision_t precision_i,

    output logic [2:0] gate_hi_o,
    output logic [2:0] gate_lo_o,

    output logic over_current_o,
    output logic encoder_o,
    output logic stroke_o,
    output logic done_o,
    output gap_t next_o,
    output logic wake_regs_o,  // a bit of STATUS is set
    output axis_domains_t awake_o,
    output logic quiescent_o
);

  logic clk_position, clk_adc, clk_angle, clk_sense, clk_gates;
  assign clk_position = clk_i & clock_en_i.position;
  assign clk_adc      = clk_i & clock_en_i.adc;
  assign clk_angle    = clk_i & clock_en_i.loop.angle;
  assign clk_sense    = clk_i & clock_en_i.sense;
  assign clk_gates    = clk_i & clock_en_i.gates;

  // ---- position ----

  count_t count, index_latch, preset_value;
  logic preset, preset_write, qep_error, qep_quiescent, unused_dir, unused_index_seen;

  assign preset_write = regs_i.pos_preset.req && regs_i.pos_preset.req_is_wr;
  assign preset       = preset_write && (&regs_i.pos_preset.wr_biten.value) && !locked_i;
  assign preset_value = count_t'(regs_i.pos_preset.wr_data.value);

  qep u_qep (
      .clk_i         (clk_sense),
      .rst_i         (rst_i),
      .filter_i      (regs_i.deadtime.qep_filter.value),
      .preset_i      (preset),
      .preset_value_i(preset_value),
      .clear_error_i (qep_error),  // STATUS keeps it
      .enc_a_i       (enc_a_i),
      .enc_b_i       (enc_b_i),
      .enc_z_i       (enc_z_i),
      .count_o       (count),
      .dir_o         (unused_dir),
      .edge_o        (edge_o),
      .up_o          (up_o),
      .index_latch_o (index_latch),
      .index_seen_o  (unused_index_seen),
      .error_o       (qep_error),
      .quiescent_o   (qep_quiescent)
  );

  assign encoder_o = regs_i.status.qep_error.value;
  assign stroke_o  = regs_i.stroke_en.enable.value &&
      (count < count_t'(regs_i.stroke_min.value.value) ||
       count > count_t'(regs_i.stroke_max.value.value));

  // ---- position controller ----

  count_t r, x_p_q, x_r, unused_dx, rule_rdata;
  word_t e, de, u, v_star, v, iq_afc, iq_position;
  model_t unused_x_m;
  logic afc_busy, afc_done, afc_start, overrun, iq_valid, saturated, unused_table_busy;
  logic command_quiescent, afc_quiescent;
  logic [6:0] step;

  command u_command (
      .clk_i         (clk_position),
      .rst_i         (rst_i),
      .tick_pos_i    (tick_pos_i),
      .commit_i      (commit_i),
      .interpolate_i (regs_i.ctrl.interpolate.value),
      .preset_i      (preset),
      .preset_value_i(preset_value),
      .pos_cmd_i     (count_t'(regs_i.pos_cmd.value.value)),
      .r_o           (r),
      .quiescent_o   (command_quiescent)
  );

  // A table write waits until the position controller is idle.
  logic tab_request, tab_in_part, tab_pending_q, tab_write;
  count_t tab_value, tab_data_q;

  assign tab_request = regs_i.tab_data.req && regs_i.tab_data.req_is_wr && !tab_in_part;
  assign tab_in_part = !(&regs_i.tab_data.wr_biten.value);
  assign tab_value   = count_t'(regs_i.tab_data.wr_data.value[23:0]);
  assign tab_write   = tab_pending_q && !afc_busy;

  always_ff @(posedge clk_position) begin
    if (rst_i) begin
      tab_pending_q <= 1'b0;
      tab_data_q    <= '0;
    end else begin
      if (tab_request) begin
        tab_pending_q <= 1'b1;
        tab_data_q    <= tab_value;
      end else if (tab_write) begin
        tab_pending_q <= 1'b0;
      end
    end
  end

  assign afc_start = tick_pos_i && !precision_i.enable;
  afc u_afc (
      .clk_i        (clk_position),
      .rst_i        (rst_i),
      .start_i      (afc_start),
      .adapt_i      (regs_i.ctrl.adapt.value),
      .feedforward_i(regs_i.ctrl.feedforward.value),
      .reset_model_i(regs_i.ctrl.reset_model.value),
      .reset_table_i(regs_i.ctrl.reset_table.value),
      .kp_i         ({regs_i.kp.exp.value, regs_i.kp.mant.value}),
      .ki_i         ({regs_i.ki.exp.value, regs_i.ki.mant.value}),
      .kv_i         ({regs_i.kv.exp.value, regs_i.kv.mant.value}),
      .eta_i        ({regs_i.eta.exp.value, regs_i.eta.mant.value}),
      .shift_e_i    (regs_i.shift.e.value),
      .shift_de_i   (regs_i.shift.de.value),
      .a0_i         (regs_i.a0.value.value),
      .a0_scale_i   (regs_i.a0.scale.value),
      .b2_i         (count_t'(regs_i.b2.value.value)),
      .r_i          (r),
      .x_p_i        (x_p_q),
      .rule_addr_i  (regs_i.tab_addr.index.value),
      .rule_we_i    (tab_write),
      .rule_wdata_i (tab_data_q),
      .busy_o       (afc_busy),
      .done_o       (afc_done),
      .overrun_o    (overrun),
      .step_o       (step),
      .iq_valid_o   (iq_valid),
      .x_m_o        (unused_x_m),
      .x_r_o        (x_r),
      .dx_o         (unused_dx),
      .e_o          (e),
      .de_o         (de),
      .u_o          (u),
      .v_star_o     (v_star),
      .v_o          (v),
      .i_q_ref_o    (iq_afc),
      .saturated_o  (saturated),
      .rule_rdata_o (rule_rdata),
      .table_busy_o (unused_table_busy),
      .quiescent_o  (afc_quiescent)
  );

  // ---- current controller ----

  count_t count_cur_q;
  word_t iq_ref, i_q_ref_q, i_a, i_b, i_d, i_q, v_d, v_q;
  logic [11:0] code_a, code_b;
  logic adc_valid, unused_adc_busy, adc_quiescent;
  logic unused_loop_busy, loop_valid, limited, unused_loop_quiescent, loop_clear;
  current_loop_pkg::domains_t loop_awake;
  cmp_t cmp_a, cmp_b, cmp_c;

  assign iq_position = precision_i.enable ? precision_i.i_q_ref : iq_afc;
  assign iq_ref      = regs_i.ctrl.position_loop.value ? iq_position :
      word_t'(regs_i.iq_manual.value.value);
  assign done_o      = precision_i.enable ? precision_i.done : afc_done;
  assign count_cur_o = count_cur_q;
  assign loop_clear = trip_i || !regs_i.ctrl.enable.value || !regs_i.ctrl.current_loop.value;

  always_ff @(posedge clk_angle) begin
    if (rst_i) begin
      count_cur_q <= '0;
      i_q_ref_q   <= '0;
    end else if (tick_cur_i) begin
      count_cur_q <= count;
      i_q_ref_q   <= iq_ref;
    end
  end

  always_ff @(posedge clk_position) begin
    if (rst_i) x_p_q <= '0;
    else if (tick_cur_i && tick_pos_i) x_p_q <= count;
  end

  adc_if u_adc (
      .clk_i      (clk_adc),
      .rst_i      (rst_i),
      .start_i    (tick_cur_i),
      .zeros_i    (regs_i.adc_frame.zeros.value),
      .sdata_a_i  (adc_sdata_a_i),
      .sdata_b_i  (adc_sdata_b_i),
      .cs_n_o     (adc_cs_n_o),
      .sclk_o     (adc_sclk_o),
      .busy_o     (unused_adc_busy),
      .valid_o    (adc_valid),
      .code_a_o   (code_a),
      .code_b_o   (code_b),
      .quiescent_o(adc_quiescent)
  );

  current_loop u_current_loop (
      .clk_i      (clk_i),
      .clock_en_i (clock_en_i.loop),
      .rst_i      (rst_i),
      .tick_i     (adc_valid),
      .clear_i    (loop_clear),
      .carrier_i  (carrier_i),
      .angle_step_i(regs_i.angle_step.value.value),
      .theta_ofs_i(regs_i.theta_ofs.value.value),
      .kp_i       ({regs_i.kp_cur.exp.value, regs_i.kp_cur.mant.value}),
      .ki_i       ({regs_i.ki_cur.exp.value, regs_i.ki_cur.mant.value}),
      .code_a_i   (code_a),
      .code_b_i   (code_b),
      .offset_a_i (word_t'(regs_i.current_offset.a.value)),
      .offset_b_i (word_t'(regs_i.current_offset.b.value)),
      .count_i    (count_cur_q),
      .i_q_ref_i  (i_q_ref_q),
      .i_d_ref_i  ('0),
      .busy_o     (unused_loop_busy),
      .valid_o    (loop_valid),
      .cmp_a_o    (cmp_a),
      .cmp_b_o    (cmp_b),
      .cmp_c_o    (cmp_c),
      .i_a_o      (i_a),
      .i_b_o      (i_b),
      .i_d_o      (i_d),
      .i_q_o      (i_q),
      .v_d_o      (v_d),
      .v_q_o      (v_q),
      .limited_o  (limited),
      .awake_o    (loop_awake),
      .quiescent_o(unused_loop_quiescent)
  );

  // The third current is -(i_a + i_b).
  assign over_current_o = reached(sum_t'(i_a), current_limit_i) ||
      reached(sum_t'(i_b), current_limit_i) ||
      reached(sum_t'(i_a) + sum_t'(i_b), current_limit_i);

  // ---- gates ----

  logic [2:0] on, leg_quiescent;
  logic [9:0] dead_time;
  logic pwm_quiescent;
  gap_t pwm_next, leg_next[3];

  assign dead_time = regs_i.deadtime.clk.value < dead_time_min_i ? dead_time_min_i :
      regs_i.deadtime.clk.value;

  pwm u_pwm (
      .clk_i      (clk_gates),
      .rst_i      (rst_i),
      .phase_i    (phase_i),
      .rest_i     (rest_i),
      .load_i     (tick_cur_i),
      .enable_i   (regs_i.ctrl.enable.value),
      .cmp_a_i    (cmp_a),
      .cmp_b_i    (cmp_b),
      .cmp_c_i    (cmp_c),
      .on_o       (on),
      .next_o     (pwm_next),
      .quiescent_o(pwm_quiescent)
  );

  for (genvar n = 0; n < 3; n++) begin : gen_leg
    gate_leg u_leg (
        .clk_i      (clk_i),
        .clock_en_i (clock_en_i.gates),
        .rst_i      (rst_i),
        .leap_i     (leap_i),
        .enable_i   (regs_i.ctrl.enable.value),
        .trip_i     (trip_i),
        .dead_time_i(dead_time),
        .on_i       (on[n]),
        .hi_o       (gate_hi_o[n]),
        .lo_o       (gate_lo_o[n]),
        .next_o     (leg_next[n]),
        .quiescent_o(leg_quiescent[n])
    );
  end

  always_comb begin
    next_o = pwm_next;
    for (int unsigned n = 0; n < 3; n++) begin
      if (leg_next[n] < next_o) next_o = leg_next[n];
    end
  end

  assign awake_o.gates       = !pwm_quiescent || leg_quiescent != '1;
  assign awake_o.sense       = !qep_quiescent;
  assign awake_o.loop.svpwm  = loop_awake.svpwm;
  assign awake_o.loop.pi     = loop_awake.pi;
  assign awake_o.loop.rotate = loop_awake.rotate;
  assign awake_o.loop.angle  = loop_awake.angle || tick_cur_i;
  assign awake_o.adc         = !adc_quiescent;
  assign awake_o.position    = !command_quiescent || !afc_quiescent || tab_pending_q ||
      tab_request || tick_pos_i;
  assign wake_regs_o         = overrun || qep_error || (iq_valid && saturated) ||
      (loop_valid && limited);
  assign quiescent_o         = awake_o == '0 && !wake_regs_o;
  // ---- what the registers show ----

  // Continuous, not procedural: simulators then see separate fields, not one wide word.
  assign regs_o.status.busy.next        = afc_busy;
  assign regs_o.status.overrun.hwset    = overrun || precision_i.overrun;
  assign regs_o.status.qep_error.hwset  = qep_error;
  assign regs_o.status.saturated.hwset  = iq_valid && saturated || precision_i.saturated;
  assign regs_o.status.limited.hwset    = loop_valid && limited;
  assign regs_o.status.underrun.hwset   = precision_i.underrun;
  assign regs_o.status.clipped.hwset    = precision_i.clipped;
  assign regs_o.status.step.next        = step;
  assign regs_o.pos.value.next          = 32'(x_p_q);
  assign regs_o.pos_model.value.next    = 32'(x_r);
  assign regs_o.err.value.next          = 32'(e);
  assign regs_o.derr.value.next         = 32'(de);
  assign regs_o.u.value.next            = 32'(u);
  assign regs_o.vstar.value.next        = 32'(v_star);
  assign regs_o.iq_cmd.value.next       = 32'(iq_ref);
  assign regs_o.speed.value.next        = 32'(v);
  assign regs_o.id_iq.i_d.next          = 16'(i_d);
  assign regs_o.id_iq.i_q.next          = 16'(i_q);
  assign regs_o.vd_vq.v_d.next          = 16'(v_d);
  assign regs_o.vd_vq.v_q.next          = 16'(v_q);
  assign regs_o.index_latch.value.next  = 32'(index_latch);
  assign regs_o.deadtime.clk.swwel      = locked_i;
  assign regs_o.phase_currents.i_a.next = 16'(i_a);
  assign regs_o.phase_currents.i_b.next = 16'(i_b);
  assign regs_o.angle_step.value.swwel  = locked_i;
  assign regs_o.current_offset.a.swwel  = locked_i;
  assign regs_o.current_offset.b.swwel  = locked_i;
  assign regs_o.adc_frame.zeros.swwel   = locked_i;
  assign regs_o.stroke_min.value.swwel  = locked_i;
  assign regs_o.stroke_max.value.swwel  = locked_i;
  assign regs_o.stroke_en.enable.swwel  = locked_i;
  assign regs_o.tab_data.rd_data.value  = 32'(rule_rdata);
  assign regs_o.tab_data.rd_ack         = regs_i.tab_data.req && !regs_i.tab_data.req_is_wr;
  assign regs_o.tab_data.wr_ack         = tab_write ||
      regs_i.tab_data.req && regs_i.tab_data.req_is_wr && tab_in_part;
  assign regs_o.pos_preset.wr_ack       = preset_write;
  assign regs_o.prec_addr.word.we       = precision_i.counts;
  assign regs_o.prec_addr.word.next     = regs_i.prec_addr.word.value + 5'd1;
  assign regs_o.prec_data.wr_ack        = precision_i.written;
  assign regs_o.prec_data.rd_ack        = precision_i.read;
  assign regs_o.prec_data.rd_data.value = precision_i.data;
  assign regs_o.prec_err.rd_ack         = precision_i.read;
  assign regs_o.prec_err.rd_data.value  = precision_i.data;
  assign regs_o.err_sum.rd_ack          = precision_i.read;
  assign regs_o.err_sum.rd_data.value   = precision_i.data;
  assign regs_o.iq_sum.rd_ack           = precision_i.read;
  assign regs_o.iq_sum.rd_data.value    = precision_i.data;
  assign regs_o.prec_dist.rd_ack        = precision_i.read;
  assign regs_o.prec_dist.rd_data.value = precision_i.data;

  logic unused_regs;
  assign unused_regs = ^{regs_i.status, regs_i.ctrl.precision, regs_i.tab_data, regs_i.pos_preset,
      regs_i.prec_data, regs_i.prec_err, regs_i.err_sum, regs_i.iq_sum, regs_i.prec_dist};

endmodule
