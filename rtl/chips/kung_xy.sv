// SPDX-License-Identifier: Apache-2.0
//
// Two-axis motion-control IC of Kung et al. 2012: linear-motor X-Y table (specification sections 1,
// 6 to 9, 11). Registers, time base, fault supervisor, precision controller and two axes;
// axis 0 is X, axis 1 is Y.
//
//   trip pin -> gates off     4 clocks
//   position tick -> sample_o 71 clocks: the words of both position controllers can be read;
//                             230 or 278 where one is the precision controller

module kung_xy
  import trammel_pkg::*;
(
    input logic clk_i,
    input kung_pkg::domains_t clock_en_i,  // all high: no clock is gated
    input logic rst_i,

    input gap_t leap_i,

    input  logic        s_axil_awvalid_i,
    output logic        s_axil_awready_o,
    input  logic [ 9:0] s_axil_awaddr_i,
    input  logic [ 2:0] s_axil_awprot_i,
    input  logic        s_axil_wvalid_i,
    output logic        s_axil_wready_o,
    input  logic [31:0] s_axil_wdata_i,
    input  logic [ 3:0] s_axil_wstrb_i,
    output logic        s_axil_bvalid_o,
    input  logic        s_axil_bready_i,
    output logic [ 1:0] s_axil_bresp_o,
    input  logic        s_axil_arvalid_i,
    output logic        s_axil_arready_o,
    input  logic [ 9:0] s_axil_araddr_i,
    input  logic [ 2:0] s_axil_arprot_i,
    output logic        s_axil_rvalid_o,
    input  logic        s_axil_rready_i,
    output logic [31:0] s_axil_rdata_o,
    output logic [ 1:0] s_axil_rresp_o,

    input  logic [1:0] enc_a_i,
    input  logic [1:0] enc_b_i,
    input  logic [1:0] enc_z_i,
    input  logic       trip_i,
    output logic [1:0] adc_cs_n_o,
    output logic [1:0] adc_sclk_o,
    input  logic [1:0] adc_sdata_a_i,
    input  logic [1:0] adc_sdata_b_i,
    output logic [5:0] gate_hi_o,
    output logic [5:0] gate_lo_o,

    output logic irq_o,
    output logic tick_o,
    output logic sample_o,
    output logic [1:0] driver_en_o,
    output logic tripped_o,
    output gap_t next_o,
    output logic quiescent_o,
    output kung_pkg::domains_t awake_o,
    output logic timed_o  // a domain that reads the timers is awake
);

  logic clk_system;
  assign clk_system = clk_i & clock_en_i.system;

  kung_xy_regs_pkg::kung_xy__in_t hwif_in;
  kung_xy_regs_pkg::kung_xy__out_t hwif_out;
  kung_xy_regs_pkg::axis_regs__out_t [1:0] axis_out;
  kung_xy_regs_pkg::axis_regs__in_t [1:0] axis_in;

  kung_xy_regs u_regs (
      .clk_i           (clk_system),
      .rst_i           (rst_i),
      .s_axil_awready_o(s_axil_awready_o),
      .s_axil_awvalid_i(s_axil_awvalid_i),
      .s_axil_awaddr_i (s_axil_awaddr_i),
      .s_axil_awprot_i (s_axil_awprot_i),
      .s_axil_wready_o (s_axil_wready_o),
      .s_axil_wvalid_i (s_axil_wvalid_i),
      .s_axil_wdata_i  (s_axil_wdata_i),
      .s_axil_wstrb_i  (s_axil_wstrb_i),
      .s_axil_bready_i (s_axil_bready_i),
      .s_axil_bvalid_o (s_axil_bvalid_o),
      .s_axil_bresp_o  (s_axil_bresp_o),
      .s_axil_arready_o(s_axil_arready_o),
      .s_axil_arvalid_i(s_axil_arvalid_i),
      .s_axil_araddr_i (s_axil_araddr_i),
      .s_axil_arprot_i (s_axil_arprot_i),
      .s_axil_rready_i (s_axil_rready_i),
      .s_axil_rvalid_o (s_axil_rvalid_o),
      .s_axil_rdata_o  (s_axil_rdata_o),
      .s_axil_rresp_o  (s_axil_rresp_o),
      .hwif_in         (hwif_in),
      .hwif_out        (hwif_out)
  );

  // ---- time ----

  carrier_t carrier;
  phase_t phase, phase_rest;
  logic tick_cur, tick_pos, tick_irq, timebase_quiescent;
  logic [31:0] tick_count;
  gap_t timebase_next;

  timebase u_timebase (
      .clk_i       (clk_i),
      .rst_i       (rst_i),
      .leap_i      (leap_i),
      .carrier_i   (hwif_out.rates.carrier.value),
      .rate_i      (hwif_out.rates.position.value),
      .irq_period_i(hwif_out.irq_period.ticks.value),
      .carrier_o   (carrier),
      .phase_o     (phase),
      .rest_o      (phase_rest),
      .tick_cur_o  (tick_cur),
      .tick_pos_o  (tick_pos),
      .tick_irq_o  (tick_irq),
      .tick_count_o(tick_count),
      .next_o      (timebase_next),
      .quiescent_o (timebase_quiescent)
  );

  // ---- faults ----

  logic [1:0] enabled, over_current, encoder, stroke;
  logic bite, trip, trip_q, fault_clear, fault_axis;
  logic watchdog_quiescent, supervisor_quiescent;
  logic [3:0] fault_code;
  logic [31:0] fault_tick;

  assign enabled     = {hwif_out.y.ctrl.enable.value, hwif_out.x.ctrl.enable.value};
  assign fault_clear = hwif_out.fault_clear.req && hwif_out.fault_clear.req_is_wr &&
      (&hwif_out.fault_clear.wr_biten.key) &&
      hwif_out.fault_clear.wr_data.key == kung_xy_regs_pkg::KeyFaultClear;

  watchdog u_watchdog (
      .clk_i      (clk_system),
      .rst_i      (rst_i),
      .tick_pos_i (tick_pos),
      .kick_i     (hwif_out.commit.take.value),
      .enable_i   (enabled != '0),
      .limit_i    (hwif_out.watchdog.limit.value),
      .bite_o     (bite),
      .quiescent_o(watchdog_quiescent)
  );

  supervisor u_supervisor (
      .clk_i         (clk_system),
      .rst_i         (rst_i),
      .tick_count_i  (tick_count),
      .enabled_i     (enabled),
      .clear_i       (fault_clear),
      .trip_pin_i    (trip_i),
      .over_current_i(over_current),
      .watchdog_i    (bite),
      .encoder_i     (encoder),
      .stroke_i      (stroke),
      .trip_o        (trip),
      .fault_code_o  (fault_code),
      .fault_axis_o  (fault_axis),
      .fault_tick_o  (fault_tick),
      .quiescent_o   (supervisor_quiescent)
  );

  // Locking always works; unlocking requires both axes disabled.
  logic locked_d, locked_q, lock_write;
  logic [31:0] lock_key;

  assign lock_key   = hwif_out.lock.wr_data.key;
  assign lock_write = hwif_out.lock.req && hwif_out.lock.req_is_wr;

  always_comb begin
    locked_d = locked_q;
    if (lock_write && (&hwif_out.lock.wr_biten.key)) begin
      if (lock_key == kung_xy_regs_pkg::KeyLock) locked_d = 1'b1;
      if (lock_key == kung_xy_regs_pkg::KeyUnlock && enabled == '0) begin
        locked_d = 1'b0;
      end
    end
  end

  // Compare values are those of the period's carrier only where it stays.
  logic rates_hold;
  assign rates_hold = locked_q || enabled != '0;

  // ---- open bus transfers: accepted addresses that wait for their response ----

  logic [2:0] open_d, open_q;
  logic bus_idle;

  assign open_d = open_q + 3'(s_axil_awvalid_i && s_axil_awready_o) +
      3'(s_axil_arvalid_i && s_axil_arready_o) - 3'(s_axil_bvalid_o && s_axil_bready_i) -
      3'(s_axil_rvalid_o && s_axil_rready_i);
  assign bus_idle = open_q == '0 && !s_axil_awvalid_i && !s_axil_wvalid_i && !s_axil_arvalid_i;

  // ---- the sample is complete when both position controllers are done ----

  logic [1:0] done, done_q, all_done;

  assign all_done = done | done_q;

  always_ff @(posedge clk_system) begin
    if (rst_i) begin
      trip_q   <= 1'b0;
      locked_q <= 1'b0;
      open_q   <= '0;
      done_q   <= '0;
    end else begin
      trip_q   <= trip;
      locked_q <= locked_d;
      open_q   <= open_d;
      done_q   <= sample_o ? '0 : all_done;
    end
  end

  // ---- axes ----

  assign axis_out[0] = hwif_out.x;
  assign axis_out[1] = hwif_out.y;

  kung_pkg::axis_domains_t [1:0] axis_en, axis_awake;
  logic [1:0] wake_regs, unused_axis_quiescent, edges, up, sense_awake;
  count_t [1:0] count_cur;
  kung_pkg::precision_t [1:0] precision_axis;
  logic awake_precision, precision_wakes_regs, edge_timed;
  gap_t axis_next[2];

  for (genvar n = 0; n < 2; n++) begin : gen_enable
    assign axis_en[n] = '{gates: clock_en_i.gates[n], sense: clock_en_i.sense[n],
        loop: clock_en_i.loop, adc: clock_en_i.adc, position: clock_en_i.position};
  end

  for (genvar n = 0; n < 2; n++) begin : gen_axis
    kung_axis u_axis (
        .clk_i          (clk_i),
        .clock_en_i     (axis_en[n]),
        .rst_i          (rst_i),
        .leap_i         (leap_i),
        .carrier_i      (carrier),
        .tick_cur_i     (tick_cur),
        .tick_pos_i     (tick_pos),
        .phase_i        (phase),
        .rest_i         (phase_rest),
        .trip_i         (trip),
        .locked_i       (locked_q),
        .commit_i       (hwif_out.commit.take.value),
        .current_limit_i(hwif_out.current_limit.value.value),
        .dead_time_min_i(hwif_out.deadtime_min.clk.value),
        .regs_i         (axis_out[n]),
        .regs_o         (axis_in[n]),
        .enc_a_i        (enc_a_i[n]),
        .enc_b_i        (enc_b_i[n]),
        .enc_z_i        (enc_z_i[n]),
        .adc_sdata_a_i  (adc_sdata_a_i[n]),
        .adc_sdata_b_i  (adc_sdata_b_i[n]),
        .adc_cs_n_o     (adc_cs_n_o[n]),
        .adc_sclk_o     (adc_sclk_o[n]),
        .edge_o         (edges[n]),
        .up_o           (up[n]),
        .count_cur_o    (count_cur[n]),
        .precision_i    (precision_axis[n]),
        .gate_hi_o      (gate_hi_o[3*n+:3]),
        .gate_lo_o      (gate_lo_o[3*n+:3]),
        .over_current_o (over_current[n]),
        .encoder_o      (encoder[n]),
        .stroke_o       (stroke[n]),
        .done_o         (done[n]),
        .next_o         (axis_next[n]),
        .wake_regs_o    (wake_regs[n]),
        .awake_o        (axis_awake[n]),
        .quiescent_o    (unused_axis_quiescent[n])
    );
  end

  kung_precision u_precision (
      .clk_i        (clk_i),
      .clock_en_i   (clock_en_i.precision),
      .sense_en_i   (clock_en_i.sense),
      .rst_i        (rst_i),
      .tick_cur_i   (tick_cur),
      .tick_pos_i   (tick_pos),
      .phase_i      (phase),
      .commit_i     (hwif_out.commit.take.value),
      .regs_i       (axis_out),
      .knot_read_i  (hwif_out.knot.req),
      .knot_ack_o   (hwif_in.knot.rd_ack),
      .edge_i       (edges),
      .up_i         (up),
      .count_i      (count_cur),
      .axis_o       (precision_axis),
      .awake_o      (awake_precision),
      .sense_awake_o(sense_awake),
      .timed_o      (edge_timed),
      .wake_regs_o  (precision_wakes_regs)
  );

  assign hwif_in.knot.rd_data.count        = precision_axis[0].data;
  assign hwif_in.x                         = axis_in[0];
  assign hwif_in.y                         = axis_in[1];
  assign hwif_in.irq_stat.tick.hwset       = tick_irq;
  assign hwif_in.irq_stat.fault.hwset      = trip && !trip_q;
  assign hwif_in.tick.value.next           = tick_count;
  assign hwif_in.fault.code.next           = fault_code;
  assign hwif_in.fault.axis.next           = fault_axis;
  assign hwif_in.fault.tick.next           = fault_tick[23:0];
  assign hwif_in.fault_clear.wr_ack        = hwif_out.fault_clear.req &&
      hwif_out.fault_clear.req_is_wr;
  assign hwif_in.lock.rd_ack               = hwif_out.lock.req && !hwif_out.lock.req_is_wr;
  assign hwif_in.lock.rd_data.key          = {31'd0, locked_q};
  assign hwif_in.lock.wr_ack               = lock_write;
  assign hwif_in.current_limit.value.swwel = locked_q;
  assign hwif_in.deadtime_min.clk.swwel    = locked_q;
  assign hwif_in.watchdog.limit.swwel      = locked_q;
  assign hwif_in.rates.carrier.swwel       = rates_hold;
  assign hwif_in.rates.position.swwel      = rates_hold;

  assign irq_o = (hwif_out.irq_stat.tick.value && hwif_out.irq_en.tick.value) ||
      (hwif_out.irq_stat.fault.value && hwif_out.irq_en.fault.value);
  assign tick_o   = tick_pos;
  assign sample_o = all_done == '1;
  assign driver_en_o = enabled & {2{!trip}};
  assign tripped_o   = trip;

  always_comb begin
    next_o = timebase_next;
    if (axis_next[0] < next_o) next_o = axis_next[0];
    if (axis_next[1] < next_o) next_o = axis_next[1];
  end

  // One net for each domain, so that a simulator follows each by itself.
  logic awake_system, awake_position, awake_adc;
  logic awake_angle, awake_rotate, awake_pi, awake_svpwm;
  logic awake_sense_x, awake_sense_y, awake_gates_x, awake_gates_y;

  assign awake_system   = !(bus_idle && watchdog_quiescent && supervisor_quiescent &&
      trip == trip_q && done == '0 && !tick_irq && wake_regs == '0 && !precision_wakes_regs);
  assign awake_position = axis_awake[0].position || axis_awake[1].position;
  assign awake_adc      = axis_awake[0].adc || axis_awake[1].adc;
  assign awake_angle    = axis_awake[0].loop.angle || axis_awake[1].loop.angle;
  assign awake_rotate   = axis_awake[0].loop.rotate || axis_awake[1].loop.rotate;
  assign awake_pi       = axis_awake[0].loop.pi || axis_awake[1].loop.pi;
  assign awake_svpwm    = axis_awake[0].loop.svpwm || axis_awake[1].loop.svpwm;
  assign awake_sense_x  = axis_awake[0].sense || sense_awake[0];
  assign awake_sense_y  = axis_awake[1].sense || sense_awake[1];
  assign awake_gates_x  = axis_awake[0].gates;
  assign awake_gates_y  = axis_awake[1].gates;

  assign awake_o = '{precision: awake_precision, system: awake_system, position: awake_position,
      adc: awake_adc,
      loop: '{angle: awake_angle, rotate: awake_rotate, pi: awake_pi, svpwm: awake_svpwm},
      sense: {awake_sense_y, awake_sense_x}, gates: {awake_gates_y, awake_gates_x}};
  assign timed_o     = awake_system || awake_gates_x || awake_gates_y || edge_timed;
  assign quiescent_o = timebase_quiescent && awake_o == '0;

  logic unused_bits;
  assign unused_bits = ^{hwif_out.fault_clear, hwif_out.lock, fault_tick[31:24]};

endmodule
