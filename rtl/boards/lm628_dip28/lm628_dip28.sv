// SPDX-License-Identifier: Apache-2.0
//
// The LM628 or LM629 in the place of the part in its package of 28 pins: the part and what its pins
// share. CLK is clk_i, 50 MHz: a PLL on the board makes it of the 8 MHz of the socket (25 / 4, with
// Inc = 4) or of its 6 MHz (25 / 3, with Inc = 3). After configuration RST must be strobed, as with
// the part.

module lm628_dip28 #(
    parameter int unsigned Variant = 628,
    parameter int unsigned Inc = 4
) (
    input logic clk_i,     // pin 26, CLK
    input logic reset_n_i, // 27, RST

    input  logic       cs_n_i,       // 12, CS
    input  logic       rd_n_i,       // 13, RD
    input  logic       wr_n_i,       // 15, WR
    input  logic       ps_i,         // 16, PS
    input  logic [7:0] d_i,          // 4 to 11, D7 to D0
    output logic [7:0] d_o,
    output logic       d_oe_o,
    output logic       direction_o,  // of a transceiver on them: 1 toward the host
    output logic       hi_o,         // 17, HI

    input  logic       enc_idx_n_i,  // 1, IN
    input  logic       enc_a_i,      // 2
    input  logic       enc_b_i,      // 3
    output logic [7:0] out_o         // 18 to 25
);

  if (Inc != 3 && Inc != 4) begin : gen_refused
    $error("lm628_dip28: a fabric of 20 MHz is too slow for RD with a transceiver");
  end

  logic d_oe, sample, hi_lo, strobe_n, magnitude, sign, reset_meta_q, reset_q;
  logic [7:0] dac;
  logic unused_chip_quiescent;
  trammel_pkg::gap_t unused_next;
  lm628_pkg::domains_t unused_awake;
  logic unused_timed;

  always_ff @(posedge clk_i) begin
    reset_meta_q <= !reset_n_i;
    reset_q      <= reset_meta_q;
  end

  lm628 #(
      .Inc(Inc)
  ) u_chip (
      .clk_i      (clk_i),
      .clock_en_i ('1),
      .rst_i      (1'b0),
      .leap_i     ('0),
      .wrap_i     (1'b0),
      .reset_n_i  (reset_n_i),
      .cs_n_i     (cs_n_i),
      .rd_n_i     (rd_n_i),
      .wr_n_i     (wr_n_i),
      .ps_i       (ps_i),
      .d_i        (d_i),
      .d_o        (d_o),
      .d_oe_o     (d_oe),
      .hi_o       (hi_o),
      .enc_a_i    (enc_a_i),
      .enc_b_i    (enc_b_i),
      .enc_idx_n_i(enc_idx_n_i),
      .dac_o      (dac),
      .dac_hi_lo_o(hi_lo),
      .dac_wr_n_o (strobe_n),
      .pwm_mag_o  (magnitude),
      .pwm_sign_o (sign),
      .sample_o   (sample),
      .next_o     (unused_next),
      .quiescent_o(unused_chip_quiescent),
      .awake_o(unused_awake),
      .timed_o(unused_timed)
  );

  lm628_pins #(
      .Variant(Variant)
  ) u_pins (
      .clk_i      (clk_i),
      .rst_i      (reset_q),
      .d_oe_i     (d_oe),
      .d_oe_o     (d_oe_o),
      .direction_o(direction_o),
      .sample_i   (sample),
      .dac_i      (dac),
      .dac_hi_lo_i(hi_lo),
      .dac_wr_n_i (strobe_n),
      .pwm_mag_i  (magnitude),
      .pwm_sign_i (sign),
      .out_o      (out_o)
  );

endmodule
