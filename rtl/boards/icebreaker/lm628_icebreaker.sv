// SPDX-License-Identifier: Apache-2.0
//
// The LM629 on an iCEBreaker (iCE40 UP5K): host port on Pmod 1A and 1B, encoder and H-bridge on
// Pmod 2. A PLL makes 19.875 MHz of the board's 12 MHz, from which the part makes 7.95 MHz, 0.6 %
// below its 8. RST is the user button or a pin; after configuration it must be strobed, as with
// the part. Outputs to the bridge are 0 until then. Pins: README.md beside this file.

module lm628_icebreaker (
    input  logic clk_12mhz_i,
    input  logic btn_n_i,
    output logic led_red_n_o,    // on: not yet reset
    output logic led_green_n_o,  // on: the PWM output is not zero

    input logic       reset_n_i,
    input logic       cs_n_i,
    input logic       rd_n_i,
    input logic       wr_n_i,
    input logic       ps_i,
    inout wire  [7:0] d_io,
    output logic      hi_o,

    input  logic       enc_a_i,
    input  logic       enc_b_i,
    input  logic       enc_idx_n_i,
    output logic       pwm_mag_o,
    output logic       pwm_sign_o,
    output logic       driver_en_o  // low until RST has been strobed
);

  logic clk, locked;

  // 12 MHz x 53 / 32
  SB_PLL40_PAD #(
      .FEEDBACK_PATH("SIMPLE"),
      .DIVR         (4'd0),
      .DIVF         (7'd52),
      .DIVQ         (3'd5),
      .FILTER_RANGE (3'd1)
  ) u_pll (
      .PACKAGEPIN  (clk_12mhz_i),
      .PLLOUTGLOBAL(clk),
      .RESETB      (1'b1),
      .BYPASS      (1'b0),
      .LOCK        (locked)
  );

  logic [7:0] d;
  logic d_oe, magnitude, sign, reset_n, low_q = 1'b0, ready_q = 1'b0;

  assign reset_n = btn_n_i && reset_n_i && locked;
  assign d_io    = d_oe ? d : 'z;

  // A strobe is seen at its end; until the first one the bridge gets nothing.
  always_ff @(posedge clk) begin
    low_q <= !reset_n && locked;
    if (low_q && reset_n) ready_q <= 1'b1;
  end

  lm628 #(
      .Inc(10)
  ) u_chip (
      .clk_i      (clk),
      .clock_en_i ('1),
      .rst_i      (1'b0),
      .leap_i     ('0),
      .wrap_i     (1'b0),
      .reset_n_i  (reset_n),
      .cs_n_i     (cs_n_i),
      .rd_n_i     (rd_n_i),
      .wr_n_i     (wr_n_i),
      .ps_i       (ps_i),
      .d_i        (d_io),
      .d_o        (d),
      .d_oe_o     (d_oe),
      .hi_o       (hi_o),
      .enc_a_i    (enc_a_i),
      .enc_b_i    (enc_b_i),
      .enc_idx_n_i(enc_idx_n_i),
      .dac_o      (),
      .dac_hi_lo_o(),
      .dac_wr_n_o (),
      .pwm_mag_o  (magnitude),
      .pwm_sign_o (sign),
      .sample_o   (),
      .next_o     (),
      .quiescent_o(),
      .awake_o    (),
      .timed_o    ()
  );

  assign pwm_mag_o     = magnitude && ready_q;
  assign pwm_sign_o    = sign && ready_q;
  assign driver_en_o   = ready_q;
  assign led_red_n_o   = ready_q;
  assign led_green_n_o = !pwm_mag_o;

endmodule
