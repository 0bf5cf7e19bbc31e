// SPDX-License-Identifier: Apache-2.0
//
// kung_soc on a Colorlight i5 v7.0 (LFE5U-25F) in its extension board v1.2: the connectors of 8
// pins are its Pmod headers. The button resets. Pins and wiring: README.md beside this file.

module kung_soc_colorlight_i5 (
    input  logic clk_25mhz_i,
    input  logic btn_reset_n_i,
    input  logic uart_rx_i,
    output logic uart_tx_o,
    output logic led_n_o,

    output logic [5:0] gate_hi_o,
    output logic [5:0] gate_lo_o,
    output logic [1:0] driver_en_o,
    input  logic [1:0] driver_fault_n_i,

    output logic [1:0] adc_cs_n_o,
    input  logic [1:0] adc_sdata_a_i,
    input  logic [1:0] adc_sdata_b_i,
    output logic [1:0] adc_sclk_o,
    input  logic [1:0] enc_a_i,
    input  logic [1:0] enc_b_i,
    input  logic [1:0] enc_z_i,
    input  logic [1:0] spare_i
);

  logic [7:0] status;

  kung_soc_ecp5 u_soc (
      .clk_25mhz_i  (clk_25mhz_i),
      .reset_i      (!btn_reset_n_i),
      .uart_rx_i    (uart_rx_i),
      .uart_tx_o    (uart_tx_o),
      .enc_a_i      (enc_a_i),
      .enc_b_i      (enc_b_i),
      .enc_z_i      (enc_z_i),
      .fault_n_i    (driver_fault_n_i),
      .adc_cs_n_o   (adc_cs_n_o),
      .adc_sclk_o   (adc_sclk_o),
      .adc_sdata_a_i(adc_sdata_a_i),
      .adc_sdata_b_i(adc_sdata_b_i),
      .gate_hi_o    (gate_hi_o),
      .gate_lo_o    (gate_lo_o),
      .driver_en_o  (driver_en_o),
      .status_o     (status)
  );

  assign led_n_o = status[1:0] == '0;  // on: an axis drives

  logic unused_bits;
  assign unused_bits = ^{spare_i, status[7:2]};

endmodule
