// SPDX-License-Identifier: Apache-2.0
//
// Properties of rule_store for any input. One rule is watched: its index is the address at reset
// or at a request for the table reset, so any of them in the proof; shadow_q is what it must hold.

module rule_store_props
  import trammel_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic reset_i,
    input logic hold_i,

    input logic   [2:0] i_i,
    input logic   [2:0] j_i,
    input logic   [1:0] sel_i,
    input logic         read_i,
    input count_t       rule_o,

    input logic   tune_we_i,
    input count_t tune_data_i,

    input logic   [5:0] addr_i,
    input logic         we_i,
    input count_t       wdata_i,
    input count_t       rdata_o,

    input logic busy_o,
    input logic quiescent_o,

    input logic       stale,
    input logic       written_q,
    input logic [5:0] ext_addr_q,
    input logic       ext_valid_q,
    input count_t     ext_q,
    input logic       asked,
    input logic       filling,
    input logic [2:0] fill_i_q,
    input logic [2:0] fill_j_q,
    input logic       we,
    input count_t     mem_q[64]
);

  localparam logic [5:0] Rules = 6'd49;
  localparam logic [5:0] Asked = 6'd50;  // the request waits for hold_i

  function automatic logic [5:0] index(logic [2:0] i, logic [2:0] j);
    return 6'd7 * 6'(j) + 6'(i);
  endfunction

  // clip(2 (i + j - 6), -6, 6) units of 2^20.
  function automatic count_t initial_rule(logic [2:0] i, logic [2:0] j);
    logic signed [5:0] twice;
    twice = 6'((6'(i) + 6'(j)) << 1) - 6'sd12;
    if (twice > 6'sd6) twice = 6'sd6;
    if (twice < -6'sd6) twice = -6'sd6;
    return count_t'(twice) <<< 20;
  endfunction

  logic live_q = 1'b0;
  logic known_q = 1'b0;        // shadow_q holds
  logic [5:0] left_q;          // clocks of the table reset still to come
  logic [2:0] watch_i_q, watch_j_q;
  count_t shadow_q;
  logic idle, tuned, written, section, fired;
  logic read_q = 1'b0;         // rule_o must hold expected_q
  count_t expected_q;
  logic [5:0] watch;
  logic [2:0] watch_i, watch_j;

  always_comb begin
    watch_j = '0;
    for (int unsigned row = 1; row < 7; row++) if (addr_i >= 6'(7 * row)) watch_j = 3'(row);
    watch_i = addr_i < Rules ? 3'(addr_i - index('0, watch_j)) : '0;
  end

  assign watch = index(watch_i_q, watch_j_q);
  assign section = i_i <= 3'd5 && j_i <= 3'd5;  // there is such a section
  assign idle = left_q == '0;
  assign fired = index(i_i + 3'(sel_i[0]), j_i + 3'(sel_i[1])) == watch;
  assign tuned = tune_we_i && section && fired;
  assign written = we_i && !tune_we_i && !hold_i && addr_i == watch;

  count_t watched;  // the cell itself
  assign watched = mem_q[{watch_j_q, watch_i_q}];

  logic quiet_q;  // no write in the previous clock, whose address was addr_q
  logic [5:0] addr_q;

  always_ff @(posedge clk_i) begin
    addr_q  <= addr_i;
    quiet_q <= !rst_i && !we;
    if (rst_i || idle && reset_i) begin
      left_q    <= Asked;
      watch_i_q <= watch_i;
      watch_j_q <= watch_j;
      known_q   <= 1'b0;
    end else if (!idle) begin
      if (left_q != Asked || !hold_i) left_q <= left_q - 6'd1;
      if (left_q == 6'd1) begin
        known_q  <= 1'b1;
        shadow_q <= initial_rule(watch_i_q, watch_j_q);
      end
    end else begin
      if (tune_we_i && !section) known_q <= 1'b0;
      if (tuned) shadow_q <= tune_data_i;
      else if (written) shadow_q <= wdata_i;
    end
    if (rst_i) begin
      read_q <= 1'b0;
    end else if (read_i) begin
      read_q     <= known_q && section && fired;
      expected_q <= shadow_q;
    end
    if (rst_i) live_q <= 1'b1;
    if (live_q) begin
      table_reset_takes_1_and_49_clocks : assert (busy_o == !idle);
      read_returns_last_written :
      assert (!known_q || stale || addr_i != watch || rdata_o == shadow_q);
      above_48_reads_zero : assert (stale || addr_i < Rules || rdata_o == '0);
      settles_in_one_clock : assert (!quiet_q || addr_i != addr_q || !stale);
      section_reads_its_four_rules : assert (!read_q || rule_o == expected_q);
      quiescent_is_honest : assert (!quiescent_o || !we && !stale && !read_i && idle && !reset_i);

      inv_watch : assert (watch_i_q < 3'd7 && watch_j_q < 3'd7 && left_q <= Asked);
      inv_asked : assert (asked == (left_q == Asked));
      inv_filling : assert (filling == (!idle && left_q != Asked) && (idle || !known_q));
      inv_place :
      assert (!filling || fill_i_q < 3'd7 && fill_j_q < 3'd7 &&
          index(fill_i_q, fill_j_q) == Rules - left_q);
      inv_filled :
      assert (!filling || watch >= Rules - left_q ||
          watched == initial_rule(watch_i_q, watch_j_q));
      inv_cell : assert (!known_q || watched == shadow_q);
      inv_read_valid : assert (ext_valid_q == (ext_addr_q < Rules) || written_q);
      inv_read_cell :
      assert (written_q || !known_q || ext_addr_q != watch || ext_q == shadow_q);

      reaches_a_read_of_a_rule : cover (read_q && known_q);
    end
  end

  // breaks table_reset_takes_1_and_49_clocks: state_d = state_q == StFill && fill_i_q == Last && fill_j_q == 3'd5 ? StIdle : state_d
  // breaks table_reset_takes_1_and_49_clocks: state_d = state_q == StAsked ? StFill : state_d
  // breaks read_returns_last_written: we = we || (we_i && !hold_i && !tune_we_i && !busy_o)
  // breaks read_returns_last_written: we = we || (we_i && ext_valid && !tune_we_i && !busy_o)
  // breaks read_returns_last_written: stale = addr_i != ext_addr_q
  // breaks above_48_reads_zero: rdata_o = ext_q
  // breaks settles_in_one_clock: ext_addr_q <= stale && !we && !rst_i ? addr_i & 6'd62 : next
  // breaks section_reads_its_four_rules: fired_j = j_i
  // breaks section_reads_its_four_rules: rule_q <= mem_q[{fired_j, fired_i}]
  // breaks quiescent_is_honest: quiescent_o = !busy_o && !reset_i && !read_i && !we_i && !stale
  // breaks quiescent_is_honest: quiescent_o = !busy_o && !read_i && !tune_we_i && !we_i && !stale

endmodule

bind rule_store rule_store_props u_rule_store_props (
    .*,
    .asked(state_q == StAsked),
    .filling(state_q == StFill)
);
