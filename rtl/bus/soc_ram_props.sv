// SPDX-License-Identifier: Apache-2.0
//
// Properties of soc_ram for any input. One word is watched: its address is that of the data port at
// reset, so any of them in the proof; shadow_q is what was written to it, byte by byte.

module soc_ram_props #(
    parameter int unsigned Words = 64
) (
    input logic clk_i,
    input logic rst_i,

    input logic i_valid_i,
    input logic i_ready_o,
    input logic d_valid_i,
    input logic d_ready_o,

    input logic [$clog2(Words)-1:0] i_addr_i,
    input logic [$clog2(Words)-1:0] d_addr_i,
    input logic [              3:0] d_wstrb_i,
    input logic [             31:0] d_wdata_i,
    input logic [             31:0] i_rdata_o,
    input logic [             31:0] d_rdata_o,

    input logic [31:0] words[Words]
);

  logic live_q = 1'b0;
  logic was_i_q, was_d_q;  // asked, and answered now
  logic i_asked, d_asked;
  logic [31:0] was_i_rdata_q, was_d_rdata_q;
  logic [$clog2(Words)-1:0] watch_q;
  logic [3:0] known_q;  // bytes written since the reset
  logic [31:0] shadow_q, mask;
  logic i_reads_q, d_reads_q;  // the port answers with the watched word
  logic [31:0] expected_q, i_mask_q, d_mask_q;

  assign i_asked = i_valid_i && !was_i_q;
  assign d_asked = d_valid_i && !was_d_q;
  assign mask    = {{8{known_q[3]}}, {8{known_q[2]}}, {8{known_q[1]}}, {8{known_q[0]}}};

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_i_q       <= !rst_i && i_asked;
    was_d_q       <= !rst_i && d_asked;
    was_i_rdata_q <= i_rdata_o;
    was_d_rdata_q <= d_rdata_o;
    i_reads_q     <= !rst_i && i_asked && i_addr_i == watch_q;
    d_reads_q     <= !rst_i && d_asked && d_addr_i == watch_q && d_wstrb_i == '0;
    expected_q    <= shadow_q;
    i_mask_q      <= mask;
    d_mask_q      <= mask;
    if (rst_i) begin
      watch_q <= d_addr_i;
      known_q <= '0;
    end else if (d_asked && d_addr_i == watch_q) begin
      known_q <= known_q | d_wstrb_i;
      for (int unsigned n = 0; n < 4; n++) begin
        if (d_wstrb_i[n]) shadow_q[8*n+:8] <= d_wdata_i[8*n+:8];
      end
    end
    if (live_q) begin
      instruction_port_answers_1_clock_later : assert (i_ready_o == was_i_q);
      data_port_answers_1_clock_later : assert (d_ready_o == was_d_q);
      instruction_is_what_was_written :
      assert (!i_reads_q || ((i_rdata_o ^ expected_q) & i_mask_q) == '0);
      data_is_what_was_written :
      assert (!d_reads_q || ((d_rdata_o ^ expected_q) & d_mask_q) == '0);
      ports_hold_what_they_read :
      assert ((was_i_q || i_rdata_o == was_i_rdata_q) && (was_d_q || d_rdata_o == was_d_rdata_q));
      inv_word : assert (((words[watch_q] ^ shadow_q) & mask) == '0);
      reaches_a_read_of_four_written_bytes : cover (d_reads_q && known_q == '1 && d_rdata_o != '0);
    end
  end

  // breaks instruction_port_answers_1_clock_later: i_ready_q <= i_valid_i
  // breaks data_port_answers_1_clock_later: d_ready_q <= d_asked && d_wstrb_i == '0
  // breaks instruction_is_what_was_written: i_rdata_q <= i_asked ? words[d_addr_i] : i_rdata_q
  // breaks data_is_what_was_written: d_rdata_q <= d_asked ? words[i_addr_i] : d_rdata_q
  // breaks ports_hold_what_they_read: i_rdata_q <= words[i_addr_i]

  // prove: set Words=4

endmodule

bind soc_ram soc_ram_props #(.Words(Words)) u_soc_ram_props (.*);
