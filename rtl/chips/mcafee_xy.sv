// SPDX-License-Identifier: Apache-2.0
//
// Two LM628 behind McAfee's port of two bytes, and the fuzzy feed rate of self-paced tracking
// (McAfee 1994, chapters IV and VI, appendices B to D), in a 50 MHz fabric. Inc sets the clock of
// the parts: 3 for his 6 MHz, 4 for 8 MHz.
//
// Both parts leave reset together, and their samples then coincide; a command RESET to one of them
// ends that. The limit switches are only reported: they cut the motors' power themselves.

module mcafee_xy
  import trammel_pkg::*;
#(
    parameter int unsigned Inc = 3
) (
    input logic clk_i,
    input lm628_pkg::domains_t clock_en_i,  // of both parts; all high: no clock is gated
    input logic rst_i,

    input gap_t leap_i,

    input  logic        s_axil_awvalid_i,
    output logic        s_axil_awready_o,
    input  logic [ 5:0] s_axil_awaddr_i,
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
    input  logic [ 5:0] s_axil_araddr_i,
    input  logic [ 2:0] s_axil_arprot_i,
    output logic        s_axil_rvalid_o,
    input  logic        s_axil_rready_i,
    output logic [31:0] s_axil_rdata_o,
    output logic [ 1:0] s_axil_rresp_o,

    input  logic [1:0] enc_a_i,
    input  logic [1:0] enc_b_i,
    input  logic [1:0] enc_idx_n_i,
    input  logic [3:0] limit_i,
    output logic [7:0] dac_x_o,
    output logic [7:0] dac_y_o,

    // The bus between bridge and parts, for measurement.
    output logic cs_x_n_o,
    output logic cs_y_n_o,
    output logic rd_n_o,
    output logic wr_n_o,
    output logic ps_o,
    output logic [7:0] d_o,
    output logic transceiver_o,
    output logic selector_o,
    output logic d_oe_x_o,
    output logic d_oe_y_o,

    output logic [1:0] sample_o,
    output logic [1:0] hi_o,
    output logic irq_o,
    output gap_t next_o,
    output logic quiescent_o,
    output lm628_pkg::domains_t awake_o,
    output logic timed_o  // a domain that reads the timers is awake
);

  logic clk_system;
  assign clk_system = clk_i & clock_en_i.system;

  mcafee_xy_regs_pkg::mcafee_xy__in_t hwif_in;
  mcafee_xy_regs_pkg::mcafee_xy__out_t hwif_out;

  mcafee_xy_regs u_regs (
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

  // Busy where a request is there, one came in the previous clock or its response is waiting.
  logic asked, asked_q, bus_idle;

  assign asked    = s_axil_awvalid_i || s_axil_wvalid_i || s_axil_arvalid_i;
  assign bus_idle = !asked && !asked_q && !s_axil_bvalid_o && !s_axil_rvalid_o;

  // ---- host ----

  logic [7:0] d_x, d_y;
  logic bridge_quiescent;
  gap_t bridge_next;

  lm628_bridge u_bridge (
      .clk_i         (clk_i),
      .clock_en_i    (clock_en_i.system),
      .rst_i         (rst_i),
      .leap_i        (leap_i),
      .write_strobe_i(hwif_out.port_b.write_strobe.value),
      .read_strobe_i (hwif_out.port_b.read_strobe.value),
      .ps_i          (hwif_out.port_b.ps.value),
      .read_i        (hwif_out.port_b.read.value),
      .y_i           (hwif_out.port_b.y.value),
      .to_part_i     (hwif_out.port_c.to_part.value),
      .from_part_o   (hwif_in.port_c.from_part.next),
      .busy_o        (hwif_in.status.busy.next),
      .refused_o     (hwif_in.status.refused.hwset),
      .cs_x_n_o      (cs_x_n_o),
      .cs_y_n_o      (cs_y_n_o),
      .rd_n_o        (rd_n_o),
      .wr_n_o        (wr_n_o),
      .ps_o          (ps_o),
      .d_o           (d_o),
      .transceiver_o (transceiver_o),
      .selector_o    (selector_o),
      .d_x_i         (d_x),
      .d_y_i         (d_y),
      .next_o        (bridge_next),
      .quiescent_o   (bridge_quiescent)
  );

  // ---- RST of both parts: 8 ticks of 6 MHz are 67 clocks ----

  localparam logic [6:0] Reset = 7'd80;

  logic reset_n;
  logic [6:0] reset_count;
  gap_t unused_reset_next;

  timer #(
      .Width(7)
  ) u_reset (
      .clk_i  (clk_i),
      .rst_i  (rst_i),
      .leap_i (leap_i),
      .load_i (hwif_out.reset.strobe.value),
      .value_i(Reset),
      .count_o(reset_count),
      .next_o (unused_reset_next)
  );

  assign reset_n = reset_count == '0;

  // ---- parts ----

  lm628_pkg::domains_t [1:0] awake;
  logic [1:0] unused_timed, unused_quiescent;
  gap_t next_x, next_y;
  logic [1:0] high, unused_wr_n, unused_mag, unused_sign;
  logic [7:0] dac_x, dac_y;

  lm628 #(
      .Inc(Inc)
  ) u_x (
      .clk_i      (clk_i),
      .clock_en_i (clock_en_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .wrap_i     (1'b0),
      .reset_n_i  (reset_n),
      .cs_n_i     (cs_x_n_o),
      .rd_n_i     (rd_n_o),
      .wr_n_i     (wr_n_o),
      .ps_i       (ps_o),
      .d_i        (d_o),
      .d_o        (d_x),
      .d_oe_o     (d_oe_x_o),
      .hi_o       (hi_o[0]),
      .enc_a_i    (enc_a_i[0]),
      .enc_b_i    (enc_b_i[0]),
      .enc_idx_n_i(enc_idx_n_i[0]),
      .dac_o      (dac_x),
      .dac_hi_lo_o(high[0]),
      .dac_wr_n_o (unused_wr_n[0]),
      .pwm_mag_o  (unused_mag[0]),
      .pwm_sign_o (unused_sign[0]),
      .sample_o   (sample_o[0]),
      .next_o     (next_x),
      .quiescent_o(unused_quiescent[0]),
      .awake_o    (awake[0]),
      .timed_o    (unused_timed[0])
  );

  lm628 #(
      .Inc(Inc)
  ) u_y (
      .clk_i      (clk_i),
      .clock_en_i (clock_en_i),
      .rst_i      (rst_i),
      .leap_i     (leap_i),
      .wrap_i     (1'b0),
      .reset_n_i  (reset_n),
      .cs_n_i     (cs_y_n_o),
      .rd_n_i     (rd_n_o),
      .wr_n_i     (wr_n_o),
      .ps_i       (ps_o),
      .d_i        (d_o),
      .d_o        (d_y),
      .d_oe_o     (d_oe_y_o),
      .hi_o       (hi_o[1]),
      .enc_a_i    (enc_a_i[1]),
      .enc_b_i    (enc_b_i[1]),
      .enc_idx_n_i(enc_idx_n_i[1]),
      .dac_o      (dac_y),
      .dac_hi_lo_o(high[1]),
      .dac_wr_n_o (unused_wr_n[1]),
      .pwm_mag_o  (unused_mag[1]),
      .pwm_sign_o (unused_sign[1]),
      .sample_o   (sample_o[1]),
      .next_o     (next_y),
      .quiescent_o(unused_quiescent[1]),
      .awake_o    (awake[1]),
      .timed_o    (unused_timed[1])
  );

  // As it leaves its reset a part puts out 12 bits of zero, the low ones first: no byte for these
  // converters.
  assign dac_x_o = high[0] ? dac_x : 8'h80;
  assign dac_y_o = high[1] ? dac_y : 8'h80;

  // ---- feed rate: a write while it computes is taken afterwards ----

  logic feed_asked_q, feeding_q, fed_q, feed_starts, feed_valid, feed_ready, feed_quiescent;
  logic [7:0] speed;

  assign feed_starts = feed_asked_q && !feeding_q;
  assign feed_ready  = fed_q && !feed_asked_q;

  feed_rate u_feed (
      .clk_i      (clk_system),
      .rst_i      (rst_i),
      .tick_i     (feed_starts),
      .c_i        (hwif_out.feed_in.c.value),
      .cc_i       (hwif_out.feed_in.cc.value),
      .valid_o    (feed_valid),
      .v_o        (speed),
      .quiescent_o(feed_quiescent)
  );

  // ---- limit switches ----

  logic [3:0] limit_meta_q, limit_q;

  always_ff @(posedge clk_system) begin
    limit_meta_q <= limit_i;
    limit_q      <= limit_meta_q;
  end

  always_ff @(posedge clk_system) begin
    if (rst_i) begin
      asked_q      <= 1'b0;
      feed_asked_q <= 1'b0;
      feeding_q    <= 1'b0;
      fed_q        <= 1'b0;
    end else begin
      asked_q      <= asked;
      feed_asked_q <= hwif_out.feed_in.c.swmod || (feed_asked_q && feeding_q);
      feeding_q    <= feed_starts || (feeding_q && !feed_valid);
      fed_q        <= feed_valid || (fed_q && !feed_starts);
    end
  end

  assign hwif_in.feed_out.ready.next = feed_ready;
  assign hwif_in.feed_out.v.next     = feed_ready ? speed : '0;
  assign hwif_in.status.sample.hwset = sample_o[0];
  assign hwif_in.irq.x.next          = hi_o[0];
  assign hwif_in.irq.y.next          = hi_o[1];
  assign {hwif_in.limits.y_high.next, hwif_in.limits.y_low.next, hwif_in.limits.x_high.next,
          hwif_in.limits.x_low.next} = limit_q;

  assign irq_o = hi_o != '0;

  always_comb begin
    next_o = bridge_next;
    if (next_x < next_o) next_o = next_x;
    if (next_y < next_o) next_o = next_y;
  end

  // One net for each domain, so that a simulator follows each by itself.
  logic awake_system, awake_engine, awake_sense;

  assign awake_system = !(bus_idle && bridge_quiescent && feed_quiescent && !feed_asked_q &&
      !feeding_q && limit_i == limit_meta_q && limit_meta_q == limit_q) ||
      awake[0].system || awake[1].system;
  assign awake_engine = awake[0].engine || awake[1].engine;
  assign awake_sense  = awake[0].sense || awake[1].sense;
  assign awake_o      = '{system: awake_system, engine: awake_engine, sense: awake_sense};
  assign timed_o      = awake_system;
  assign quiescent_o  = awake_o == '0;

  logic unused_bits;
  assign unused_bits = ^{hwif_out.status, unused_wr_n, unused_mag, unused_sign, unused_reset_next};

endmodule
