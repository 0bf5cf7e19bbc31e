// SPDX-License-Identifier: Apache-2.0
//
// Properties of lm628_engine for any input and any program: what its memories give is free in the
// proof. What its program computes is compared with the twin.

module lm628_engine_props
  import lm628_pkg::*;
(
    input logic clk_i,
    input logic rst_i,

    input logic sample_i,
    input logic start_i,
    input logic commit_i,
    input logic end_i,

    input logic arm_i,

    input logic        [23:0] count_i,
    input logic               index_seen_i,
    input logic        [23:0] index_count_i,
    input logic        [31:0] reply_o,
    input events_t            sample_events_o,
    input logic               sample_off_o,
    input events_t            command_events_o,
    input logic               command_off_o,
    input logic signed [15:0] u_o,
    input logic               eight_bits_o,
    input logic        [ 2:0] word_addr_o,
    input logic               busy_o,
    input logic               quiescent_o,

    input logic               boot_q,
    input logic        [17:0] instr_q,
    input logic        [ 5:0] loop_q,
    input logic        [ 9:0] c_q,
    input logic        [ 9:0] pc_d,
    input logic        [ 9:0] pc_q,
    input logic        [ 9:0] return_q,
    input logic        [ 5:0] read,
    input logic        [ 5:0] after_q,
    input logic        [ 5:0] return_after_q,
    input logic signed [63:0] operand_q,
    input logic signed [63:0] acc_q,
    input logic        [29:0] q_q,
    input logic        [23:0] count_q,
    input logic        [23:0] index_q,
    input logic               captured_q,
    input logic               capturing_q,
    input logic               take_q,
    input logic        [22:0] flag_q
);

  logic live_q = 1'b0;
  logic was_rst_q, was_busy_q, was_asked_q, was_commit_q, was_end_q, was_sample_q;
  logic was_quiescent_q, was_halt_q;
  logic [49:0] results, was_results_q;
  logic [22:0] was_flag_q, flags, flags_q, one;  // as the operations set them
  logic [2:0] addr_q;
  logic [2:0] was_capture_q;
  events_t was_sample_events_q;
  logic signed [63:0] was_acc_q, was_operand_q;
  logic [29:0] was_mult_q;
  logic [17:0] was_instr_q;
  logic [ 5:0] was_loop_q;
  logic [ 2:0] was_addr_q;
  logic held, was_held_q;  // the instruction takes more clocks than those so far
  logic is_out, was_out_q, was_reply_q, was_call_q, is_jump, runs, is_word, is_flag;
  logic [15:0] was_return_q, was_place_q;  // after a call: address, register that is read there

  // Model of the capture.
  logic armed_q, caught_q, taken_q;
  logic [23:0] at_q, sampled_q;

  assign results = {u_o, sample_off_o, eight_bits_o, reply_o};
  assign is_jump = instr_q[17];
  logic unused_controls;
  assign unused_controls = ^c_q[9:6];

  assign runs    = busy_o && !boot_q && !is_jump;
  assign held    = runs && instr_q[16] && loop_q != instr_q[11:6];
  assign is_out  = runs && instr_q[16:12] == OpOut;
  assign is_flag = runs && instr_q[16:12] == OpFlag;
  assign is_word = runs && instr_q[16:12] == OpIn && instr_q[11:9] == FromWord;
  assign one     = 23'd1 << instr_q[4:0];

  always_comb begin
    flags = flag_q;
    if (is_flag) flags = instr_q[5] ? flag_q | one : flag_q & ~one;
    if (end_i || is_out) flags[6:1] = '0;
  end

  always_ff @(posedge clk_i) begin
    if (rst_i) live_q <= 1'b1;
    was_rst_q           <= rst_i;
    was_busy_q          <= !rst_i && busy_o;
    was_asked_q         <= !rst_i && !busy_o && (sample_i || start_i);
    was_sample_q        <= !rst_i && sample_i;
    was_commit_q        <= !rst_i && commit_i;
    was_end_q           <= !rst_i && end_i;
    was_quiescent_q     <= !rst_i && quiescent_o;
    was_halt_q          <= !boot_q && !is_jump && instr_q[16:12] == OpHalt;
    was_out_q           <= !rst_i && is_out;
    was_reply_q         <= busy_o && !is_jump && instr_q[16:12] == OpReply;
    was_held_q          <= !rst_i && held;
    was_call_q          <= runs && instr_q[16:12] == OpCall;
    was_return_q        <= {return_q, return_after_q};
    was_place_q         <= {pc_q + 10'd1, after_q};
    was_operand_q       <= operand_q;
    was_results_q       <= results;
    was_flag_q          <= flag_q;
    flags_q             <= flags;
    addr_q              <= start_i ? '0 : word_addr_o + 3'(is_word);
    was_capture_q       <= {captured_q, capturing_q, take_q};
    was_sample_events_q <= sample_events_o;
    was_acc_q           <= acc_q;
    was_mult_q          <= q_q;
    was_instr_q         <= instr_q;
    was_loop_q          <= loop_q;
    was_addr_q          <= word_addr_o;
    if (rst_i) begin
      armed_q  <= 1'b0;
      caught_q <= 1'b0;
      taken_q  <= 1'b0;
    end else begin
      if (sample_i) begin
        taken_q  <= caught_q;
        caught_q <= 1'b0;
      end
      if (arm_i) begin
        armed_q  <= 1'b1;
        caught_q <= 1'b0;
      end else if (armed_q && index_seen_i) begin
        armed_q  <= 1'b0;
        caught_q <= 1'b1;
        at_q     <= index_count_i;
      end
    end
    if (sample_i) sampled_q <= count_i;
    if (live_q) begin
      off_from_reset :
      assert (!was_rst_q || (u_o == '0 && sample_off_o && command_off_o && eight_bits_o &&
                             sample_events_o == '0 && command_events_o == '0 &&
                             reply_o == '0 && word_addr_o == '0));
      busy_from_a_request_to_halt :
      assert (was_rst_q || busy_o == (was_asked_q || (was_busy_q && !was_halt_q)));
      results_move_by_their_operation :
      assert (was_rst_q || was_out_q || was_reply_q || results == was_results_q);
      events_go_with_their_end :
      assert (was_rst_q || was_busy_q || was_sample_events_q == '0 || was_commit_q ||
              sample_events_o == was_sample_events_q);
      taken_events_are_gone :
      assert (was_rst_q || was_out_q || !was_commit_q || sample_events_o == '0);
      command_events_end_with_it :
      assert (was_rst_q || !(was_end_q || was_out_q) || command_events_o == '0);
      flags_rest_while_idle :
      assert (was_rst_q || was_busy_q || was_end_q || flag_q == was_flag_q);
      flags_move_by_their_operation : assert (was_rst_q || flag_q == flags_q);
      words_go_on_as_they_are_taken : assert (was_rst_q || word_addr_o == addr_q);
      address_and_register_are_of_one_place :
      assert (boot_q || !busy_o || {pc_d, read} == {pc_q + 10'd1, after_q} ||
              {pc_d, read} == {instr_q[9:0], c_q[5:0]} ||
              {pc_d, read} == {return_q, return_after_q});
      accumulator_rests_while_idle :
      assert (was_rst_q || was_busy_q || (acc_q == was_acc_q && q_q == was_mult_q));
      held_operations_count :
      assert (!was_held_q || was_rst_q || (instr_q == was_instr_q &&
                                           loop_q == was_loop_q + 6'd1));
      a_word_stays_with_its_operation :
      assert (was_rst_q || !(was_held_q || was_quiescent_q) || operand_q == was_operand_q);
      a_call_keeps_its_place :
      assert (was_rst_q || {return_q, return_after_q} == (was_call_q ? was_place_q : was_return_q));
      others_do_not : assert (was_rst_q || was_held_q || !was_busy_q || loop_q == '0);
      count_is_that_of_the_sample : assert (was_rst_q || !was_sample_q || count_q == sampled_q);
      index_is_the_first_after_arming :
      assert (was_rst_q || !captured_q || (caught_q && index_q == at_q));
      index_is_taken_once : assert (was_rst_q || !was_sample_q || take_q == taken_q);
      quiescent_is_honest :
      assert (!was_quiescent_q || (results == was_results_q && flag_q == was_flag_q &&
                                   acc_q == was_acc_q && instr_q == was_instr_q &&
                                   loop_q == was_loop_q && word_addr_o == was_addr_q &&
                                   sample_events_o == was_sample_events_q &&
                                   {captured_q, capturing_q, take_q} == was_capture_q));
      rests_unless_asked :
      assert (quiescent_o || busy_o || sample_i || start_i || arm_i ||
              (capturing_q && index_seen_i) || (end_i && command_events_o != '0) ||
              (commit_i && sample_events_o != '0));
      inv_capture : assert (capturing_q == armed_q && captured_q == caught_q);
      inv_at : assert (!caught_q || index_q == at_q);
      reaches_busy : cover (!was_rst_q && was_asked_q && busy_o);
      reaches_index : cover (!was_rst_q && take_q && was_sample_q);
    end
  end

  // breaks off_from_reset: u_q <= rst_i ? acc_q[15:0] : next
  // breaks busy_from_a_request_to_halt: busy_q <= fetch && !rst_i
  // breaks results_move_by_their_operation: reply_q <= runs && !rst_i ? acc_q[31:0] : next
  // breaks events_go_with_their_end: sample_events_q <= busy_q ? next : '0
  // breaks taken_events_are_gone: sample_events_q <= commit_i && !end_i && !rst_i && !(runs && op == OpOut) ? sample_events_q : next
  // breaks command_events_end_with_it: flag_d = end_i && !(runs && op == OpOut) ? flag_q : flag_d
  // breaks flags_rest_while_idle: flag_d = sample_i && !runs ? '0 : flag_d
  // breaks flags_move_by_their_operation: flag_d = runs && op == OpFlag && instr_q[6] ? flag_q : flag_d
  // breaks words_go_on_as_they_are_taken: word_addr_q <= runs && op == OpIn && instr_q[10:9] == 2'd1 && !start_i && !rst_i ? word_addr_q + 3'd1 : next
  // breaks address_and_register_are_of_one_place: read = busy_q && !branches && op == OpRet ? after_q : read
  // breaks accumulator_rests_while_idle: q_en = sample_i || to_q || op == OpMul || op == OpDiv
  // breaks held_operations_count: fetch = busy_q ? !halts : boot_q || sample_i || start_i
  // breaks a_word_stays_with_its_operation: operand_q <= m_q[read]
  // breaks a_call_keeps_its_place: return_after_q <= runs && op == OpCall && !rst_i ? read : next
  // breaks a_call_keeps_its_place: return_q <= runs && loops && !rst_i ? pc_q + 1'b1 : next
  // breaks others_do_not: loop_q <= busy_q && !rst_i ? loop_q + 6'd1 : next
  // breaks count_is_that_of_the_sample: count_q <= sample_i ? index_count_i : next
  // breaks index_is_the_first_after_arming: index_q <= index_seen_i ? index_count_i : next
  // breaks index_is_taken_once: captured_q <= sample_i && !start_i && !arm_i && !captures && !rst_i ? captured_q : next
  // breaks quiescent_is_honest: quiescent_o = !busy_o && !sample_i && !arm_i && !captures && !(end_i && command_events_o != '0) && !(commit_i && sample_events_q != '0)
  // breaks rests_unless_asked: quiescent_o = !busy_o && !sample_i && !start_i && !arm_i && !index_seen_i && !(end_i && command_events_o != '0) && !(commit_i && sample_events_q != '0)

  // prove: free $mem_v2

endmodule

bind lm628_engine lm628_engine_props u_lm628_engine_props (.*);
