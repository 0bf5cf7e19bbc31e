// SPDX-License-Identifier: Apache-2.0
//
// Properties of calibration for any input. A checksum is built beside it, byte by byte.

module calibration_props
  import sincos_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic        write_i,
    input logic [ 2:0] command_i,
    input logic [15:0] word_i,
    input logic        reads_i,
    input calib_addr_t addr_i,
    input calib_t      data_o,
    input logic        nv_valid_o,
    input logic        nv_write_o,
    input calib_addr_t nv_addr_o,
    input logic [15:0] nv_data_o,
    input logic        nv_ready_i,
    input logic [15:0] nv_data_i,
    input logic        valid_o,
    input logic        busy_o,
    input logic [ 5:0] count_o,
    input logic        stored_o,
    input logic        refused_o,
    input logic        quiescent_o,

    input logic [ 2:0] state,
    input logic        bank_q,
    input logic        right_q,
    input logic [15:0] check,
    input logic [ 5:0] saved
);

  // CRC-16/CCITT-FALSE of one more byte.
  function automatic logic [15:0] crc(logic [15:0] old, logic [7:0] data);
    crc = old ^ {data, 8'd0};
    for (int k = 0; k < 8; k++) crc = crc[15] ? {crc[14:0], 1'b0} ^ 16'h1021 : {crc[14:0], 1'b0};
  endfunction

  logic live_q = 1'b0;
  logic was_rst_q, was_bank_q, was_reads_q, was_valid_q, was_quiescent_q, was_write_q;
  logic was_ready_q, was_taken_q, takes_now;
  logic [5:0] words_q, was_words_q;  // that came since the start, 63 at most
  logic [15:0] check_q;  // of them
  logic [5:0] was_addr_q, saved_q;
  logic match_q, starts, comes;  // the last word was the checksum of those before
  logic [15:0] word;

  // Loading, what comes is the memory's; resting, the commands'.
  assign starts = state == 3'd5 && write_i && command_i == 3'd1;
  assign comes  = words_q != 6'd63 && (state == 3'd0 ? nv_ready_i :
                                       state == 3'd5 && write_i && command_i == 3'd2);
  assign word   = state == 3'd0 ? nv_data_i : word_i;
  assign takes_now = state == 3'd2 && !reads_i;

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q       <= rst_i;
    was_bank_q      <= bank_q;
    was_reads_q     <= reads_i;
    was_valid_q     <= valid_o;
    was_taken_q     <= takes_now && words_q == 6'd63 && match_q;
    was_quiescent_q <= !rst_i && quiescent_o;
    was_write_q     <= !rst_i && nv_valid_o && nv_write_o;
    was_ready_q     <= nv_ready_i;
    was_words_q     <= words_q;
    was_addr_q      <= nv_addr_o;
    if (rst_i || takes_now || starts) begin
      words_q <= '0;
      check_q <= '1;
      match_q <= 1'b0;
    end else if (comes) begin
      words_q <= words_q + 6'd1;
      check_q <= crc(crc(check_q, word[7:0]), word[15:8]);
      match_q <= word == check_q;
    end
    if (rst_i || takes_now) saved_q <= '0;
    else if (nv_valid_o && nv_write_o && nv_ready_i) saved_q <= saved_q + 6'd1;
    if (live_q) begin
      without_data_from_reset : assert (!was_rst_q || (!valid_o && busy_o && !nv_write_o));
      counts_the_words : assert (count_o == words_q);
      in_use_by_the_right_checksum_only :
      assert (was_rst_q || bank_q == was_bank_q || was_taken_q);
      valid_for_good : assert (was_rst_q || !was_valid_q || valid_o);
      valid_with_data_only : assert (was_rst_q || valid_o == (was_valid_q || bank_q != was_bank_q));
      banks_change_while_the_reader_rests :
      assert (was_rst_q || bank_q == was_bank_q || !was_reads_q);
      refused_exactly_where_it_is_wrong :
      assert (refused_o == (state == 3'd1 && !(words_q == 6'd63 && match_q)));
      stored_after_the_last_word :
      assert (!stored_o || (nv_write_o && nv_ready_i && saved_q == 6'd62 && nv_addr_o == 6'd62));
      words_are_stored_in_their_order : assert (!nv_write_o || nv_addr_o == saved_q);
      a_word_waits_for_the_memory :
      assert (!was_write_q || was_ready_q || was_rst_q ||
              (nv_valid_o && nv_write_o && nv_addr_o == was_addr_q));
      writes_nothing_but_new_data : assert (!nv_write_o || valid_o);
      quiescent_is_honest :
      assert (!was_quiescent_q || (!busy_o && bank_q == was_bank_q && words_q == was_words_q));
      inv_match : assert (right_q == match_q);
      inv_check : assert (check == check_q);
      inv_good : assert (state != 3'd2 || (words_q == 6'd63 && match_q));
      inv_state : assert (state <= 3'd5 && (state < 3'd3 || state > 3'd4 || valid_o));
      inv_saved :
      assert ((state != 3'd3 && state != 3'd4) || (saved == saved_q && saved_q < 6'd63));
      inv_load : assert (state != 3'd0 || words_q != 6'd63);
      reaches_a_refusal : cover (refused_o);
    end
  end

  logic unused_inputs;
  assign unused_inputs = ^{addr_i, data_o, nv_data_o};

  // breaks without_data_from_reset: valid_q <= rst_i ? write_i : next
  // breaks counts_the_words: count_q <= next + 6'(takes && nv_data_i[0] && !rst_i)
  // breaks in_use_by_the_right_checksum_only: right_q <= rst_i ? 1'b0 : 1'b1
  // breaks valid_for_good: valid_q <= refused_o ? 1'b0 : next
  // breaks valid_with_data_only: valid_q <= rst_i ? 1'b0 : next || write_i
  // breaks banks_change_while_the_reader_rests: bank_q <= state_q == StTake && !rst_i ? !bank_q : next
  // breaks refused_exactly_where_it_is_wrong: refused_o = refused_o || (state_q == StLoad && write_i)
  // breaks stored_after_the_last_word: stored_o = state_q == StCheck
  // breaks words_are_stored_in_their_order: nv_write_o = state_q == StStore || state_q == StReady
  // breaks a_word_waits_for_the_memory: nv_write_o = state_q == StStore || (state_q == StLoad && !nv_ready_i)
  // breaks writes_nothing_but_new_data: nv_write_o = state_q == StStore || state_q == StCheck
  // breaks quiescent_is_honest: quiescent_o = !busy_o

endmodule

bind calibration calibration_props u_calibration_props (
    .*,
    .state(3'(state_q)),
    .check(check_q),
    .saved(saved_q)
);
