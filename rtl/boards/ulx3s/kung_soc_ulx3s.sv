// SPDX-License-Identifier: Apache-2.0
//
// kung_soc on a ULX3S (LFE5U-12F to 85F): four connectors of 8 pins on J1 and J2, the console on
// the USB bridge. Button FIRE1 resets. Pins and wiring: README.md beside this file.

module kung_soc_ulx3s (
    input  logic clk_25mhz_i,
    input  logic btn_reset_i,
    input  logic ftdi_txd_i,
    output logic ftdi_rxd_o,
    output logic wifi_gpio0_o,
    output logic [7:0] led_o,

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

  kung_soc_ecp5 u_soc (
      .clk_25mhz_i  (clk_25mhz_i),
      .reset_i      (btn_reset_i),
      .uart_rx_i    (ftdi_txd_i),
      .uart_tx_o    (ftdi_rxd_o),
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
      .status_o     (led_o)
  );

  assign wifi_gpio0_o = 1'b1;  // low would reset the board

  logic unused_spare;
  assign unused_spare = ^spare_i;

endmodule
