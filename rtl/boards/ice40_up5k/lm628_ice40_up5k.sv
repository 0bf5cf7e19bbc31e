// SPDX-License-Identifier: Apache-2.0
//
// lm628 on an iCE40 UP5K: what surrounds the part on a board. The clock comes from its pin, 20 MHz,
// from which the part makes its 8 MHz; it never leaps. The pins are those of the LM628 and LM629
// together, with a bidirectional data bus. Pin numbers: the board's PCF file.

module lm628_ice40_up5k (
    input logic clk_i,
    input logic reset_n_i,

    input logic       cs_n_i,
    input logic       rd_n_i,
    input logic       wr_n_i,
    input logic       ps_i,
    inout wire  [7:0] d_io,
    output logic      hi_o,

    input  logic       enc_a_i,
    input  logic       enc_b_i,
    input  logic       enc_idx_n_i,
    output logic [7:0] dac_o,
    output logic       dac_hi_lo_o,
    output logic       dac_wr_n_o,
    output logic       pwm_mag_o,
    output logic       pwm_sign_o
);

  logic [7:0] d;
  logic d_oe, unused_sample, unused_quiescent;
  trammel_pkg::gap_t unused_next;
  lm628_pkg::domains_t unused_awake;
  logic unused_timed;

  assign d_io = d_oe ? d : 'z;

  lm628 #(
      .Inc(10)
  ) u_chip (
      .clk_i(clk_i),
      .clock_en_i('1),
      .rst_i(1'b0),
      .leap_i('0),
      .wrap_i(1'b0),
      .reset_n_i(reset_n_i),
      .cs_n_i(cs_n_i),
      .rd_n_i(rd_n_i),
      .wr_n_i(wr_n_i),
      .ps_i(ps_i),
      .d_i(d_io),
      .d_o(d),
      .d_oe_o(d_oe),
      .hi_o(hi_o),
      .enc_a_i(enc_a_i),
      .enc_b_i(enc_b_i),
      .enc_idx_n_i(enc_idx_n_i),
      .dac_o(dac_o),
      .dac_hi_lo_o(dac_hi_lo_o),
      .dac_wr_n_o(dac_wr_n_o),
      .pwm_mag_o(pwm_mag_o),
      .pwm_sign_o(pwm_sign_o),
      .sample_o(unused_sample),
      .next_o(unused_next),
      .quiescent_o(unused_quiescent),
      .awake_o(unused_awake),
      .timed_o(unused_timed)
  );

endmodule
