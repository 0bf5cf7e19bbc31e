// SPDX-License-Identifier: Apache-2.0
//
// Motion controller compatible with National's LM628 and LM629 (data sheet SNVS781C, AN-693), in a
// 50 MHz fabric. Inc sets the part's clock: 4 for 8 MHz (LM628-8), 3 for 6 MHz (-6); 10 is 8 MHz in
// a 20 MHz fabric.
//
// The pins are those of the part; reset_n_i is one, rst_i is not. The index is where enc_a_i,
// enc_b_i and enc_idx_n_i are low together. wrap_i is ours: products and sum of the filter wrap at
// 16 bits instead of saturating.

module lm628
  import trammel_pkg::*;
  import lm628_pkg::*;
#(
    parameter int unsigned Inc = 4
) (
    input logic clk_i,
    input domains_t clock_en_i,  // all high: no clock is gated
    input logic rst_i,

    input gap_t leap_i,

    input logic wrap_i,

    input logic reset_n_i,

    input  logic       cs_n_i,
    input  logic       rd_n_i,
    input  logic       wr_n_i,
    input  logic       ps_i,
    input  logic [7:0] d_i,
    output logic [7:0] d_o,
    output logic       d_oe_o,
    output logic       hi_o,

    input  logic       enc_a_i,
    input  logic       enc_b_i,
    input  logic       enc_idx_n_i,
    output logic [7:0] dac_o,
    output logic       dac_hi_lo_o,
    output logic       dac_wr_n_o,
    output logic       pwm_mag_o,
    output logic       pwm_sign_o,

    output logic sample_o,  // at the edge that publishes the results of a sample
    output gap_t next_o,
    output logic quiescent_o,
    output domains_t awake_o,
    output logic timed_o  // a domain that reads the timers is awake
);

  logic clk_system, clk_engine, clk_sense;
  assign clk_system = clk_i & clock_en_i.system;
  assign clk_engine = clk_i & clock_en_i.engine;
  assign clk_sense  = clk_i & clock_en_i.sense;

  // ---- reset ----

  logic reset_n_meta_q, reset_n_q, restart, rst;

  always_ff @(posedge clk_system) begin
    reset_n_meta_q <= reset_n_i;
    reset_n_q      <= reset_n_meta_q;
  end

  assign rst = rst_i || !reset_n_q || restart;

  // ---- time ----

  logic begins, ready, sample, open, commit, time_quiescent;
  gap_t time_next;

  lm628_time #(
      .Inc(Inc)
  ) u_time (
      .clk_i      (clk_i),
      .clock_en_i (clock_en_i.system),
      .rst_i      (rst),
      .leap_i     (leap_i),
      .begin_o    (begins),
      .ready_o    (ready),
      .sample_o   (sample),
      .open_o     (open),
      .commit_o   (commit),
      .next_o     (time_next),
      .quiescent_o(time_quiescent)
  );

  // ---- host ----

  logic start, ends, arm, sample_off, command_off, host_irq, port_quiescent;
  logic [7:0] opcode;
  logic [2:0] word_addr;
  logic [15:0] word;
  logic [31:0] reply;
  events_t sample_events, command_events, status;
  gap_t port_next;

  lm628_port #(
      .Inc(Inc)
  ) u_port (
      .clk_i           (clk_i),
      .clock_en_i      (clock_en_i.system),
      .rst_i           (rst),
      .leap_i          (leap_i),
      .commit_i        (commit),
      .open_i          (open),
      .ready_i         (ready),
      .cs_n_i          (cs_n_i),
      .rd_n_i          (rd_n_i),
      .wr_n_i          (wr_n_i),
      .ps_i            (ps_i),
      .d_i             (d_i),
      .d_o             (d_o),
      .d_oe_o          (d_oe_o),
      .hi_o            (hi_o),
      .restart_o       (restart),
      .start_o         (start),
      .end_o           (ends),
      .arm_o           (arm),
      .opcode_o        (opcode),
      .word_addr_i     (word_addr),
      .word_o          (word),
      .reply_i         (reply),
      .sample_events_i (sample_events),
      .sample_off_i    (sample_off),
      .command_events_i(command_events),
      .command_off_i   (command_off),
      .status_o        (status),
      .host_irq_o      (host_irq),
      .next_o          (port_next),
      .quiescent_o     (port_quiescent)
  );

  // ---- encoder: counts from the end of the reset routine on ----

  // The index is formed from three pins, so each is synchronised first.
  typedef struct packed {
    logic a;
    logic b;
    logic idx_n;
  } encoder_t;

  encoder_t encoder, encoder_meta_q, encoder_q;

  assign encoder = '{a: enc_a_i, b: enc_b_i, idx_n: enc_idx_n_i};

  always_ff @(posedge clk_sense) begin
    encoder_meta_q <= encoder;
    encoder_q      <= encoder_meta_q;
  end

  count_t count, index_count;
  logic index_seen, unused_dir, unused_edge, unused_up, unused_error, qep_quiescent;

  qep u_qep (
      .clk_i         (clk_sense),
      .rst_i         (rst),
      .filter_i      (4'd1),
      .preset_i      (begins),
      .preset_value_i('0),
      .clear_error_i (arm),
      .enc_a_i       (enc_a_i),
      .enc_b_i       (enc_b_i),
      .enc_z_i       (encoder_q == '0),
      .count_o       (count),
      .dir_o         (unused_dir),
      .edge_o        (unused_edge),
      .up_o          (unused_up),
      .index_latch_o (index_count),
      .index_seen_o  (index_seen),
      .error_o       (unused_error),
      .quiescent_o   (qep_quiescent)
  );

  // ---- motion ----

  logic signed [15:0] u;
  logic eight_bits, unused_busy, engine_quiescent;

  lm628_engine u_engine (
      .clk_i           (clk_engine),
      .rst_i           (rst),
      .sample_i        (sample),
      .start_i         (start),
      .commit_i        (commit),
      .end_i           (ends),
      .wrap_i          (wrap_i),
      .opcode_i        (opcode),
      .status_i        (status),
      .host_irq_i      (host_irq),
      .arm_i           (arm),
      .word_i          (word),
      .word_addr_o     (word_addr),
      .count_i         (count),
      .index_seen_i    (index_seen),
      .index_count_i   (index_count),
      .reply_o         (reply),
      .sample_events_o (sample_events),
      .sample_off_o    (sample_off),
      .command_events_o(command_events),
      .command_off_o   (command_off),
      .u_o             (u),
      .eight_bits_o    (eight_bits),
      .busy_o          (unused_busy),
      .quiescent_o     (engine_quiescent)
  );

  // ---- outputs ----

  logic output_quiescent;
  gap_t output_next;

  lm628_output #(
      .Inc(Inc)
  ) u_output (
      .clk_i       (clk_i),
      .clock_en_i  (clock_en_i.system),
      .rst_i       (rst),
      .leap_i      (leap_i),
      .commit_i    (commit),
      .eight_bits_i(eight_bits),
      .u_i         (u[15:4]),
      .dac_o       (dac_o),
      .dac_hi_lo_o (dac_hi_lo_o),
      .dac_wr_n_o  (dac_wr_n_o),
      .pwm_mag_o   (pwm_mag_o),
      .pwm_sign_o  (pwm_sign_o),
      .next_o      (output_next),
      .quiescent_o (output_quiescent)
  );

  assign sample_o = commit;

  logic unused_bits;
  assign unused_bits = ^u[3:0];

  always_comb begin
    next_o = time_next;
    if (port_next < next_o) next_o = port_next;
    if (output_next < next_o) next_o = output_next;
  end

  // One net for each domain, so that a simulator follows each by itself.
  logic awake_system, awake_engine, awake_sense;

  assign awake_system = !(reset_n_i && reset_n_meta_q && reset_n_q && time_quiescent &&
      port_quiescent && output_quiescent);
  assign awake_engine = rst || !engine_quiescent;
  assign awake_sense  = rst || !qep_quiescent || encoder != encoder_meta_q ||
      encoder_meta_q != encoder_q;
  assign awake_o      = '{system: awake_system, engine: awake_engine, sense: awake_sense};
  assign timed_o      = awake_system;
  assign quiescent_o  = awake_o == '0;

endmodule
