// SPDX-License-Identifier: Apache-2.0
//
// The 49 rules c[j][i] of the fuzzy controller (i of the error, j of its change, 0..6), Q20 of a
// unit, in block memory. Of the four rules around section (i, j) one is read or tuned per clock.
// Table reset: 49 clocks, c[j][i] = clip(2 (i + j - 6), -6, 6), begins when hold_i is low; it also
// follows rst_i, because memory has no reset. External access is by index 7 j + i; it writes only
// while neither hold_i nor busy_o is high. What it reads follows the index by one clock, and a
// write, to any rule, by two.

module rule_store
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic reset_i,  // pulse: request the table reset
    input logic hold_i,   // the controller runs: the table belongs to it

    input  logic   [2:0] i_i,     // section of the error, 0..5
    input  logic   [2:0] j_i,     // section of its change, 0..5
    input  logic   [1:0] sel_i,   // {j + 1, i + 1}: which of the four rules around it
    input  logic         read_i,
    output count_t       rule_o,  // c[j + sel_i[1]][i + sel_i[0]] of the last read

    input logic   tune_we_i,
    input count_t tune_data_i,

    input  logic   [5:0] addr_i,
    input  logic         we_i,
    input  count_t       wdata_i,
    output count_t       rdata_o,

    output logic busy_o,
    output logic quiescent_o
);

  localparam logic [2:0] Last = 3'd6;

  typedef enum logic [1:0] {
    StIdle,
    StAsked,  // a reset waits for hold_i to fall
    StFill
  } state_e;

  state_e state_q, state_d;
  logic [2:0] fill_i_q, fill_i_d, fill_j_q, fill_j_d;

  always_comb begin
    state_d  = state_q;
    fill_i_d = fill_i_q;
    fill_j_d = fill_j_q;
    unique case (state_q)
      StIdle: if (reset_i) state_d = StAsked;
      StAsked: begin
        fill_i_d = '0;
        fill_j_d = '0;
        if (!hold_i) state_d = StFill;
      end
      default: begin  // StFill; a reset requested meanwhile is this one
        fill_i_d = fill_i_q == Last ? '0 : fill_i_q + 3'd1;
        if (fill_i_q == Last) fill_j_d = fill_j_q + 3'd1;
        if (fill_i_q == Last && fill_j_q == Last) state_d = StIdle;
      end
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q  <= StAsked;
      fill_i_q <= '0;
      fill_j_q <= '0;
    end else begin
      state_q  <= state_d;
      fill_i_q <= fill_i_d;
      fill_j_q <= fill_j_d;
    end
  end

  logic stale;  // rdata_o is not the rule at addr_i

  assign busy_o = state_q != StIdle;
  assign quiescent_o = !busy_o && !reset_i && !read_i && !tune_we_i && !we_i && !stale;

  // Initial value (Kung eq. 19): the clipped plane in units, in the top four bits.
  function automatic count_t initial_rule(logic [2:0] i, logic [2:0] j);
    logic signed [4:0] twice;  // i + j - 6, -6..6
    twice = 5'(i) + 5'(j) - 5'd6;
    if (twice >= 5'sd3) return {4'd6, 20'd0};
    if (twice <= -5'sd3) return {-4'sd6, 20'd0};
    return {twice[2:0], 21'd0};
  endfunction

  // Index 7 j + i = 8 h + l = 7 h + (h + l).
  logic [2:0] ext_i, ext_j, high;
  logic [3:0] digits;
  logic ext_valid;
  always_comb begin
    high = addr_i[5:3];
    digits = 4'(high) + 4'(addr_i[2:0]);
    ext_j = high + 3'(digits >= 4'd7);
    ext_i = digits >= 4'd7 ? 3'(digits - 4'd7) : digits[2:0];
    ext_valid = !(addr_i[5] && addr_i[4] && addr_i[3:0] != '0);
  end

  logic [2:0] fired_i, fired_j;
  assign fired_i = i_i + 3'(sel_i[0]);
  assign fired_j = j_i + 3'(sel_i[1]);

  // One writer at a time: table reset, tuning, external access.
  logic we;
  logic [2:0] write_i, write_j;
  count_t wdata;
  always_comb begin
    we = we_i && !hold_i && ext_valid;
    write_i = ext_i;
    write_j = ext_j;
    wdata = wdata_i;
    if (tune_we_i) begin
      we = 1'b1;
      write_i = fired_i;
      write_j = fired_j;
      wdata = tune_data_i;
    end
    if (busy_o) begin
      we = state_q == StFill;
      write_i = fill_i_q;
      write_j = fill_j_q;
      wdata = initial_rule(fill_i_q, fill_j_q);
    end
  end

  // Neither read coincides with a write to its rule: the controller does not read the rule that it
  // tunes, and the external read waits for a clock without a write.
  (* no_rw_check *) count_t mem_q[64];  // at {j, i}
  count_t rule_q, ext_q;
  logic [5:0] ext_addr_q;
  logic ext_valid_q, written_q, ext_read;

  assign stale    = written_q || addr_i != ext_addr_q;
  assign ext_read = stale && !we;

  always_ff @(posedge clk_i) begin
    if (we) mem_q[{write_j, write_i}] <= wdata;
    if (read_i) rule_q <= mem_q[{fired_j, fired_i}];
    if (ext_read) ext_q <= mem_q[{ext_j, ext_i}];
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      written_q   <= 1'b1;
      ext_addr_q  <= '0;
      ext_valid_q <= 1'b0;
    end else if (we) begin
      written_q <= 1'b1;
    end else if (stale) begin
      written_q   <= 1'b0;
      ext_addr_q  <= addr_i;
      ext_valid_q <= ext_valid;
    end
  end

  assign rule_o  = rule_q;
  assign rdata_o = ext_valid_q ? ext_q : '0;

endmodule
