// SPDX-License-Identifier: Apache-2.0
//
// kung_soc on any board with an ECP5 and a clock of 25 MHz: the PLL that makes 50 MHz, and reset. A
// board's top adds its buttons and lamps.
//
// All registers begin as configured, gates and driver enables at 0, and are held in reset until
// the PLL has locked and for four clocks of 50 MHz more.

module kung_soc_ecp5 (
    input logic clk_25mhz_i,
    input logic reset_i,  // at any time, active high

    input  logic uart_rx_i,
    output logic uart_tx_o,

    input  logic [1:0] enc_a_i,
    input  logic [1:0] enc_b_i,
    input  logic [1:0] enc_z_i,
    input  logic [1:0] fault_n_i,  // of the gate drivers, open drain
    output logic [1:0] adc_cs_n_o,
    output logic [1:0] adc_sclk_o,
    input  logic [1:0] adc_sdata_a_i,
    input  logic [1:0] adc_sdata_b_i,
    output logic [5:0] gate_hi_o,
    output logic [5:0] gate_lo_o,
    output logic [1:0] driver_en_o,

    output logic [7:0] status_o  // as of kung_soc
);

  // 25 MHz x 24 / 24 feeds back, 600 MHz in the oscillator, 600 / 12 = 50 MHz.
  logic clk, feedback, locked;

  (* FREQUENCY_PIN_CLKI = "25" *) (* FREQUENCY_PIN_CLKOS = "50" *)
  (* ICP_CURRENT = "12" *) (* LPF_RESISTOR = "8" *)
  (* MFG_ENABLE_FILTEROPAMP = "1" *) (* MFG_GMCREF_SEL = "2" *)
  EHXPLLL #(
      .PLLRST_ENA      ("DISABLED"),
      .INTFB_WAKE      ("DISABLED"),
      .STDBY_ENABLE    ("DISABLED"),
      .DPHASE_SOURCE   ("DISABLED"),
      .OUTDIVIDER_MUXA ("DIVA"),
      .OUTDIVIDER_MUXB ("DIVB"),
      .OUTDIVIDER_MUXC ("DIVC"),
      .OUTDIVIDER_MUXD ("DIVD"),
      .CLKI_DIV        (1),
      .CLKFB_DIV       (1),
      .FEEDBK_PATH     ("CLKOP"),
      .CLKOP_ENABLE    ("ENABLED"),
      .CLKOP_DIV       (24),
      .CLKOP_CPHASE    (9),
      .CLKOP_FPHASE    (0),
      .CLKOS_ENABLE    ("ENABLED"),
      .CLKOS_DIV       (12),
      .CLKOS_CPHASE    (0),
      .CLKOS_FPHASE    (0)
  ) u_pll (
      .RST         (1'b0),
      .STDBY       (1'b0),
      .CLKI        (clk_25mhz_i),
      .CLKFB       (feedback),
      .CLKOP       (feedback),
      .CLKOS       (clk),
      .CLKINTFB    (),
      .PHASESEL0   (1'b0),
      .PHASESEL1   (1'b0),
      .PHASEDIR    (1'b1),
      .PHASESTEP   (1'b1),
      .PHASELOADREG(1'b1),
      .PLLWAKESYNC (1'b0),
      .ENCLKOP     (1'b0),
      .LOCK        (locked)
  );

  logic [3:0] reset_q = '1;

  always_ff @(posedge clk) reset_q <= {reset_q[2:0], !locked || reset_i};

  // The image is random numbers, in whose place trammel synth puts the firmware.
  kung_soc #(
      .Image("image.hex")
  ) u_soc (
      .clk_i         (clk),
      .rst_i         (reset_q[3]),
      .uart_rx_i     (uart_rx_i),
      .uart_tx_o     (uart_tx_o),
      .enc_a_i       (enc_a_i),
      .enc_b_i       (enc_b_i),
      .enc_z_i       (enc_z_i),
      .driver_fault_i(~fault_n_i),
      .adc_cs_n_o    (adc_cs_n_o),
      .adc_sclk_o    (adc_sclk_o),
      .adc_sdata_a_i (adc_sdata_a_i),
      .adc_sdata_b_i (adc_sdata_b_i),
      .gate_hi_o     (gate_hi_o),
      .gate_lo_o     (gate_lo_o),
      .driver_en_o   (driver_en_o),
      .status_o      (status_o)
  );

endmodule
