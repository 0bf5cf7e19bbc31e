// SPDX-License-Identifier: Apache-2.0
//
// Replays recorded pins into a netlist of kung_xy and prints every clock in which something
// happened: edge, gates, interrupt line, sample tick seen, sample done, transfer ended, last data
// read, then the two words an axis that the event hash holds. +pins=FILE +end=EDGE
`timescale 1ns / 1ps

module replay;
  reg clk = 0, rst = 1, awvalid = 0, wvalid = 0, arvalid = 0, trip = 0;
  reg [9:0] awaddr = 0, araddr = 0;
  reg [31:0] wdata = 0;
  reg [1:0] enc_a = 0, enc_b = 0, enc_z = 0, sdata_a = 0, sdata_b = 0;
  wire bvalid, rvalid, irq, tick, sample;
  wire [31:0] rdata;
  wire [5:0] hi, lo;

  kung_xy dut (
      .clk_i(clk),
      .rst_i(rst),
      .clock_en_i(12'hfff),
      .leap_i(12'd0),
      .s_axil_awvalid_i(awvalid),
      .s_axil_awaddr_i(awaddr),
      .s_axil_awprot_i(3'd0),
      .s_axil_wvalid_i(wvalid),
      .s_axil_wdata_i(wdata),
      .s_axil_wstrb_i(4'hf),
      .s_axil_bvalid_o(bvalid),
      .s_axil_bready_i(1'b1),
      .s_axil_arvalid_i(arvalid),
      .s_axil_araddr_i(araddr),
      .s_axil_arprot_i(3'd0),
      .s_axil_rvalid_o(rvalid),
      .s_axil_rready_i(1'b1),
      .s_axil_rdata_o(rdata),
      .enc_a_i(enc_a),
      .enc_b_i(enc_b),
      .enc_z_i(enc_z),
      .trip_i(trip),
      .adc_sdata_a_i(sdata_a),
      .adc_sdata_b_i(sdata_b),
      .gate_hi_o(hi),
      .gate_lo_o(lo),
      .irq_o(irq),
      .tick_o(tick),
      .sample_o(sample)
  );

  integer file, got, now, at, last;
  reg [8*256:1] name;
  reg n_rst, n_awvalid, n_wvalid, n_arvalid, n_trip;
  reg [9:0] n_awaddr, n_araddr;
  reg [31:0] n_wdata, data;
  reg [1:0] n_enc_a, n_enc_b, n_enc_z, n_sdata_a, n_sdata_b;
  reg ended, ticked, irq_before;
  reg [5:0] hi_before, lo_before;

  task read_line;
    begin
      got = $fscanf(file, "%d %1h%1h%1h%1h %h %h %h %h %h %h %h %h %h", at, n_rst, n_awvalid,
                    n_wvalid, n_arvalid, n_awaddr, n_araddr, n_wdata, n_enc_a, n_enc_b, n_enc_z,
                    n_trip, n_sdata_a, n_sdata_b);
    end
  endtask

  initial begin
    if (!$value$plusargs("pins=%s", name) || !$value$plusargs("end=%d", last)) $finish;
    file = $fopen(name, "r");
    read_line;
    data = 0;
    irq_before = 0;
    hi_before = 0;
    lo_before = 0;
    for (now = -4; now < last; now = now + 1) begin
      if (got == 14 && at == now) begin
        {rst, awvalid, wvalid, arvalid} = {n_rst, n_awvalid, n_wvalid, n_arvalid};
        {awaddr, araddr, wdata, trip} = {n_awaddr, n_araddr, n_wdata, n_trip};
        {enc_a, enc_b, enc_z} = {n_enc_a, n_enc_b, n_enc_z};
        {sdata_a, sdata_b} = {n_sdata_a, n_sdata_b};
        read_line;
      end
      #10;
      ended  = bvalid || rvalid;
      ticked = tick;
      if (rvalid) data = rdata;
      clk = 1;
      #10;
      if (now >= 0 && (ended || ticked || sample || (irq && !irq_before) || hi != hi_before ||
                       lo != lo_before)) begin
        $display("%0d %0h %0h %b%b%b%b %0h %0h %0h %0h %0h", now, hi, lo, irq, ticked, sample,
                 ended, data, dut.\gen_axis[0].u_axis.u_afc.x_m_q ,
                 dut.\gen_axis[0].u_axis.u_afc.i_q_ref_q ,
                 dut.\gen_axis[1].u_axis.u_afc.x_m_q ,
                 dut.\gen_axis[1].u_axis.u_afc.i_q_ref_q );
      end
      irq_before = irq;
      hi_before = hi;
      lo_before = lo;
      clk = 0;
    end
    $finish;
  end
endmodule
