// SPDX-License-Identifier: Apache-2.0
//
// What the pins of an LM628 or LM629 share (data sheet SNVS781C): a data bus of two directions, and
// the output port, whose pins mean three things:
//
//   pin      18 to 23         24       25
//   8 bits   dac[7:2]         dac[1]   dac[0]
//   12 bits  dac[7:2]         HI/LO    WR: strobes
//   LM629    SIGN, MAG, 0000  0        0
//
// The part does not say which width it has: a sample with a strobe has 12 bits. As it leaves a
// reset it strobes 12 bits of zero; Hold clocks later the port has 8.
//
// direction_o turns a bus transceiver, which stays enabled: toward the host a clock before d_oe_o
// begins, and back a clock after it ended, so that two never drive one wire.

module lm628_pins #(
    parameter int unsigned Variant = 628
) (
    input logic clk_i,
    input logic rst_i,

    input  logic       d_oe_i,       // of the part
    output logic       d_oe_o,       // of the pins
    output logic       direction_o,

    input  logic       sample_i,
    input  logic [7:0] dac_i,
    input  logic       dac_hi_lo_i,
    input  logic       dac_wr_n_i,
    input  logic       pwm_mag_i,
    input  logic       pwm_sign_i,
    output logic [7:0] out_o         // bit 7 is pin 18, bit 0 pin 25
);

  if (Variant != 628 && Variant != 629) begin : gen_refused
    $error("lm628_pins: Variant is 628 or 629");
  end

  localparam logic [6:0] Hold = 7'd127;  // longer than a part waits before it strobes, 67
  localparam logic [7:0] Zero = Variant == 628 ? 8'h83 : 8'h00;

  logic oe_q, direction_q, sample_q, twelve_q, strobes, eight;
  logic [6:0] hold_q;
  logic [7:0] out, out_q;

  assign strobes = !dac_wr_n_i || !dac_hi_lo_i;
  assign eight   = !strobes && (sample_q || (!twelve_q && hold_q == '0));

  assign out = Variant == 629 ? {pwm_sign_i, pwm_mag_i, 6'd0} :
      {dac_i[7:2], eight ? dac_i[1:0] : {dac_hi_lo_i, dac_wr_n_i}};

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      oe_q        <= 1'b0;
      direction_q <= 1'b0;
      sample_q    <= 1'b0;
      twelve_q    <= 1'b0;
      hold_q      <= Hold;
      out_q       <= Zero;
    end else begin
      oe_q        <= d_oe_i && direction_q;
      direction_q <= d_oe_i || oe_q;
      sample_q    <= sample_i;
      if (sample_q) twelve_q <= strobes;
      if (strobes) hold_q <= Hold;
      else if (sample_q) hold_q <= '0;
      else if (hold_q != '0) hold_q <= hold_q - 7'd1;
      out_q <= out;
    end
  end

  assign d_oe_o      = oe_q;
  assign direction_o = direction_q;
  assign out_o       = out_q;

endmodule
